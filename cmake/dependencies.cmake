# Debian's packages; scripts/setup installs them. OpenEXR and Imath come through pkg-config because their
# CMake files ask for the Python bindings too.
find_package(PkgConfig REQUIRED)
pkg_check_modules(Imath REQUIRED IMPORTED_TARGET Imath)
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR)
pkg_check_modules(Librsvg REQUIRED IMPORTED_TARGET librsvg-2.0)
pkg_check_modules(Turbojpeg REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(Nats REQUIRED IMPORTED_TARGET libnats)
pkg_check_modules(WebP REQUIRED IMPORTED_TARGET libwebp)
pkg_check_modules(Seccomp REQUIRED IMPORTED_TARGET libseccomp)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TBB REQUIRED)
find_package(Boost REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(Ceres REQUIRED)
find_package(embree 3 REQUIRED)
find_package(assimp REQUIRED)
# Assimp's CMake file names static libraries that its shared library already contains. One of them, Draco, contains an
# older tinygltf with the same symbols, which would replace ours.
set_target_properties(assimp::assimp PROPERTIES INTERFACE_LINK_LIBRARIES "")
find_package(OpenMesh REQUIRED)
find_package(TinyGLTF REQUIRED)
# libdraco contains an older tinygltf with the same symbols: whatever links it has to link ours before it.
find_package(draco REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(LibArchive REQUIRED)
find_package(OpenSSL REQUIRED)
# Only the Python module needs these: without pybind11, everything else is built and tested.
# Debian's interpreter has NumPy, which another one in PATH may lack.
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 COMPONENTS Interpreter Development.Module)
if(Python3_Development.Module_FOUND)
  find_package(pybind11 CONFIG)
endif()
# Only the editor needs these: without Qt, everything else is built and tested.
find_package(Qt6 6.4 COMPONENTS Concurrent Network OpenGLWidgets PrintSupport Svg Test Widgets)
if(Qt6_FOUND)
  find_package(Qt6 6.4 REQUIRED COMPONENTS LinguistTools)
  find_package(QCustomPlotQt6 REQUIRED)
  find_package(muparser REQUIRED)
endif()

# Defines GRANADA_LIBRARIES for the version of a program: its main libraries, as pairs of names and versions. The list
# of all, with their licences, is in share/doc/granada/sbom.spdx.json.
function(granada_name_libraries target)
  set(libraries "")
  while(ARGN)
    list(POP_FRONT ARGN name version)
    list(APPEND libraries "${name} ${version}")
  endwhile()
  list(JOIN libraries ", " libraries)
  target_compile_definitions(${target} PRIVATE "GRANADA_LIBRARIES=\"${libraries}\"")
endfunction()
