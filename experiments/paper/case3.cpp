// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/case3.hpp"

#include <algorithm>
#include <array>

#include "experiments/paper/figures/exchange_figures.hpp"
#include "experiments/paper/tables/json_numbers.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

namespace {

constexpr int kRuns = 40;
constexpr int kRunsWithSlowSolver = 2;

// The statistics of all runs of one kind.
struct Summary {
  int arrived = 0;     // runs in which all robots arrived
  int contacts = 0;    // runs with at least one contact
  Estimate time;       // of the runs in which all robots arrived [s]
  double bound = 0.0;  // driving time of the straight path [s]
  double least_separation = 0.0;
};

Summary summary_of(const ExchangeRuns& runs, ExchangeKind kind) {
  Summary summary;
  std::vector<double> times;
  summary.least_separation = runs.front().at(static_cast<std::size_t>(kind)).min_separation;
  for (const ExchangeComparison& one : runs) {
    const Exchange& run = one.at(static_cast<std::size_t>(kind));
    summary.least_separation = std::min(summary.least_separation, run.min_separation);
    summary.contacts += run.contacts > 0 ? 1 : 0;
    summary.bound = std::max(summary.bound, run.bound);
    if (!run.all_reached) continue;
    ++summary.arrived;
    times.push_back(run.time);
  }
  summary.time = estimate(times);
  return summary;
}

Table exchange_table(const ExchangeRuns& runs) {
  Table table{
      .caption = fmt::format(
          "Case 3: {} runs with different starts. Time: until the last robot has arrived, mean "
          "of the runs in which all do, \u00b1 95 % confidence; the straight path takes about {} "
          "s.",
          runs.size(), fixed(summary_of(runs, ExchangeKind::Ours).bound, 1)),
      .header = {"method", "keep-out distance [m]", "success rate", "runs with contact", "time [s]",
                 "least separation of bodies [m]"},
      .rows = {}};
  for (const ExchangeKind kind : kComparedExchanges) {
    const Summary s = summary_of(runs, kind);
    const Exchange& first = runs.front().at(static_cast<std::size_t>(kind));
    table.rows.push_back({to_text(kind), fixed(keep_out_distance(first.settings), 1),
                          fmt::format("{} of {}", s.arrived, runs.size()),
                          std::to_string(s.contacts), with_interval(s.time, 1),
                          fixed(s.least_separation, 3)});
  }
  return table;
}

Json exchange_numbers(const ExchangeRuns& runs) {
  Json all = Json::object();
  for (const ExchangeKind kind : kComparedExchanges) {
    const Summary s = summary_of(runs, kind);
    Json each = Json::array();
    for (const ExchangeComparison& one : runs) {
      const Exchange& run = one.at(static_cast<std::size_t>(kind));
      each.push_back({{"all_arrived", run.all_reached},
                      {"robots_in_contact", run.contacts},
                      {"time", run.time},
                      {"straight_way_time", run.bound},
                      {"min_separation", run.min_separation}});
    }
    all[to_text(kind)] = {{"runs_all_arrived", s.arrived},
                          {"runs_with_contact", s.contacts},
                          {"time", to_json(s.time)},
                          {"least_separation", s.least_separation},
                          {"runs", std::move(each)}};
  }
  return all;
}

Table cycle_times(const ExchangeRuns& runs) {
  Table table{.caption =
                  "Case 3: control cycle of one robot [us], thread CPU time: median over runs of "
                  "the runs' medians and 99th percentiles.",
              .header = {"method", "median", "99 %"},
              .rows = {}};
  for (const ExchangeKind kind : kComparedExchanges) {
    std::vector<double> medians;
    std::vector<double> tails;
    for (const ExchangeComparison& one : runs) {
      medians.push_back(one.at(static_cast<std::size_t>(kind)).cycle.median);
      tails.push_back(one.at(static_cast<std::size_t>(kind)).cycle.p99);
    }
    table.rows.push_back({to_text(kind), fixed(1e6 * quantiles(medians).median, 1),
                          fixed(1e6 * quantiles(tails).median, 1)});
  }
  return table;
}

Json exchange_timing(const ExchangeRuns& runs) {
  Json all = Json::object();
  for (const ExchangeKind kind : kComparedExchanges) {
    Json each = Json::array();
    for (const ExchangeComparison& one : runs) {
      const Quantiles& q = one.at(static_cast<std::size_t>(kind)).cycle;
      each.push_back({{"median", 1e6 * q.median}, {"p99", 1e6 * q.p99}, {"max", 1e6 * q.max}});
    }
    all[to_text(kind)]["cycle_us"] = std::move(each);
  }
  return all;
}

Finding arrival_finding(const ExchangeRuns& runs, ExchangeKind kind) {
  const Summary s = summary_of(runs, kind);
  return {
      .claim = std::string("All robots reach their targets without contact: ") + to_text(kind),
      .outcome = fmt::format("all arrive in {} of {} runs, contact in {}, least separation {} m",
                             s.arrived, runs.size(), s.contacts, fixed(s.least_separation, 3)),
      .holds = s.contacts == 0 && s.arrived == static_cast<int>(runs.size())};
}

}  // namespace

Chapter run_case3(const StudyOptions& options) {
  const int usual = options.make_solver ? kRunsWithSlowSolver : kRuns;
  const auto runs = std::make_shared<const ExchangeRuns>(
      compare_exchanges(options.maps > 0 ? options.maps : usual, options));
  Chapter chapter{.id = "case3", .title = "Case 3: four robots exchange places"};
  chapter.setup =
      "Four robots with bodies of 0.25 m start on a circle of 4 m in open space, each with its "
      "goal on the opposite side. Starts are shifted by up to 0.05 m in x and y and turned by up "
      "to 0.1 rad. ISMPC: Table I with R_o = 0.8 m between centres and \u03b3 = 5; every robot "
      "knows the others\u2019 positions and velocities, as the paper shares them, and predicts "
      "them with constant velocity; our recovery is off, our stop check on. Ours: default "
      "settings; robots publish their committed stops and intended motions. The paper shows one "
      "run; here there are many runs with different starts.";
  for (const ExchangeKind kind : kComparedExchanges) {
    chapter.findings.push_back(arrival_finding(*runs, kind));
    const Summary s = summary_of(*runs, kind);
    if (s.contacts > 0) {
      chapter.faults.push_back(fmt::format("case 3, {}: contact in {} of {} runs", to_text(kind),
                                           s.contacts, runs->size()));
    }
  }
  chapter.tables = {exchange_table(*runs)};
  chapter.figures = {snapshot_figure(runs, ExchangeKind::Ismpc),
                     snapshot_figure(runs, ExchangeKind::Ours), separation_figure(runs)};
  chapter.numbers = exchange_numbers(*runs);
  chapter.timing_tables = {cycle_times(*runs)};
  chapter.timing = exchange_timing(*runs);
  return chapter;
}

}  // namespace fairway::reproduction
