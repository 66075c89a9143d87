# What every target is compiled with: link granada_options.
add_library(granada_options INTERFACE)
target_include_directories(granada_options INTERFACE ${PROJECT_SOURCE_DIR})

# One stated baseline and no contraction or fast-math, so that an image depends on its seed alone and not on
# what the compiler makes of an expression on one machine. Embree picks its own instruction set at run time.
target_compile_options(granada_options INTERFACE
  -march=x86-64-v3 -ffp-contract=off
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Werror)

# g++ 12 sees uninitialised members in copies of std::variant and std::optional that have none, and copies that
# overlap in sums of std::string (GCC bug 105651). It takes the files of a unit for headers, in which types must not
# hold what is in an unnamed namespace.
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(granada_options INTERFACE
    -Wno-maybe-uninitialized -Wno-restrict -Wno-subobject-linkage)
endif()

# A folder that asks for this is built in two thirds of the time: of use for what runs a few times a command. Where
# files are read and written -O3 gains a few per cent, where rays are traced far more.
# With RELEASE, builds for debugging and for sanitizers keep their own optimisation: of use where tests of large files
# take longer than the compiler saves.
macro(granada_optimise_little)
  string(APPEND CMAKE_CXX_FLAGS_RELEASE " -O1")
  if(NOT "${ARGN}" STREQUAL "RELEASE")
    string(APPEND CMAKE_CXX_FLAGS_DEBUG " -O0")
  endif()
endmacro()

# The linker lld takes less time than ld, which counts where there are many programs.
target_link_options(granada_options INTERFACE -fuse-ld=lld)

if(GRANADA_SANITIZERS)
  add_compile_definitions(GRANADA_HAS_SANITIZERS)
  # Of folders, so that tests can do without (tests/CMakeLists.txt).
  add_compile_options(-fsanitize=${GRANADA_SANITIZERS} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${GRANADA_SANITIZERS})
  if(GRANADA_SANITIZERS MATCHES address)
    # AddressSanitizer finds accesses through null and past an object itself: these take a fifth of the build.
    add_compile_options(-fno-sanitize=null,object-size,vptr)
  endif()
  if(GRANADA_SANITIZERS MATCHES thread)
    add_compile_definitions(GRANADA_THREAD_SANITIZER)
    add_compile_options(-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/thread_sanitizer_ignorelist)
  endif()
endif()
