# Debian's packages; scripts/setup installs them. OpenEXR and Imath come through pkg-config because their
# CMake files ask for the Python bindings too.
find_package(PkgConfig REQUIRED)
pkg_check_modules(Imath REQUIRED IMPORTED_TARGET Imath)
pkg_check_modules(OpenEXR REQUIRED IMPORTED_TARGET OpenEXR)
pkg_check_modules(Librsvg REQUIRED IMPORTED_TARGET librsvg-2.0)
pkg_check_modules(Turbojpeg REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(WebP REQUIRED IMPORTED_TARGET libwebp)
find_package(fmt REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(TBB REQUIRED)
find_package(Boost REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
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
# Only the editor needs these: without Qt, everything else is built and tested.
find_package(Qt6 6.4 COMPONENTS Concurrent Network OpenGLWidgets PrintSupport Svg Test Widgets)
if(Qt6_FOUND)
  find_package(Qt6 6.4 REQUIRED COMPONENTS LinguistTools)
  find_package(QCustomPlotQt6 REQUIRED)
  find_package(muparser REQUIRED)
endif()
