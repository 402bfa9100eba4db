// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/tables/field_tables.hpp"

#include "experiments/paper/tables/json_numbers.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

std::vector<double> FieldSample::counts(std::size_t obstacles, RectangleKind kind) const {
  std::vector<double> result;
  for (const FieldSeries& one : series)
    result.push_back(one.at(obstacles).count(kind));
  return result;
}

std::vector<double> FieldSample::areas(std::size_t obstacles, RectangleKind kind) const {
  std::vector<double> result;
  for (const FieldSeries& one : series)
    result.push_back(one.at(obstacles).mean_area(kind));
  return result;
}

std::vector<double> area_gain(const FieldSample& sample, std::size_t obstacles) {
  return percent_over(sample.areas(obstacles, RectangleKind::Mdsrc),
                      sample.areas(obstacles, RectangleKind::Src));
}

std::vector<double> count_gain(const FieldSample& sample, std::size_t obstacles) {
  return percent_over(sample.counts(obstacles, RectangleKind::Mdsrc),
                      sample.counts(obstacles, RectangleKind::Src));
}

Estimate area_gain_growth(const FieldSample& sample) {
  return estimate(differences(area_gain(sample, kFieldObstacles.size() - 1), area_gain(sample, 0)));
}

Estimate count_gain_growth(const FieldSample& sample) {
  std::vector<double> growth =
      differences(count_gain(sample, kFieldObstacles.size() - 1), count_gain(sample, 0));
  // Fewer is better: a more negative change is a greater gain.
  for (double& value : growth)
    value = -value;
  return estimate(growth);
}

Table field_table(const FieldSample& sample) {
  Table table{.caption = fmt::format(
                  "Behind Figure 10: means over {} fields \u00b1 95 % confidence; p of Welch's "
                  "two-sample t-test (Boost.Math) of SRC against MDSRC.",
                  sample.series.size()),
              .header = {"obstacles"},
              .rows = {}};
  for (const char* quantity : {"number", "area [m\u00b2]"}) {
    for (const RectangleKind kind : kComparedRectangles)
      table.header.push_back(std::string(quantity) + " " + to_text(kind));
    table.header.push_back(std::string(quantity) + ", test");
  }
  for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
    std::vector<std::string> row = {std::to_string(kFieldObstacles.at(i))};
    const auto add = [&](const auto& values, int decimals) {
      for (const RectangleKind kind : kComparedRectangles)
        row.push_back(with_interval(estimate(values(kind)), decimals));
      const TestResult test = welch_test(values(RectangleKind::Mdsrc), values(RectangleKind::Src));
      row.push_back(significance_mark(test.p) + " " + p_text(test.p));
    };
    add([&](RectangleKind kind) { return sample.counts(i, kind); }, 2);
    add([&](RectangleKind kind) { return sample.areas(i, kind); }, 2);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Json field_numbers(const FieldSample& sample) {
  Json fields = Json::array();
  for (std::size_t i = 0; i < kFieldObstacles.size(); ++i) {
    Json one = {{"obstacles", kFieldObstacles.at(i)}};
    for (const RectangleKind kind : kComparedRectangles) {
      one[to_text(kind)] = {{"count", to_json(estimate(sample.counts(i, kind)))},
                            {"mean_area", to_json(estimate(sample.areas(i, kind)))},
                            {"counts", sample.counts(i, kind)},
                            {"mean_areas", sample.areas(i, kind)}};
    }
    const auto tests = [](const std::vector<double>& mdsrc, const std::vector<double>& src) {
      return Json{{"welch", to_json(welch_test(mdsrc, src))},
                  {"paired", to_json(paired_test(mdsrc, src))},
                  {"change_percent", to_json(estimate(percent_over(mdsrc, src)))}};
    };
    one["mdsrc_against_src"] = {{"count", tests(sample.counts(i, RectangleKind::Mdsrc),
                                                sample.counts(i, RectangleKind::Src))},
                                {"area", tests(sample.areas(i, RectangleKind::Mdsrc),
                                               sample.areas(i, RectangleKind::Src))}};
    fields.push_back(std::move(one));
  }
  return {{"first_seed", sample.first_seed},
          {"fields_per_number", sample.series.size()},
          {"points", kFieldPoints},
          {"by_obstacles", std::move(fields)},
          {"growth_of_gain_from_5_to_20_obstacles",
           {{"area_percentage_points", to_json(area_gain_growth(sample))},
            {"count_percentage_points", to_json(count_gain_growth(sample))}}}};
}

}  // namespace fairway::reproduction
