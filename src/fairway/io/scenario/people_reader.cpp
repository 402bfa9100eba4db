// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/people_reader.hpp"

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

std::vector<MovingBody> read_people(YamlMapping& root, double duration) {
  std::optional<YamlMapping> mapping = root.mapping("people");
  if (!mapping) return {};
  constexpr auto kModels = setting_names(WalkingModel{});
  const std::size_t model = mapping->choice("kind", kModels, 0);
  std::vector<Walker> walkers;
  for (YamlMapping& one : mapping->mappings("walkers")) {
    Walker walker;
    walker.name = one.text("name", fmt::format("person {}", walkers.size() + 1));
    walker.start = read_place(one, "start");
    walker.goal = read_place(one, "goal");
    walker.speed = one.number("speed", {.min = 0.05, .max = 5.0}, walker.speed);
    walker.radius = one.number("radius", {.min = 0.05, .max = 2.0}, walker.radius);
    walker.returns = one.boolean("returns", walker.returns);
    one.finish();
    walkers.push_back(std::move(walker));
  }
  mapping->finish();
  if (walkers.empty() || walkers.size() > kMostPeople) {
    mapping->complain(
        "walkers", fmt::format("expected 1 to {} people, found {}", kMostPeople, walkers.size()));
    return {};
  }
  if (duration > kLongestWalk) {
    mapping->complain("walkers", fmt::format("expected a time_limit of at most {:g} s, found {:g}",
                                             kLongestWalk, duration));
    return {};
  }
  return walk(walkers, static_cast<WalkingModel>(model), duration);
}

}  // namespace fairway::io
