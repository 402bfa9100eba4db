# What each part of Fairway needs from apt; sourced by ./demo and ./test.
# build: compiler and build system; library: the core; tool: files, pictures, recordings and
# the command line; reference: the optional IPOPT solver; test: what only the tests need.
build_packages=(g++ cmake ninja-build pkg-config)
library_packages=(libeigen3-dev libexpected-dev)
tool_packages=(libyaml-cpp-dev libcli11-dev libfmt-dev nlohmann-json3-dev libcairo2-dev libgraphicsmagick++1-dev
  zlib1g-dev libzstd-dev)
reference_packages=(coinor-libipopt-dev)
test_packages=(libgtest-dev libbenchmark-dev python3 chromium)
# physics: MuJoCo, optional; its CMake config asks for qhull. OSMesa draws its pictures off-screen.
physics_packages=(libmujoco-dev libqhull-dev libosmesa6-dev)
# live page (Boost.Beast) and fairway reproduce (Boost.Math), optional.
live_packages=(libboost-dev)
