// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/case2.hpp"

#include "experiments/paper/figures/broken_claim_figures.hpp"
#include "experiments/paper/figures/corridor_figures.hpp"
#include "experiments/paper/figures/field_figures.hpp"
#include "experiments/paper/tables/corridor_tables.hpp"
#include "experiments/paper/tables/text_format.hpp"

namespace fairway::reproduction {

namespace {

constexpr int kCorridorMaps = 40;
constexpr int kFieldsPerMap = 5;

std::shared_ptr<const CorridorComparison> first_of(const CorridorEnvironment& e) {
  return std::make_shared<const CorridorComparison>(e.maps.front());
}

Finding gain_finding(const CorridorEnvironment& e) {
  const CorridorGain gain =
      gain_over(e.maps, CorridorKind::MdsrcPublished, CorridorKind::SrcPublished);
  return {.claim = "MDSRC needs fewer and larger corridors than SRC (" + e.name + ")",
          .outcome = fmt::format(
              "number {} ({}), area {} of SRC's ({}), both as published; Welch's two-sample test",
              percent_interval(gain.fewer), p_text(gain.count_welch.p),
              percent_interval(gain.larger), p_text(gain.area_welch.p)),
          .holds = gain.fewer.high < 0.0 && gain.larger.low > 0.0};
}

Finding sound_finding(const CorridorEnvironment& e) {
  const CorridorGain gain = gain_over(e.maps, CorridorKind::MdsrcSound, CorridorKind::SrcSound);
  return {.claim = "The same once both are corrected (" + e.name + ")",
          .outcome = fmt::format("number {} ({}), area {} of SRC's ({})",
                                 percent_interval(gain.fewer), p_text(gain.count_welch.p),
                                 percent_interval(gain.larger), p_text(gain.area_welch.p)),
          .holds = gain.fewer.high < 0.0 && gain.larger.low > 0.0};
}

Finding growth_finding(const FieldSample& sample) {
  const Estimate area = area_gain_growth(sample);
  const Estimate count = count_gain_growth(sample);
  return {.claim = "The advantage grows with the number of obstacles (Figure 10)",
          .outcome = fmt::format("from 5 to 20 obstacles the gain grows by {} percentage points in "
                                 "area and by {} in number",
                                 with_interval(area, 1), with_interval(count, 1)),
          .holds = area.low > 0.0 && count.low > 0.0};
}

double total(const CorridorEnvironment& e, CorridorKind kind, int CorridorOutcome::*value) {
  double sum = 0.0;
  for (const double one : column(e.maps, kind, [&](const CorridorOutcome& o) { return o.*value; }))
    sum += one;
  return sum;
}

Finding soundness_finding(const CorridorEnvironment& e) {
  const CorridorKind kind = CorridorKind::MdsrcPublished;
  double rectangles = 0.0;
  int broken = 0;
  for (const CorridorComparison& map : e.maps) {
    rectangles += static_cast<double>(map.of(kind).rectangles.size());
    broken += map.of(kind).breaks > 0 ? 1 : 0;
  }
  const double holding = total(e, kind, &CorridorOutcome::holding);
  return {.claim = "Corridors are free of obstacles and connected (" + e.name + ")",
          .outcome = fmt::format(
              "{} % of the published rectangles contain a part of an obstacle, {} of {} chains "
              "break after contraction",
              fixed(100.0 * holding / rectangles, 1), broken, e.maps.size()),
          .holds = holding == 0.0 && broken == 0};
}

// Finds violations that our own corridors must never have.
void find_faults(const CorridorEnvironment& e, std::vector<std::string>& faults) {
  for (const CorridorKind kind :
       {CorridorKind::SrcSound, CorridorKind::FsrcSound, CorridorKind::MdsrcSound,
        CorridorKind::Fewest, CorridorKind::FewestConfiguration}) {
    if (total(e, kind, &CorridorOutcome::holding) > 0.0 ||
        total(e, kind, &CorridorOutcome::breaks) > 0.0) {
      faults.push_back(fmt::format("{}: {} contains an obstacle or breaks", e.name, to_text(kind)));
    }
  }
}

std::string figure_caption(const CorridorEnvironment& e, const char* figure) {
  return fmt::format(
      "{}: corridors in {} (our map in the manner of the paper's, seed {}): SRC, FSRC and "
      "MDSRC as published, and the fewest-rectangle corridor.",
      figure, e.name, e.maps.front().seed);
}

std::string structured_caption(const CorridorEnvironment& e) {
  const CorridorGain published =
      gain_over(e.maps, CorridorKind::MdsrcPublished, CorridorKind::SrcPublished);
  const CorridorGain sound = gain_over(e.maps, CorridorKind::MdsrcSound, CorridorKind::SrcSound);
  return fmt::format(
      "Where the claim of fewer and larger corridors fails: walls parallel to the axes (seed {} "
      "shown). Over {} such maps MDSRC's number changes by {} (corrected: {}) and its area by "
      "{} ({}) relative to SRC.",
      e.maps.front().seed, e.maps.size(), percent_interval(published.fewer),
      percent_interval(sound.fewer), percent_interval(published.larger),
      percent_interval(sound.larger));
}

}  // namespace

Chapter run_case2(const StudyOptions& options) {
  const int maps = options.maps > 0 ? options.maps : kCorridorMaps;
  std::vector<CorridorEnvironment> environments = {
      {MapKind::UnstructuredLarge, "Environment 1", {}},
      {MapKind::UnstructuredSmall, "Environment 2", {}},
      {MapKind::Structured, "Axis-aligned", {}}};
  for (CorridorEnvironment& e : environments)
    e.maps = compare_corridors_on_maps(e.kind, maps, options);
  const auto fields = std::make_shared<const FieldSample>(
      FieldSample{options.seed, make_field_series(kFieldsPerMap * maps, options)});

  Chapter chapter{.id = "case2", .title = "Case 2: corridors in unstructured environments"};
  chapter.setup = fmt::format(
      "The paper's maps are not public. Ours are generated in their manner: {} maps each of 50 m "
      "(Environment 1) and 25 m (Environment 2) with irregular polygons, posts and thin slanted "
      "walls, cells of 0.05 m, and of 30 m with walls parallel to the axes; paths from corner to "
      "corner keep 0.45 m from obstacles and have a point every 0.1 m. \u201cAs published\u201d "
      "is Algorithms 1 and 2 with the corrections that they need to run "
      "(docs/paper_notes.md), sampled as in Eq. (7); \u201ccorrected\u201d tests every strip "
      "exactly and chains the contracted rectangles. Figures 9 and 10: {} fields of 20 m \u00d7 "
      "20 m per number of obstacles.",
      maps, fields->series.size());
  for (std::size_t i = 0; i < 2; ++i) {
    chapter.findings.push_back(gain_finding(environments[i]));
    chapter.findings.push_back(sound_finding(environments[i]));
  }
  chapter.findings.push_back(growth_finding(*fields));
  chapter.findings.push_back(gain_finding(environments[2]));
  for (const CorridorEnvironment& e : environments) {
    chapter.findings.push_back(soundness_finding(e));
    find_faults(e, chapter.faults);
  }
  chapter.tables = {table_two(environments), gain_table(environments),
                    soundness_table(environments), field_table(*fields)};
  chapter.timing_tables = {corridor_times(environments)};
  chapter.figures = {
      corridor_figure("case2_figure7_environment1", figure_caption(environments[0], "Figure 7"),
                      environments[0].kind, first_of(environments[0])),
      corridor_figure("case2_figure8_environment2", figure_caption(environments[1], "Figure 8"),
                      environments[1].kind, first_of(environments[1])),
      field_map_figure(fields),
      field_chart_figure(fields),
      field_gain_figure(fields),
      structured_figure(first_of(environments[2]), structured_caption(environments[2]))};
  if (auto figure = hopping_figure(environments[1].kind, environments[1].maps)) {
    chapter.figures.push_back(std::move(*figure));
  }
  if (auto figure = break_figure(environments[1].kind, environments[1].maps)) {
    chapter.figures.push_back(std::move(*figure));
  }
  chapter.numbers = {{"environments", corridor_numbers(environments)},
                     {"fields", field_numbers(*fields)}};
  chapter.timing = corridor_timing(environments);
  return chapter;
}

}  // namespace fairway::reproduction
