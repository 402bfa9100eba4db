// SPDX-License-Identifier: Apache-2.0
#include "bridge/background_planner.hpp"

#include <chrono>
#include <utility>

#include "fairway/base/contract.hpp"

namespace fairway::bridge {

void BackgroundPlanner::start(Request request) {
  FAIRWAY_EXPECTS(!busy());
  pending_ = std::async(std::launch::async, [this, request = std::move(request)]() mutable {
    const PreparedMap map(std::move(request.obstacles));
    return planner_.plan(map, request.start, request.goal, planner_settings(request.settings));
  });
}

std::optional<Plan> BackgroundPlanner::take(bool wait) {
  if (!busy()) return std::nullopt;
  if (!wait && pending_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return std::nullopt;
  }
  return pending_.get();
}

}  // namespace fairway::bridge
