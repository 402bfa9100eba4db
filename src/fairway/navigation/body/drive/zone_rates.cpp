// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/body/drive/zone_rates.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/map/body_zones.hpp"

namespace fairway {

std::vector<double> zone_rates(const ZoneMap& zones,
                               const BodyShape& body,
                               const DriveReference& drive) {
  if (zones.speed_regions().empty()) return {};
  constexpr double kBeside = 0.08;  // that a robot may be off its drive [m]
  constexpr double kShare = 0.95;   // of a limit; the rest is for corrections
  const std::vector<TrajectoryRow>& rows = drive.rows();
  std::vector<double> rates(rows.size(), 1.0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const PlanarTwist& twist = rows[k].twist;
    const double speed = std::hypot(twist.linear, twist.lateral);
    const double way =
        drive.period() * body.greatest_speed(twist.linear, twist.lateral, twist.angular);
    const double most = kShare * internal::zone_speed(zones, body, rows[k].pose, kBeside + way);
    if (!(most < speed)) continue;
    // The inputs between two rows lie between theirs.
    for (std::size_t i = k > 0 ? k - 1 : 0; i <= std::min(k + 1, rows.size() - 1); ++i)
      rates[i] = std::min(rates[i], most / speed);
  }
  const bool limited = std::any_of(rates.begin(), rates.end(), [](double r) { return r < 1.0; });
  return limited ? rates : std::vector<double>();
}

}  // namespace fairway
