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
  if(TXN_SANITIZE STREQUAL address)
    set(sanitizers address,undefined)
  elseif(TXN_SANITIZE STREQUAL thread)
    set(sanitizers thread)
    target_compile_definitions(txn_options INTERFACE TXN_THREAD_SANITIZED)
  else()
    message(FATAL_ERROR "TXN_SANITIZE must be empty, address or thread, not ${TXN_SANITIZE}")
  endif()
  target_compile_options(txn_options INTERFACE -fsanitize=${sanitizers} -fno-sanitize-recover=all
                                               -fno-omit-frame-pointer)
  target_link_options(txn_options INTERFACE -fsanitize=${sanitizers})
  target_compile_definitions(txn_options INTERFACE TXN_SANITIZED)
endif()

# txn_unity(TARGET): each folder of the target compiled as one file, where TXN_UNITY asks for it.
# Names of a folder's files are unique within it for that.
function(txn_unity target)
  if(NOT TXN_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^[A-Za-z].*cpp$") # not what is generated
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "${target}_${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# txn_fuzzed(TARGET PATHS...): what of the target the fuzzers watch, in the build that has them.
# The rest would only become slower.
function(txn_fuzzed target)
  if(NOT TXN_SANITIZE STREQUAL address)
    return()
  endif()
  list(JOIN ARGN "|" paths)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^(${paths}).*cpp$")
  set_property(SOURCE ${sources} APPEND PROPERTY COMPILE_OPTIONS
    -fsanitize-coverage=inline-8bit-counters,indirect-calls,trace-cmp,pc-table)
endfunction()

# txn_precompile(TARGET HEADERS...): headers that most files of the target include anyway.
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
