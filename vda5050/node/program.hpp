// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "bases/robot_bases.hpp"
#include "node/node_options.hpp"

namespace fairway::vda5050 {

/// Makes the robots that the options name. @throws std::exception if they cannot be made.
using BasesMaker = std::function<std::unique_ptr<RobotBases>(const NodeOptions& options)>;

/// Runs the program until it is asked to end. @return its exit code: 0, or 2 for bad input.
int run_program(int argc, char** argv, RobotKind kind, const BasesMaker& make_bases);

}  // namespace fairway::vda5050
