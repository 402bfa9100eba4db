// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/body_driver.hpp"

#include <optional>

#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/navigation/facade/obstacle_merge.hpp"
#include "fairway/simulation/episode.hpp"
#include "fairway/simulation/lidar_senses.hpp"

namespace fairway {

namespace {

class BodyDriver final : public RobotDriver {
 public:
  BodyDriver(const DriverContext& context,
             const World& world,
             std::size_t robot,
             RobotResult& result)
      : context_(context),
        robot_(robot),
        result_(result),
        lidar_(context.scenario.sensing.sensing == Sensing::Lidar),
        pose_(context.scenario, world, robot),
        own_map_(!lidar_ && !context.scenario.zones.empty()),
        navigator_(
            lidar_ || own_map_
                ? BodyNavigator(context.settings, world.model_of(robot)->model)
                : BodyNavigator(context.settings, world.model_of(robot)->model, context.map)) {
    if (own_map_) navigator_.set_map(context.map.obstacles);
    if (!context.scenario.zones.empty()) navigator_.set_zones(context.scenario.zones);
    if (lidar_)
      senses_.emplace(context.scenario.sensing, world, robot, context.scenario.seed + robot);
    const BodyRobot& actual = *world.model_of(robot);
    navigator_.reset(actual.twist(), actual.input.turn);
    navigator_.lend_clock(context.clock);
    tell(world);
  }

  [[nodiscard]] double next_measurement() const override {
    return senses_ ? senses_->next_scan() : pose_.next_measurement();
  }
  void measure(const World& world) override {
    if (senses_) senses_->measure(world);
    pose_.measure(world);
  }
  void replace_last(const Twist2& sent) override {
    navigator_.replace_last({.linear = sent.linear, .angular = sent.angular});
  }
  [[nodiscard]] const Plan& plan() const override { return navigator_.plan(); }
  [[nodiscard]] StepExplanation explain(const NavigationStep& /*step*/,
                                        double /*speed*/) const override {
    if (navigator_.explanation().empty()) return {};
    return {.kind = StepExplanation::Kind::Path, .text = navigator_.explanation()};
  }
  [[nodiscard]] LimitMark mark(const NavigationStep& /*step*/) const override { return {}; }
  void tell_standing(const World& world) override {
    look_around(world.time());
    tell(world);
  }

  [[nodiscard]] DrivenCycle drive(const World& world) override {
    const double begin = now();
    look_around(world.time());
    const double before = now();
    if (lidar_ && context_.clock) result_.sense_seconds.push_back(before - begin);
    const Measurements measured = measurements(world);
    const NavigationStep step = navigator_.update(measured);
    const double seconds = now() - (lidar_ ? begin : before) - navigator_.planning_seconds();
    note_planning();
    tell(world);
    NavigationInput input = input_of(measured);
    input.map = navigator_.obstacles();
    return {.input = input,
            .step = step,
            .seconds = seconds,
            .new_plan = navigator_.follows_new_plan(),
            .occupied = lidar_ ? navigator_.obstacles() : nullptr};
  }

  bool head_for(const Goal& goal, const World& world) override {
    navigator_.set_goal(goal);
    return !lidar_ && plan_now(world);
  }

  bool cancel(const World& /*world*/) override {
    navigator_.cancel();
    return true;
  }
  bool take_plan(const World& /*world*/) override { return false; }

  bool note_map_change(const World& world) override {
    if (lidar_) return false;
    if (own_map_) {
      navigator_.set_map(context_.map.obstacles);
    } else {
      navigator_.map_changed();
    }
    return plan_now(world);
  }

 private:
  [[nodiscard]] double now() const { return context_.clock ? context_.clock() : 0.0; }

  [[nodiscard]] Measurements measurements(const World& world) {
    if (lidar_) return {.time = world.time(), .pose = senses_->pose()};
    return measure_on_map(world, robot_, pose_.pose(world), context_.radio, seen_);
  }

  // Robots that know the map publish their motion.
  void tell(const World& world) {
    if (lidar_ || !context_.radio.model().on) return;
    context_.radio.tell(robot_, navigator_.share(static_cast<std::uint32_t>(robot_), world.time(),
                                                 pose_.pose(world)));
  }

  // Takes over the scans that have become available.
  void look_around(double time) {
    pose_.locate(time);
    if (!senses_) return;
    senses_->deliver(time, [this](const LidarScan& scan, const Eigen::Vector2d& position) {
      navigator_.observe(scan, position);
      if (context_.observer != nullptr)
        context_.observer->on_scan({.robot = robot_, .scan = scan, .position = position});
    });
  }

  [[nodiscard]] bool plan_now(const World& world) {
    const bool new_plan = navigator_.plan_now(measurements(world));
    note_planning();
    return new_plan;
  }

  void note_planning() {
    if (context_.clock && navigator_.planned())
      result_.plan_seconds.push_back(navigator_.planning_seconds());
  }

  DriverContext context_;
  std::size_t robot_;
  RobotResult& result_;
  bool lidar_;
  MeasuredPose pose_;
  bool own_map_;  // with the zones in the form for a body
  BodyNavigator navigator_;
  std::optional<LidarSenses> senses_;
  std::vector<MovingObstacle> seen_;
};

}  // namespace

std::unique_ptr<RobotDriver> make_body_driver(const DriverContext& context,
                                              const World& world,
                                              std::size_t robot,
                                              RobotResult& result) {
  return std::make_unique<BodyDriver>(context, world, robot, result);
}

}  // namespace fairway
