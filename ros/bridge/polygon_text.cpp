// SPDX-License-Identifier: Apache-2.0
#include "bridge/polygon_text.hpp"

#include <charconv>
#include <cmath>

namespace fairway::bridge {

namespace {

// Reads tokens, and skips the spaces between them.
class Reader {
 public:
  explicit Reader(std::string_view text) : rest_(text) {}

  [[nodiscard]] bool take(char token) {
    skip_spaces();
    if (rest_.empty() || rest_.front() != token) return false;
    rest_.remove_prefix(1);
    return true;
  }
  [[nodiscard]] bool take(double& number) {
    skip_spaces();
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return false;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return true;
  }
  [[nodiscard]] bool at_end() {
    skip_spaces();
    return rest_.empty();
  }

 private:
  void skip_spaces() {
    while (!rest_.empty() && rest_.front() == ' ')
      rest_.remove_prefix(1);
  }
  std::string_view rest_;
};

bool read_polygon(Reader reader, Polygon& polygon) {
  if (reader.at_end()) return true;
  if (!reader.take('[')) return false;
  if (reader.take(']')) return reader.at_end();
  do {
    Eigen::Vector2d corner;
    if (!reader.take('[') || !reader.take(corner.x()) || !reader.take(',') ||
        !reader.take(corner.y()) || !reader.take(']'))
      return false;
    polygon.push_back(corner);
  } while (reader.take(','));
  return reader.take(']') && reader.at_end() && polygon.size() >= 3;
}

}  // namespace

Expected<Polygon> polygon_of(const std::string& name, std::string_view text) {
  Polygon polygon;
  if (read_polygon(Reader(text), polygon)) return polygon;
  constexpr std::size_t kLongest = 40;
  return fail(name + ": expected a polygon [[x, y], [x, y], [x, y], ...] in metres, found " +
              std::string(text.substr(0, kLongest)));
}

}  // namespace fairway::bridge
