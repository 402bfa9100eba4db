// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "fairway/map/bit_grid.hpp"

namespace fairway::io {

/// Appends numbers in few bytes, with seven bits per byte and the last byte below 128. Signed
/// numbers are stored as zigzag (0, -1, 1, -2, ... become 0, 1, 2, 3, ...). Numbers that are not
/// finite become 0, and large ones are clamped.
class CompactFields {
 public:
  explicit CompactFields(std::string& bytes) : bytes_(&bytes) {}

  void count(std::uint64_t value);
  void integer(std::int64_t value);
  void millis(double value);  ///< thousandths
  void angle(double value);   ///< tenths of thousandths
  void time(double value) { millis(value); }
  void point(const Eigen::Vector2d& p);
  void real(double value);  ///< as in memory, little-endian
  void text(std::string_view value);

 private:
  std::string* bytes_;
};

/// Appends points as differences, without accumulating rounding errors.
class PointDeltas {
 public:
  explicit PointDeltas(CompactFields& out, const Eigen::Vector2d& from = Eigen::Vector2d::Zero());
  void append(const Eigen::Vector2d& p);

 private:
  CompactFields* out_;
  std::int64_t x_;
  std::int64_t y_;
};

/// Appends a time and the runs of cells that differ. These are the number of runs, then y, x, count
/// and value of each.
/// @return the number of runs. @pre the same frame.
std::size_t append_changes(CompactFields& out,
                           double time,
                           const BitGrid& before,
                           const BitGrid& now);

}  // namespace fairway::io
