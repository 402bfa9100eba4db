// SPDX-License-Identifier: Apache-2.0
#include "fairway/safety/zone_check.hpp"

namespace fairway {

StopVerdict verdict_of(const ZoneMap& zones, std::size_t zone) noexcept {
  return zones.zones()[zone].kind == ZoneKind::Strip ? StopVerdict::LeavesStrip
                                                     : StopVerdict::EntersZone;
}

StopVerdict cause_of(const ZoneMap* zones,
                     const OrientedRectangle& region,
                     double clearance) noexcept {
  if (zones == nullptr) return StopVerdict::HitsStatic;
  const auto zone = zones->forbidding(region, clearance, ZoneSubject::Body);
  return zone ? verdict_of(*zones, *zone) : StopVerdict::HitsStatic;
}

namespace {

// A centre that an error of its pose has put outside of its strip, a little, may come back.
bool comes_back(const ZoneMap& zones, const Segment& motion) noexcept {
  constexpr double kLittle = 0.1;  // [m]
  const double before = zones.excursion(motion.a);
  return before > 0.0 && before <= kLittle && zones.excursion(motion.b) <= before;
}

}  // namespace

StopVerdict check_centre(const ZoneMap& zones, const CentreMotion& motion) noexcept {
  constexpr double kSameSpeed = 5e-4;  // [m/s]
  if (const auto zone =
          zones.forbidding(motion.chord, motion.aside, ZoneSubject::Centre, motion.body_radius)) {
    const StopVerdict verdict = verdict_of(zones, *zone);
    if (verdict != StopVerdict::LeavesStrip || !comes_back(zones, motion.mean)) return verdict;
  }
  const ZoneSpeed limit = zones.speed_in(motion.chord, motion.body_radius + motion.aside);
  if (motion.fastest > limit.speed + kSameSpeed) return StopVerdict::TooFast;
  return zones.against(motion.mean) ? StopVerdict::WrongWay : StopVerdict::Free;
}

}  // namespace fairway
