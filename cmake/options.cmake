# Other compilers than those of CI have other warnings, which should not keep anyone from building.
option(GRANADA_WARNINGS_AS_ERRORS "Treat warnings as errors, as CI does" OFF)

# Every target links granada_options for its compile options. Other programs that link the libraries need the same
# instruction set, which headers use, and C++20.
set(GRANADA_INSTRUCTION_SET -march=x86-64-v3)
add_library(granada_options INTERFACE)
target_include_directories(granada_options INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
target_compile_features(granada_options INTERFACE cxx_std_20)

# One fixed x86-64 baseline without floating-point contraction or fast-math, so that an image depends only on its
# seed and not on the machine. Embree picks its own instruction set at run time.
target_compile_options(granada_options INTERFACE
  ${GRANADA_INSTRUCTION_SET}
  $<BUILD_INTERFACE:-ffp-contract=off>
  $<BUILD_INTERFACE:-Wall> $<BUILD_INTERFACE:-Wextra> $<BUILD_INTERFACE:-Wpedantic> $<BUILD_INTERFACE:-Wshadow>
  $<BUILD_INTERFACE:-Wconversion> $<BUILD_INTERFACE:-Wno-sign-conversion>
  $<BUILD_INTERFACE:$<$<BOOL:${GRANADA_WARNINGS_AS_ERRORS}>:-Werror>>)

# g++ 12 has false warnings of uninitialised members in copies of std::variant and std::optional, and of overlapping
# copies in concatenations of std::string (GCC bug 105651). In unity builds it takes source files for headers, in which
# types must not have members from an unnamed namespace.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(granada_options INTERFACE
    $<BUILD_INTERFACE:-Wno-maybe-uninitialized> $<BUILD_INTERFACE:-Wno-restrict>
    $<BUILD_INTERFACE:-Wno-subobject-linkage>)
endif()

# Compiles a folder with little optimisation, in two thirds of the time, for code that runs a few times per command. -O3
# gains a few per cent in reading and writing files, and far more in ray tracing.
# With RELEASE, builds for debugging and with sanitizers keep their own optimisation, where tests of large files would
# take longer than the compiler saves.
macro(granada_optimise_little)
  string(APPEND CMAKE_CXX_FLAGS_RELEASE " -O1")
  if(NOT "${ARGN}" STREQUAL "RELEASE")
    string(APPEND CMAKE_CXX_FLAGS_DEBUG " -O0")
  endif()
endmacro()

# Libraries are position independent, so that the Python module can contain them; sanitizers never see the module. With
# hidden symbols, and none that another library may replace, the compiler inlines as much as it does in programs.
macro(granada_begin_position_independent)
  if(NOT GRANADA_SANITIZERS)
    set(CMAKE_POSITION_INDEPENDENT_CODE ON)
    set(CMAKE_CXX_VISIBILITY_PRESET hidden)
    set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
    set(flags_before "${CMAKE_CXX_FLAGS}")
    string(APPEND CMAKE_CXX_FLAGS " -fno-semantic-interposition")
  endif()
endmacro()
macro(granada_end_position_independent)
  if(NOT GRANADA_SANITIZERS)
    unset(CMAKE_POSITION_INDEPENDENT_CODE)
    unset(CMAKE_CXX_VISIBILITY_PRESET)
    unset(CMAKE_VISIBILITY_INLINES_HIDDEN)
    set(CMAKE_CXX_FLAGS "${flags_before}")
  endif()
endmacro()

# The linker lld is faster than ld, which matters with many programs.
target_link_options(granada_options INTERFACE $<BUILD_INTERFACE:-fuse-ld=lld>)

if(GRANADA_SANITIZERS)
  add_compile_definitions(GRANADA_HAS_SANITIZERS)
  # Options of folders, so that tests can disable them (tests/CMakeLists.txt).
  add_compile_options(-fsanitize=${GRANADA_SANITIZERS} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${GRANADA_SANITIZERS})
  if(GRANADA_SANITIZERS MATCHES address)
    # AddressSanitizer itself finds null and out-of-bounds accesses; these checks take a fifth of the build time.
    add_compile_options(-fno-sanitize=null,object-size,vptr)
  endif()
  if(GRANADA_SANITIZERS MATCHES thread)
    add_compile_definitions(GRANADA_THREAD_SANITIZER)
    add_compile_options(-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/thread_sanitizer_ignorelist)
  endif()
endif()
