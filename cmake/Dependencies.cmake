# Every library in use, by the name under which Debian 12 and Ubuntu 24.04 ship it; the list of
# packages is in script/bootstrap. OpenImageIO is found by pkg-config, since Debian's CMake files
# for it also demand its command line tools.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(glm REQUIRED)
pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(TINYOBJ REQUIRED IMPORTED_TARGET tinyobjloader)
pkg_check_modules(FFTW REQUIRED IMPORTED_TARGET fftw3f)
pkg_check_modules(LBFGS REQUIRED IMPORTED_TARGET liblbfgs)
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)
pkg_check_modules(LCMS REQUIRED IMPORTED_TARGET lcms2)
pkg_check_modules(SECCOMP REQUIRED IMPORTED_TARGET libseccomp)
find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets Svg Charts LinguistTools)
if(TXN_BUILD_TESTS)
  find_package(Qt6 REQUIRED COMPONENTS Test)
endif()
if(TXN_BUILD_BENCH)
  find_package(benchmark REQUIRED)
endif()

# What --version --verbose tells, as C++ literals.
set(TXN_LIBRARY_VERSIONS)
foreach(library "OpenImageIO ${OIIO_VERSION}" "FFTW ${FFTW_VERSION}" "L-BFGS ${LBFGS_VERSION}"
                "Little CMS ${LCMS_VERSION}" "libseccomp ${SECCOMP_VERSION}" "TBB ${TBB_VERSION}"
                "Eigen ${Eigen3_VERSION}" "GLM ${glm_VERSION}" "tinyobjloader ${TINYOBJ_VERSION}"
                "JSON for Modern C++ ${nlohmann_json_VERSION}" "CLI11 ${CLI11_VERSION}"
                "libepoxy ${EPOXY_VERSION}" "Qt ${Qt6_VERSION}")
  list(APPEND TXN_LIBRARY_VERSIONS "\"${library}\"")
endforeach()
list(JOIN TXN_LIBRARY_VERSIONS ",\n        " TXN_LIBRARY_VERSIONS)
