// SPDX-License-Identifier: Apache-2.0
#include "fairway/navigation/facade/map_planning.hpp"

#include <exception>
#include <utility>

namespace fairway {

MapPlanning::MapPlanning(const Settings& settings)
    : wanted_(planner_settings(settings)),
      background_(settings.planning.background),
      own_map_(std::make_unique<PreparedMap>()),
      own_planner_(std::make_unique<Planner>()) {
  map_ = own_map_.get();
  planner_ = own_planner_.get();
}

MapPlanning::MapPlanning(const Settings& settings, const PreparedMap& map, Planner& planner)
    : wanted_(planner_settings(settings)),
      background_(false),
      map_(&map),
      planner_(&planner) {}

void MapPlanning::set_settings(const Settings& settings) {
  wanted_ = planner_settings(settings);
  background_ = settings.planning.background && own_map_ != nullptr;
}

void MapPlanning::start(const BitGrid& obstacles, PlanRequest request) {
  settings_ = wanted_;
  if (std::exchange(task_is_new_, false)) {
    failures_ = 0;
    explained_.clear();
  }
  request_ = std::move(request);
  made_.reset();
  const CellWindow changed = std::exchange(changed_, kNoCells);
  if (!background_) {
    const double before = clock_ ? clock_() : 0.0;
    if (own_map_) own_map_->update(obstacles, changed);
    make();
    if (clock_) seconds_ = clock_() - before;
    return;
  }
  // The cells are copied here, in the thread that owns them; the worker computes the distances.
  worker_.start([this, changed, cells = obstacles] {
    own_map_->update(cells, changed);
    make();
    make_explanation();
  });
}

void MapPlanning::make() {
  try {
    made_ = request_.along
                ? plan_along(*planner_, *map_, request_.start, *request_.along, settings_)
                : planner_->plan(*map_, request_.start, request_.goal, settings_);
  } catch (const std::exception&) {  // out of memory: no plan, and another attempt later
    made_ = Plan{};
  }
}

// An explanation reads the whole map, and is therefore not made for every attempt.
void MapPlanning::make_explanation() {
  constexpr int kEvery = 8;
  failures_ = made_->usable() ? 0 : failures_ + 1;
  if (made_->usable()) explained_.clear();
  if (failures_ % kEvery != 1) return;
  try {
    explained_ = explain(*map_, request_.start, *made_, settings_.radius);
  } catch (const std::exception&) {  // out of memory
    explained_ = made_->reason();
  }
}

void MapPlanning::begin_task() noexcept {
  task_is_new_ = true;
  explanation_.clear();
}

std::optional<Plan> MapPlanning::take() {
  if (!worker_.idle()) {
    if (!worker_.finished()) return std::nullopt;
    worker_.collect();
    if (!task_is_new_) explanation_ = explained_;
  }
  return std::exchange(made_, std::nullopt);
}

}  // namespace fairway
