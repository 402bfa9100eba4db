// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/maps/map_file.hpp"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "fairway/io/maps/map_image.hpp"
#include "fairway/simulation/scenarios/generated_maps.hpp"
#include "support/runs/map_files.hpp"

namespace fairway::io {
namespace {

using enum CellState;
using test::TemporaryFolder;

MapHeader header(MapMode mode, bool negate = false) {
  return {.image = "m.pgm",
          .resolution = 0.05,
          .origin = {},
          .negate = negate,
          .occupied_thresh = 0.65,
          .free_thresh = 0.196,
          .mode = mode};
}

// The cell state for a grey level from 0 to 255.
CellState state(int level, const MapHeader& header, bool opaque = true, int white = 255) {
  const MapImage image{.width = 1,
                       .height = 1,
                       .white = static_cast<std::uint32_t>(white),
                       .brightness = {static_cast<std::uint32_t>(level)},
                       .opaque = {opaque}};
  return make_grid(header, image, "m").value().at({0, 0});
}

TEST(MapFile, ReadsTheLevelsOfMapSaver) {
  EXPECT_EQ(state(254, header(MapMode::Trinary)), Free);
  EXPECT_EQ(state(205, header(MapMode::Trinary)), Unknown);
  EXPECT_EQ(state(0, header(MapMode::Trinary)), Occupied);
}

TEST(MapFile, ComparesWithBothThresholdsStrictly) {
  MapHeader h = header(MapMode::Trinary);
  h.free_thresh = 0.2;
  h.occupied_thresh = 0.6;
  EXPECT_EQ(state(205, h), Free);      // 50 / 255 < 0.2
  EXPECT_EQ(state(204, h), Unknown);   // 51 / 255 = 0.2
  EXPECT_EQ(state(102, h), Unknown);   // 153 / 255 = 0.6
  EXPECT_EQ(state(101, h), Occupied);  // 154 / 255 > 0.6
}

// Brightness is sample / maximum, so that the middle of 0 to 100 is exactly a threshold of 0.5.
TEST(MapFile, LeavesOnlyTheThresholdItselfUnknownWhereBothAreEqual) {
  for (const MapMode mode : {MapMode::Trinary, MapMode::Raw}) {
    MapHeader h = header(mode);
    h.free_thresh = 0.5;
    h.occupied_thresh = 0.5;
    const bool raw = mode == MapMode::Raw;
    const int white = raw ? 255 : 100;
    EXPECT_EQ(state(raw ? 51 : 49, h, true, white), Occupied);
    EXPECT_EQ(state(50, h, true, white), Unknown);
    EXPECT_EQ(state(raw ? 49 : 51, h, true, white), Free);
  }
}

TEST(MapFile, TurnsLevelsAroundWhenNegated) {
  EXPECT_EQ(state(254, header(MapMode::Trinary, true)), Occupied);
  EXPECT_EQ(state(0, header(MapMode::Trinary, true)), Free);
}

TEST(MapFile, TransparentPixelsAreUnknown) {
  EXPECT_EQ(state(254, header(MapMode::Trinary), false), Unknown);
  EXPECT_EQ(state(254, header(MapMode::Scale), false), Unknown);
  EXPECT_EQ(state(0, header(MapMode::Scale), false), Unknown);
  EXPECT_EQ(state(0, header(MapMode::Raw), false), Free);
}

TEST(MapFile, RoundsScaledLevelsNextToTheThresholds) {
  MapHeader h = header(MapMode::Scale);
  h.free_thresh = 0.0;
  h.occupied_thresh = 1.0;
  EXPECT_EQ(state(255, h), Free);     // scaled to 0
  EXPECT_EQ(state(254, h), Free);     // 0.39 rounds to 0
  EXPECT_EQ(state(253, h), Unknown);  // 0.78 rounds to 1
  EXPECT_EQ(state(128, h), Unknown);
  EXPECT_EQ(state(2, h), Unknown);   // 99.2
  EXPECT_EQ(state(1, h), Occupied);  // 99.6 rounds to 100
}

TEST(MapFile, ReadsRawLevelsAsPercent) {
  EXPECT_EQ(state(0, header(MapMode::Raw)), Free);
  EXPECT_EQ(state(20, header(MapMode::Raw)), Free);
  EXPECT_EQ(state(21, header(MapMode::Raw)), Unknown);
  EXPECT_EQ(state(65, header(MapMode::Raw)), Occupied);
  EXPECT_EQ(state(100, header(MapMode::Raw)), Occupied);
  EXPECT_EQ(state(101, header(MapMode::Raw)), Unknown);
  EXPECT_EQ(state(255, header(MapMode::Raw)), Unknown);
  EXPECT_EQ(state(0, header(MapMode::Raw, true)), Free);
}

constexpr const char* kYaml =
    "image: m.pgm\nresolution: 0.5\norigin: [1, 2, 1.5707963267948966]\nnegate: 0\n"
    "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

TEST(MapFile, PutsTheTopRowHighestAndTurnsTheOrigin) {
  const TemporaryFolder folder;
  folder.write("m.pgm", "P2 2 3 255  0 255  255 255  205 255");
  const OccupancyGrid grid = read_map(folder.write("m.yaml", kYaml)).value();
  EXPECT_EQ(grid.frame().width, 2);
  EXPECT_EQ(grid.frame().height, 3);
  EXPECT_EQ(grid.at({0, 2}), Occupied);
  EXPECT_EQ(grid.at({0, 0}), Unknown);
  EXPECT_EQ(grid.at({1, 0}), Free);
  // The map is turned by 90 degrees: the column axis points along +y, the row axis along -x.
  EXPECT_TRUE(grid.frame().center({0, 2}).isApprox(Eigen::Vector2d(1 - 1.25, 2 + 0.25), 1e-12));
}

TEST(MapFile, WarnsWhereTheUsualGreyOfUnknownIsFree) {
  const TemporaryFolder folder;
  const auto warnings_of = [&](const char* free_thresh, const char* pixels, const char* more = "") {
    folder.write("m.pgm", pixels);
    const std::string yaml = "image: m.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n" +
                             std::string("occupied_thresh: 0.65\nfree_thresh: ") + free_thresh +
                             "\n" + more;
    FileNotes notes;
    EXPECT_TRUE(read_map(folder.write("m.yaml", yaml), &notes));
    return notes.warnings;
  };
  const std::vector<std::string> one{
      folder.path("m.yaml") +
      ": free_thresh: expected at most 0.196, found 0.25: grey 205, usually unknown, is free"};
  EXPECT_EQ(warnings_of("0.25", "P2 2 1 255  254 205"), one);
  EXPECT_EQ(warnings_of("0.25", "P2 2 1 65535  0 52685"), one);  // 205 x 257
  EXPECT_TRUE(warnings_of("0.25", "P2 2 1 255  254 0").empty());
  EXPECT_TRUE(warnings_of("0.196", "P2 2 1 255  254 205").empty());
  EXPECT_TRUE(warnings_of("0.25", "P2 2 1 255  100 205", "mode: raw\n").empty());
}

TEST(MapFile, WarnsOfAnInvertedOrMiddleGreyThatIsFree) {
  const TemporaryFolder folder;
  const auto warning_of = [&](const char* negate, const char* thresholds, const char* pixels) {
    folder.write("m.pgm", pixels);
    const std::string yaml =
        "image: m.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: " + std::string(negate) + "\n" +
        thresholds;
    FileNotes notes;
    EXPECT_TRUE(read_map(folder.write("m.yaml", yaml), &notes));
    return notes.warnings.empty() ? "" : notes.warnings.front();
  };
  const auto expected = [&](const char* most, const char* found, const char* grey) {
    return folder.path("m.yaml") + ": free_thresh: expected at most " + most + ", found " + found +
           ": grey " + grey + ", usually unknown, is free";
  };
  constexpr const char* kLoose = "occupied_thresh: 0.65\nfree_thresh: 0.25\n";
  EXPECT_EQ(warning_of("1", kLoose, "P2 2 1 255  1 50"), expected("0.196", "0.25", "50"));
  EXPECT_EQ(warning_of("1", kLoose, "P2 2 1 255  1 205"), "");  // a wall
  EXPECT_EQ(warning_of("0", kLoose, "P2 2 1 255  254 50"), "");
  EXPECT_EQ(warning_of("1", "occupied_thresh: 0.65\nfree_thresh: 0.196\n", "P2 2 1 255  1 50"), "");
  EXPECT_EQ(warning_of("0", kLoose, "P2 2 1 100  99 80"), expected("0.196", "0.25", "205"));
  EXPECT_EQ(warning_of("0", kLoose, "P2 2 1 1  1 0"), "");
  constexpr const char* kMiddle = "occupied_thresh: 0.65\nfree_thresh: 0.6\n";
  EXPECT_EQ(warning_of("0", kMiddle, "P2 2 1 255  254 128"), expected("0.498", "0.6", "128"));
  EXPECT_EQ(warning_of("1", kMiddle, "P2 2 1 255  1 127"), expected("0.498", "0.6", "127"));
}

TEST(MapFile, SaysWhichOfItsFilesIsMissing) {
  const TemporaryFolder folder;
  const std::string yaml = folder.write("m.yaml", kYaml);
  EXPECT_EQ(read_map(yaml).error().message, yaml + ": image: " + folder.path("m.pgm") +
                                                ": expected a file, found nothing of that name");
  EXPECT_FALSE(read_map(folder.path("none.yaml")));
  EXPECT_FALSE(read_map(folder.path("")));
}

TEST(MapFile, AcceptsAnAbsoluteImagePath) {
  const TemporaryFolder folder;
  const TemporaryFolder other;
  std::string yaml = kYaml;
  yaml.replace(0, yaml.find('\n'), "image: " + other.write("x.pgm", "P2 1 1 255 255"));
  EXPECT_EQ(read_map(folder.write("m.yaml", yaml)).value().at({0, 0}), Free);
}

TEST(MapFile, OpensNoReaderByName) {
  const TemporaryFolder folder;
  for (const char* image : {"@m.pgm", "-", "|cat", "mvg:m.pgm", "http://x/y.png", "m.pgm[0]"}) {
    std::string yaml = kYaml;
    yaml.replace(0, yaml.find('\n'), "image: '" + std::string(image) + "'");
    EXPECT_FALSE(read_map(folder.write("m.yaml", yaml))) << image;
  }
}

TEST(MapFile, ReadsEveryCellOfAGeneratedMap) {
  const TemporaryFolder folder;
  const OccupancyGrid drawn = generate_map(MapKind::Field, 4, 12);
  GridFrame frame = drawn.frame();
  frame.origin = {.position = {-3.25, 7.5}, .heading = 0.5};
  OccupancyGrid map(frame);
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x)
      map.set({x, y}, x < 10 ? Unknown : drawn.at({x, y}));
  }
  const auto read = read_map(test::write_map(folder, "m", map));
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->cells().size(), map.cells().size());
  EXPECT_TRUE(std::equal(map.cells().begin(), map.cells().end(), read->cells().begin()));
  EXPECT_EQ(read->frame().width, frame.width);
  EXPECT_EQ(read->frame().resolution, frame.resolution);
  EXPECT_EQ(read->frame().origin.position, frame.origin.position);
  EXPECT_EQ(read->frame().origin.heading, frame.origin.heading);
}

TEST(MapFile, ReadsRealMaps) {
  const std::string folder = FAIRWAY_SHARED_DATA "/maps/";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data at " << folder;
  struct Case {
    const char* name;
    int width;
    int height;
  };
  for (const Case& c : {Case{"depot", 604, 307}, Case{"tb3_world", 384, 384},
                        Case{"willow-full-0.05", 1165, 945}}) {
    const auto grid = read_map(folder + c.name + ".yaml");
    ASSERT_TRUE(grid) << grid.error().message;
    EXPECT_EQ(grid->frame().width, c.width);
    EXPECT_EQ(grid->frame().height, c.height);
    std::size_t free = 0;
    std::size_t occupied = 0;
    for (const CellState cell : grid->cells()) {
      free += cell == Free ? 1U : 0U;
      occupied += cell == Occupied ? 1U : 0U;
    }
    EXPECT_GT(free, 5000U);
    EXPECT_GT(occupied, 500U);
  }
}

}  // namespace
}  // namespace fairway::io
