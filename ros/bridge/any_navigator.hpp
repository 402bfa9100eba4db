// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "fairway/navigation/body/body_navigator.hpp"
#include "fairway/navigation/facade/map_navigator.hpp"
#include "fairway/navigation/facade/mapless_navigator.hpp"

namespace fairway::bridge {

/// One of the library's navigators behind one interface.
class AnyNavigator {
 private:
  template <typename Visitor>
  decltype(auto) visit(Visitor&& visitor) {
    return std::visit(std::forward<Visitor>(visitor), navigator_);
  }
  template <typename Visitor>
  decltype(auto) visit(Visitor&& visitor) const {
    return std::visit(std::forward<Visitor>(visitor), navigator_);
  }

 public:
  explicit AnyNavigator(MapNavigator navigator) : navigator_(std::move(navigator)) {}
  explicit AnyNavigator(MaplessNavigator navigator) : navigator_(std::move(navigator)) {}

  explicit AnyNavigator(BodyNavigator navigator) : navigator_(std::move(navigator)) {}

  /// Ignored by a navigator without a map.
  void set_map(const OccupancyGrid& map) {
    if (auto* const with_map = std::get_if<MapNavigator>(&navigator_)) with_map->set_map(map);
    if (auto* const body = std::get_if<BodyNavigator>(&navigator_)) body->set_map(map);
  }
  [[nodiscard]] bool observe(const LidarScan& scan, const Eigen::Vector2d& position) {
    return visit([&](auto& navigator) { return navigator.observe(scan, position); });
  }
  void set_goal(const Goal& goal) {
    visit([&](auto& navigator) { navigator.set_goal(goal); });
  }
  void follow(const Path& path, const std::optional<double>& goal_heading) {
    visit([&](auto& navigator) { navigator.follow(path, goal_heading); });
  }
  /// A path of poses, which only a BodyNavigator follows.
  void follow(const PosePath& path) {
    if (auto* const body = std::get_if<BodyNavigator>(&navigator_)) body->follow(path);
  }
  /// Where a BodyNavigator is on its path; none of the others.
  [[nodiscard]] std::optional<PathPlace> place_on_path() const {
    const auto* const body = std::get_if<BodyNavigator>(&navigator_);
    return body != nullptr ? body->place_on_path() : std::nullopt;
  }
  void set_zones(const Zones& zones) {
    visit([&](auto& navigator) {
      if constexpr (requires { navigator.set_zones(zones); }) navigator.set_zones(zones);
    });
  }
  void cancel() {
    visit([](auto& navigator) { navigator.cancel(); });
  }
  /// `steering` is the angle of the steered wheel of a car or tricycle [rad].
  void reset(const PlanarTwist& actual, double steering) {
    if (auto* const body = std::get_if<BodyNavigator>(&navigator_)) {
      body->reset(actual, steering);
      return;
    }
    const Twist2 twist{.linear = actual.linear, .angular = actual.angular};
    visit([&](auto& navigator) {
      if constexpr (requires { navigator.reset(twist); }) navigator.reset(twist);
    });
  }
  /// The command that was really sent in the last cycle; see MapNavigator::replace_last.
  void replace_last(const PlanarTwist& sent, double steering) {
    if (auto* const body = std::get_if<BodyNavigator>(&navigator_)) {
      body->replace_last(sent, steering);
      return;
    }
    const Twist2 twist{.linear = sent.linear, .angular = sent.angular};
    visit([&](auto& navigator) {
      if constexpr (requires { navigator.replace_last(twist); }) navigator.replace_last(twist);
    });
  }
  void set_settings(const Settings& settings) {
    visit([&](auto& navigator) { navigator.set_settings(settings); });
  }
  [[nodiscard]] NavigationStep update(const Measurements& measurements) {
    return visit([&](auto& navigator) { return navigator.update(measurements); });
  }
  [[nodiscard]] const Plan& plan() const {
    return visit([](const auto& navigator) -> const Plan& { return navigator.plan(); });
  }
  [[nodiscard]] bool plan_is_current() const {
    return visit([](const auto& navigator) { return navigator.plan_is_current(); });
  }
  /// Why there is no usable plan, with numbers where they are known.
  [[nodiscard]] std::string why_no_plan() const {
    return visit([](const auto& navigator) -> std::string {
      if constexpr (requires { navigator.explanation(); }) {
        if (!navigator.explanation().empty()) return navigator.explanation();
      }
      return navigator.plan().reason();
    });
  }
  /// Why the robot does not drive, or not faster, in one sentence with numbers; empty if nothing is
  /// wrong or known. As MapNavigator::explain.
  [[nodiscard]] std::string explain(const NavigationStep& step, double speed) const {
    return visit([&](const auto& navigator) -> std::string {
      if constexpr (requires { navigator.explain(step, speed); })
        return navigator.explain(step, speed).text;
      return {};
    });
  }
  [[nodiscard]] bool follows_new_plan() const {
    return visit([](const auto& navigator) { return navigator.follows_new_plan(); });
  }
  [[nodiscard]] MovingObstacles tracked() const {
    return visit([](const auto& navigator) { return navigator.tracked(); });
  }
  /// None of a BodyNavigator, which the fleet sees as a moving obstacle.
  [[nodiscard]] std::optional<SharedMotion> share(std::uint32_t robot,
                                                  double time,
                                                  const Pose2& pose) const {
    return visit([&](const auto& navigator) -> std::optional<SharedMotion> {
      if constexpr (requires { navigator.share(robot, time, pose); })
        return navigator.share(robot, time, pose);
      return std::nullopt;
    });
  }

 private:
  std::variant<MapNavigator, MaplessNavigator, BodyNavigator> navigator_;
};

}  // namespace fairway::bridge
