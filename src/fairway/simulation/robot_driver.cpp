// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/robot_driver.hpp"

#include <limits>

#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"
#include "fairway/navigation/facade/obstacle_merge.hpp"
#include "fairway/perception/perception.hpp"
#include "fairway/simulation/body_driver.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/lidar_senses.hpp"

namespace fairway {

namespace {

double now(const DriverContext& context) { return context.clock ? context.clock() : 0.0; }

// Knows the map and all moving obstacles, and its pose as the scenario says.
class MapDriver final : public RobotDriver {
 public:
  MapDriver(const DriverContext& context,
            const World& world,
            std::size_t robot,
            RobotResult& result)
      : context_(context),
        robot_(robot),
        result_(result),
        pose_(context.scenario, world, robot),
        navigator_(
            context.settings.planning.background
                ? MapNavigator(context.settings, context.solver)
                : MapNavigator(context.settings, context.map, context.planner, context.solver)) {
    if (context.settings.planning.background) {
      navigator_.set_map(context.map.obstacles);
      navigator_.set_zones(context.scenario.zones);
    }
    navigator_.reset(world.robots()[robot].twist);
    navigator_.lend_clock(context.clock);
    tell(world);
  }

  [[nodiscard]] double next_measurement() const override { return pose_.next_measurement(); }
  void measure(const World& world) override { pose_.measure(world); }
  [[nodiscard]] const Plan& plan() const override { return navigator_.navigator().plan(); }
  [[nodiscard]] LimitMark mark(const NavigationStep& step) const override {
    return limit_mark(navigator_.navigator(), step);
  }
  [[nodiscard]] StepExplanation explain(const NavigationStep& step, double speed) const override {
    return navigator_.explain(step, speed);
  }

  [[nodiscard]] DrivenCycle drive(const World& world) override {
    const double begin = now(context_);
    pose_.locate(world.time());
    if (context_.clock && pose_.by_scans()) result_.sense_seconds.push_back(now(context_) - begin);
    Measurements measured = measure_on_map(world, robot_, pose_.pose(world), context_.radio, seen_);
    measured.entrances = context_.entrances;
    const double before = now(context_);
    const NavigationStep step = navigator_.update(measured);
    const double planning = navigator_.planning_seconds();
    const DrivenCycle cycle{.input = navigator_.input(),
                            .step = step,
                            .seconds = now(context_) - before - planning,
                            .new_plan = navigator_.follows_new_plan()};
    note_planning();
    tell(world);
    return cycle;
  }

  void replace_last(const Twist2& sent) override { navigator_.replace_last(sent); }

  void tell_standing(const World& world) override {
    navigator_.reset();
    tell(world);
  }

  bool head_for(const Goal& goal, const World& world) override {
    // A robot that had arrived was not informed of changes since then.
    if (context_.settings.planning.background) navigator_.set_map(context_.map.obstacles);
    navigator_.set_goal(goal);
    return plan_now(world);
  }

  bool cancel(const World& world) override {
    navigator_.cancel();
    tell(world);
    return true;
  }

  bool take_plan(const World& world) override {
    return context_.settings.planning.background && plan_now(world);
  }

  bool note_map_change(const World& world) override {
    if (context_.settings.planning.background) {
      navigator_.set_map(context_.map.obstacles);
    } else {
      navigator_.map_changed();
    }
    return plan_now(world);
  }

 private:
  bool plan_now(const World& world) {
    const bool new_plan = navigator_.plan_now({.time = world.time(), .pose = pose_.pose(world)});
    note_planning();
    return new_plan;
  }

  void note_planning() {
    if (context_.clock && navigator_.planned())
      result_.plan_seconds.push_back(navigator_.planning_seconds());
  }

  void tell(const World& world) {
    if (!context_.radio.model().on) return;
    context_.radio.tell(robot_, navigator_.share(static_cast<std::uint32_t>(robot_), world.time(),
                                                 pose_.pose(world)));
  }

  DriverContext context_;
  std::size_t robot_;
  RobotResult& result_;
  MeasuredPose pose_;
  MapNavigator navigator_;
  std::vector<MovingObstacle> seen_;
};

// Knows only its lidar scans and odometry. Its cycle covers all work from scans to command.
class LidarDriver final : public RobotDriver {
 public:
  LidarDriver(const DriverContext& context,
              const World& world,
              std::size_t robot,
              RobotResult& result)
      : context_(context),
        result_(result),
        senses_(context.scenario.sensing, world, robot, context.scenario.seed + robot),
        navigator_(context.settings, context.solver, world.robots()[robot].pose.position),
        robot_(robot) {
    if (!context.scenario.zones.empty()) navigator_.set_zones(context.scenario.zones);
    navigator_.reset(world.robots()[robot].twist);
  }

  void replace_last(const Twist2& sent) override { navigator_.replace_last(sent); }

  [[nodiscard]] double next_measurement() const override { return senses_.next_scan(); }
  void measure(const World& world) override { senses_.measure(world); }
  [[nodiscard]] const Plan& plan() const override { return navigator_.navigator().plan(); }
  [[nodiscard]] LimitMark mark(const NavigationStep& step) const override {
    return limit_mark(navigator_.navigator(), step);
  }
  [[nodiscard]] StepExplanation explain(const NavigationStep& step, double speed) const override {
    const std::string no_path = navigator_.explanation();
    if (!no_path.empty()) return {.kind = StepExplanation::Kind::Path, .text = no_path};
    return navigator_.explain(step, speed);
  }
  bool head_for(const Goal& goal, const World& /*world*/) override {
    navigator_.set_goal(goal);
    return false;
  }
  // A recording contains no cancelled goals of such robots; a new navigator without one is exact.
  bool cancel(const World& /*world*/) override { return false; }
  bool take_plan(const World& /*world*/) override { return false; }
  bool note_map_change(const World& /*world*/) override { return false; }
  void tell_standing(const World& world) override { look_around(world.time()); }

  [[nodiscard]] DrivenCycle drive(const World& world) override {
    const double before = now(context_);
    look_around(world.time());
    const double sensed = now(context_);
    const NavigationStep step = navigator_.update({.time = world.time(), .pose = senses_.pose()});
    const double after = now(context_);
    if (context_.clock) {
      result_.sense_seconds.push_back(sensed - before);
      if (navigator_.planned()) result_.plan_seconds.push_back(after - sensed);
    }
    return {.input = navigator_.input(),
            .step = step,
            .seconds = after - before,
            .new_plan = navigator_.follows_new_plan(),
            .occupied = &navigator_.perception().grid().occupied()};
  }

 private:
  // Takes over the scans that have become available.
  void look_around(double time) {
    senses_.deliver(time, [this](const LidarScan& scan, const Eigen::Vector2d& position) {
      navigator_.observe(scan, position);
      if (context_.observer != nullptr)
        context_.observer->on_scan({.robot = robot_, .scan = scan, .position = position});
    });
  }

  DriverContext context_;
  RobotResult& result_;
  LidarSenses senses_;
  MaplessNavigator navigator_;
  std::size_t robot_;
};

}  // namespace

Measurements measure_on_map(const World& world,
                            std::size_t robot,
                            const Pose2& pose,
                            FleetRadio& radio,
                            std::vector<MovingObstacle>& seen) {
  if (radio.model().on) {
    world.moving_bodies(seen);
  } else {
    world.moving_around(robot, seen);
  }
  Measurements measured{.time = world.time(),
                        .pose = pose,
                        .obstacles = seen,
                        .robot = static_cast<std::uint32_t>(robot)};
  if (radio.model().on) measured.fleet = radio.hear(robot, pose.position, world.time());
  return measured;
}

std::unique_ptr<RobotDriver> make_driver(const DriverContext& context,
                                         const World& world,
                                         std::size_t robot,
                                         RobotResult& result) {
  if (world.model_of(robot) != nullptr) return make_body_driver(context, world, robot, result);
  if (context.scenario.sensing.sensing == Sensing::Lidar) {
    return std::make_unique<LidarDriver>(context, world, robot, result);
  }
  return std::make_unique<MapDriver>(context, world, robot, result);
}

}  // namespace fairway
