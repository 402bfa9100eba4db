// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cstdint>
#include <stdexcept>

#include "fairway/base/contract.hpp"
#include "fairway/io/base64.hpp"
#include "fairway/io/recording/exact/exact_json.hpp"
#include "fairway/map/occupancy_grid.hpp"

namespace fairway::io::exact {

namespace {

void append_word(std::string& bytes, std::uint64_t word) {
  for (int i = 0; i < 8; ++i)
    bytes.push_back(static_cast<char>(word >> (8 * i) & 0xFFU));
}

std::uint64_t word_at(std::string_view bytes, std::size_t index) noexcept {
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < 8; ++i)
    word |= static_cast<std::uint64_t>(static_cast<std::uint8_t>(bytes[8 * index + i])) << (8 * i);
  return word;
}

}  // namespace

Json to_json(const GridFrame& frame) {
  return {{"width", frame.width},
          {"height", frame.height},
          {"resolution", to_json(frame.resolution)},
          {"origin", to_json(frame.origin)}};
}

GridFrame to_frame(const Json& json) {
  const GridFrame frame{.width = json.at("width").get<int>(),
                        .height = json.at("height").get<int>(),
                        .resolution = to_number(json.at("resolution")),
                        .origin = to_pose(json.at("origin"))};
  const auto is_side = [](int cells) { return cells >= 1 && cells <= OccupancyGrid::kMaxSide; };
  if (!is_side(frame.width) || !is_side(frame.height) || !(frame.resolution > 0.0) ||
      !std::isfinite(frame.resolution) || !is_finite(frame.origin)) {
    throw std::invalid_argument("expected a map of 1 to " +
                                std::to_string(OccupancyGrid::kMaxSide) + " cells a side");
  }
  return frame;
}

Json to_json(const BitGrid& grid) {
  std::string bytes;
  for (int y = 0; y < grid.frame().height; ++y) {
    for (const std::uint64_t word : grid.row(y))
      append_word(bytes, word);
  }
  return {{"frame", to_json(grid.frame())}, {"bits", to_base64(bytes)}};
}

BitGrid to_grid(const Json& json) {
  const GridFrame frame = to_frame(json.at("frame"));
  const auto bytes = from_base64(json.at("bits").get_ref<const std::string&>());
  const std::size_t words_per_row = (static_cast<std::size_t>(frame.width) + 63) / 64;
  if (!bytes || bytes->size() != 8 * words_per_row * static_cast<std::size_t>(frame.height)) {
    throw std::invalid_argument("expected as many bits as the map has cells");
  }
  BitGrid grid(frame, false);
  // Bits past the width must stay 0.
  const int used = frame.width % 64;
  const std::uint64_t last_mask = used == 0 ? ~0ULL : (1ULL << used) - 1;
  grid.rewrite([&](const auto& words_of_row) {
    for (int y = 0; y < frame.height; ++y) {
      const std::span<std::uint64_t> row = words_of_row(y);
      for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = word_at(*bytes, static_cast<std::size_t>(y) * words_per_row + i);
      row.back() &= last_mask;
    }
  });
  return grid;
}

Json changed_cells(const BitGrid& before, const BitGrid& now) {
  FAIRWAY_EXPECTS(same_frame(before.frame(), now.frame()));
  Json runs = Json::array();
  for (int y = 0; y < now.frame().height; ++y) {
    const auto old_row = before.row(y);
    const auto row = now.row(y);
    for (std::size_t i = 0; i < row.size(); ++i) {
      std::uint64_t difference = old_row[i] ^ row[i];
      while (difference != 0) {
        const int first = std::countr_zero(difference);
        const bool blocked = (row[i] >> first & 1U) != 0;
        // Adjacent changed cells of one value within the word.
        const std::uint64_t alike = difference & (blocked ? row[i] : ~row[i]);
        const int count = std::countr_one(alike >> first);
        for (const int number :
             {y, static_cast<int>(i) * 64 + first, count, static_cast<int>(blocked)})
          runs.push_back(number);
        const std::uint64_t run = count == 64 ? ~0ULL : ((1ULL << count) - 1) << first;
        difference &= ~run;
      }
    }
  }
  return runs;
}

void change_cells(const Json& runs, BitGrid& grid) {
  for (std::size_t i = 0; i < runs.size(); i += 4) {
    const int y = runs.at(i).get<int>();
    const int first = runs.at(i + 1).get<int>();
    const int count = runs.at(i + 2).get<int>();
    const bool blocked = runs.at(i + 3).get<int>() != 0;
    if (count < 1 || count > 64 || !grid.frame().contains({.x = first, .y = y}) ||
        !grid.frame().contains({.x = first + count - 1, .y = y})) {
      throw std::invalid_argument("expected changed cells inside the map");
    }
    for (int x = first; x < first + count; ++x)
      grid.set({.x = x, .y = y}, blocked);
  }
}

}  // namespace fairway::io::exact
