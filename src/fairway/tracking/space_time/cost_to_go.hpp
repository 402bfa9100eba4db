// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "fairway/prediction/forecast.hpp"
#include "fairway/tracking/space_time/encounter_cost.hpp"

namespace fairway {

/// Estimates what the rest of a motion costs, from a place and a time on, among predicted
/// obstacles.
///
/// The estimate is that of a point, which moves in any direction up to the speed of the robot. It
/// is the least cost over all motions on a grid whose layers are a stage apart. Waiting and driving
/// back are included. So a tree of motions that is guided by it does not enter a place that people
/// will close. Values are found backwards from the last layer. The work is bounded; nothing is
/// allocated after construction.
class CostToGo {
 public:
  CostToGo(std::size_t stages, double stage, double speed);

  /// Changes to another robot or horizon. The values are those of a new object.
  /// @pre `reserve` was called with at least as many stages, or this allocates.
  void set(std::size_t stages, double stage, double speed);

  /// Allocates what `stages` stages need.
  void reserve(std::size_t stages) { values_.reserve((stages + 1) * kCells); }

  /// Moves the grid to a place. All cells must be set after it.
  void begin(const Eigen::Vector2d& center) noexcept;

  /// Calls `set(place, last, arrival)` for every cell: the cost after the last layer [s], and that
  /// of entering the cell in a stage without the obstacles [s].
  template <typename Set>
  void for_each_cell(Set&& set) noexcept {
    for (std::size_t row = kBorder; row < kPitch - kBorder; ++row) {
      for (std::size_t column = kBorder; column < kPitch - kBorder; ++column) {
        const std::size_t i = row * kPitch + column;
        set(Eigen::Vector2d(origin_ + cell_ * Eigen::Vector2d(column, row)), values_[last_ + i],
            arrival_[i]);
      }
    }
  }

  /// Finds the values. A cell from which the goal is nearer than a stage ends there.
  void solve(const Forecast& forecast, const EncounterCost& cost, bool ends_at_goal) noexcept;

  /// Returns the cost from a place in a layer on [s].
  [[nodiscard]] double at(double x, double y, std::size_t layer) const noexcept;

  [[nodiscard]] double cell() const noexcept { return cell_; }

 private:
  static constexpr std::size_t kSide = 48;
  static constexpr std::size_t kBorder = 2;
  static constexpr std::size_t kPitch = kSide + 2 * kBorder;
  static constexpr std::size_t kCells = kPitch * kPitch;

  void add_obstacle(const Forecast& forecast,
                    const EncounterCost& cost,
                    std::size_t sample,
                    std::size_t obstacle) noexcept;
  void step_back(float* earlier) noexcept;

  std::size_t stages_ = 0;
  float stage_ = 0.0F;  // [s]
  double cell_ = 0.0;   // [m]; a stage at full speed is two cells long
  double speed_ = 0.0;
  std::size_t last_ = 0;                              // where the last layer begins
  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero();  // middle of the first cell
  std::vector<float> values_;                         // layer by layer, row by row
  std::vector<float> arrival_;
  std::vector<float> entered_;  // of the layer in work
  std::vector<float> row_;      // least of three in a row
};

}  // namespace fairway
