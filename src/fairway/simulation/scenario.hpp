// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"
#include "fairway/geometry/robot_model.hpp"
#include "fairway/map/occupancy_grid.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/planning/planner.hpp"
#include "fairway/simulation/fleet_radio.hpp"
#include "fairway/simulation/people/moving_body.hpp"
#include "fairway/simulation/sensors/sensing.hpp"
#include "fairway/simulation/unicycle_robot.hpp"
#include "fairway/zones/zones.hpp"

namespace fairway {

/// One robot of a scenario. Its body and limits are in the settings, unless it has a model.
struct RobotTask {
  std::string name = "robot";
  Pose2 start;
  Goal goal;
  /// What its base really does, where that is not what the settings say.
  std::optional<UnicycleLimits> actuation{};
  /// Its outline and base, where it is driven by a BodyNavigator.
  std::optional<RobotModel> model{};
  bool idle = false;  ///< has no goal until it receives one during the run; `goal` is not used
};

/// Model that moves the robots.
enum class Engine : std::uint8_t {
  Unicycle,  ///< exact unicycles with limited acceleration
  Mujoco,    ///< rigid bodies on wheels that slip; optional, see docs/physics.md
};

[[nodiscard]] constexpr std::array<const char*, 2> setting_names(Engine /*type*/) noexcept {
  return {"unicycle", "mujoco"};
}

/// Everything that a simulated run depends on: equal scenarios give equal bits.
struct Scenario {
  std::string name;
  OccupancyGrid map{GridFrame{.width = 1, .height = 1, .resolution = 1.0, .origin = {}}};
  Settings settings;  ///< of every robot
  std::vector<RobotTask> robots;
  std::vector<MovingBody> bodies;
  Zones zones;                       ///< for every robot
  SensingModel sensing;              ///< what each robot knows of the world
  Engine engine = Engine::Unicycle;  ///< the caller of run_episode makes it (EpisodeHooks::physics)
  RadioModel radio;                  ///< how robots communicate
  double time_limit = 120.0;         ///< [s]
  std::uint64_t seed = 1;            ///< of all random numbers
};

/// Whether any robot has a model.
[[nodiscard]] bool has_models(const Scenario& scenario) noexcept;

/// Whether robots with models can be simulated as the scenario says: they know the map and move by
/// their kinematics.
[[nodiscard]] Expected<void> check_models(const Scenario& scenario);

/// Sets the settings of the robots from the first model, as far as they can express it. These are
/// speeds, accelerations, and discs that cover the outline, which pages and pictures draw. All
/// robots publish their motion with their true outline.
void describe_models(Scenario& scenario);

}  // namespace fairway
