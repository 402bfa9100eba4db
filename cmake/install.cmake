# Installation by component: `cmake --install BUILD --component core` installs the library for
# embedding and nothing else. find_package(fairway) finds the installed components.
#   core  fairway::fairway, its public headers, the CMake package, the licence
#   simulation, io, ipopt  the library of that name
#   tool  the fairway tool with its manual and completion, and the scenarios
#   python, ros1, dds  the Python package and the nodes; see their folders
include(CMakePackageConfigHelpers)

set(FAIRWAY_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/fairway)

# Each library has its own export, so that it can be installed without the others.
function(fairway_install target component)
  if(NOT TARGET ${target})
    return()
  endif()
  install(TARGETS ${target} EXPORT ${target}-targets
          ARCHIVE COMPONENT ${component} LIBRARY COMPONENT ${component}
          FILE_SET HEADERS COMPONENT ${component})
  install(EXPORT ${target}-targets NAMESPACE fairway:: DESTINATION ${FAIRWAY_CONFIG_DIR} COMPONENT ${component})
endfunction()
fairway_install(fairway core)
fairway_install(fairway_simulation simulation)
fairway_install(fairway_io io)
fairway_install(fairway_ipopt ipopt)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/fairway-config.cmake.in fairway-config.cmake
                              INSTALL_DESTINATION ${FAIRWAY_CONFIG_DIR})
write_basic_package_version_file(fairway-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/fairway-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/fairway-config-version.cmake
        DESTINATION ${FAIRWAY_CONFIG_DIR} COMPONENT core)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT core)
if(TARGET fairway_tool)
  install(TARGETS fairway_tool COMPONENT tool)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenarios DESTINATION ${CMAKE_INSTALL_DATADIR}/fairway COMPONENT tool)
  # `fairway --help` and its manual name these documents.
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/fairway COMPONENT tool)
  # The tool itself writes its manual and its completion, when it is installed.
  find_program(FAIRWAY_GZIP gzip)
  mark_as_advanced(FAIRWAY_GZIP)
  if(FAIRWAY_GZIP AND NOT CMAKE_CROSSCOMPILING)
    set(made ${CMAKE_CURRENT_BINARY_DIR}/manual)
    install(CODE "
      file(MAKE_DIRECTORY \"${made}\")
      foreach(page \"manual;fairway.1\" \"completion;bash;fairway\" \"completion;zsh;_fairway\")
        list(POP_BACK page file)
        execute_process(COMMAND \"$<TARGET_FILE:fairway_tool>\" \${page}
                        OUTPUT_FILE \"${made}/\${file}\" COMMAND_ERROR_IS_FATAL ANY)
      endforeach()
      execute_process(COMMAND \"${FAIRWAY_GZIP}\" -9nf \"${made}/fairway.1\" COMMAND_ERROR_IS_FATAL ANY)"
            COMPONENT tool)
    install(FILES ${made}/fairway.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tool)
    install(FILES ${made}/fairway DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tool)
    install(FILES ${made}/_fairway DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT tool)
  endif()
endif()

# Completion of the programs beside the tool: both shells read their options from --help.
foreach(program fairway_vda5050:tool fairway_vda5050_ros:ros1 fairway_vda5050_dds:dds fairway_dds_node:dds
                fairway_dds_simulator:dds fairway_dds_goal:dds)
  string(REPLACE ":" ";" program ${program})
  list(GET program 0 name)
  list(GET program 1 component)
  if(TARGET ${name})
    set(made ${CMAKE_CURRENT_BINARY_DIR}/completion)
    file(WRITE ${made}/${name} "complete -o filenames -F _longopt ${name}\n")
    file(WRITE ${made}/_${name} "#compdef ${name}\n_gnu_generic\n")
    install(FILES ${made}/${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT ${component})
    install(FILES ${made}/_${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT ${component})
  endif()
endforeach()
