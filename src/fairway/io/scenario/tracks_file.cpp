// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/tracks_file.hpp"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include "fairway/io/number_text.hpp"
#include "fairway/io/whole_file.hpp"

namespace fairway::io {

namespace {

constexpr std::size_t kLargestFile = 64U << 20U;  // [bytes]
constexpr double kFurthestPlace = 1e7;            // [m]
constexpr double kMostFrames = 1e9;
constexpr std::array<const char*, 8> kColumns{"frame", "id", "x", "z", "y", "vx", "vz", "vy"};

// Removes the next word from a line and returns it; empty at the end.
std::string_view take_word(std::string_view& line) {
  const std::size_t begin = line.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) {
    line = {};
    return {};
  }
  line.remove_prefix(begin);
  const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
  line.remove_prefix(word.size());
  return word;
}

using Row = std::array<double, kColumns.size()>;

// The numbers of a line; none for an empty one.
Expected<std::optional<Row>> read_row(std::string_view line) {
  Row row{};
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string_view word = take_word(line);
    if (word.empty() && i == 0) return std::nullopt;
    const std::optional<double> number = parse_number(word);
    if (!number) {
      return fail(fmt::format("{}: expected a number, found {}", kColumns[i],
                              word.empty() ? "the end of the line" : excerpt(word)));
    }
    row[i] = *number;
  }
  if (const std::string_view more = take_word(line); !more.empty()) {
    return fail(fmt::format("expected 8 numbers, found more: {}", excerpt(more)));
  }
  if (std::abs(row[0]) > kMostFrames) {
    return fail(fmt::format("frame: expected a number up to {:g}, found {}", kMostFrames, row[0]));
  }
  if (row[1] != std::floor(row[1]) || row[1] < 0.0 || row[1] > kMostFrames) {
    return fail(
        fmt::format("id: expected a whole number from 0 to {:g}, found {}", kMostFrames, row[1]));
  }
  if (std::abs(row[2]) > kFurthestPlace || std::abs(row[4]) > kFurthestPlace) {
    return fail(
        fmt::format("expected places to {:g} m, found [{}, {}]", kFurthestPlace, row[2], row[4]));
  }
  return row;
}

}  // namespace

Expected<std::vector<MovingBody>> read_tracks(const std::string& path, const TracksFormat& format) {
  const Expected<std::string> text = read_whole_file(path, kLargestFile);
  if (!text) return tl::unexpected(text.error());
  std::map<long, MovingBody> people;
  std::string_view rest = *text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    const Expected<std::optional<Row>> row = read_row(line);
    if (!row) return fail(fmt::format("{}:{}: {}", path, number, row.error().message));
    if (!*row) continue;
    const auto& [frame, id, x, z, y, vx, vz, vy] = **row;
    MovingBody& person = people[static_cast<long>(id)];
    const double time = frame / format.frame_rate;
    if (!person.key_frames.empty() && time <= person.key_frames.back().time) {
      return fail(fmt::format("{}:{}: frame: expected one after {} of person {}, found {}", path,
                              number, person.key_frames.back().time * format.frame_rate, id,
                              frame));
    }
    person.key_frames.push_back({.time = time, .position = {x, y}});
  }
  if (people.empty()) return fail(path + ":1: expected tracks of people, found none");
  std::vector<MovingBody> bodies;
  for (auto& [id, person] : people) {
    person.name = fmt::format("person {}", id);
    person.radius = format.radius;
    person.passing = true;
    bodies.push_back(std::move(person));
  }
  return bodies;
}

}  // namespace fairway::io
