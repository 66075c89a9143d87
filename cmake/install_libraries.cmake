# Installs the libraries grf, reflectance and converters for other programs, as the component `dev`: static libraries,
# the headers under the paths that sources include them by, and what CMake's find_package(granada) and pkg-config read.
# samples/library shows their use.
include(CMakePackageConfigHelpers)

macro(granada_install_libraries)
  set(static_libraries grf options image reflectance converters)
  foreach(library IN LISTS static_libraries)
    set_target_properties(${library} PROPERTIES OUTPUT_NAME granada_${library})
  endforeach()
  install(TARGETS ${static_libraries} parallel granada_options EXPORT granada
    ARCHIVE DESTINATION lib COMPONENT dev INCLUDES DESTINATION include/granada)

  set(package_folder lib/cmake/granada)
  install(EXPORT granada NAMESPACE granada:: FILE granada-targets.cmake DESTINATION ${package_folder} COMPONENT dev)
  configure_package_config_file(cmake/granada-config.cmake.in granada-config.cmake
    INSTALL_DESTINATION ${package_folder})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/granada-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/granada-config.cmake ${PROJECT_BINARY_DIR}/granada-config-version.cmake
    DESTINATION ${package_folder} COMPONENT dev)

  foreach(library grf reflectance converters)
    configure_file(cmake/granada-${library}.pc.in granada-${library}.pc @ONLY)
    install(FILES ${PROJECT_BINARY_DIR}/granada-${library}.pc DESTINATION lib/pkgconfig COMPONENT dev)
  endforeach()

  # Formulas are part of the models' headers. Most headers of converters are of single formats.
  set(folder include/granada)
  foreach(library grf renderer/reflectance renderer/image renderer/options renderer/parallel)
    install(DIRECTORY ${library}/ DESTINATION ${folder}/${library} COMPONENT dev FILES_MATCHING
      PATTERN *.h PATTERN *.glsl PATTERN nonnegative_factors.h EXCLUDE)
  endforeach()
  foreach(header converters/embedded_files.h converters/format.h converters/input.h converters/material_rule.h
      converters/mesh_operations/mesh_operations.h converters/mesh_operations/subdivide.h converters/output.h
      converters/risks/risk.h converters/scene_building.h renderer/transport/effect.h)
    cmake_path(GET header PARENT_PATH header_folder)
    install(FILES ${header} DESTINATION ${folder}/${header_folder} COMPONENT dev)
  endforeach()
endmacro()
