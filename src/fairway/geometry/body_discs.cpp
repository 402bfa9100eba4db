// SPDX-License-Identifier: Apache-2.0
#include <charconv>
#include <cmath>

#include "fairway/geometry/footprint.hpp"

namespace fairway {

namespace {

bool in_range(const Eigen::Vector2d& center, double radius) noexcept {
  // This form also rejects NaN.
  return std::abs(center.x()) <= BodyDiscs::kMostOffset &&
         std::abs(center.y()) <= BodyDiscs::kMostOffset && radius >= BodyDiscs::kLeastRadius &&
         radius <= BodyDiscs::kMostRadius;
}

// Reads lists and numbers from the front of a text.
class Reader {
 public:
  explicit Reader(std::string_view text) noexcept : text_(text) {}

  [[nodiscard]] bool take(char wanted) noexcept {
    skip_spaces();
    if (text_.empty() || text_.front() != wanted) return false;
    text_.remove_prefix(1);
    return true;
  }

  [[nodiscard]] std::optional<double> number() noexcept {
    skip_spaces();
    if (!text_.empty() && text_.front() == '+') text_.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (error != std::errc()) return std::nullopt;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return value;
  }

  [[nodiscard]] bool at_end() noexcept {
    skip_spaces();
    return text_.empty();
  }

 private:
  void skip_spaces() noexcept {
    while (!text_.empty() && (text_.front() == ' ' || text_.front() == '\t'))
      text_.remove_prefix(1);
  }

  std::string_view text_;
};

bool read_disc(Reader& reader, BodyDiscs& discs) noexcept {
  if (!reader.take('[')) return false;
  const auto x = reader.number();
  if (!x || !reader.take(',')) return false;
  const auto y = reader.number();
  if (!y || !reader.take(',')) return false;
  const auto radius = reader.number();
  return radius && reader.take(']') && discs.add({*x, *y}, *radius);
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

}  // namespace

bool BodyDiscs::add(const Eigen::Vector2d& center, double radius) noexcept {
  if (count == Footprint::kMaxDiscs || !in_range(center, radius)) return false;
  discs[static_cast<std::size_t>(count++)] = {.center = center, .radius = radius};
  return true;
}

bool is_valid(const BodyDiscs& discs) noexcept {
  if (discs.count < 0 || discs.count > Footprint::kMaxDiscs) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(discs.count); ++i) {
    if (!in_range(discs.discs[i].center, discs.discs[i].radius)) return false;
  }
  return true;
}

bool operator==(const BodyDiscs& a, const BodyDiscs& b) noexcept {
  if (a.count != b.count) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.count); ++i) {
    if (a.discs[i].center != b.discs[i].center || a.discs[i].radius != b.discs[i].radius)
      return false;
  }
  return true;
}

std::string to_text(const BodyDiscs& discs) {
  std::string text = "[";
  for (std::size_t i = 0; i < static_cast<std::size_t>(discs.count); ++i) {
    const Footprint::Disc& disc = discs.discs[i];
    text.append(i == 0 ? "[" : ", [").append(number_text(disc.center.x()));
    text.append(", ").append(number_text(disc.center.y()));
    text.append(", ").append(number_text(disc.radius)).append("]");
  }
  return text.append("]");
}

std::optional<BodyDiscs> parse_body_discs(std::string_view text) noexcept {
  Reader reader(text);
  BodyDiscs discs;
  if (!reader.take('[')) return std::nullopt;
  if (!reader.take(']')) {
    do {
      if (!read_disc(reader, discs)) return std::nullopt;
    } while (reader.take(','));
    if (!reader.take(']')) return std::nullopt;
  }
  return reader.at_end() ? std::optional(discs) : std::nullopt;
}

}  // namespace fairway
