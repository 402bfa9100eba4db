// SPDX-License-Identifier: Apache-2.0
#include "experiments/people/people_files.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/core.h>

#include "experiments/people/csv_table.hpp"
#include "fairway/io/number_text.hpp"

namespace fairway::io {

namespace {

using Eigen::Vector2d;

constexpr double kFurthest = 1e4;  // place in a file [m]
constexpr int kMostNumber = 1 << 30;

// Reports the first of `numbers` that a file does not have.
Expected<void> check_all_found(const std::string& file,
                               const std::vector<int>& numbers,
                               const std::set<int>& found) {
  for (const int number : numbers) {
    if (!found.contains(number))
      return fail(fmt::format("{}: case: expected a case {}, found none", file, number));
  }
  return {};
}

bool is_wanted(int number, const std::vector<int>& numbers) {
  return numbers.empty() || std::find(numbers.begin(), numbers.end(), number) != numbers.end();
}

const char* file_of(CrowdBenchmark benchmark) noexcept {
  switch (benchmark) {
    case CrowdBenchmark::CrowdNav:
      return "crowdnav_cases.csv";
    case CrowdBenchmark::DsRnn:
      return "dsrnn_cases.csv";
    case CrowdBenchmark::CrowdNavPlus:
      return "crowdnavpp_cases.csv";
  }
  return "";
}

enum CrowdColumn : std::uint8_t { kCase, kSeed, kAgent, kX, kY, kGoalX, kGoalY };

// The columns after those that all benchmarks have.
struct CrowdColumns {
  std::vector<std::string> names{"case", "seed", "agent", "x", "y", "goal_x", "goal_y"};
  std::size_t radius = 0;
  std::size_t speed = 0;
  std::size_t heading = 0;

  explicit CrowdColumns(CrowdBenchmark benchmark) {
    if (benchmark == CrowdBenchmark::CrowdNav) return;
    radius = add("radius");
    speed = add("v_pref");
    if (benchmark == CrowdBenchmark::DsRnn) heading = add("heading");
  }

  std::size_t add(const char* name) {
    names.emplace_back(name);
    return names.size() - 1;
  }
};

}  // namespace

Expected<std::vector<RecordedCase>> read_recorded_cases(const std::string& folder,
                                                        const std::vector<int>& numbers) {
  const std::string file = folder + "/cases.csv";
  Expected<CsvTable> table = CsvTable::read(file, {"scene", "case", "start_x", "start_y", "goal_x",
                                                   "goal_y", "start_frame", "time_limit"});
  if (!table) return tl::unexpected(table.error());
  std::vector<RecordedCase> cases;
  std::set<int> found;
  for (std::size_t row = 0; row < table->size(); ++row) {
    const auto place = [&](std::size_t column) {
      return Vector2d(table->number(row, column, -kFurthest, kFurthest),
                      table->number(row, column + 1, -kFurthest, kFurthest));
    };
    RecordedCase one{.scene = std::string(table->text(row, 0)),
                     .number = table->whole(row, 1, 0, kMostNumber),
                     .start = place(2),
                     .goal = place(4),
                     .start_frame = table->whole(row, 6, -kMostNumber, kMostNumber),
                     .time_limit = table->number(row, 7, 0.1, 1e4)};
    const bool is_name =
        !one.scene.empty() && std::all_of(one.scene.begin(), one.scene.end(), [](char c) {
          return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        });
    if (!is_name) table->complain(row, 0, "expected the name of a scene in letters and digits");
    if (!table->error().empty()) return fail(table->error());
    if (!found.insert(one.number).second) {
      table->complain(row, 1, "expected each case once");
      return fail(table->error());
    }
    if (is_wanted(one.number, numbers)) cases.push_back(std::move(one));
  }
  if (found.empty()) return fail(file + ":1: expected cases, found none");
  if (auto all = check_all_found(file, numbers, found); !all) return tl::unexpected(all.error());
  return cases;
}

Expected<PeopleRecording> read_recording(const std::string& folder, const std::string& scene) {
  std::string name = scene;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Expected<CsvTable> table =
      CsvTable::read(folder + "/tracks_" + name + ".csv", {"frame", "id", "x", "y"});
  if (!table) return tl::unexpected(table.error());
  PeopleRecording recording;
  for (std::size_t row = 0; row < table->size(); ++row) {
    const int frame = table->whole(row, 0, -kMostNumber, kMostNumber);
    recording.frames[frame].push_back({.person = table->whole(row, 1, 0, kMostNumber),
                                       .position = {table->number(row, 2, -kFurthest, kFurthest),
                                                    table->number(row, 3, -kFurthest, kFurthest)}});
    if (!table->error().empty()) return fail(table->error());
  }
  return recording;
}

Expected<std::vector<CrowdCase>> read_crowd_cases(const std::string& folder,
                                                  CrowdBenchmark benchmark,
                                                  const std::vector<int>& numbers) {
  const std::string file = folder + "/" + file_of(benchmark);
  const CrowdColumns columns(benchmark);
  Expected<CsvTable> table = CsvTable::read(file, columns.names);
  if (!table) return tl::unexpected(table.error());
  std::vector<CrowdCase> cases;
  std::set<int> found;
  int present = -1;
  int agents = 0;
  for (std::size_t row = 0; row < table->size(); ++row) {
    const int number = table->whole(row, kCase, 0, kMostNumber);
    const int agent = table->whole(row, kAgent, 0, 1000);
    if (number != present) {
      if (!found.insert(number).second) table->complain(row, kCase, "expected each case once");
      if (is_wanted(number, numbers)) cases.emplace_back().number = number;
      present = number;
      agents = 0;
    }
    if (agent != agents++)
      table->complain(row, kAgent, fmt::format("expected agent {}", agents - 1));
    if (!is_wanted(number, numbers)) {
      if (!table->error().empty()) return fail(table->error());
      continue;
    }
    CrowdCase& one = cases.back();
    const Vector2d place(table->number(row, kX, -kFurthest, kFurthest),
                         table->number(row, kY, -kFurthest, kFurthest));
    const Vector2d goal(table->number(row, kGoalX, -kFurthest, kFurthest),
                        table->number(row, kGoalY, -kFurthest, kFurthest));
    const double radius = columns.radius > 0 ? table->number(row, columns.radius, 0.01, 5.0) : 0.3;
    const double speed = columns.speed > 0 ? table->number(row, columns.speed, 0.01, 10.0) : 1.0;
    if (agent > 0) {
      one.people.push_back({.position = place, .goal = goal, .radius = radius, .speed_max = speed});
    } else {
      one.seed = static_cast<std::uint32_t>(table->whole(row, kSeed, 0, kMostNumber));
      one.start = {.position = place,
                   .heading = columns.heading > 0
                                  ? table->number(row, columns.heading, -10.0, 10.0)
                                  : std::atan2(goal.y() - place.y(), goal.x() - place.x())};
      one.goal = goal;
      one.robot_radius = radius;
      one.robot_speed = speed;
    }
    if (!table->error().empty()) return fail(table->error());
  }
  if (found.empty()) return fail(file + ":1: expected cases, found none");
  if (auto all = check_all_found(file, numbers, found); !all) return tl::unexpected(all.error());
  return cases;
}

}  // namespace fairway::io
