// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "bridge/background_planner.hpp"
#include "bridge/guide.hpp"
#include "fairway/map/grid_overlay.hpp"
#include "fairway/perception/perception.hpp"

namespace fairway::bridge {

namespace {

constexpr double kRetryAfter = 0.5;  // [s], when there was no way

class MapGuide final : public Guide {
 public:
  MapGuide(const Settings& settings, const PilotOptions& options)
      : settings_(settings),
        options_(options),
        navigator_(settings) {}

  void set_map(const OccupancyGrid& map) override {
    map_ = BitGrid(map, unknown_cells(settings_.map));
    now_ = *map_;
    if (perception_) add_obstacles(perception_->grid().occupied(), now_);
    wants_plan_ = true;
  }

  void observe(const LidarScan& scan, const Eigen::Vector2d& position) override {
    if (!options_.use_scan || !map_) return;
    if (!perception_) perception_.emplace(settings_.perception, options_.max_beams, position);
    perception_->observe(scan, position, settings_.robot.radius);
    now_ = *map_;
    add_obstacles(perception_->grid().occupied(), now_);
  }

  void set_goal(const Goal& goal) override {
    goal_ = goal;
    ++goal_number_;
    wants_plan_ = true;
    plan_time_ = -std::numeric_limits<double>::infinity();
  }

  void cancel() override {
    goal_.reset();
    ++goal_number_;
    navigator_.cancel();
  }

  void reset(const Twist2& actual) override { navigator_.reset(actual); }

  NavigationStep update(const GuideInput& input) override {
    take_plan();
    ask_for_plan(input);
    ObstacleBoard board = input.board;
    if (options_.use_scan) {
      const double seen = perception_ ? perception_->time() : -kNever;
      const MovingObstacles tracked = this->tracked();
      board.set_detections("own", {.obstacles = {tracked.begin(), tracked.end()}, .time = seen});
    }
    const SeenObstacles moving = board.collect(input.time);
    NavigationInput in{.time = input.time,
                       .pose = input.pose,
                       .pose_time = input.pose_time,
                       .obstacles = moving.obstacles,
                       .obstacles_time = moving.time,
                       .obstacles_due = board.has_detectors(),
                       .map = map_ ? &now_ : nullptr,
                       .map_time = input.time,
                       .fleet = input.fleet};
    if (options_.use_scan) in.map_time = perception_ ? perception_->time() : -kNever;
    const NavigationStep step = navigator_.update(in);
    wants_plan_ = wants_plan_ || step.wants_plan;
    return step;
  }

  [[nodiscard]] bool plan_is_current() const override { return plan_number_ == goal_number_; }
  [[nodiscard]] int plans_made() const override { return plans_made_; }
  [[nodiscard]] const Navigator& navigator() const override { return navigator_; }
  [[nodiscard]] MovingObstacles tracked() const override {
    return perception_ ? perception_->tracker().obstacles() : MovingObstacles{};
  }

 private:
  static constexpr double kNever = 1e9;  // [s] ago

  void take_plan() {
    std::optional<Plan> plan = planner_.take(!options_.plan_in_background);
    if (!plan || asked_number_ != goal_number_) return;
    // An old way is better than none while the scans may be wrong about a narrow place: whatever is
    // done on it is checked before it is sent.
    const bool old_way = plan_is_current() && navigator_.plan().usable();
    if (!plan->usable() && old_way) return;
    navigator_.follow(*std::move(plan));
    plan_number_ = goal_number_;
    ++plans_made_;
  }

  void ask_for_plan(const GuideInput& input) {
    const bool without = !navigator_.plan().usable() || !plan_is_current();
    if (!goal_ || !map_ || planner_.busy() || !(wants_plan_ || without)) return;
    if (input.time - plan_time_ < kRetryAfter || !is_finite(input.pose)) return;
    if (!(input.time - input.pose_time <= settings_.safety.pose_timeout)) return;
    planner_.start(
        {.obstacles = now_, .start = input.pose.position, .goal = *goal_, .settings = settings_});
    asked_number_ = goal_number_;
    plan_time_ = input.time;
    wants_plan_ = false;
  }

  Settings settings_;
  PilotOptions options_;
  std::optional<BitGrid> map_;
  BitGrid now_;  // the map and what was seen
  std::optional<Perception> perception_;
  Navigator navigator_;
  BackgroundPlanner planner_;
  std::optional<Goal> goal_;
  int goal_number_ = 0;
  int asked_number_ = 0;  // the goal that a plan was asked for last
  int plan_number_ = 0;   // the goal of the present plan
  int plans_made_ = 0;
  bool wants_plan_ = false;
  double plan_time_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

std::unique_ptr<Guide> make_map_guide(const Settings& settings, const PilotOptions& options) {
  return std::make_unique<MapGuide>(settings, options);
}

}  // namespace fairway::bridge
