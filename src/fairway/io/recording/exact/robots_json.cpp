// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/exact/robots_json.hpp"

#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"

namespace fairway::io {

using exact::Json;

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

}  // namespace fairway::io
