// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/case1.hpp"

#include <memory>

#include "experiments/paper/figures/drive_figures.hpp"
#include "experiments/paper/figures/stuck_figure.hpp"
#include "experiments/paper/tables/drive_tables.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

namespace {

constexpr int kDriveMaps = 40;
constexpr int kMapsWithSlowSolver = 2;  // another solver takes hundreds of times as long

Finding change_finding(const DriveRuns& runs, const char* claim, DriveMeasure measure) {
  const Estimate e = change(runs, DriverKind::Ismpc, DriverKind::Smpc, measure);
  const TestResult test =
      welch_test(values(runs, DriverKind::Ismpc, measure), values(runs, DriverKind::Smpc, measure));
  return {.claim = claim,
          .outcome = fmt::format("{}: {} on {} maps ({}, Welch's two-sample test)",
                                 to_text(measure), percent_interval(e), e.count, p_text(test.p)),
          .holds = e.high < 0.0};
}

// Whether all commands and speeds of a run lie within its settings' limits.
bool within_bounds(const Drive& drive) {
  constexpr double kRounding = 1e-9;
  const RobotSettings& limits = drive.robot;
  // At standstill, before the start and at the goal, the robot is below the paper's least speed.
  return drive.greatest.linear <= limits.linear_max + kRounding &&
         drive.least.linear >= std::min(0.0, limits.linear_min) - kRounding &&
         drive.greatest.angular <= limits.angular_max + kRounding &&
         drive.least.angular >= -limits.angular_max - kRounding;
}

void find_faults(const DriveRuns& runs, std::vector<std::string>& faults) {
  for (const DriveComparison& map : runs.maps) {
    for (std::size_t k = 0; k < kDriverKinds; ++k) {
      const auto kind = static_cast<DriverKind>(k);
      const auto report = [&](const char* what) {
        faults.push_back(fmt::format("case 1, {}, seed {}, {}: {}", to_text(runs.course), map.seed,
                                     to_text(kind), what));
      };
      if (map.of(kind).collided) report("contact");
      if (!within_bounds(map.of(kind))) report("a speed beyond its bound");
    }
  }
}

Finding smooth_finding(const DriveRuns& runs) {
  Twist2 most;
  for (const DriveComparison& map : runs.maps) {
    most.linear = std::max(most.linear, map.of(DriverKind::Ismpc).greatest_change.linear);
    most.angular = std::max(most.angular, map.of(DriverKind::Ismpc).greatest_change.angular);
  }
  constexpr double kTrackable = 10.0;  // [rad/s^2]; more than small bases do
  return {.claim = "The commands are smooth enough to be tracked perfectly",
          .outcome =
              fmt::format("ISMPC changes its command by up to {} m/s\u00b2 and {} rad/s\u00b2; the "
                          "paper's problem does not limit or penalise the first change",
                          fixed(most.linear, 1), fixed(most.angular, 1)),
          .holds = most.angular < kTrackable};
}

Finding arrival_finding(const DriveRuns& runs) {
  const int reached = runs.reached(DriverKind::Ismpc);
  return {.claim = std::string("ISMPC brings the robot to its goal (") + to_text(runs.course) + ")",
          .outcome = fmt::format("ISMPC {} of {}, SMPC {}, Fairway {}", reached, runs.maps.size(),
                                 runs.reached(DriverKind::Smpc), runs.reached(DriverKind::Ours)),
          .holds = reached == static_cast<int>(runs.maps.size())};
}

// How often the stop check overruled the solver of the paper's two methods.
struct Overruled {
  std::size_t stopped = 0;
  std::size_t cycles = 0;
};

Overruled overruled_cycles(const DriveRuns& runs) {
  Overruled sum;
  for (const DriveComparison& map : runs.maps) {
    for (const DriverKind kind : {DriverKind::Smpc, DriverKind::Ismpc}) {
      sum.stopped += static_cast<std::size_t>(map.of(kind).stop_cycles);
      sum.cycles += map.of(kind).rows.size();
    }
  }
  return sum;
}

}  // namespace

Chapter run_case1(const StudyOptions& options) {
  const int usual = options.make_solver ? kMapsWithSlowSolver : kDriveMaps;
  const int maps = options.maps > 0 ? options.maps : usual;
  std::vector<DriveRuns> courses;
  for (const DriveCourse course :
       {DriveCourse::Structured, DriveCourse::Unstructured, DriveCourse::LargeRectangles}) {
    courses.push_back({.course = course, .maps = compare_drivers(course, maps, options)});
  }
  const Overruled overruled = overruled_cycles(courses.front());
  Chapter chapter{.id = "case1", .title = "Case 1: driving through a structured, dense map"};
  chapter.setup = fmt::format(
      "{} generated maps of 30 m \u00d7 30 m with rooms, doors and boxes, from corner to corner. "
      "ISMPC and SMPC [17] share path, corridors (MDSRC corrected, contracted by \u0394s = 0.3 "
      "m), model and weights of Table I, and differ in their targets only. The body is a disc of "
      "0.25 m: a step of Eq. (1) has errors up to 7.5 mm, so a body of radius \u0394s would have "
      "no clearance left in a contracted corridor, and our stop check would refuse narrow "
      "passages. The stop check, the only one of our safety measures that is on for these two, "
      "overruled the solver in {} of their {} cycles. Ours: default settings, which limit "
      "accelerations to 2 m/s\u00b2 and 4 rad/s\u00b2, unlike the paper's. Two more courses test "
      "progress: the unstructured maps of Case 2, and structured maps with larger rectangles.",
      courses.front().maps.size(), overruled.stopped, overruled.cycles);
  const DriveRuns& structured = courses.front();
  chapter.findings = {
      change_finding(structured, "ISMPC drives shorter paths than SMPC", DriveMeasure::Length),
      change_finding(structured, "ISMPC is faster", DriveMeasure::Time),
      change_finding(structured, "ISMPC reduces redundant manoeuvres", DriveMeasure::Smoothness),
      smooth_finding(structured)};
  for (const DriveRuns& runs : courses) {
    chapter.findings.push_back(arrival_finding(runs));
    find_faults(runs, chapter.faults);
  }
  chapter.findings.push_back(
      {.claim = "Speeds stay within 1 m/s and 1.5 rad/s, and no obstacle is touched",
       .outcome = chapter.faults.empty() ? "in every run of every method" : chapter.faults.front(),
       .holds = chapter.faults.empty()});
  chapter.tables = {drive_table(structured), drive_change_table(structured),
                    drive_example_table(structured.maps.front()), arrival_table(courses)};
  chapter.timing_tables = {solve_times(courses)};
  chapter.numbers = drive_numbers(courses);
  chapter.timing = drive_timing(courses);
  std::vector<std::shared_ptr<const DriveRuns>> shared;
  for (DriveRuns& runs : courses)
    shared.push_back(std::make_shared<const DriveRuns>(std::move(runs)));
  chapter.figures = {trajectory_figure(shared.front()), speed_figure(shared.front()),
                     change_figure(shared.front())};
  if (auto figure = stuck_figure({shared[1], shared[2]})) {
    chapter.figures.push_back(std::move(*figure));
  }
  return chapter;
}

}  // namespace fairway::reproduction
