# An overlay port: vcpkg install fairway --overlay-ports=packaging/vcpkg
# It builds the sources around this file: the core and the simulation. Files, pictures and the tool
# need libraries that are not in this port's manifest, and are left out.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)

set(off "")
foreach(part APPS SERVER REPRODUCTION PHYSICS TESTS EXAMPLES ROS PYTHON)
  list(APPEND off -DFAIRWAY_BUILD_${part}=OFF)
endforeach()
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS ${off} -DFAIRWAY_COMPILER_CACHE=OFF -DCMAKE_DISABLE_FIND_PACKAGE_yaml-cpp=ON
          -DCMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/fairway)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
