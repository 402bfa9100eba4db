// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "fairway/prediction/forecast.hpp"
#include "fairway/tracking/space_time/cost_to_go.hpp"
#include "fairway/tracking/space_time/encounter_cost.hpp"

namespace fairway {

/// Memory of a plan in space and time while it is made. Nothing in it lasts from one update to the
/// next, so the planners of one thread can share it. It takes most of the memory of a robot.
struct SpaceTimeWorkspace {
  static constexpr std::size_t kWidth = 28;  ///< most motions that are kept in a stage
  static constexpr std::size_t kMostSpeeds = 5;
  static constexpr std::size_t kMostTurns = 6;
  static constexpr std::size_t kMostChildren = kWidth * kMostSpeeds * kMostTurns;
  static constexpr std::size_t kTable = 4096;  ///< of cells in a stage; a power of two

  /// The end of a motion.
  struct Node {
    double x = 0.0;
    double y = 0.0;
    double cosine = 1.0;  // of the heading
    double sine = 0.0;
    double heading = 0.0;
    double speed = 0.0;
    double risk = 0.0;   // so far [s]
    double time = 0.0;   // until the goal, or until the end of the stage [s]
    double total = 0.0;  // with the time that is left [s]
    std::uint32_t parent = 0;
    std::uint8_t rectangle = 0;
    bool arrived = false;
  };

  /// Allocates what plans of `stages` stages need.
  void reserve(std::size_t stages) {
    to_go.reserve(stages);
    if (layers.size() < stages + 1) layers.resize(stages + 1);
    for (std::vector<Node>& layer : layers)
      layer.reserve(kWidth);
    children.resize(kMostChildren);
    order.reserve(kMostChildren);
    table.resize(kTable);
    keys.resize(kMostChildren);
  }

  Forecast forecast;
  EncounterCost cost{{}};
  CostToGo to_go{0, 1.0, 1.0};
  std::vector<std::vector<Node>> layers;  ///< motions that are kept, by stage
  std::vector<Node> children;             ///< of the stage in work
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> table;  ///< hash of a cell -> child + 1
  std::vector<std::uint64_t> keys;
};

}  // namespace fairway
