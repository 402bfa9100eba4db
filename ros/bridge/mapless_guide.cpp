// SPDX-License-Identifier: Apache-2.0
#include "bridge/guide.hpp"
#include "fairway/mpc/interior_point/real_time_solver.hpp"
#include "fairway/navigation/mapless_navigator.hpp"

namespace fairway::bridge {

namespace {

class MaplessGuide final : public Guide {
 public:
  MaplessGuide(const Settings& settings, std::size_t max_beams, const Eigen::Vector2d& position)
      : solver_(settings.mpc),
        navigator_(settings, solver_, max_beams, position) {}

  void set_map(const OccupancyGrid& /*map*/) override {}

  void observe(const LidarScan& scan, const Eigen::Vector2d& position) override {
    navigator_.observe(scan, position);
  }

  void set_goal(const Goal& goal) override {
    navigator_.cancel();  // else it would go on to the old goal where there is no way to this one
    navigator_.set_goal(goal);
  }
  void cancel() override { navigator_.cancel(); }
  void reset(const Twist2& actual) override { navigator_.reset(actual); }

  NavigationStep update(const GuideInput& input) override {
    const NavigationStep step = navigator_.update(input.time, input.pose, input.pose_time);
    if (navigator_.planned()) ++plans_made_;
    return step;
  }

  // It plans inside its cycle, at the first one after a goal.
  [[nodiscard]] bool plan_is_current() const override { return true; }
  [[nodiscard]] int plans_made() const override { return plans_made_; }
  [[nodiscard]] const Navigator& navigator() const override { return navigator_.navigator(); }
  [[nodiscard]] MovingObstacles tracked() const override {
    return navigator_.perception().tracker().obstacles();
  }

 private:
  RealTimeSolver solver_;
  MaplessNavigator navigator_;
  int plans_made_ = 0;
};

}  // namespace

std::unique_ptr<Guide> make_mapless_guide(const Settings& settings,
                                          std::size_t max_beams,
                                          const Eigen::Vector2d& position) {
  return std::make_unique<MaplessGuide>(settings, max_beams, position);
}

}  // namespace fairway::bridge
