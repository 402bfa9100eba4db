// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/people_reader.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/core.h>

#include "fairway/simulation/people/walkers.hpp"

namespace fairway::io {

namespace {

constexpr double kFurthestWalk = 1e4;  // [m]
constexpr std::size_t kMostPeople = 200;
constexpr double kLongestWalk = 3600.0;  // [s]

Eigen::Vector2d read_place(YamlMapping& mapping, const char* key) {
  const std::vector<double> place = mapping.numbers(key, 2, 2);
  if (place.size() != 2) return Eigen::Vector2d::Zero();
  const Eigen::Vector2d point(place[0], place[1]);
  if (!(point.cwiseAbs().maxCoeff() <= kFurthestWalk))
    mapping.complain(key, fmt::format("expected a place to {:g} m", kFurthestWalk));
  return point;
}

}  // namespace

void add_people(YamlMapping& root, double duration, std::vector<MovingBody>& bodies) {
  std::optional<YamlMapping> mapping = root.mapping("people");
  if (!mapping) return;
  constexpr auto kModels = setting_names(WalkingModel{});
  const std::size_t model = mapping->choice("kind", kModels, 0);
  const bool sees_robots = mapping->boolean("sees_robots", false);
  std::vector<Walker> walkers;
  for (YamlMapping& one : mapping->mappings("walkers")) {
    Walker walker;
    walker.name = one.text("name", fmt::format("person {}", walkers.size() + 1));
    walker.start = read_place(one, "start");
    walker.goal = read_place(one, "goal");
    walker.speed = one.number("speed", {.min = 0.05, .max = 5.0}, walker.speed);
    walker.radius = one.number("radius", {.min = 0.05, .max = 2.0}, walker.radius);
    walker.returns = one.boolean("returns", walker.returns);
    walker.group = one.text("group", "");
    one.finish();
    walkers.push_back(std::move(walker));
  }
  mapping->finish();
  if (walkers.empty() || walkers.size() > kMostPeople) {
    mapping->complain(
        "walkers", fmt::format("expected 1 to {} people, found {}", kMostPeople, walkers.size()));
    return;
  }
  if (duration > kLongestWalk) {
    mapping->complain("walkers", fmt::format("expected a time_limit of at most {:g} s, found {:g}",
                                             kLongestWalk, duration));
    return;
  }
  const auto kind = static_cast<WalkingModel>(model);
  std::ranges::move(sees_robots ? walking_bodies(walkers, kind) : walk(walkers, kind, duration),
                    std::back_inserter(bodies));
}

std::optional<WalkPlan> read_walk_plan(YamlMapping& obstacle) {
  std::optional<YamlMapping> mapping = obstacle.mapping("walk");
  if (!mapping) return {};
  WalkPlan plan;
  constexpr auto kModels = setting_names(WalkingModel{});
  plan.model = static_cast<WalkingModel>(mapping->choice("kind", kModels, 0));
  plan.from = read_place(*mapping, "from");
  plan.to = read_place(*mapping, "to");
  plan.speed = mapping->number("speed", {.min = 0.05, .max = 5.0}, plan.speed);
  plan.returns = mapping->boolean("returns", plan.returns);
  plan.group = mapping->text("group", "");
  mapping->finish();
  return plan;
}

}  // namespace fairway::io
