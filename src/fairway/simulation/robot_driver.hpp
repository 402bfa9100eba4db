// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "fairway/navigation/navigator.hpp"
#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/world.hpp"

namespace fairway {

struct RobotResult;

/// What drives one robot of an episode: a navigator, and what tells it about the world.
class RobotDriver {
 public:
  RobotDriver() = default;
  RobotDriver(const RobotDriver&) = delete;
  RobotDriver& operator=(const RobotDriver&) = delete;
  virtual ~RobotDriver() = default;

  /// When `measure` wants to be called next [s]; infinite for never.
  [[nodiscard]] virtual double next_measurement() const = 0;

  /// Looks at the world between two cycles.
  virtual void measure(const World& world) = 0;

  /// One control cycle at the world's time.
  [[nodiscard]] virtual NavigationStep drive(const World& world) = 0;

  /// The plan that is being followed.
  [[nodiscard]] virtual const Plan& plan() const = 0;
};

/// What all drivers of an episode share. Everything outlives them.
struct DriverContext {
  const Scenario& scenario;
  const PreparedMap& map;
  Planner& planner;
  ControlSolver& solver;
  const std::function<double()>& clock;  ///< empty: nothing is timed
};

/// Makes the driver that the scenario's sensing asks for. Times go to `result`, which outlives it.
[[nodiscard]] std::unique_ptr<RobotDriver> make_driver(const DriverContext& context,
                                                       const World& world,
                                                       std::size_t robot,
                                                       RobotResult& result);

}  // namespace fairway
