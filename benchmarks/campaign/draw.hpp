// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "fairway/simulation/scenario.hpp"
#include "fairway/simulation/sensors/noise.hpp"

// The runs of the safety campaign: each is drawn from its number and the seed alone.
namespace fairway::campaign {

using Eigen::Vector2d;

/// What a run varies beyond its scenario.
struct Run {
  Scenario scenario;
  double jitter = 0.0;       ///< of the time between two cycles, in periods
  double lost_share = 0.0;   ///< of cycles that do not take place, two in a row in late runs only
  double late_share = 0.0;   ///< of cycles that come a second late
  bool valid = true;         ///< the settings are accepted
  std::string refused = {};  ///< why they are not
};

/// Which part of the space of runs is drawn.
struct DrawOptions {
  std::uint64_t seed = 1;
  Sensing sensing = Sensing::Map;
  PoseSource pose = PoseSource::Exact;
  double noise = 0.0;  ///< of lidar and odometry, in multiples of the standard noise
  double mujoco_share = 0.0;
  double body_share = 0.0;  ///< of robots with their true outline on a base of any kind
  double late_share = 0.0;  ///< of runs with cycles that are later than is promised
};

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : noise_(seed) {}

  Run run(const DrawOptions& options) {
    Run drawn;
    Scenario& s = drawn.scenario;
    draw_robot(s.settings);
    draw_cycles(drawn);
    if (chance(0.35)) {
      passage(s);
    } else {
      hall(s);
    }
    s.sensing.sensing = options.sensing;
    s.sensing.pose = options.pose;
    if (options.noise > 0.0) draw_noise(s.sensing, options.noise);
    s.engine = chance(options.mujoco_share) ? Engine::Mujoco : Engine::Unicycle;
    s.radio.on = false;
    s.time_limit = 30.0;
    if (chance(options.body_share)) draw_body(s);
    if (chance(options.late_share)) {
      drawn.late_share = noise_.uniform(0.01, 0.15);
      drawn.lost_share = std::max(drawn.lost_share, noise_.uniform(0.0, 0.2));
    }
    if (const Expected<void> valid = validate(s.settings); !valid) {
      drawn.valid = false;
      drawn.refused = valid.error().message;
    }
    return drawn;
  }

 private:
  static constexpr double kCell = 0.05;  // [m]

  bool chance(double share) { return noise_.uniform(0.0, 1.0) < share; }
  // As often in each octave.
  double log_uniform(double low, double high) {
    return std::exp(noise_.uniform(std::log(low), std::log(high)));
  }
  int integer(int low, int high) {
    return std::min(high, static_cast<int>(noise_.uniform(low, high + 1)));
  }

  void draw_robot(Settings& settings) {
    RobotSettings& robot = settings.robot;
    robot.linear_max = log_uniform(0.3, 3.0);
    robot.linear_acceleration_max = log_uniform(0.3, 3.0);
    robot.angular_max = noise_.uniform(0.5, 2.5);
    robot.angular_acceleration_max = log_uniform(0.6, 6.0);
    if (chance(0.3)) robot.linear_min = -0.3;
    if (chance(0.5)) robot.linear_braking_max = log_uniform(0.3, 3.0);
    if (chance(0.3)) robot.angular_braking_max = log_uniform(0.6, 6.0);
    if (chance(0.4)) {
      robot.linear_delay = noise_.uniform(0.0, 0.6);
      robot.angular_delay = chance(0.7) ? robot.linear_delay : noise_.uniform(0.0, 0.6);
    }
    if (chance(0.2)) {
      robot.linear_lag = noise_.uniform(0.0, 0.3);
      robot.angular_lag = noise_.uniform(0.0, 0.3);
    }
    robot.radius = noise_.uniform(0.15, 0.35);
    if (chance(0.25)) {
      robot.length = noise_.uniform(0.4, 0.7);
      robot.width = noise_.uniform(0.3, 0.5);
      robot.radius = 0.5 * std::hypot(robot.length, robot.width) + 1e-3;
    } else if (chance(0.15)) {
      const double half = noise_.uniform(0.1, 0.2);
      robot.discs.count = 2;
      robot.discs.discs[0] = {.center = {half, 0.0}, .radius = 0.2};
      robot.discs.discs[1] = {.center = {-half, 0.0}, .radius = 0.2};
      robot.radius = half + 0.2 + 1e-3;
    }
  }

  static void draw_noise(SensingModel& sensing, double noise) {
    use_standard_noise(sensing);
    sensing.lidar.range_sigma *= noise;
    sensing.lidar.dropout *= noise;
    sensing.odometry.most_scale_error *= noise;
    sensing.odometry.most_drift *= noise;
  }

  // Replaces the robot by one with its own base, which fits where the other one does. Its base
  // follows each command as hard as its limits allow, without delay.
  void draw_body(Scenario& s) {
    RobotSettings& robot = s.settings.robot;
    RobotModel model;
    model.base.kind = static_cast<BaseKind>(integer(0, 3));
    const bool steered = is_steered(model.base);
    const double length = noise_.uniform(1.0, 1.6) * (robot.radius + 0.15);
    model.body = BodyShape::rectangle(length, noise_.uniform(0.5, 0.9) * length,
                                      (steered ? 0.75 : noise_.uniform(0.4, 0.6)) * length);
    BaseModel& base = model.base;
    base.linear_max = robot.linear_max;
    base.linear_min = -noise_.uniform(0.2, 0.5);
    base.lateral_max = noise_.uniform(0.2, 0.5);
    base.angular_max = robot.angular_max;
    base.linear_acceleration = robot.linear_acceleration_max;
    base.lateral_acceleration = log_uniform(0.3, 3.0);
    base.angular_acceleration = robot.angular_acceleration_max;
    base.wheelbase = 0.5 * length;
    base.steering_max = noise_.uniform(0.4, 0.8);
    base.steering_rate_max = noise_.uniform(0.5, 2.0);
    robot = RobotSettings();
    s.robots.front().model = model;
    describe_models(s);
  }

  void draw_cycles(Run& drawn) {
    Settings& settings = drawn.scenario.settings;
    settings.navigation.control_period = chance(0.5) ? 0.1 : log_uniform(0.02, 0.2);
    if (chance(0.4)) drawn.jitter = noise_.uniform(0.0, 0.45);
    if (chance(0.2)) {
      drawn.lost_share = noise_.uniform(0.0, 0.2);
      settings.safety.longest_hold = 2.0 + drawn.jitter;
    }
  }

  void outline(OccupancyGrid& map, int width, int height) {
    for (int x = 0; x < width; ++x) {
      map.set({.x = x, .y = 0}, CellState::Occupied);
      map.set({.x = x, .y = height - 1}, CellState::Occupied);
    }
    for (int y = 0; y < height; ++y) {
      map.set({.x = 0, .y = y}, CellState::Occupied);
      map.set({.x = width - 1, .y = y}, CellState::Occupied);
    }
  }

  static void box(OccupancyGrid& map, double x0, double y0, double x1, double y1) {
    const GridFrame& frame = map.frame();
    for (int y = std::max(0, static_cast<int>(y0 / kCell));
         y < std::min(frame.height, static_cast<int>(y1 / kCell)); ++y) {
      for (int x = std::max(0, static_cast<int>(x0 / kCell));
           x < std::min(frame.width, static_cast<int>(x1 / kCell)); ++x)
        map.set({.x = x, .y = y}, CellState::Occupied);
    }
  }

  MovingBody body(std::vector<MovingBody::KeyFrame> frames) {
    MovingBody drawn;
    drawn.radius = noise_.uniform(0.2, 0.35);
    drawn.key_frames = std::move(frames);
    return drawn;
  }

  // Makes a straight passage in which a person walks ahead, or is at standstill.
  void passage(Scenario& s) {
    const double length = 40.0;
    const int across =
        static_cast<int>((2.0 * s.settings.robot.radius + noise_.uniform(0.4, 1.1)) / kCell) + 2;
    const int along = static_cast<int>(length / kCell);
    s.map = OccupancyGrid({.width = along, .height = across, .resolution = kCell, .origin = {}});
    outline(s.map, along, across);
    const double width = across * kCell;
    s.robots = {{.name = "robot",
                 .start = {.position = {1.0, 0.5 * width}, .heading = 0.0},
                 .goal = {.position = {length - 1.0, 0.5 * width}, .heading = {}}}};
    const double x = noise_.uniform(4.0, 15.0);
    const double y = noise_.uniform(0.35, width - 0.35);
    const double speed = chance(0.3) ? 0.0 : noise_.uniform(0.2, 1.3);
    const double drift = chance(0.3) ? noise_.uniform(-0.001, 0.001) : 0.0;
    constexpr double kLong = 100.0;  // [s]
    s.bodies.push_back(body({{0.0, {x, y}}, {kLong, {x + kLong * speed, y + kLong * drift}}}));
  }

  // A hall with walls and posts, in which people stand, walk, turn and step in front of the robot.
  void hall(Scenario& s) {
    const double length = noise_.uniform(8.0, 16.0);
    const double width = noise_.uniform(4.0, 8.0);
    const int along = static_cast<int>(length / kCell);
    const int across = static_cast<int>(width / kCell);
    s.map = OccupancyGrid({.width = along, .height = across, .resolution = kCell, .origin = {}});
    outline(s.map, along, across);
    const double free = s.settings.robot.radius + 0.3;
    const Vector2d start(noise_.uniform(free, 1.5), noise_.uniform(free, width - free));
    const Vector2d goal(length - noise_.uniform(free, 1.5), noise_.uniform(free, width - free));
    for (int i = integer(0, 8); i > 0; --i) {
      const Vector2d at(noise_.uniform(0.0, length), noise_.uniform(0.0, width));
      const bool post = chance(0.6);
      const Vector2d size(post ? noise_.uniform(0.1, 0.4) : noise_.uniform(0.1, 2.0),
                          post ? noise_.uniform(0.1, 0.4) : noise_.uniform(0.1, 2.0));
      const auto near = [&](const Vector2d& p) {
        return ((p - at).cwiseAbs() - size).maxCoeff() < free;
      };
      if (near(start) || near(goal)) continue;
      box(s.map, at.x() - size.x(), at.y() - size.y(), at.x() + size.x(), at.y() + size.y());
    }
    s.robots = {{.name = "robot",
                 .start = {.position = start, .heading = noise_.uniform(-3.1, 3.1)},
                 .goal = {.position = goal, .heading = {}}}};
    for (int i = integer(0, 3); i > 0; --i)
      person(s, start, goal, length, width);
  }

  void person(
      Scenario& s, const Vector2d& start, const Vector2d& goal, double length, double width) {
    constexpr double kLong = 60.0;  // [s]
    Vector2d at(noise_.uniform(0.5, length - 0.5), noise_.uniform(0.5, width - 0.5));
    if ((at - start).norm() < 1.5) return;
    const double speed = noise_.uniform(0.2, 1.5);
    const int kind = integer(0, 3);
    if (kind == 0) {  // stands
      s.bodies.push_back(body({{0.0, at}}));
    } else if (kind == 1) {  // walks straight on
      const Vector2d velocity = speed * direction(noise_.uniform(-3.1, 3.1));
      s.bodies.push_back(body({{0.0, at}, {kLong, at + kLong * velocity}}));
    } else if (kind == 2) {  // turns now and then
      std::vector<MovingBody::KeyFrame> frames{{0.0, at}};
      for (double time = 0.0; time < 30.0;) {
        const double leg = noise_.uniform(1.0, 5.0);
        at += leg * speed * direction(noise_.uniform(-3.1, 3.1));
        at = at.cwiseMax(Vector2d(0.3, 0.3)).cwiseMin(Vector2d(length - 0.3, width - 0.3));
        frames.push_back({time += leg, at});
      }
      s.bodies.push_back(body(std::move(frames)));
    } else {  // stands aside, then steps in front
      const Vector2d way = (goal - start).normalized();
      const double share = noise_.uniform(0.3, 0.8);
      const Vector2d across(-way.y(), way.x());
      const double side = chance(0.5) ? 1.0 : -1.0;
      const Vector2d before =
          start + share * (goal - start) + side * noise_.uniform(0.8, 1.5) * across;
      const double when =
          share * (goal - start).norm() / s.settings.robot.linear_max + noise_.uniform(-2.0, 1.0);
      const double first = std::max(0.1, when);
      const double last = first + noise_.uniform(0.8, 2.0) / speed;
      s.bodies.push_back(body({{0.0, before},
                               {first, before},
                               {last, before - (last - first) * speed * side * across}}));
    }
  }

  Noise noise_;
};

/// Run number `index` of the campaign with this seed.
[[nodiscard]] inline Run draw_run(const DrawOptions& options, std::uint64_t index) {
  return Draw(options.seed * 0x9E3779B97F4A7C15ULL + index).run(options);
}

}  // namespace fairway::campaign
