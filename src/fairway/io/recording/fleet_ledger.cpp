// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/fleet_ledger.hpp"

#include <stdexcept>

#include "fairway/io/recording/exact/exact_json.hpp"

namespace fairway::io {

namespace {

using nlohmann::json;

constexpr std::size_t kRemembered = 80;  // messages kept per robot; covers the longest radio delay

json samples_json(const SampledMotion& motion) {
  json positions = json::array();
  for (std::size_t i = 0; i < static_cast<std::size_t>(motion.count); ++i)
    positions.push_back(exact::to_json(motion.positions[i]));
  return {{"start", exact::to_json(motion.start)},
          {"interval", exact::to_json(motion.interval)},
          {"positions", std::move(positions)}};
}

SampledMotion samples_of(const json& from) {
  SampledMotion motion{.start = exact::to_number(from.at("start")),
                       .interval = exact::to_number(from.at("interval"))};
  for (const json& position : from.at("positions"))
    motion.add(exact::to_point(position));
  return motion;
}

json headings_json(const std::array<double, SampledMotion::kMaxSamples>& headings, int count) {
  json list = json::array();
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    list.push_back(exact::to_json(headings[i]));
  return list;
}

json outline_json(const SharedMotion& motion) {
  const SharedOutline& outline = motion.outline;
  return {{"low", exact::to_json(outline.low)},
          {"high", exact::to_json(outline.high)},
          {"plan_headings", headings_json(outline.plan_headings, motion.plan.count)},
          {"stop_headings", headings_json(outline.stop_headings, motion.stop.count)}};
}

void read_headings(const json& list, std::array<double, SampledMotion::kMaxSamples>& headings) {
  if (list.size() > headings.size()) throw std::invalid_argument("headings: too long");
  for (std::size_t i = 0; i < list.size(); ++i)
    headings[i] = exact::to_number(list[i]);
}

SharedOutline outline_of(const json& from) {
  SharedOutline outline;
  outline.is_box = true;
  outline.low = exact::to_point(from.at("low"));
  outline.high = exact::to_point(from.at("high"));
  read_headings(from.at("plan_headings"), outline.plan_headings);
  read_headings(from.at("stop_headings"), outline.stop_headings);
  return outline;
}

}  // namespace

json motion_json(const SharedMotion& motion) {
  json way = json::array();
  for (std::size_t i = 0; i < static_cast<std::size_t>(motion.way.count); ++i)
    way.push_back(exact::to_json(motion.way.points[i]));
  json written{{"robot", motion.robot},
               {"time", exact::to_json(motion.time)},
               {"position", exact::to_json(motion.position)},
               {"speed", exact::to_json(motion.speed)},
               {"radius", exact::to_json(motion.radius)},
               {"speed_max", exact::to_json(motion.speed_max)},
               {"acceleration", exact::to_json(motion.acceleration)},
               {"turn_max", exact::to_json(motion.turn_max)},
               {"plan", samples_json(motion.plan)},
               {"stop", samples_json(motion.stop)},
               {"way", std::move(way)},
               {"to_narrow", exact::to_json(motion.distance_to_bottleneck)},
               {"can_step_aside", motion.can_step_aside},
               {"way_back", exact::to_json(motion.retreat_length)},
               {"under_way", motion.under_way},
               {"roundabout",
                {{"center", exact::to_json(motion.roundabout.center)},
                 {"radius", exact::to_json(motion.roundabout.radius)}}}};
  if (motion.outline.is_box) written["outline"] = outline_json(motion);
  return written;
}

SharedMotion motion_of(const json& from) {
  SharedMotion motion{
      .robot = from.at("robot").get<std::uint32_t>(),
      .time = exact::to_number(from.at("time")),
      .position = exact::to_point(from.at("position")),
      .speed = exact::to_number(from.at("speed")),
      .radius = exact::to_number(from.at("radius")),
      .speed_max = exact::to_number(from.at("speed_max")),
      .acceleration = exact::to_number(from.at("acceleration")),
      .turn_max = exact::to_number(from.at("turn_max")),
      .plan = samples_of(from.at("plan")),
      .stop = samples_of(from.at("stop")),
      .under_way = from.at("under_way").get<bool>(),
      .distance_to_bottleneck = exact::to_number(from.at("to_narrow")),
      .can_step_aside = from.at("can_step_aside").get<bool>(),
      .retreat_length = from.contains("way_back") ? exact::to_number(from.at("way_back")) : 0.0};
  for (const json& point : from.at("way")) {
    if (motion.way.count == UpcomingWaypoints::kMaxPoints)
      throw std::invalid_argument("way: too long");
    motion.way.points[static_cast<std::size_t>(motion.way.count++)] = exact::to_point(point);
  }
  if (from.contains("outline")) motion.outline = outline_of(from.at("outline"));
  const json& roundabout = from.at("roundabout");
  motion.roundabout = {.center = exact::to_point(roundabout.at("center")),
                       .radius = exact::to_number(roundabout.at("radius"))};
  return motion;
}

json FleetLedger::to_json(Fleet fleet) {
  json list = json::array();
  for (const FleetMember& member : fleet) {
    const SharedMotion& motion = *member.motion;
    json written = motion_json(motion);
    std::deque<Entry>& told = told_[motion.robot];
    const Entry* known = nullptr;
    for (const Entry& entry : told) {
      if (entry.time == motion.time && entry.motion == written) known = &entry;
    }
    json item{{"told", known != nullptr ? known->number : next_},
              {"unseen", exact::to_json(member.unseen)}};
    if (known == nullptr) {
      if (told.size() == kRemembered) told.pop_front();
      told.push_back({.number = next_++, .time = motion.time, .motion = written});
      item["motion"] = std::move(written);
    }
    list.push_back(std::move(item));
  }
  return list;
}

Fleet FleetReader::read(const json& list) {
  fleet_.clear();
  for (const json& item : list) {
    const auto number = item.at("told").get<std::int64_t>();
    if (item.contains("motion")) told_.insert_or_assign(number, motion_of(item.at("motion")));
    const auto found = told_.find(number);
    if (found == told_.end()) throw std::invalid_argument("expected a motion recorded earlier");
    fleet_.push_back({.motion = &found->second, .unseen = exact::to_number(item.at("unseen"))});
  }
  return fleet_;
}

}  // namespace fairway::io
