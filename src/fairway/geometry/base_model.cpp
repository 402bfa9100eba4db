// SPDX-License-Identifier: Apache-2.0
#include "fairway/geometry/base_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace fairway {

namespace {

Expected<void> check(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return fail(std::string(key) + ": expected a number from " + std::to_string(low) + " to " +
              std::to_string(high) + ", found " + std::to_string(value));
}

struct Range {
  const char* key;
  double value;
  double low;
  double high;
};

Expected<void> check_all(std::initializer_list<Range> ranges) {
  for (const Range& r : ranges) {
    if (auto ok = check(r.key, r.value, r.low, r.high); !ok) return ok;
  }
  return {};
}

Expected<void> validate_wheels(const WheelLimit& wheels) {
  if (wheels.kind == WheelKind::None) return {};
  if (auto ok = check("speed_max", wheels.speed_max, 0.01, 100.0); !ok) return ok;
  if (wheels.kind == WheelKind::Differential) return check("track", wheels.track, 0.01, 20.0);
  if (wheels.kind == WheelKind::Mecanum) return check("half_sum", wheels.half_sum, 0.01, 20.0);
  if (wheels.kind != WheelKind::Swerve) return {};
  if (wheels.num_modules < 1 || wheels.num_modules > WheelLimit::kMaxModules)
    return fail("positions: expected 1 to 8, found " + std::to_string(wheels.num_modules));
  for (int i = 0; i < wheels.num_modules; ++i) {
    const Eigen::Vector2d& place = wheels.modules[static_cast<std::size_t>(i)];
    if (auto ok = check("positions", place.cwiseAbs().maxCoeff(), 0.0, 20.0); !ok) return ok;
  }
  return {};
}

}  // namespace

Expected<void> validate(const BaseModel& base) {
  constexpr double kFastest = 100.0;
  constexpr double kStrongest = 1000.0;
  if (auto ok = check_all({{"linear_min", base.linear_min, -kFastest, 0.0},
                           {"linear_max", base.linear_max, 0.01, kFastest},
                           {"angular_max", base.angular_max, 0.01, kFastest},
                           {"linear_acceleration", base.linear_acceleration, 0.01, kStrongest},
                           {"angular_acceleration", base.angular_acceleration, 0.01, kStrongest},
                           {"response_time", base.response_time, 0.0, 1.0}});
      !ok)
    return ok;
  if (is_steered(base)) {
    if (auto ok = check_all({{"wheelbase", base.wheelbase, 0.05, 50.0},
                             {"steering_max", base.steering_max, 0.01, 1.5},
                             {"steering_rate_max", base.steering_rate_max, 0.01, 100.0}});
        !ok)
      return ok;
  }
  if (base.kind == BaseKind::Omni) {
    if (auto ok =
            check_all({{"lateral_max", base.lateral_max, 0.01, kFastest},
                       {"lateral_acceleration", base.lateral_acceleration, 0.01, kStrongest}});
        !ok)
      return ok;
  }
  return validate_wheels(base.wheels);
}

double greatest_curvature(const BaseModel& base) noexcept {
  return std::tan(base.steering_max) / base.wheelbase;
}

double wheel_load(const BaseModel& base, const PlanarTwist& twist) noexcept {
  const WheelLimit& wheels = base.wheels;
  double fastest = 0.0;
  switch (wheels.kind) {
    case WheelKind::None:
      return 0.0;
    case WheelKind::Differential:
      fastest = std::abs(twist.linear) + 0.5 * wheels.track * std::abs(twist.angular);
      break;
    case WheelKind::Steered:
      fastest = std::hypot(twist.linear, base.wheelbase * twist.angular);
      break;
    case WheelKind::Mecanum:
      fastest = std::abs(twist.linear) + std::abs(twist.lateral) +
                wheels.half_sum * std::abs(twist.angular);
      break;
    case WheelKind::Swerve:
      for (int i = 0; i < wheels.num_modules; ++i) {
        const Eigen::Vector2d& place = wheels.modules[static_cast<std::size_t>(i)];
        fastest = std::max(fastest, std::hypot(twist.linear - twist.angular * place.y(),
                                               twist.lateral + twist.angular * place.x()));
      }
      break;
  }
  return fastest / wheels.speed_max;
}

double speed_load(const BaseModel& base, const PlanarTwist& twist) noexcept {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const auto share = [](double amount, double limit) {
    if (amount <= 0.0) return 0.0;
    return limit > 0.0 ? amount / limit : kNever;
  };
  const double along = twist.linear >= 0.0 ? share(twist.linear, base.linear_max)
                                           : share(-twist.linear, -base.linear_min);
  const double across =
      share(std::abs(twist.lateral), base.kind == BaseKind::Omni ? base.lateral_max : 0.0);
  const double turning = share(std::abs(twist.angular), base.angular_max);
  double bent = 0.0;
  if (is_steered(base) && std::abs(twist.angular) > 0.0) {
    const double most = greatest_curvature(base) * std::abs(twist.linear) * (1.0 + 1e-9);
    bent = std::abs(twist.angular) <= most ? 0.0 : kNever;
  }
  return std::max({along, across, turning, bent, wheel_load(base, twist)});
}

}  // namespace fairway
