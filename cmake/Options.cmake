# txn_options: what every target of the project is compiled with.
add_library(txn_options INTERFACE)
target_include_directories(txn_options INTERFACE ${PROJECT_SOURCE_DIR})
# No errno from sqrt and friends: without this the hot loops do not vectorise.
target_compile_options(txn_options INTERFACE -Wall -Wextra -Wshadow -Wconversion
                                             -fno-math-errno -fopenmp-simd)
# GCC 12 warns of std::string's own code (GCC bug 105651).
target_compile_options(txn_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
if(TXN_WERROR)
  target_compile_options(txn_options INTERFACE -Werror)
endif()
if(TXN_SANITIZE)
  target_compile_options(txn_options INTERFACE -fsanitize=address,undefined
                                               -fno-sanitize-recover=all -fno-omit-frame-pointer)
  # GCC warns of initialised variables once its sanitizers have rewritten the code around them.
  target_compile_options(txn_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(txn_options INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(txn_options INTERFACE TXN_SANITIZED)
endif()
if(TXN_FUZZ)
  target_compile_options(txn_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# txn_precompile(TARGET HEADERS...): headers that most files of the target include anyway. The release
# build goes without, so that every file is seen to include what it uses.
function(txn_precompile target)
  if(TXN_PRECOMPILE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# The same headers for the targets that follow, compiled once for all of them.
function(txn_share_precompiled target from)
  if(TXN_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM ${from})
  endif()
endfunction()
