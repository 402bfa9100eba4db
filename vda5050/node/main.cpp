// SPDX-License-Identifier: Apache-2.0
// fairway_vda5050: the robots of the built-in simulator.
#include "bases/simulated_fleet.hpp"
#include "node/program.hpp"

int main(int argc, char** argv) {
  using namespace fairway::vda5050;
  return run_program(argc, argv, RobotKind::Simulated, [](const NodeOptions& options) {
    return std::make_unique<SimulatedFleet>(options.scenario, options.physics);
  });
}
