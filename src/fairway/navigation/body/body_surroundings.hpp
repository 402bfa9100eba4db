// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "fairway/map/body_clearance.hpp"
#include "fairway/navigation/settings.hpp"
#include "fairway/perception/perception.hpp"
#include "fairway/planning/planner.hpp"

namespace fairway {

/// The static obstacles that a robot with a body knows: of a map, of its lidar, or of both.
///
/// Plans and stops use the map with the obstacles that scans have added. Without a map, plans treat
/// what was not seen as free, and stops treat it as blocked. Prepared when a map or a scan arrives,
/// so that a control cycle only reads.
class BodySurroundings {
 public:
  /// @param shared  The caller's map, which outlives this; null for none.
  /// @param reach   How far a stop can lead [m]: further away stops need not look.
  BodySurroundings(const Settings& settings,
                   const BodyShape& body,
                   const PreparedMap* shared,
                   double reach);
  BodySurroundings(const BodySurroundings&) = delete;
  BodySurroundings& operator=(const BodySurroundings&) = delete;

  /// Changes the settings. What scans have shown is kept unless those of perception change; how
  /// unknown cells of a map count holds from the next map on.
  void set_settings(const Settings& settings);

  /// Replaces the own map.
  void set_map(const OccupancyGrid& map);

  /// Replaces the own map; its zones are not taken over.
  void set_map(const BitGrid& map);

  /// Sets the zones that hold; null for none. @pre there is no shared map, whose own zones hold.
  void set_zones(std::shared_ptr<const ZoneMap> zones);
  [[nodiscard]] bool shares_map() const noexcept { return shared_ != nullptr; }

  /// Takes over a change of the shared map.
  void note_map();

  /// Processes one scan. @return whether it was taken in, as MapNavigator::observe.
  bool observe(const LidarScan& scan, const Eigen::Vector2d& position);

  /// Prepares the obstacles of the scans since the last call: once per cycle.
  void prepare() {
    if (stale_) refresh();
  }

  /// Treats what was not seen as free where the body is: a lidar does not see through it.
  void claim(const Pose2& pose);

  /// Whether anything is known: a map, or scans.
  [[nodiscard]] bool known() const noexcept { return planned_.has_value(); }
  /// Whether the robot has no map and relies on its scans.
  [[nodiscard]] bool mapless() const noexcept { return map() == nullptr && perception_; }

  /// Obstacles for plans. @pre known().
  [[nodiscard]] const PreparedMap& map_for_plans() const noexcept {
    return merged_ ? *merged_ : *map();
  }
  /// Obstacles and what was not seen, for plans that lead only through what is known to be free.
  /// @pre mapless().
  [[nodiscard]] const BitGrid& seen_free() const noexcept {
    return perception_->grid().not_seen_free();
  }
  [[nodiscard]] const BodyClearance& for_plans() const noexcept { return *planned_; }
  [[nodiscard]] const BodyClearance& for_stops() const noexcept { return *proven_; }

  /// Whether obstacles have changed since the last call.
  [[nodiscard]] bool take_change() noexcept { return std::exchange(changed_, false); }

  /// What tracks and scans say of moving obstacles; null before the first scan.
  [[nodiscard]] const Perception* perception() const noexcept {
    return perception_ ? &*perception_ : nullptr;
  }
  [[nodiscard]] bool scan_refused() const noexcept { return scan_refused_; }

 private:
  [[nodiscard]] const PreparedMap* map() const noexcept {
    return shared_ != nullptr ? shared_ : own_ ? &*own_ : nullptr;
  }
  void refresh();
  void adopt(const BitGrid& bits, std::optional<PreparedMap>& prepared) const;

  PerceptionSettings settings_;
  UnknownCells unknown_;
  BodyShape body_;
  const PreparedMap* shared_;
  double reach_;
  std::optional<PreparedMap> own_;
  std::shared_ptr<const ZoneMap> zones_;  // null without
  std::optional<Perception> perception_;
  BitGrid drawn_;                         // the map with the obstacles of scans
  std::optional<PreparedMap> merged_;     // the same, prepared; or the scans' obstacles alone
  std::optional<PreparedMap> seen_free_;  // without a map: what is near, for stops
  Eigen::Vector2d center_ = Eigen::Vector2d::Zero();  // of the robot at the last scan
  std::optional<BodyClearance> planned_;
  std::optional<BodyClearance> proven_;
  bool changed_ = false;
  bool stale_ = false;  // there are scans that are not prepared
  bool scan_refused_ = false;
};

/// The window of cells in which two grids of the same frame differ; may be empty.
[[nodiscard]] CellWindow difference(const BitGrid& a, const BitGrid& b) noexcept;

/// The part of a grid, in whole words, that covers the square about `center` with a half side of
/// `reach` [m], as far as it lies in the grid. @pre the grid's width is a multiple of 64.
[[nodiscard]] BitGrid cropped(const BitGrid& grid, const Eigen::Vector2d& center, double reach);

/// Returns the goal, or a place in the known window if the goal lies outside. From that place the
/// path to the goal is probably shortest. It has no heading: the body fits there in all of them.
[[nodiscard]] Goal goal_inside(const BodyClearance& clearance, const Pose2& pose, const Goal& goal);

}  // namespace fairway
