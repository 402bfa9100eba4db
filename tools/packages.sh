# The apt packages for each part of Fairway; sourced by ./demo, ./test and .ci.
# build: compiler, build system and compiler cache; library: the core; tool: files, pictures,
# recordings and the command line; reference: the optional IPOPT solver; test: for the tests only.
build_packages=(g++ cmake ninja-build pkg-config ccache)
library_packages=(libeigen3-dev libexpected-dev)
tool_packages=(libyaml-cpp-dev libcli11-dev libfmt-dev nlohmann-json3-dev libcairo2-dev libgraphicsmagick++1-dev
  zlib1g-dev libzstd-dev)
reference_packages=(coinor-libipopt-dev)
test_packages=(libgtest-dev libbenchmark-dev python3 chromium)
# physics: MuJoCo, optional; its CMake config requires qhull. OSMesa draws its pictures off-screen.
physics_packages=(libmujoco-dev libqhull-dev libosmesa6-dev)
# live page (Boost.Beast) and fairway reproduce (Boost.Math), optional.
live_packages=(libboost-dev)
# ROS 1 nodes and their tests, optional; the Python packages are for the tests and the tools.
ros1_packages=(libroscpp-dev libtf2-ros-dev libactionlib-dev libmove-base-msgs-dev
  libdynamic-reconfigure-config-init-mutex-dev libnav-msgs-dev libsensor-msgs-dev libgeometry-msgs-dev
  libvisualization-msgs-dev libdiagnostic-msgs-dev libactionlib-msgs-dev libstd-msgs-dev libros-rosgraph-msgs-dev
  python3-roslaunch python3-rostopic python3-rosbag python3-actionlib python3-move-base-msgs
  python3-dynamic-reconfigure python3-diagnostic-msgs python3-nav-msgs python3-sensor-msgs
  python3-visualization-msgs python3-tf2-msgs python3-rosparam)
# ROS 2 on the wire, optional; iproute2 makes the networks for its test.
dds_packages=(cyclonedds-dev cyclonedds-tools iproute2)
# The VDA 5050 program, optional; a broker and Python packages for its test.
vda5050_packages=(libmosquitto-dev mosquitto mosquitto-clients python3-paho-mqtt python3-jsonschema)
# The Python package, optional: numpy to use it; pytest, mypy and matplotlib for its tests.
python_packages=(python3-dev pybind11-dev python3-numpy python3-venv python3-pip python3-pytest python3-matplotlib
  mypy)
# The page that runs Fairway in a browser, optional.
browser_packages=(emscripten nodejs)
# Debian packages of Fairway, optional; lintian checks them.
package_packages=(dpkg-dev file lintian)
# The checks of .ci; the formatter's version is pinned, because it determines the result.
format_packages=(git clang-format-14)
tidy_packages=(git clang clang-tidy)
fuzz_packages=(clang libclang-rt-14-dev libgtest-dev)
