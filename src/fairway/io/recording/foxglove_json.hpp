// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/geometry/oriented_rectangle.hpp"
#include "fairway/geometry/pose2.hpp"
#include "fairway/map/grid_frame.hpp"
#include "fairway/perception/lidar_scan.hpp"

// Messages that Foxglove and Lichtblick draw directly: the well-known schemas foxglove.*, as JSON.
// Coordinates are rounded to 0.1 mm for display; the exact numbers are in fairway.*.
namespace fairway::io::foxglove {

using Json = nlohmann::json;

/// The default frame of all messages.
inline constexpr const char* kMapFrame = "map";

/// Red, green, blue and opacity, 0..1.
struct Tint {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;
  double opacity = 1.0;
};

/// A JSON Schema for "foxglove.SceneUpdate", "foxglove.Grid", "foxglove.PoseInFrame",
/// "foxglove.FrameTransform" or "foxglove.LaserScan". @pre the name is one of these.
[[nodiscard]] std::string schema(const std::string& name);

[[nodiscard]] Json time_json(std::uint64_t nanoseconds);

/// A map; `cells` holds one byte per cell, lowest row first: 0 free, 100 occupied, 255 unknown.
[[nodiscard]] Json grid(std::uint64_t time,
                        const GridFrame& frame,
                        const std::string& cells,
                        const std::string& frame_id = kMapFrame);

[[nodiscard]] Json pose_in_frame(std::uint64_t time,
                                 const Pose2& pose,
                                 const std::string& frame_id = kMapFrame);

/// The pose of the frame `child` in the frame `parent`.
[[nodiscard]] Json frame_transform(std::uint64_t time,
                                   const std::string& child,
                                   const Pose2& pose,
                                   const std::string& parent = kMapFrame);

/// A scan with exact ranges: a lost beam is 0, and one without a hit has the largest range. A
/// moving sensor is shown at its pose of the last beam.
[[nodiscard]] Json laser_scan(std::uint64_t time,
                              const LidarScan& scan,
                              const std::string& frame_id);

/// The ranges of such a message.
/// @throws nlohmann::json::exception where it has another content.
[[nodiscard]] std::vector<float> ranges_of(const Json& laser_scan);

/// Named primitives to draw; a later one replaces an earlier one of the same name.
class Scene {
 public:
  explicit Scene(std::uint64_t time, std::string frame_id = kMapFrame);

  void line(const std::string& id, std::span<const Eigen::Vector2d> points, const Tint& tint);
  void outlines(const std::string& id,
                std::span<const OrientedRectangle> rectangles,
                const Tint& tint);
  void disc(const std::string& id,
            const Eigen::Vector2d& center,
            double radius,
            double height,
            const Tint& tint);
  /// A box with its centre at `pose`, `length` along its heading.
  void box(const std::string& id,
           const Pose2& pose,
           double length,
           double width,
           double height,
           const Tint& tint);
  void arrow(const std::string& id, const Pose2& pose, double length, const Tint& tint);
  void remove(const std::string& id);

  [[nodiscard]] const Json& json() const noexcept { return json_; }

 private:
  Json& entity(const std::string& id);

  std::uint64_t time_;
  std::string frame_id_;
  Json json_;
};

}  // namespace fairway::io::foxglove
