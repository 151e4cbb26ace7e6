# Every library in use, by the name under which Debian 12 and Ubuntu 24.04 ship it; the list of
# packages is in script/bootstrap. OpenImageIO is found by pkg-config, since Debian's CMake files
# for it also demand its command line tools.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3f)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(LCMS REQUIRED IMPORTED_TARGET lcms2)
if(TXN_BUILD_TESTS)
  find_package(Qt6 REQUIRED COMPONENTS Test)
endif()
if(TXN_BUILD_BENCH)
  find_package(benchmark REQUIRED)
endif()
