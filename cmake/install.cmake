# cmake --install: the program, the shared library with its headers, modules and data, and find_package(Solitaire).
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Solitaire)

install(TARGETS solitaire_shared EXPORT SolitaireTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY library/include/solitaire DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(DIRECTORY assets solitaire/std DESTINATION ${SOLITAIRE_DATA_INSTALL_DIR})
install(EXPORT SolitaireTargets NAMESPACE Solitaire:: FILE SolitaireConfig.cmake DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SolitaireConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SolitaireConfigVersion.cmake DESTINATION ${package})
