# Manual pages, completions and the packages of Debian: `cmake --build --preset release --target packages` makes
# granada (bpt, grfconvert), granada-wannabe (the editor), granada-samples, libgranada-dev and python3-granada in
# build/release/packages.

set(manual_folder ${PROJECT_BINARY_DIR}/manual)
file(MAKE_DIRECTORY ${manual_folder})

# Makes the manual page of a program and what completes its words in shells, from its own command line. Programs that
# sanitizers instrument are not run while building; nobody installs them.
function(granada_install_manual program)
  if(GRANADA_SANITIZERS)
    return()
  endif()
  set(outputs ${manual_folder}/${program}.1.gz ${manual_folder}/${program}.bash ${manual_folder}/_${program}
    ${manual_folder}/${program}.fish)
  add_custom_command(OUTPUT ${outputs}
    COMMAND $<TARGET_FILE:${program}> --manual man > ${program}.1
    COMMAND gzip -n9f ${program}.1
    COMMAND $<TARGET_FILE:${program}> --manual bash > ${program}.bash
    COMMAND $<TARGET_FILE:${program}> --manual zsh > _${program}
    COMMAND $<TARGET_FILE:${program}> --manual fish > ${program}.fish
    DEPENDS ${program} WORKING_DIRECTORY ${manual_folder} VERBATIM)
  add_custom_target(${program}_manual ALL DEPENDS ${outputs})
  set(shells ${CMAKE_INSTALL_DATADIR})
  install(FILES ${manual_folder}/${program}.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT granada)
  install(FILES ${manual_folder}/${program}.bash DESTINATION ${shells}/bash-completion/completions
    RENAME ${program} COMPONENT granada)
  install(FILES ${manual_folder}/_${program} DESTINATION ${shells}/zsh/vendor-completions COMPONENT granada)
  install(FILES ${manual_folder}/${program}.fish DESTINATION ${shells}/fish/vendor_completions.d COMPONENT granada)
endfunction()

# Makes a manual page of section 5 from the document that describes a format. Those who build the renderer alone, as
# `scripts/demo` does, need no converter of documents.
function(granada_install_format_manual name title document)
  find_program(GO_MD2MAN go-md2man)
  if(NOT GO_MD2MAN)
    return()
  endif()
  set(output ${manual_folder}/${name}.5.gz)
  add_custom_command(OUTPUT ${output}
    COMMAND ${PROJECT_SOURCE_DIR}/packages/make_format_manual ${GO_MD2MAN} ${name} ${title} ${GRANADA_DATE}
      ${PROJECT_VERSION} ${PROJECT_SOURCE_DIR}/${document} ${output}
    DEPENDS ${PROJECT_SOURCE_DIR}/${document} ${PROJECT_SOURCE_DIR}/packages/make_format_manual VERBATIM)
  add_custom_target(${name}_format_manual ALL DEPENDS ${output})
  install(FILES ${output} DESTINATION ${CMAKE_INSTALL_MANDIR}/man5 COMPONENT granada)
endfunction()

# Lists the libraries in the programs of a package, where Debian's packages are known.
function(granada_install_sbom component package)
  find_program(DPKG_QUERY dpkg-query)
  find_package(Python3 QUIET COMPONENTS Interpreter)
  if(NOT ARGN OR NOT DPKG_QUERY OR NOT Python3_FOUND)
    return()
  endif()
  set(programs ${ARGN})
  list(TRANSFORM programs REPLACE "(.+)" "$<TARGET_FILE:\\1>")
  set(output ${PROJECT_BINARY_DIR}/packages/${package}/sbom.spdx.json)
  add_custom_command(OUTPUT ${output}
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/packages/make_sbom ${PROJECT_SOURCE_DIR} ${PROJECT_VERSION}
      ${GRANADA_DATE} ${package} ${output} ${programs}
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/packages/make_sbom ${PROJECT_SOURCE_DIR}/scripts/setup VERBATIM)
  add_custom_target(${package}_sbom ALL DEPENDS ${output})
  install(FILES ${output} DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component})
endfunction()

# Puts the licence, the changes and, as Debian's own packages have it, the copyright into a package's documents; of
# programs, what they contain.
function(granada_install_documents component package)
  granada_install_sbom(${component} ${package} ${ARGN})
  set(folder ${PROJECT_BINARY_DIR}/packages/${package})
  add_custom_command(OUTPUT ${folder}/changelog.gz ${folder}/copyright
    COMMAND ${PROJECT_SOURCE_DIR}/packages/make_documents ${PROJECT_SOURCE_DIR} ${PROJECT_VERSION} ${GRANADA_DATE} ${folder}
    DEPENDS ${PROJECT_SOURCE_DIR}/CHANGELOG.md ${PROJECT_SOURCE_DIR}/packages/copyright
      ${PROJECT_SOURCE_DIR}/packages/make_documents VERBATIM)
  add_custom_target(${package}_documents ALL DEPENDS ${folder}/changelog.gz ${folder}/copyright)
  install(FILES ${folder}/changelog.gz ${folder}/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package}
    COMPONENT ${component})
endfunction()

# Describes the packages. It is called once, after all that is installed was named.
macro(granada_define_packages)
  granada_install_format_manual(grf "text format of scenes with a BRDF per face" grf/FORMAT.md)
  granada_install_format_manual(op "render options of bpt" renderer/OPTIONS.md)
  granada_install_documents(granada granada bpt grfconvert)
  granada_install_documents(samples granada-samples)
  granada_install_documents(dev libgranada-dev)
  install(FILES packages/dev/lintian-overrides DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides
    RENAME libgranada-dev COMPONENT dev)

  set(CPACK_GENERATOR DEB)
  set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
  set(CPACK_PACKAGE_CONTACT "Granada maintainers <granada@packages.debian.org>")
  set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_STRIP_FILES ON)
  set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
    WORLD_READ WORLD_EXECUTE)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_ALL granada samples dev)
  set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
  set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

  set(CPACK_DEBIAN_GRANADA_PACKAGE_NAME granada)
  set(CPACK_DEBIAN_GRANADA_DESCRIPTION "path tracer and converter for scenes with exact reflectance
 GRF is a text format of scenes whose faces carry a BRDF of many
 models, a sampling scheme, a colour and emitted light. The path tracer
 bpt renders them, measures what accuracy costs in time and shows which
 effects a scene calls for; grfconvert converts them from and to OBJ,
 PLY, glTF, 3DS, pbrt, Mitsuba and other formats.")
  set(CPACK_DEBIAN_GRANADA_PACKAGE_SUGGESTS "granada-wannabe, granada-samples, nats-server")

  set(CPACK_DEBIAN_SAMPLES_PACKAGE_NAME granada-samples)
  set(CPACK_DEBIAN_SAMPLES_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_SAMPLES_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_SAMPLES_DESCRIPTION "sample scenes for the path tracer bpt
 Scenes in the format GRF with their render options: the Cornell box,
 spheres of all BRDF models, a garden, a teapot, studies of sampling,
 and the environment maps that light them.")
  set(CPACK_DEBIAN_SAMPLES_PACKAGE_RECOMMENDS granada)

  set(CPACK_DEBIAN_DEV_PACKAGE_NAME libgranada-dev)
  set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
  set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_DEV_DESCRIPTION "libraries for scenes with exact reflectance
 Static libraries and headers in C++20: grf reads and writes scenes in
 the text format GRF, reflectance has BRDF models and sampling schemes,
 converters reads and writes other formats. CMake finds them by
 find_package(granada), and pkg-config as granada-converters.")
  set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libassimp-dev, libdraco-dev, libfmt-dev, libimath-dev, libmeshoptimizer-dev, \
libopenexr-dev, libopenmesh-dev, libpng-dev, libtbb-dev, libtinygltf-dev, libturbojpeg0-dev, libwebp-dev, zlib1g-dev")

  if(TARGET python_module)
    granada_install_documents(python python3-granada)
    list(APPEND CPACK_COMPONENTS_ALL python)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-granada)
    set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
    set(CPACK_DEBIAN_PYTHON_DESCRIPTION "scenes, BRDFs and renders over NumPy arrays
 The module granada reads, checks, converts and writes scenes with
 exact reflectance, evaluates and samples their BRDFs over arrays, and
 renders images to arrays.")
    math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
    set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
      ${PROJECT_SOURCE_DIR}/packages/python/postinst ${PROJECT_SOURCE_DIR}/packages/python/prerm)
  endif()

  if(TARGET wannabe)
    granada_install_documents(wannabe granada-wannabe wannabe)
    list(APPEND CPACK_COMPONENTS_ALL wannabe)
    set(CPACK_DEBIAN_WANNABE_PACKAGE_NAME granada-wannabe)
    set(CPACK_DEBIAN_WANNABE_DESCRIPTION "editor for scenes with exact reflectance
 wannabe imports models, assigns BRDFs, colours, textures and area
 lights to faces, shows a preview by path tracing while they are
 edited, and renders final images. Its study tools draw BRDFs, sampling
 schemes and what they cost.")
    set(CPACK_DEBIAN_WANNABE_PACKAGE_DEPENDS "granada (= ${PROJECT_VERSION}), qt6-qpa-plugins")
    set(CPACK_DEBIAN_WANNABE_PACKAGE_RECOMMENDS granada-samples)
  endif()
  include(CPack)
  # The time of all files in the packages, which the same sources make bit for bit.
  execute_process(COMMAND date --utc --date ${GRANADA_DATE} +%s
    OUTPUT_VARIABLE seconds OUTPUT_STRIP_TRAILING_WHITESPACE)
  add_custom_target(packages
    COMMAND ${CMAKE_COMMAND} -E env SOURCE_DATE_EPOCH=${seconds}
      ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
    COMMENT "Packing")
endmacro()
