// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/web_report/compact_fields.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "fairway/io/recording/exact/exact_json.hpp"

namespace fairway::io {

namespace {

std::int64_t scaled(double value, double scale) noexcept {
  if (!std::isfinite(value)) return 0;
  return std::llround(std::clamp(value * scale, -1e12, 1e12));
}

}  // namespace

void CompactFields::count(std::uint64_t value) {
  while (value >= 128) {
    bytes_->push_back(static_cast<char>(value % 128 + 128));
    value /= 128;
  }
  bytes_->push_back(static_cast<char>(value));
}

void CompactFields::integer(std::int64_t value) {
  count(value < 0 ? 2 * static_cast<std::uint64_t>(-(value + 1)) + 1
                  : 2 * static_cast<std::uint64_t>(value));
}

void CompactFields::millis(double value) { integer(scaled(value, 1e3)); }

void CompactFields::angle(double value) { integer(scaled(value, 1e4)); }

void CompactFields::point(const Eigen::Vector2d& p) {
  millis(p.x());
  millis(p.y());
}

void CompactFields::real(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (int i = 0; i < 8; ++i)
    bytes_->push_back(static_cast<char>(bits >> (8 * i) & 0xFFU));
}

void CompactFields::text(std::string_view value) {
  count(value.size());
  bytes_->append(value);
}

PointDeltas::PointDeltas(CompactFields& out, const Eigen::Vector2d& from)
    : out_(&out),
      x_(scaled(from.x(), 1e3)),
      y_(scaled(from.y(), 1e3)) {}

void PointDeltas::append(const Eigen::Vector2d& p) {
  const std::int64_t x = scaled(p.x(), 1e3);
  const std::int64_t y = scaled(p.y(), 1e3);
  out_->integer(x - x_);
  out_->integer(y - y_);
  x_ = x;
  y_ = y;
}

std::size_t append_changes(CompactFields& out,
                           double time,
                           const BitGrid& before,
                           const BitGrid& now) {
  const auto runs = exact::changed_cells(before, now);
  out.time(time);
  out.count(runs.size() / 4);
  for (const auto& number : runs)
    out.count(number.get<std::uint64_t>());
  return runs.size() / 4;
}

}  // namespace fairway::io
