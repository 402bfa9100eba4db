include(CMakePackageConfigHelpers)

set(FAIRWAY_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/fairway)
set(fairway_targets fairway)
foreach(optional fairway_simulation fairway_io fairway_ipopt)
  if(TARGET ${optional})
    list(APPEND fairway_targets ${optional})
  endif()
endforeach()
install(TARGETS ${fairway_targets} EXPORT fairway-targets FILE_SET HEADERS)
install(EXPORT fairway-targets NAMESPACE fairway:: DESTINATION ${FAIRWAY_CONFIG_DIR})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/fairway-config.cmake.in fairway-config.cmake
                              INSTALL_DESTINATION ${FAIRWAY_CONFIG_DIR})
write_basic_package_version_file(fairway-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fairway-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/fairway-config-version.cmake
        DESTINATION ${FAIRWAY_CONFIG_DIR})
if(TARGET fairway_tool)
  install(TARGETS fairway_tool)
endif()
