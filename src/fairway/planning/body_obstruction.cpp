// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/body_obstruction.hpp"

#include "fairway/planning/obstruction_text.hpp"

namespace fairway {

namespace {

using Eigen::Vector2d;

// The diameter of the largest disc in the middle of the body, which every gap has to let through.
double width_of(const BodyShape& body) {
  return 2.0 * body.inscribed_radius(0.5 * (body.low() + body.high()));
}

std::string at_end(const char* end, const PathObstruction& o) {
  return joined_text({"the body does not fit at the ", end, " ", place_text(o.position),
                      ": the reference point is ", length_text(o.found),
                      " from an obstacle and the body extends ", length_text(o.needed),
                      " from it"});
}

}  // namespace

std::optional<PathObstruction> find_body_obstruction(const PreparedMap& map,
                                                     const BodyShape& body,
                                                     const Vector2d& start,
                                                     const Plan& plan) {
  const double radius = body.circumscribed_radius();
  Plan without_margin = plan;
  without_margin.margin = 0.0;
  std::optional<PathObstruction> found = find_obstruction(map, start, without_margin, radius);
  if (found && found->kind == PathObstruction::Kind::NarrowGap) {
    const double width = width_of(body);
    if (found->found < width) found->needed = width;
  }
  return found;
}

std::string explain_body(const PreparedMap& map,
                         const BodyShape& body,
                         const Vector2d& start,
                         const Plan& plan) {
  if (plan.usable()) return {};
  const std::optional<PathObstruction> o = find_body_obstruction(map, body, start, plan);
  if (!o) return plan.reason();
  const std::string width = length_text(width_of(body));
  switch (o->kind) {
    case PathObstruction::Kind::StartClearance:
      return at_end("start", *o);
    case PathObstruction::Kind::GoalClearance:
      return at_end("goal", *o);
    case PathObstruction::Kind::ClosedRoute:
      return joined_text(
          {"there is no path: obstacles or unknown cells close every route; the best one "
           "is closed at ",
           place_text(o->position)});
    case PathObstruction::Kind::NarrowGap:
      break;
  }
  const std::string gap = joined_text({"the narrowest gap on the best route, at ",
                                       place_text(o->position), ", is ", length_text(o->found)});
  if (o->found < width_of(body)) {
    return joined_text(
        {"there is no path for the body: ", gap, " wide and the body is ", width, " wide"});
  }
  return joined_text({"there is no path that the body can drive: ", gap, " wide; the body is ",
                      width, " wide and needs ", length_text(o->needed), " to turn on the spot"});
}

}  // namespace fairway
