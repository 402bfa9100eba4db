// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fairway/geometry/pose2.hpp"
#include "fairway/simulation/physics/mujoco_model.hpp"

namespace fairway {

/// From where a picture is taken: by default from behind and above of `look_at`.
struct CameraView {
  Eigen::Vector2d look_at = Eigen::Vector2d::Zero();  ///< on the floor [m]
  double distance = 5.0;                              ///< from there to the camera [m]
  double azimuth = 1.5707963267948966;                ///< in which the camera looks [rad]
  double elevation = -0.8;                            ///< of its line of sight; below 0: down [rad]
};

/// A picture: rows from the top, three bytes per pixel: red, green, blue.
struct CameraImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Takes pictures of a scenario's MuJoCo world without a screen (OSMesa draws on the processor).
///
/// The camera has a world of its own, in which it places the robots as requested. So it can show a
/// run afterwards, from its trace. Use one per thread at a time, since OpenGL contexts belong to a
/// thread.
class MujocoCamera {
 public:
  static constexpr int kMostWidth = 1280;  ///< [px]
  static constexpr int kMostHeight = 720;  ///< [px]

  /// @throws std::runtime_error when no off-screen context can be had.
  /// @pre 1 <= width <= kMostWidth, 1 <= height <= kMostHeight.
  MujocoCamera(const Scenario& scenario,
               int width,
               int height,
               const MujocoRobot& robot = MujocoRobot());
  ~MujocoCamera();
  MujocoCamera(const MujocoCamera&) = delete;
  MujocoCamera& operator=(const MujocoCamera&) = delete;

  /// The world with the robots at `robots`, one pose each, and the moving bodies as at `time` [s].
  [[nodiscard]] CameraImage shot(std::span<const Pose2> robots,
                                 double time,
                                 const CameraView& view);

 private:
  struct Scene;  // all that is MuJoCo's and OpenGL's

  std::vector<MovingBody> bodies_;
  int width_;
  int height_;
  std::unique_ptr<Scene> scene_;
};

}  // namespace fairway
