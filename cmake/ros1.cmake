# Finds Debian's ROS 1 packages by pkg-config, because their own CMake files would load catkin,
# which takes over testing. Defines the target fairway::ros1, or sets ROS1_MISSING to the missing
# packages.
find_package(PkgConfig QUIET)
set(ros1_message_packages actionlib_msgs diagnostic_msgs dynamic_reconfigure geometry_msgs
    move_base_msgs nav_msgs rosgraph_msgs sensor_msgs std_msgs visualization_msgs)
set(ROS1_MISSING "")
if(PkgConfig_FOUND)
  pkg_check_modules(ros1 QUIET IMPORTED_TARGET roscpp tf2_ros actionlib dynamic_reconfigure
                    ${ros1_message_packages})
endif()
if(NOT ros1_FOUND)
  set(ROS1_MISSING "libroscpp-dev libtf2-ros-dev libactionlib-dev libmove-base-msgs-dev "
      "libdynamic-reconfigure-config-init-mutex-dev and their message packages")
  list(JOIN ROS1_MISSING "" ROS1_MISSING)
  return()
endif()

# Many of the packaged message headers, and those for serialisation, use allocator::rebind, which
# C++20 has removed. Copies of these headers with allocator_traits precede them in the include path.
set(ros1_headers ${PROJECT_BINARY_DIR}/ros1_headers)
pkg_get_variable(prefix roscpp prefix)
foreach(package ros ${ros1_message_packages})
  file(GLOB headers ${prefix}/include/${package}/*.h)
  foreach(header ${headers})
    get_filename_component(name ${header} NAME)
    file(READ ${header} text)
    string(FIND "${text}" "ContainerAllocator::template rebind<" found)
    if(found GREATER -1)
      string(REPLACE "ContainerAllocator::template rebind<"
             "std::allocator_traits<ContainerAllocator>::template rebind_alloc<" text "${text}")
      string(REPLACE ">::other" ">" text "${text}")
      string(REGEX REPLACE "#include \"([a-z_]+\\.h)\"" "#include <${package}/\\1>" text "${text}")
      file(CONFIGURE OUTPUT ${ros1_headers}/${package}/${name} CONTENT "${text}" @ONLY)
    endif()
  endforeach()
endforeach()

add_library(fairway_ros1_interface INTERFACE)
add_library(fairway::ros1 ALIAS fairway_ros1_interface)
target_include_directories(fairway_ros1_interface SYSTEM INTERFACE ${ros1_headers})
target_link_libraries(fairway_ros1_interface INTERFACE PkgConfig::ros1)
