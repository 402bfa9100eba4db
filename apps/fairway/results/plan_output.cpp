// SPDX-License-Identifier: Apache-2.0
#include "results/plan_output.hpp"

#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/output.hpp"
#include "fairway/io/drawing/world_picture.hpp"

namespace fairway::app {

namespace {

Json point_json(const Eigen::Vector2d& p) { return Json::array({p.x(), p.y()}); }

}  // namespace

Json obstruction_json(const PathObstruction& obstruction) {
  return {{"kind", to_text(obstruction.kind)},
          {"position", point_json(obstruction.position)},
          {"found", obstruction.found},
          {"needed", obstruction.needed}};
}

std::string plan_json(const PlanAnswer& answer,
                      const PlanQuery& query,
                      const char* method,
                      const Provenance& provenance) {
  const Plan& plan = answer.plan;
  Json json;
  json["success"] = plan.usable();
  if (!plan.usable()) json["reason"] = answer.reason;
  if (answer.obstruction) {
    json["obstruction"] = obstruction_json(*answer.obstruction);
  }
  json["method"] = method;
  json["start"] = point_json(query.start.position);
  json["goal"] = point_json(query.goal.position);
  json["length"] = plan.path.length();
  Json path = Json::array();
  for (const Eigen::Vector2d& p : plan.path.waypoints)
    path.push_back(point_json(p));
  json["path"] = std::move(path);
  Json rectangles = Json::array();
  for (const OrientedRectangle& r : plan.corridor.rectangles) {
    rectangles.push_back(Json{{"seed", point_json(r.seed)},
                              {"orientation", r.orientation},
                              {"min", point_json(r.min)},
                              {"max", point_json(r.max)},
                              {"area", r.area()}});
  }
  json["rectangles"] = std::move(rectangles);
  json["space"] = to_text(query.settings.corridor.space);
  json["inward_offset"] = query.settings.corridor.space == CorridorSpace::Workspace
                              ? query.settings.corridor.inward_offset
                              : 0.0;
  json["robot_radius"] = plan.usable() ? plan.corridor.robot_radius : query.settings.robot.radius;
  json["margin"] = plan.margin;
  json["count"] = plan.corridor.rectangles.size();
  json["mean_area"] = plan.corridor.mean_area();
  json["seconds"] = Json{{"prepare", answer.prepare_seconds},
                         {"path", plan.path_seconds},
                         {"corridor", plan.corridor_seconds}};
  add_provenance(json, provenance);
  return json_text(json);
}

std::string plan_summary(const PlanAnswer& answer) {
  const Plan& plan = answer.plan;
  if (!plan.usable()) return "";
  return fmt::format(
      "path      {:.2f} m, {} waypoints\ncorridor  {} rectangles, {:.2f} m^2 each in the mean\n"
      "time      map {:.2f} ms, path {:.2f} ms, corridor {:.2f} ms\n",
      plan.path.length(), plan.path.waypoints.size(), plan.corridor.rectangles.size(),
      plan.corridor.mean_area(), 1e3 * answer.prepare_seconds, 1e3 * plan.path_seconds,
      1e3 * plan.corridor_seconds);
}

Expected<void> write_plan_picture(const std::string& file,
                                  const OccupancyGrid& grid,
                                  const PlanQuery& query,
                                  const Plan& plan) {
  if (file.empty()) return {};
  const double heading = query.start.heading.value_or(
      plan.path.waypoints.size() > 1
          ? std::atan2(plan.path.waypoints[1].y() - plan.path.waypoints[0].y(),
                       plan.path.waypoints[1].x() - plan.path.waypoints[0].x())
          : 0.0);
  const io::WorldDrawing drawing{
      .map = &grid,
      .robots = {{.name = "robot",
                  .radius = query.settings.robot.radius,
                  .start = {.position = query.start.position, .heading = heading},
                  .goal = query.goal.position,
                  .path = plan.path,
                  .corridor = plan.corridor,
                  .track = {}}},
      .bodies = {},
      .zones = query.zones};
  const Expected<std::string> bytes = io::draw_world(drawing, *io::picture_format(file));
  return bytes ? write_output(file, *bytes) : tl::unexpected(bytes.error());
}

}  // namespace fairway::app
