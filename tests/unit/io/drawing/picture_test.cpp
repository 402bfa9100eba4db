// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include <Magick++.h>
#include <gtest/gtest.h>

#include "fairway/io/drawing/animation.hpp"
#include "fairway/io/drawing/map_raster.hpp"
#include "fairway/io/drawing/plot_axes.hpp"
#include "fairway/io/drawing/speed_picture.hpp"
#include "fairway/io/drawing/world_picture.hpp"

namespace fairway::io {
namespace {

using Eigen::Vector2d;

WorldDrawing one_robot(const OccupancyGrid& map) {
  return {.map = &map,
          .robots = {{.name = "robot",
                      .radius = 0.25,
                      .start = {.position = {1, 1}, .heading = 0},
                      .goal = {3, 2},
                      .path = {{Vector2d(1, 1), Vector2d(3, 2)}},
                      .corridor = {},
                      .track = {}}},
          .bodies = {}};
}

TEST(Picture, HasTheFormatOfItsSuffix) {
  EXPECT_EQ(picture_format("a/b.svg").value(), PictureFormat::Svg);
  EXPECT_EQ(picture_format("b.PNG").value(), PictureFormat::Png);
  EXPECT_EQ(picture_format("b.x.pdf").value(), PictureFormat::Pdf);
  for (const char* name : {"", "png", ".png", "a.jpg", "a.png.", "a.svg/b", "a"}) {
    EXPECT_FALSE(picture_format(name)) << name;
  }
}

TEST(Picture, HasTheBytesOfItsFormat) {
  const OccupancyGrid map({.width = 50, .height = 40, .resolution = 0.1, .origin = {}});
  const WorldDrawing world = one_robot(map);
  EXPECT_TRUE(draw_world(world, PictureFormat::Svg).value().starts_with("<?xml"));
  EXPECT_TRUE(draw_world(world, PictureFormat::Png).value().starts_with("\x89PNG"));
  EXPECT_TRUE(draw_world(world, PictureFormat::Pdf).value().starts_with("%PDF"));
}

// Each moving part has one value per frame, and the last of them for the rest of the loop.
TEST(Picture, AnAnimationHasAPlaceForEachFrame) {
  const OccupancyGrid map({.width = 50, .height = 40, .resolution = 0.1, .origin = {}});
  Animation animation{.world = one_robot(map), .region = {.min = {0, 0}, .max = {5, 4}}};
  MovingDrawing robot{.color = palette::kBlue, .radius = 0.25, .heading = true};
  MovingDrawing person{.color = palette::kPurple, .radius = 0.3};
  for (int i = 0; i < 20; ++i) {
    robot.poses.push_back(Pose2{.position = {1.0 + 0.1 * i, 2.0}, .heading = 3.1 + 0.01 * i});
    person.poses.push_back(i < 5 ? std::nullopt : std::optional(Pose2{.position = {3.0, 3.0}}));
  }
  animation.moving = {robot, person};
  const std::string text = draw_animation(animation).value();
  const auto values_of = [&](const std::string& start) {
    const std::size_t at = text.find("values='", text.find(start)) + 8;
    const std::string values = text.substr(at, text.find('\'', at) - at);
    return std::count(values.begin(), values.end(), ';') + 1;
  };
  EXPECT_EQ(values_of("type='translate'"), 20 + 10);
  EXPECT_EQ(values_of("calcMode='discrete'"), 20 + 10);
  // A heading beyond half a turn goes on, so that the robot does not spin back.
  EXPECT_NE(text.find("-178;-178"), std::string::npos);
  EXPECT_NE(text.find("-188"), std::string::npos);
  EXPECT_TRUE(text.ends_with("</svg>\n</svg>\n")) << text.substr(text.size() - 40);
}

TEST(Picture, IsTheSameEveryTime) {
  const OccupancyGrid map({.width = 50, .height = 40, .resolution = 0.1, .origin = {}});
  EXPECT_EQ(draw_world(one_robot(map), PictureFormat::Png).value(),
            draw_world(one_robot(map), PictureFormat::Png).value());
}

TEST(Picture, ShowsTheRunAndNotTheWholeMap) {
  const OccupancyGrid map({.width = 1000, .height = 1000, .resolution = 0.1, .origin = {}});
  WorldDrawing world = one_robot(map);
  world.robots[0].start.position = {50, 50};
  world.robots[0].goal = {60, 55};
  world.robots[0].path.waypoints = {{50, 50}, {60, 55}};
  const Box shown = shown_region(world);
  EXPECT_GT(shown.min.x(), 45.0);
  EXPECT_LT(shown.min.x(), 50.0);
  EXPECT_GT(shown.max.x(), 60.0);
  EXPECT_LT(shown.max.x(), 65.0);
}

TEST(Picture, StaysWithinTheMapIfPossible) {
  const OccupancyGrid map({.width = 100, .height = 60, .resolution = 0.1, .origin = {}});
  const Box shown = shown_region(one_robot(map));
  EXPECT_GE(shown.min.x(), 0.0);
  EXPECT_GE(shown.min.y(), 0.0);
  EXPECT_LE(shown.max.x(), 10.0);
  EXPECT_LE(shown.max.y(), 6.0);
}

TEST(Picture, ShowsCellsWhereTheyAreInTheWorld) {
  // A turned map: the occupied cell lies above and to the left of the turned origin.
  OccupancyGrid map({.width = 20,
                     .height = 20,
                     .resolution = 1.0,
                     .origin = {.position = {0, 0}, .heading = std::numbers::pi / 2}});
  map.set({10, 2}, CellState::Occupied);
  const Vector2d center = map.frame().center({10, 2});
  EXPECT_TRUE(center.isApprox(Vector2d(-2.5, 10.5), 1e-9));
  Canvas canvas(PictureFormat::Png, {100, 100});
  const PlotAxes axes({.min = {0, 0}, .max = {100, 100}}, {.min = {-20, 0}, .max = {0, 20}});
  draw_map(canvas, axes, map);
  const std::string bytes = canvas.finish().value();
  Magick::InitializeMagick(nullptr);
  Magick::Image image(Magick::Blob(bytes.data(), bytes.size()));
  const double scale = 300.0 / 72.0;
  const auto dark = [&](const Vector2d& point) {
    const Vector2d at = scale * axes.at(point);
    return Magick::ColorGray(
               image.pixelColor(static_cast<unsigned>(at.x()), static_cast<unsigned>(at.y())))
               .shade() < 0.5;
  };
  EXPECT_TRUE(dark(center));
  EXPECT_TRUE(dark(center + Vector2d(0.4, 0.4)));
  EXPECT_FALSE(dark(center + Vector2d(0.7, 0.0)));
  EXPECT_FALSE(dark(center - Vector2d(0.0, 0.7)));
}

TEST(Picture, KeepsThinWallsOfHugeMapsVisible) {
  OccupancyGrid map({.width = 9000, .height = 100, .resolution = 0.05, .origin = {}});
  map.set({4501, 50}, CellState::Occupied);
  const Box all{.min = {0, 0}, .max = {450, 5}};
  EXPECT_TRUE(shows(map, all, CellState::Occupied));
  EXPECT_FALSE(shows(map, all, CellState::Unknown));
  EXPECT_FALSE(shows(map, {.min = {0, 0}, .max = {200, 5}}, CellState::Occupied));
}

TEST(Picture, OfNothingIsStillAPicture) {
  EXPECT_TRUE(draw_world({}, PictureFormat::Svg));
  EXPECT_TRUE(draw_speeds({}, PictureFormat::Svg));
}

TEST(Picture, OfSpeedsHasTheBytesOfItsFormat) {
  const SpeedDrawing drawing{.robots = {{.name = "a",
                                         .time = {0.0, 0.1, 0.2},
                                         .commands = {{.linear = 0.1, .angular = 0}, {}, {}},
                                         .executed = {{}, {}, {}}}},
                             .min = {.linear = 0.0, .angular = -1.5},
                             .max = {.linear = 1.0, .angular = 1.5}};
  EXPECT_TRUE(draw_speeds(drawing, PictureFormat::Png).value().starts_with("\x89PNG"));
}

TEST(PlotAxes, PutsRoundNumbersAtTheTicks) {
  EXPECT_DOUBLE_EQ(tick_step(0, 10, 5), 2.0);
  EXPECT_DOUBLE_EQ(tick_step(0, 1, 10), 0.1);
  EXPECT_DOUBLE_EQ(tick_step(-3, 40, 6), 10.0);
  EXPECT_EQ(ticks(-0.5, 2.1, 1.0), (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(ticks(0.0, 0.3, 0.1).size(), 4U);
}

TEST(PlotAxes, TurnsTheUpwardAxisDown) {
  const PlotAxes axes({.min = {10, 20}, .max = {110, 70}}, {.min = {0, 0}, .max = {10, 5}});
  EXPECT_EQ(axes.at(Vector2d(0, 0)), Vector2d(10, 70));
  EXPECT_EQ(axes.at(Vector2d(10, 5)), Vector2d(110, 20));
  EXPECT_EQ(axes.scale(), 10.0);
}

}  // namespace
}  // namespace fairway::io
