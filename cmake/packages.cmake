# Debian packages: `cpack -G DEB` in the build's folder. Each package holds one or more of the
# components that install.cmake describes:
#   libfairway-dev         core and simulation
#   libfairway-io-dev      io
#   libfairway-ipopt-dev   ipopt
#   fairway                tool: with scenarios, manual and completion
#   python3-fairway        python
#   fairway-ros            ros1: the ROS 1 nodes
#   fairway-dds            dds: the nodes that speak ROS 2's protocol
# A package whose component is not built is left out.
if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()

set(CPACK_PACKAGE_NAME fairway)
set(CPACK_PACKAGE_VENDOR "The Fairway authors")
set(CPACK_PACKAGE_CONTACT "The Fairway authors <fairway@users.noreply.github.com>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package has its own
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_COMPONENTS_ALL "")
set(fairway_same_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

set(debian ${CMAKE_CURRENT_BINARY_DIR}/debian)
file(MAKE_DIRECTORY ${debian})
configure_file(${PROJECT_SOURCE_DIR}/packaging/debian/copyright ${debian}/copyright COPYONLY)
configure_file(${PROJECT_SOURCE_DIR}/packaging/debian/changelog ${debian}/changelog.Debian COPYONLY)
if(FAIRWAY_GZIP)
  execute_process(COMMAND ${FAIRWAY_GZIP} -9nfk ${debian}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
endif()

# fairway_package(<package> SECTION <section> SUMMARY <line> TEXT <lines> COMPONENTS <names>
#   [DEPENDS <packages>] [RECOMMENDS <packages>] [SUGGESTS <packages>] [PROGRAMS])
# PROGRAMS: it contains compiled programs, whose libraries become dependencies.
function(fairway_package package)
  cmake_parse_arguments(PARSE_ARGV 1 arg PROGRAMS "SECTION;SUMMARY;TEXT"
                        "COMPONENTS;DEPENDS;RECOMMENDS;SUGGESTS")
  # What only packages have: plain installations leave it out.
  foreach(file copyright changelog.Debian.gz)
    install(FILES ${debian}/${file} DESTINATION share/doc/${package} COMPONENT debian_${package} EXCLUDE_FROM_ALL)
  endforeach()
  string(TOUPPER ${package} key)
  foreach(component ${arg_COMPONENTS} debian_${package})
    string(TOUPPER ${component} upper)
    set(CPACK_COMPONENT_${upper}_GROUP ${package} PARENT_SCOPE)
  endforeach()
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${arg_COMPONENTS} debian_${package} PARENT_SCOPE)
  set(CPACK_COMPONENT_GROUP_${key}_DESCRIPTION ${arg_TEXT} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${package} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${arg_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${arg_SUMMARY}\n${arg_TEXT}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SHLIBDEPS ${arg_PROGRAMS} PARENT_SCOPE)
  foreach(relation DEPENDS RECOMMENDS SUGGESTS)
    list(JOIN arg_${relation} ", " packages)
    set(CPACK_DEBIAN_${key}_PACKAGE_${relation} "${packages}" PARENT_SCOPE)
  endforeach()
endfunction()

set(about "Fairway drives wheeled robots through clutter: from a map or lidar scans to\n\
a path, a corridor of free rectangles, model predictive control, and a\n\
velocity command with a proven stop behind it.\n")

# Programs that link a shared Fairway would need a package for it; nothing here needs one so far.
if(BUILD_SHARED_LIBS)
  message(STATUS "Debian packages are left out: they hold static libraries, and BUILD_SHARED_LIBS is on")
  return()
endif()

fairway_package(libfairway-dev SECTION libdevel COMPONENTS core simulation
  DEPENDS "libeigen3-dev (>= 3.4)" libexpected-dev
  SUMMARY "Safe corridors and predictive control for robots (development files)"
  TEXT "${about}.\nThis package contains the static libraries of the navigators and of the\nsimulation, their headers and the CMake package.")
if(TARGET fairway_io)
  fairway_package(libfairway-io-dev SECTION libdevel COMPONENTS io
    DEPENDS "libfairway-dev ${fairway_same_version}" pkg-config libyaml-cpp-dev libfmt-dev nlohmann-json3-dev
            zlib1g-dev libzstd-dev libcairo2-dev libgraphicsmagick++1-dev
    SUMMARY "Maps, settings and pictures of Fairway (development files)"
    TEXT "${about}.\nThis package contains the static library that reads and writes maps,\nsettings, scenarios, recordings and pictures.")
endif()
if(TARGET fairway_ipopt)
  fairway_package(libfairway-ipopt-dev SECTION libdevel COMPONENTS ipopt
    DEPENDS "libfairway-dev ${fairway_same_version}" coinor-libipopt-dev
    SUMMARY "Reference solver of Fairway (development files)"
    TEXT "${about}.\nThis package contains the static library that solves Fairway's control\nproblems with IPOPT.")
endif()
if(TARGET fairway_tool)
  fairway_package(fairway SECTION science COMPONENTS tool PROGRAMS
    SUMMARY "Plan, simulate and measure robots with safe corridors"
    TEXT "${about}.\nThis package contains the command line tool: plans, simulations, a live page\nin the browser, reports and benchmarks; with scenarios to begin with.")
endif()
if(TARGET fairway_python)
  get_target_property(minor fairway_python FAIRWAY_PYTHON_MINOR)
  math(EXPR next_minor "${minor} + 1")
  fairway_package(python3-fairway SECTION python COMPONENTS python PROGRAMS
    DEPENDS "python3 (>= 3.${minor})" "python3 (<< 3.${next_minor})" python3-numpy
    SUGGESTS python3-matplotlib
    SUMMARY "Safe corridors and predictive control for robots (Python 3)"
    TEXT "${about}.\nThis package contains the Python module.")
  set(CPACK_DEBIAN_PYTHON3-FAIRWAY_PACKAGE_CONTROL_EXTRA
      ${PROJECT_SOURCE_DIR}/packaging/debian/python3-fairway/postinst
      ${PROJECT_SOURCE_DIR}/packaging/debian/python3-fairway/prerm)
endif()
if(TARGET fairway_ros1)
  fairway_package(fairway-ros SECTION science COMPONENTS ros1 PROGRAMS
    RECOMMENDS python3-roslaunch ros-core SUGGESTS rviz
    SUMMARY "Navigation node for ROS 1 with safe corridors"
    TEXT "${about}.\nThis package contains the ROS 1 nodes: navigation and a simulator, with\nlaunch files.")
endif()
if(TARGET fairway_dds)
  fairway_package(fairway-dds SECTION science COMPONENTS dds PROGRAMS
    SUMMARY "Navigation node for ROS 2 over DDS with safe corridors"
    TEXT "${about}.\nThis package contains nodes that speak the protocol of ROS 2 without an\ninstallation of ROS 2: navigation, a simulator, and a sender of goals.")
endif()
include(CPack)
