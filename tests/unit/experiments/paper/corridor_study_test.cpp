// SPDX-License-Identifier: Apache-2.0
#include "experiments/paper/studies/corridor_study.hpp"

#include <gtest/gtest.h>

#include "experiments/paper/tables/corridor_tables.hpp"
#include "fairway/map/free_space.hpp"

namespace fairway::reproduction {
namespace {

StudyOptions corridor_options() {
  StudyOptions options{.threads = 2};
  options.clock = [] { return 0.0; };
  return options;
}

TEST(CorridorStudy, SoundCorridorsAreFreeAndConnected) {
  const auto maps = compare_corridors_on_maps(MapKind::UnstructuredSmall, 4, corridor_options());
  ASSERT_EQ(maps.size(), 4U);
  for (const CorridorComparison& map : maps) {
    const BitGrid obstacles(generate_map(MapKind::UnstructuredSmall, map.seed));
    for (const CorridorKind kind : {CorridorKind::SrcSound, CorridorKind::FsrcSound,
                                    CorridorKind::MdsrcSound, CorridorKind::Fewest}) {
      const CorridorOutcome& outcome = map.of(kind);
      EXPECT_TRUE(outcome.complete) << to_text(kind);
      EXPECT_EQ(outcome.holding, 0) << to_text(kind);
      EXPECT_EQ(outcome.breaks, 0) << to_text(kind);
      for (const OrientedRectangle& rectangle : outcome.rectangles)
        EXPECT_TRUE(is_free(obstacles, rectangle, 0.0));
    }
    EXPECT_LE(map.of(CorridorKind::Fewest).rectangles.size(),
              map.of(CorridorKind::MdsrcSound).rectangles.size());
  }
}

TEST(CorridorStudy, TheFirstMapHasTheRequestedSeed) {
  StudyOptions options = corridor_options();
  options.seed = 3;
  const auto maps = compare_corridors_on_maps(MapKind::Structured, 1, options);
  EXPECT_EQ(maps.front().seed, 3U);
}

TEST(CorridorStudy, DoesNotDependOnThreads) {
  StudyOptions one = corridor_options();
  one.threads = 1;
  const auto a = compare_corridors_on_maps(MapKind::UnstructuredSmall, 3, one);
  const auto b = compare_corridors_on_maps(MapKind::UnstructuredSmall, 3, corridor_options());
  const CorridorEnvironment first{MapKind::UnstructuredSmall, "e", a};
  const CorridorEnvironment second{MapKind::UnstructuredSmall, "e", b};
  EXPECT_EQ(corridor_numbers({first}).dump(), corridor_numbers({second}).dump());
}

TEST(CorridorTables, ShowThePaperBesideFairway) {
  const auto maps = compare_corridors_on_maps(MapKind::UnstructuredSmall, 2, corridor_options());
  const Table table = table_two({{MapKind::UnstructuredSmall, "Environment 2", maps}});
  ASSERT_EQ(table.rows.size(), kCorridorKinds);
  EXPECT_EQ(table.rows[2][1], "12");
  EXPECT_EQ(table.rows[2][3], "11.92");
  for (const auto& row : table.rows)
    EXPECT_EQ(row.size(), table.header.size());
}

TEST(CorridorTables, BasesOfThePercentagesDiffer) {
  const auto maps = compare_corridors_on_maps(MapKind::UnstructuredSmall, 3, corridor_options());
  const CorridorGain gain = gain_over(maps, CorridorKind::MdsrcSound, CorridorKind::SrcSound);
  // (m - s) / s exceeds (m - s) / m where m exceeds s.
  EXPECT_GT(gain.larger.mean, gain.larger_of_own.mean);
  EXPECT_LT(gain.larger_of_own.mean, 100.0);
}

}  // namespace
}  // namespace fairway::reproduction
