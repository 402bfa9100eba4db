// SPDX-License-Identifier: Apache-2.0
#include "fairway/perception/map_localization.hpp"

#include <algorithm>
#include <vector>

#include "fairway/perception/scan_alignment.hpp"

namespace fairway {

namespace {

// Returns the side of a square that the map fits into, however it is turned [m].
double side_around(const GridFrame& frame) {
  return frame.resolution * std::hypot(frame.width, frame.height);
}

}  // namespace

struct MapLocalization::State {
  State(const OccupancyGrid& map, const PerceptionSettings& settings)
      : reach(settings.reach),
        alignment(side_around(map.frame()), static_cast<std::size_t>(settings.max_beams)) {
    alignment.correction.use_map(BitGrid(map, UnknownCells::Free));
    beams.reserve(static_cast<std::size_t>(settings.max_beams));
  }

  double reach;
  ScanAlignment alignment;
  std::vector<Beam> beams;
};

MapLocalization::MapLocalization(const OccupancyGrid& map, const PerceptionSettings& settings)
    : state_(std::make_unique<State>(map, settings)) {}

MapLocalization::MapLocalization(MapLocalization&&) noexcept = default;
MapLocalization& MapLocalization::operator=(MapLocalization&&) noexcept = default;
MapLocalization::~MapLocalization() = default;

void MapLocalization::set_pose(const Pose2& odometry,
                               const Pose2& pose,
                               double position_sigma,
                               double heading_sigma) noexcept {
  const Eigen::Vector3d sigma(position_sigma, position_sigma, heading_sigma);
  state_->alignment.correction.set_pose(odometry, pose,
                                        sigma.cwiseAbs2().asDiagonal().toDenseMatrix());
}

bool MapLocalization::observe(const LidarScan& scan) noexcept {
  if (!is_plausible(scan, scan.last_pose.position)) return false;
  state_->alignment.lay(scan, state_->reach, state_->beams);
  return true;
}

MapPose MapLocalization::locate(const Pose2& odometry) const noexcept {
  const PoseCertainty& certainty = state_->alignment.correction.certainty();
  return {.pose = state_->alignment.correction.corrected(odometry),
          .covariance = certainty.covariance,
          .matched = certainty.matched,
          .share = certainty.share,
          .degenerate = certainty.degenerate,
          .weak_direction = certainty.weak_direction};
}

}  // namespace fairway
