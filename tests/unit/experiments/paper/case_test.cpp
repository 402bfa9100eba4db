// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include "experiments/paper/case1.hpp"
#include "experiments/paper/case2.hpp"
#include "experiments/paper/case3.hpp"

namespace fairway::reproduction {
namespace {

StudyOptions quick_options() {
  StudyOptions options{.maps = 2, .threads = 2};
  options.clock = [] { return 0.0; };
  return options;
}

void expect_whole(const Chapter& chapter, const std::set<std::string>& figures) {
  EXPECT_FALSE(chapter.findings.empty());
  EXPECT_FALSE(chapter.numbers.empty());
  EXPECT_FALSE(chapter.timing.empty());
  for (const auto& tables : {chapter.tables, chapter.timing_tables}) {
    EXPECT_FALSE(tables.empty());
    for (const Table& table : tables) {
      for (const auto& row : table.rows)
        EXPECT_EQ(row.size(), table.header.size()) << table.caption;
    }
  }
  std::set<std::string> names;
  for (const Figure& figure : chapter.figures) {
    EXPECT_TRUE(names.insert(figure.name).second) << figure.name;
    EXPECT_FALSE(figure.caption.empty());
    for (const auto format : {io::PictureFormat::Svg, io::PictureFormat::Pdf}) {
      const Expected<std::string> bytes = figure.draw(format);
      ASSERT_TRUE(bytes) << figure.name;
      EXPECT_GT(bytes->size(), 1000U) << figure.name;
    }
  }
  for (const std::string& name : figures)
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Cases, FirstHasThePapersFigures) {
  const Chapter chapter = run_case1(quick_options());
  expect_whole(chapter, {"case1_figure5_trajectories", "case1_figure6_velocities"});
  EXPECT_TRUE(chapter.faults.empty()) << chapter.faults.front();
}

TEST(Cases, SecondHasThePapersFigures) {
  const Chapter chapter = run_case2(quick_options());
  expect_whole(chapter, {"case2_figure7_environment1", "case2_figure8_environment2",
                         "case2_figure9_fields", "case2_figure10_area_and_number"});
  EXPECT_TRUE(chapter.faults.empty()) << chapter.faults.front();
}

TEST(Cases, ThirdHasThePapersFigures) {
  expect_whole(run_case3(quick_options()),
               {"case3_figure11_snapshots", "case3_snapshots_ours", "case3_separation"});
}

}  // namespace
}  // namespace fairway::reproduction
