// SPDX-License-Identifier: Apache-2.0
#include "fairway/tracking/space_time/cost_to_go.hpp"

#include <algorithm>
#include <cmath>

namespace fairway {

namespace {

constexpr float kOutsideOfGrid = 1000.0F;  // [s]

float smaller_of(float a, float b) noexcept { return a < b ? a : b; }
float greater_of(float a, float b) noexcept { return a > b ? a : b; }

}  // namespace

CostToGo::CostToGo(std::size_t stages, double stage, double speed)
    : arrival_(kCells, kOutsideOfGrid),
      entered_(kCells, kOutsideOfGrid),
      row_(kCells, kOutsideOfGrid) {
  set(stages, stage, speed);
}

// The border of a last layer must be outside of the grid. It is not if another number of stages was
// solved before.
void CostToGo::set(std::size_t stages, double stage, double speed) {
  stage_ = static_cast<float>(stage);
  cell_ = 0.5 * stage * speed;
  speed_ = speed;
  if (stages == stages_ && !values_.empty()) return;
  stages_ = stages;
  last_ = stages * kCells;
  values_.assign((stages + 1) * kCells, kOutsideOfGrid);
}

// The grid moves by whole cells. Otherwise its values would change slightly in every cycle.
void CostToGo::begin(const Eigen::Vector2d& center) noexcept {
  const double half = static_cast<double>(kPitch / 2);
  origin_ = cell_ * ((center / cell_).array().floor() - half).matrix();
}

// The costs rise with the squared distance, because a loop without square roots is faster.
void CostToGo::add_obstacle(const Forecast& forecast,
                            const EncounterCost& cost,
                            std::size_t sample,
                            std::size_t obstacle) noexcept {
  const EncounterCost::Shape shape = cost.shape(forecast, sample, obstacle, 0.7 * speed_);
  const auto column = [this](double x) {
    return std::clamp((x - origin_.x()) / cell_, double{kBorder}, double{kPitch - kBorder});
  };
  const auto row = [this](double y) {
    return std::clamp((y - origin_.y()) / cell_, double{kBorder}, double{kPitch - kBorder});
  };
  const double x = forecast.x[sample][obstacle];
  const double y = forecast.y[sample][obstacle];
  const auto first = static_cast<std::size_t>(std::ceil(column(x - shape.reach)));
  const auto end = static_cast<std::size_t>(std::ceil(column(x + shape.reach)));
  const auto top = static_cast<std::size_t>(std::ceil(row(y + shape.reach)));
  const auto size = static_cast<float>(cell_);
  const auto x0 = static_cast<float>(origin_.x() - x);
  const auto ahead_x = static_cast<float>(shape.ahead_x);
  const auto comfort_far = static_cast<float>(shape.comfort_far * shape.comfort_far);
  const auto comfort_per = static_cast<float>(
      1.0 / (shape.comfort_far * shape.comfort_far - shape.comfort_near * shape.comfort_near));
  const auto contact_far = static_cast<float>(shape.contact_far * shape.contact_far);
  const auto contact_per = static_cast<float>(
      1.0 / (shape.contact_far * shape.contact_far - shape.contact_near * shape.contact_near));
  const auto turn_far = static_cast<float>(shape.turn_far * shape.turn_far);
  const auto turn_per = static_cast<float>(
      1.0 / (shape.turn_far * shape.turn_far - shape.turn_near * shape.turn_near));
  const auto turn_cost = stage_ * static_cast<float>(shape.turn);
  const auto comfort_cost = stage_ * static_cast<float>(shape.comfort);
  const auto contact_cost = stage_ * static_cast<float>(shape.contact);
  for (auto r = static_cast<std::size_t>(std::ceil(row(y - shape.reach))); r < top; ++r) {
    const auto dy = static_cast<float>(origin_.y() + cell_ * static_cast<double>(r) - y);
    const float ahead_y = dy - static_cast<float>(shape.ahead_y);
    float* cells = entered_.data() + r * kPitch;
    for (std::size_t c = first; c < end; ++c) {
      const float dx = x0 + size * static_cast<float>(static_cast<int>(c));
      const float from_ahead = dx - ahead_x;
      const float squared = dx * dx + dy * dy;
      const float contact = (contact_far - squared) * contact_per;
      const float turn = smaller_of(1.0F, greater_of(0.0F, (turn_far - squared) * turn_per));
      const float comfort =
          (comfort_far - (from_ahead * from_ahead + ahead_y * ahead_y)) * comfort_per;
      const float near_by = smaller_of(1.0F, greater_of(0.0F, comfort));
      cells[c] += contact_cost * smaller_of(1.0F, greater_of(0.0F, contact)) +
                  comfort_cost * near_by * near_by + turn_cost * turn * turn;
    }
  }
}

// The least over the cells that a stage can come from: three by three, and then a cross.
void CostToGo::step_back(float* earlier) noexcept {
  for (std::size_t i = 1; i + 1 < kCells; ++i)
    row_[i] = smaller_of(smaller_of(entered_[i - 1], entered_[i]), entered_[i + 1]);
  for (std::size_t i = kPitch; i + kPitch < kCells; ++i)
    entered_[i] = smaller_of(smaller_of(row_[i - kPitch], row_[i]), row_[i + kPitch]);
  for (std::size_t i = kPitch; i + kPitch < kCells; ++i) {
    earlier[i] = smaller_of(smaller_of(smaller_of(entered_[i - 1], entered_[i]), entered_[i + 1]),
                            smaller_of(entered_[i - kPitch], entered_[i + kPitch]));
  }
}

void CostToGo::solve(const Forecast& forecast,
                     const EncounterCost& cost,
                     bool ends_at_goal) noexcept {
  const float* end = values_.data() + last_;
  for (std::size_t layer = stages_; layer > 0; --layer) {
    const float* later = values_.data() + layer * kCells;
    float* earlier = values_.data() + (layer - 1) * kCells;
    std::copy(arrival_.begin(), arrival_.end(), entered_.begin());
    for (std::size_t i = 0; i < forecast.count; ++i)
      add_obstacle(forecast, cost, 2 * layer, i);
    for (std::size_t i = 0; i < kCells; ++i)
      entered_[i] += later[i];
    step_back(earlier);
    if (!ends_at_goal) continue;
    for (std::size_t i = 0; i < kCells; ++i)
      earlier[i] = end[i] < stage_ ? end[i] : earlier[i];
  }
}

double CostToGo::at(double x, double y, std::size_t layer) const noexcept {
  constexpr double kFirst = kBorder;
  constexpr double kEnd = kPitch - kBorder - 1.001;
  const double u = std::clamp((x - origin_.x()) / cell_, kFirst, kEnd);
  const double v = std::clamp((y - origin_.y()) / cell_, kFirst, kEnd);
  const auto column = static_cast<std::size_t>(u);
  const auto row = static_cast<std::size_t>(v);
  const double right = u - static_cast<double>(column);
  const double up = v - static_cast<double>(row);
  const float* cell = values_.data() + layer * kCells + row * kPitch + column;
  const auto between = [right](const float* left) {
    return static_cast<double>(left[0]) + right * static_cast<double>(left[1] - left[0]);
  };
  const double low = between(cell);
  const double high = between(cell + kPitch);
  return low + up * (high - low);
}

}  // namespace fairway
