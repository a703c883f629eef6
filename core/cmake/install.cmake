# cmake --install: headers, library, find_package(polylap) and pkg-config, all relocatable.
include(CMakePackageConfigHelpers)

set(POLYLAP_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/polylap")

install(DIRECTORY include/polylap DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" FILES_MATCHING PATTERN "*.hpp")
install(TARGETS polylap EXPORT polylap-targets)
install(EXPORT polylap-targets NAMESPACE polylap:: DESTINATION "${POLYLAP_CMAKE_DIR}")

configure_package_config_file(cmake/polylap-config.cmake.in polylap-config.cmake INSTALL_DESTINATION "${POLYLAP_CMAKE_DIR}")
write_basic_package_version_file(polylap-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/polylap-config.cmake" "${CMAKE_CURRENT_BINARY_DIR}/polylap-config-version.cmake"
        DESTINATION "${POLYLAP_CMAKE_DIR}")

file(RELATIVE_PATH POLYLAP_PC_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
string(REGEX REPLACE "/$" "" POLYLAP_PC_PREFIX "${POLYLAP_PC_PREFIX}")
configure_file(cmake/polylap.pc.in polylap.pc @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/polylap.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/polylap")

if(TARGET polylap_cli)
    install(TARGETS polylap_cli)
endif()
