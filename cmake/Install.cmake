# SPDX-License-Identifier: GPL-3.0-or-later
# What others need to use Ductus: the program, the library with its headers and data, and the files by which pkg-config
# and CMake's find_package() find it.
include(CMakePackageConfigHelpers)
set(ductus_package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ductus)

# The program finds its library wherever the whole tree is put.
file(RELATIVE_PATH ductus_library_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(ductus_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${ductus_library_from_program}")

install(TARGETS ductus EXPORT ductusTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(TARGETS ductus_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/ductus DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h")
install(FILES ${CMAKE_BINARY_DIR}/include/ductus/version.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ductus)
install(DIRECTORY ${DUCTUS_BUILD_DATA}/hands ${DUCTUS_BUILD_DATA}/styles DESTINATION ${CMAKE_INSTALL_DATADIR}/ductus)
install(FILES ${CMAKE_BINARY_DIR}/share/man/man1/ductus.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
foreach(script bash-completion/completions/ductus zsh/site-functions/_ductus fish/vendor_completions.d/ductus.fish)
  get_filename_component(folder ${script} DIRECTORY)
  install(FILES ${CMAKE_BINARY_DIR}/share/${script} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT ductusTargets NAMESPACE ductus:: DESTINATION ${ductus_package_folder})
configure_package_config_file(cmake/ductusConfig.cmake.in ${CMAKE_BINARY_DIR}/ductusConfig.cmake
                              INSTALL_DESTINATION ${ductus_package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/ductusConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/ductusConfig.cmake ${CMAKE_BINARY_DIR}/ductusConfigVersion.cmake
        DESTINATION ${ductus_package_folder})

file(RELATIVE_PATH ductus_prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
file(RELATIVE_PATH ductus_library_from_prefix ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH ductus_include_from_prefix ${CMAKE_INSTALL_PREFIX} ${CMAKE_INSTALL_FULL_INCLUDEDIR})
configure_file(cmake/ductus.pc.in ${CMAKE_BINARY_DIR}/ductus.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/ductus.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
