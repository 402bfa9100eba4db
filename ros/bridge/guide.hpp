// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "bridge/obstacle_board.hpp"
#include "fairway/base/error.hpp"
#include "fairway/navigation/navigator.hpp"
#include "fairway/perception/lidar_scan.hpp"

namespace fairway::bridge {

/// What a node decides once, when it starts.
struct PilotOptions {
  bool use_map = true;             ///< drive on a map; else on what the scans have shown
  bool use_scan = true;            ///< scans are needed, and their age is checked
  bool plan_in_background = true;  ///< false: the cycle waits for plans, and is deterministic
  std::size_t max_beams = 4096;
  double patience = 20.0;             ///< a goal that gets no nearer for so long is given up [s]
  double localisation_timeout = 2.0;  ///< oldest pose of the odometry's frame in the map [s]
};

/// Whether a robot can be driven that way; the error names the option.
[[nodiscard]] Expected<void> validate(const PilotOptions& options);

/// What a guide is told in a cycle. Times on the node's clock [s].
struct GuideInput {
  double time = 0.0;
  Pose2 pose;
  double pose_time = 0.0;
  const ObstacleBoard& board;
  Fleet fleet{};  ///< other robots, in the same frame
};

/// One of the library's two navigators behind one face: with a map, or without.
class Guide {
 public:
  Guide() = default;
  Guide(const Guide&) = delete;
  Guide& operator=(const Guide&) = delete;
  virtual ~Guide() = default;

  /// A map arrives, or another one. Ignored by a guide that drives without.
  virtual void set_map(const OccupancyGrid& map) = 0;

  /// @param position  Where the robot was at the scan's time [m].
  virtual void observe(const LidarScan& scan, const Eigen::Vector2d& position) = 0;

  /// Sends the robot somewhere, or somewhere else.
  virtual void set_goal(const Goal& goal) = 0;

  /// Forgets the goal: the robot brakes to a stand.
  virtual void cancel() = 0;

  /// Tells how the robot moves now, before the first cycle of a drive.
  virtual void reset(const Twist2& actual) = 0;

  /// One control cycle; plans where there is need.
  [[nodiscard]] virtual NavigationStep update(const GuideInput& input) = 0;

  /// Whether the present plan is one for the present goal.
  [[nodiscard]] virtual bool plan_is_current() const = 0;

  /// How often a plan has been taken over since the start.
  [[nodiscard]] virtual int plans_made() const = 0;

  [[nodiscard]] virtual const Navigator& navigator() const = 0;

  /// What its own tracker follows; empty without scans.
  [[nodiscard]] virtual MovingObstacles tracked() const = 0;
};

/// Drives on a map; with `use_scan` also on what the lidar sees and the map does not have.
[[nodiscard]] std::unique_ptr<Guide> make_map_guide(const Settings& settings,
                                                    const PilotOptions& options);

/// Drives on what the lidar has seen, in the frame of the odometry.
[[nodiscard]] std::unique_ptr<Guide> make_mapless_guide(const Settings& settings,
                                                        std::size_t max_beams,
                                                        const Eigen::Vector2d& position);

}  // namespace fairway::bridge
