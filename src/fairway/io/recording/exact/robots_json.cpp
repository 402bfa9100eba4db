// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/exact/robots_json.hpp"

#include <stdexcept>
#include <string>

#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"

namespace fairway::io {

using exact::Json;

namespace {

constexpr double kFastestWalk = 5.0;  // [m/s]

}  // namespace

Json robots_json(std::span<const RobotTask> tasks) {
  Json robots = Json::array();
  for (const RobotTask& task : tasks) {
    robots.push_back({{"name", task.name},
                      {"start", exact::to_json(task.start)},
                      {"goal", exact::to_json(task.goal)}});
    if (task.idle) robots.back()["idle"] = true;
    if (task.model) robots.back()["robot"] = robot_model_yaml(*task.model, 0);
  }
  return robots;
}

Json contact_json(const Encounter& met) {
  return {{"with", static_cast<int>(met.contact.with)},
          {"other", met.contact.other},
          {"time", exact::to_json(met.collision_time)},
          {"approach", exact::to_json(met.approach)},
          {"other_approach", exact::to_json(met.contact.other_approach)}};
}

Json walk_plan_json(const WalkPlan& plan) {
  return {{"kind", setting_names(plan.model)[static_cast<std::size_t>(plan.model)]},
          {"from", exact::to_json(plan.from)},
          {"to", exact::to_json(plan.to)},
          {"speed", exact::to_json(plan.speed)},
          {"returns", plan.returns},
          {"group", plan.group}};
}

WalkPlan to_walk_plan(const Json& json) {
  const std::string kind = json.at("kind").get<std::string>();
  WalkPlan plan{.from = exact::to_point(json.at("from")),
                .to = exact::to_point(json.at("to")),
                .speed = exact::to_number(json.at("speed")),
                .returns = json.at("returns").get<bool>(),
                .group = json.at("group").get<std::string>()};
  if (kind == setting_names(WalkingModel::SocialForce).back())
    plan.model = WalkingModel::SocialForce;
  if (!is_plausible(plan.from) || !is_plausible(plan.to) ||
      !(plan.speed > 0.0 && plan.speed <= kFastestWalk))
    throw std::invalid_argument("expected a walk between plausible places, up to 5 m/s");
  return plan;
}

}  // namespace fairway::io
