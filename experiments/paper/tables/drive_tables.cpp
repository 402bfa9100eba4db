// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/tables/drive_tables.hpp"

#include <algorithm>

#include "experiments/paper/tables/json_numbers.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

namespace {

constexpr std::array kDrivers = {DriverKind::Smpc, DriverKind::Ismpc, DriverKind::Ours};

struct DriverPair {
  DriverKind kind;
  DriverKind base;
};
constexpr std::array kDriverPairs = {DriverPair{DriverKind::Ismpc, DriverKind::Smpc},
                                     DriverPair{DriverKind::Ours, DriverKind::Smpc},
                                     DriverPair{DriverKind::Ours, DriverKind::Ismpc}};

std::string pair_name(const DriverPair& pair) {
  return std::string(to_text(pair.kind)) + " against " + to_text(pair.base);
}

// The name of a measure in results.json; units are m and s.
const char* key_of(DriveMeasure measure) {
  switch (measure) {
    case DriveMeasure::Length:
      return "length";
    case DriveMeasure::Time:
      return "time";
    case DriveMeasure::Smoothness:
      return "smoothness";
    case DriveMeasure::Switches:
      return "switches";
  }
  return "unknown";
}

int decimals(DriveMeasure measure) {
  return measure == DriveMeasure::Length || measure == DriveMeasure::Time ? 2 : 0;
}

double least_clearance(const DriveRuns& runs, DriverKind kind) {
  double least = runs.maps.front().of(kind).min_clearance;
  for (const DriveComparison& map : runs.maps)
    least = std::min(least, map.of(kind).min_clearance);
  return least;
}

// The extremes over all maps of a course.
struct SpeedRange {
  Twist2 least;
  Twist2 greatest;
  Twist2 change;
};

SpeedRange speeds(const DriveRuns& runs, DriverKind kind) {
  SpeedRange range;
  for (const DriveComparison& map : runs.maps) {
    const Drive& d = map.of(kind);
    range.least.linear = std::min(range.least.linear, d.least.linear);
    range.least.angular = std::min(range.least.angular, d.least.angular);
    range.greatest.linear = std::max(range.greatest.linear, d.greatest.linear);
    range.greatest.angular = std::max(range.greatest.angular, d.greatest.angular);
    range.change.linear = std::max(range.change.linear, d.greatest_change.linear);
    range.change.angular = std::max(range.change.angular, d.greatest_change.angular);
  }
  return range;
}

std::string range_text(double least, double greatest) {
  return fmt::format("{} to {}", fixed(least, 2), fixed(greatest, 2));
}

Json speeds_json(const SpeedRange& range) {
  return {{"linear", {range.least.linear, range.greatest.linear}},
          {"angular", {range.least.angular, range.greatest.angular}},
          {"greatest_linear_change_per_second", range.change.linear},
          {"greatest_angular_change_per_second", range.change.angular}};
}

Json driver_json(const DriveRuns& runs, DriverKind kind) {
  Json json = {{"reached", runs.reached(kind)},
               {"contacts", runs.collided(kind)},
               {"least_clearance", least_clearance(runs, kind)},
               {"speeds", speeds_json(speeds(runs, kind))}};
  for (const DriveMeasure measure : kDriveMeasures)
    json[key_of(measure)] = to_json(estimate(values(runs, kind, measure)));
  Json each = Json::array();
  for (const DriveComparison& map : runs.maps) {
    const Drive& d = map.of(kind);
    each.push_back({{"map_seed", map.seed},
                    {"reached", d.reached},
                    {"contact", d.collided},
                    {"time", d.time},
                    {"length", d.length},
                    {"smoothness", d.smoothness},
                    {"switches", d.switches},
                    {"corridors", d.plan.corridor.rectangles.size()},
                    {"min_clearance", d.min_clearance},
                    {"cycles_braked_by_stop_check", d.stop_cycles}});
  }
  json["runs"] = std::move(each);
  return json;
}

}  // namespace

Table drive_table(const DriveRuns& runs) {
  Table table{
      .caption = fmt::format(
          "Case 1: means over the {} of {} maps on which all three arrive, \u00b1 95 % "
          "confidence. Smoothness: integral of (du/dt)\u00b2 + (dr/dt)\u00b2 of the commands "
          "[m\u00b2/s\u00b3 + rad\u00b2/s\u00b3], less is smoother. The paper gives no numbers.",
          runs.comparable().size(), runs.maps.size()),
      .header = {"method"},
      .rows = {}};
  for (const DriveMeasure measure : kDriveMeasures)
    table.header.emplace_back(to_text(measure));
  for (const char* name :
       {"contacts", "least clearance [m]", "linear speed [m/s]", "angular speed [rad/s]",
        "greatest change of linear speed [m/s\u00b2]", "of angular speed [rad/s\u00b2]"}) {
    table.header.emplace_back(name);
  }
  for (const DriverKind kind : kDrivers) {
    std::vector<std::string> row = {to_text(kind)};
    for (const DriveMeasure measure : kDriveMeasures)
      row.push_back(with_interval(estimate(values(runs, kind, measure)), decimals(measure)));
    const SpeedRange range = speeds(runs, kind);
    row.push_back(std::to_string(runs.collided(kind)));
    row.push_back(fixed(least_clearance(runs, kind), 3));
    row.push_back(range_text(range.least.linear, range.greatest.linear));
    row.push_back(range_text(range.least.angular, range.greatest.angular));
    row.push_back(fixed(range.change.linear, 1));
    row.push_back(fixed(range.change.angular, 1));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table drive_example_table(const DriveComparison& map) {
  Table table{.caption = fmt::format("The map of Figures 5 and 6 (seed {}).", map.seed),
              .header = {"method", "corridors"},
              .rows = {}};
  for (const DriveMeasure measure : kDriveMeasures)
    table.header.emplace_back(to_text(measure));
  for (const DriverKind kind : kDrivers) {
    const Drive& d = map.of(kind);
    std::vector<std::string> row = {to_text(kind),
                                    std::to_string(d.plan.corridor.rectangles.size())};
    for (const DriveMeasure measure : kDriveMeasures)
      row.push_back(fixed(value_of(d, measure), decimals(measure)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table drive_change_table(const DriveRuns& runs) {
  Table table{.caption =
                  "Case 1: changes map by map, \u00b1 95 % confidence, and p of Welch's "
                  "two-sample t-test (Boost.Math).",
              .header = {"comparison"},
              .rows = {}};
  for (const DriveMeasure measure : kDriveMeasures)
    table.header.emplace_back(to_text(measure));
  for (const DriverPair& pair : kDriverPairs) {
    std::vector<std::string> row = {pair_name(pair)};
    for (const DriveMeasure measure : kDriveMeasures) {
      const TestResult test =
          welch_test(values(runs, pair.kind, measure), values(runs, pair.base, measure));
      row.push_back(fmt::format("{} ({})",
                                percent_interval(change(runs, pair.kind, pair.base, measure)),
                                p_text(test.p)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table arrival_table(const std::vector<DriveRuns>& courses) {
  Table table{.caption = "Arrivals within 120 s, and contacts.", .header = {"method"}, .rows = {}};
  for (const DriveRuns& runs : courses) {
    table.header.push_back(std::string(to_text(runs.course)) + ": success rate");
    table.header.emplace_back("contacts");
  }
  for (const DriverKind kind : kDrivers) {
    std::vector<std::string> row = {to_text(kind)};
    for (const DriveRuns& runs : courses) {
      row.push_back(fmt::format("{} of {}", runs.reached(kind), runs.maps.size()));
      row.push_back(std::to_string(runs.collided(kind)));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table solve_times(const std::vector<DriveRuns>& courses) {
  Table table{.caption =
                  "Solver time per control cycle [us], thread CPU time: median over maps of the "
                  "maps' medians and 99th percentiles. Ours solves a horizon twice as long from "
                  "two starts.",
              .header = {"method"},
              .rows = {}};
  for (const DriveRuns& runs : courses) {
    table.header.push_back(std::string(to_text(runs.course)) + ": median");
    table.header.emplace_back("99 %");
  }
  for (const DriverKind kind : kDrivers) {
    std::vector<std::string> row = {to_text(kind)};
    for (const DriveRuns& runs : courses) {
      std::vector<double> medians;
      std::vector<double> tails;
      for (const DriveComparison& map : runs.maps) {
        medians.push_back(map.of(kind).solve.median);
        tails.push_back(map.of(kind).solve.p99);
      }
      row.push_back(fixed(1e6 * quantiles(medians).median, 1));
      row.push_back(fixed(1e6 * quantiles(tails).median, 1));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Json drive_numbers(const std::vector<DriveRuns>& courses) {
  Json all = Json::object();
  for (const DriveRuns& runs : courses) {
    Json drivers = Json::object();
    for (const DriverKind kind : kDrivers)
      drivers[to_text(kind)] = driver_json(runs, kind);
    Json changes = Json::object();
    for (const DriverPair& pair : kDriverPairs) {
      for (const DriveMeasure measure : kDriveMeasures) {
        const std::vector<double> a = values(runs, pair.kind, measure);
        const std::vector<double> b = values(runs, pair.base, measure);
        changes[pair_name(pair)][key_of(measure)] = {
            {"change_percent", to_json(change(runs, pair.kind, pair.base, measure))},
            {"welch_test", to_json(welch_test(a, b))},
            {"paired_test", to_json(paired_test(a, b))}};
      }
    }
    all[to_text(runs.course)] = {{"map_kind", to_text(map_kind(runs.course))},
                                 {"maps", runs.maps.size()},
                                 {"compared_maps", runs.comparable().size()},
                                 {"methods", std::move(drivers)},
                                 {"changes", std::move(changes)}};
  }
  return all;
}

Json drive_timing(const std::vector<DriveRuns>& courses) {
  Json all = Json::object();
  for (const DriveRuns& runs : courses) {
    for (const DriverKind kind : kDrivers) {
      Json each = Json::array();
      for (const DriveComparison& map : runs.maps) {
        const Quantiles& q = map.of(kind).solve;
        each.push_back(
            {{"map_seed", map.seed},
             {"solve_us",
              {{"median", 1e6 * q.median}, {"p99", 1e6 * q.p99}, {"max", 1e6 * q.max}}}});
      }
      all[to_text(runs.course)][to_text(kind)] = std::move(each);
    }
  }
  return all;
}

}  // namespace fairway::reproduction
