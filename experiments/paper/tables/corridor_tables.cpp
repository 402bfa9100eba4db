// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/tables/corridor_tables.hpp"

#include <array>

#include "experiments/paper/tables/json_numbers.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

namespace {

constexpr auto kCount = [](const CorridorOutcome& o) { return o.rectangles.size(); };
constexpr auto kArea = [](const CorridorOutcome& o) { return o.mean_area; };
constexpr auto kSeconds = [](const CorridorOutcome& o) { return o.seconds; };
constexpr auto kHolding = [](const CorridorOutcome& o) { return o.holding; };
constexpr auto kBreaks = [](const CorridorOutcome& o) { return o.breaks; };
constexpr auto kIsBroken = [](const CorridorOutcome& o) { return o.breaks > 0 ? 1 : 0; };
constexpr auto kIsComplete = [](const CorridorOutcome& o) { return o.complete ? 1 : 0; };

// Table II as printed, with the rows SRC, FSRC and MDSRC. The columns are number, mean area [m^2]
// and total time [s] in Environment 1, then in Environment 2.
struct PaperRow {
  std::array<double, 3> first;
  std::array<double, 3> second;
};
constexpr std::array<PaperRow, 3> kPaper = {PaperRow{{52, 6.94, 0.002}, {17, 7.59, 0.001}},
                                            PaperRow{{52, 6.94, 0.001}, {17, 7.59, 0.0002}},
                                            PaperRow{{30, 12.80, 0.004}, {12, 11.92, 0.002}}};

// The printed values of a method and an environment, or null.
const std::array<double, 3>* printed(CorridorKind method, MapKind environment) {
  const auto row = static_cast<std::size_t>(method);
  if (row >= kPaper.size()) return nullptr;
  if (environment == MapKind::UnstructuredLarge) return &kPaper.at(row).first;
  return environment == MapKind::UnstructuredSmall ? &kPaper.at(row).second : nullptr;
}

std::string printed_text(CorridorKind method, MapKind kind, std::size_t column, int decimals) {
  const std::array<double, 3>* row = printed(method, kind);
  return row == nullptr ? "\u2013" : fixed(row->at(column), decimals);
}

double sum(const std::vector<double>& values) {
  double total = 0.0;
  for (const double value : values)
    total += value;
  return total;
}

struct Pair {
  CorridorKind method;
  CorridorKind base;
};
constexpr std::array<Pair, 4> kMethodPairs = {
    Pair{CorridorKind::MdsrcPublished, CorridorKind::SrcPublished},
    Pair{CorridorKind::MdsrcSound, CorridorKind::SrcSound},
    Pair{CorridorKind::Fewest, CorridorKind::SrcSound},
    Pair{CorridorKind::Fewest, CorridorKind::MdsrcSound}};

std::string pair_name(const Pair& pair) {
  return std::string(to_text(pair.method)) + " against " + to_text(pair.base);
}

Json gain_json(const CorridorGain& gain) {
  return {{"count_change_percent", to_json(gain.fewer)},
          {"area_change_percent_of_other", to_json(gain.larger)},
          {"area_change_percent_of_own", to_json(gain.larger_of_own)},
          {"count_welch_test", to_json(gain.count_welch)},
          {"count_paired_test", to_json(gain.count_paired)},
          {"area_welch_test", to_json(gain.area_welch)},
          {"area_paired_test", to_json(gain.area_paired)}};
}

}  // namespace

CorridorGain gain_over(const std::vector<CorridorComparison>& maps,
                       CorridorKind method,
                       CorridorKind other) {
  const std::vector<double> counts = column(maps, method, kCount);
  const std::vector<double> other_counts = column(maps, other, kCount);
  const std::vector<double> areas = column(maps, method, kArea);
  const std::vector<double> other_areas = column(maps, other, kArea);
  std::vector<double> of_own = percent_over(other_areas, areas);
  for (double& value : of_own)
    value = -value;
  return {.fewer = estimate(percent_over(counts, other_counts)),
          .larger = estimate(percent_over(areas, other_areas)),
          .larger_of_own = estimate(of_own),
          .count_welch = welch_test(counts, other_counts),
          .count_paired = paired_test(counts, other_counts),
          .area_welch = welch_test(areas, other_areas),
          .area_paired = paired_test(areas, other_areas)};
}

Table table_two(const std::vector<CorridorEnvironment>& environments) {
  Table table{.caption =
                  "Table II: number of corridors NC and mean area MA [m\u00b2]. Paper: its one "
                  "map. Ours: mean over maps \u00b1 95 % confidence.",
              .header = {"method"},
              .rows = {}};
  for (const CorridorEnvironment& e : environments) {
    for (const char* name : {"NC paper", "NC Fairway", "MA paper", "MA Fairway"})
      table.header.push_back(e.name + ": " + name);
  }
  for (std::size_t i = 0; i < kCorridorKinds; ++i) {
    const auto method = static_cast<CorridorKind>(i);
    std::vector<std::string> row = {to_text(method)};
    for (const CorridorEnvironment& e : environments) {
      row.push_back(printed_text(method, e.kind, 0, 0));
      row.push_back(with_interval(estimate(column(e.maps, method, kCount)), 1));
      row.push_back(printed_text(method, e.kind, 1, 2));
      row.push_back(with_interval(estimate(column(e.maps, method, kArea)), 2));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table gain_table(const std::vector<CorridorEnvironment>& environments) {
  Table table{
      .caption =
          "Gains, map by map, \u00b1 95 % confidence. The paper's \u201c\u221235.86 % corridors, "
          "+41.05 % area\u201d are means over its two maps, the area relative to MDSRC's own; "
          "relative to SRC, its area grows by 84.4 % and 57.0 %.",
      .header = {"comparison"},
      .rows = {}};
  for (const CorridorEnvironment& e : environments) {
    for (const char* name : {"number", "area, relative to the other", "area, relative to its own"})
      table.header.push_back(e.name + ": " + name);
  }
  std::vector<std::string> paper = {"paper: MDSRC against SRC"};
  for (const CorridorEnvironment& e : environments) {
    const auto* src = printed(CorridorKind::SrcPublished, e.kind);
    const auto* mdsrc = printed(CorridorKind::MdsrcPublished, e.kind);
    const bool known = src != nullptr && mdsrc != nullptr;
    paper.push_back(known ? fixed(100.0 * (mdsrc->at(0) / src->at(0) - 1.0), 1) + " %" : "\u2013");
    paper.push_back(known
                        ? fmt::format("+{} %", fixed(100.0 * (mdsrc->at(1) / src->at(1) - 1.0), 1))
                        : "\u2013");
    paper.push_back(known
                        ? fmt::format("+{} %", fixed(100.0 * (1.0 - src->at(1) / mdsrc->at(1)), 1))
                        : "\u2013");
  }
  table.rows.push_back(std::move(paper));
  for (const Pair& pair : kMethodPairs) {
    std::vector<std::string> row = {pair_name(pair)};
    for (const CorridorEnvironment& e : environments) {
      const CorridorGain gain = gain_over(e.maps, pair.method, pair.base);
      row.push_back(percent_interval(gain.fewer));
      row.push_back(percent_interval(gain.larger));
      row.push_back(percent_interval(gain.larger_of_own));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table soundness_table(const std::vector<CorridorEnvironment>& environments) {
  Table table{.caption =
                  "Not visible in the numbers above: rectangles that contain a part of an "
                  "obstacle (more than 1 mm deep), and chains in which neighbours, contracted by "
                  "\u0394s, do not overlap.",
              .header = {"method"},
              .rows = {}};
  for (const CorridorEnvironment& e : environments) {
    for (const char* name : {"rectangles with obstacle", "chains broken", "chains incomplete"})
      table.header.push_back(e.name + ": " + name);
  }
  for (std::size_t i = 0; i < kCorridorKinds; ++i) {
    const auto method = static_cast<CorridorKind>(i);
    std::vector<std::string> row = {to_text(method)};
    for (const CorridorEnvironment& e : environments) {
      const double rectangles = sum(column(e.maps, method, kCount));
      const auto maps = static_cast<double>(e.maps.size());
      row.push_back(fixed(100.0 * sum(column(e.maps, method, kHolding)) / rectangles, 1) + " %");
      row.push_back(fixed(sum(column(e.maps, method, kIsBroken)), 0) + " of " + fixed(maps, 0));
      row.push_back(fixed(maps - sum(column(e.maps, method, kIsComplete)), 0) + " of " +
                    fixed(maps, 0));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table corridor_times(const std::vector<CorridorEnvironment>& environments) {
  Table table{
      .caption =
          "Total generation time TS of a path's corridors [ms]: the fastest of three "
          "runs, thread CPU time, mean over maps. The paper's times are from an i7-14650HX.",
      .header = {"method"},
      .rows = {}};
  for (const CorridorEnvironment& e : environments) {
    table.header.push_back(e.name + ": TS paper");
    table.header.push_back(e.name + ": TS Fairway");
  }
  for (std::size_t i = 0; i < kCorridorKinds; ++i) {
    const auto method = static_cast<CorridorKind>(i);
    std::vector<std::string> row = {to_text(method)};
    for (const CorridorEnvironment& e : environments) {
      const auto* paper = printed(method, e.kind);
      row.push_back(paper == nullptr ? "\u2013" : fixed(1e3 * paper->at(2), 1));
      row.push_back(fixed(1e3 * estimate(column(e.maps, method, kSeconds)).mean, 3));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Json corridor_numbers(const std::vector<CorridorEnvironment>& environments) {
  Json all = Json::object();
  for (const CorridorEnvironment& e : environments) {
    Json methods = Json::object();
    for (std::size_t i = 0; i < kCorridorKinds; ++i) {
      const auto method = static_cast<CorridorKind>(i);
      Json one = {{"count", to_json(estimate(column(e.maps, method, kCount)))},
                  {"mean_area", to_json(estimate(column(e.maps, method, kArea)))},
                  {"rectangles", sum(column(e.maps, method, kCount))},
                  {"rectangles_holding_obstacles", sum(column(e.maps, method, kHolding))},
                  {"neighbours_not_meeting", sum(column(e.maps, method, kBreaks))},
                  {"broken_chains", sum(column(e.maps, method, kIsBroken))},
                  {"complete_chains", sum(column(e.maps, method, kIsComplete))},
                  {"counts", column(e.maps, method, kCount)},
                  {"mean_areas", column(e.maps, method, kArea)}};
      if (const auto* paper = printed(method, e.kind)) {
        one["paper"] = {{"count", paper->at(0)},
                        {"mean_area", paper->at(1)},
                        {"generation_seconds", paper->at(2)}};
      }
      methods[to_text(method)] = std::move(one);
    }
    Json gains = Json::object();
    for (const Pair& pair : kMethodPairs)
      gains[pair_name(pair)] = gain_json(gain_over(e.maps, pair.method, pair.base));
    Json seeds = Json::array();
    Json lengths = Json::array();
    for (const CorridorComparison& map : e.maps) {
      seeds.push_back(map.seed);
      lengths.push_back(map.path.length());
    }
    all[e.name] = {{"map_kind", to_text(e.kind)},
                   {"map_seeds", std::move(seeds)},
                   {"path_lengths", std::move(lengths)},
                   {"methods", std::move(methods)},
                   {"gains", std::move(gains)}};
  }
  return all;
}

Json corridor_timing(const std::vector<CorridorEnvironment>& environments) {
  Json all = Json::object();
  for (const CorridorEnvironment& e : environments) {
    for (std::size_t i = 0; i < kCorridorKinds; ++i) {
      const auto method = static_cast<CorridorKind>(i);
      all[e.name][to_text(method)] = {
          {"generation_seconds", to_json(estimate(column(e.maps, method, kSeconds)))}};
    }
  }
  return all;
}

}  // namespace fairway::reproduction
