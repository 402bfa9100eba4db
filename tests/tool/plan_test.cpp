// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fairway/map/free_space.hpp"
#include "tool_run.hpp"

namespace fairway::test {
namespace {

using nlohmann::json;

Eigen::Vector2d point(const json& value) {
  return {value.at(0).get<double>(), value.at(1).get<double>()};
}

// The room of write_room, made without reading a file.
BitGrid room() {
  BitGrid grid({.width = 80, .height = 40, .resolution = 0.1, .origin = {}}, false);
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 80; ++x) {
      const bool border = x == 0 || y == 0 || x == 79 || y == 39;
      const bool wall = (x == 40 || x == 41) && (y < 15 || y >= 25);
      if (border || wall) grid.set({x, y}, true);
    }
  }
  return grid;
}

void expect_good(const json& plan, double path_clearance) {
  EXPECT_TRUE(plan.at("success").get<bool>());
  const auto& path = plan.at("path");
  EXPECT_EQ(point(path.front()), Eigen::Vector2d(1, 2));
  EXPECT_EQ(point(path.back()), Eigen::Vector2d(7, 2));
  const BitGrid obstacles = room();
  for (std::size_t i = 1; i < path.size(); ++i) {
    EXPECT_TRUE(is_free(obstacles, point(path[i - 1]), point(path[i]), path_clearance));
  }
  const bool workspace = plan.at("space") == "workspace";
  double area = 0.0;
  for (const json& r : plan.at("rectangles")) {
    const OrientedRectangle rectangle{.seed = point(r.at("seed")),
                                      .orientation = r.at("orientation").get<double>(),
                                      .min = point(r.at("min")),
                                      .max = point(r.at("max"))};
    EXPECT_TRUE(
        is_free(obstacles, rectangle, workspace ? 0.0 : plan.at("robot_radius").get<double>()));
    EXPECT_DOUBLE_EQ(rectangle.area(), r.at("area").get<double>());
    area += rectangle.area();
  }
  const auto count = plan.at("count").get<std::size_t>();
  ASSERT_EQ(count, plan.at("rectangles").size());
  ASSERT_GT(count, 0U);
  EXPECT_NEAR(plan.at("mean_area").get<double>(), area / static_cast<double>(count), 1e-12);
  for (const char* stage : {"prepare", "path", "corridor"}) {
    EXPECT_GT(plan.at("seconds").at(stage).get<double>(), 0.0);
  }
}

TEST(Plan, GivesAPathAndRectanglesWithEveryMethod) {
  const TemporaryFolder folder;
  write_room(folder);
  for (const std::string method : {"src", "fsrc", "mdsrc", "fewest"}) {
    const ToolRun run = run_tool(
        folder,
        "plan room.yaml --start 1,2 --goal 7,2 --robot-radius 0.3 --json - --corridor " + method);
    ASSERT_EQ(run.code, 0) << method << run.err;
    const json plan = json::parse(run.out);
    EXPECT_EQ(plan.at("space"), "configuration");
    EXPECT_EQ(plan.at("robot_radius").get<double>(), 0.3);
    EXPECT_EQ(plan.at("inward_offset").get<double>(), 0.0);
    expect_good(plan, 0.3);
  }
}

TEST(Plan, WorksInTheWorkspace) {
  const TemporaryFolder folder;
  write_room(folder);
  const ToolRun run = run_tool(folder,
                               "plan room.yaml --start 1,2,0 --goal 7,2,0 --corridor mdsrc "
                               "--inward-offset 0.3 --clearance 0.45 --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json plan = json::parse(run.out);
  EXPECT_EQ(plan.at("space"), "workspace");
  EXPECT_EQ(plan.at("inward_offset").get<double>(), 0.3);
  expect_good(plan, 0.45);
}

TEST(Plan, IsTheSameEveryTime) {
  const TemporaryFolder folder;
  write_room(folder);
  const auto plan = [&] {
    json result =
        json::parse(run_tool(folder, "plan room.yaml --start 1,2 --goal 7,3 --json -").out);
    result.erase("seconds");
    return result;
  };
  EXPECT_EQ(plan(), plan());
}

TEST(Plan, ReportsWhyThereIsNone) {
  const TemporaryFolder folder;
  write_room(folder);
  const auto refused = [&](const std::string& arguments, const std::string& beginning) {
    const ToolRun run = run_tool(folder, "plan room.yaml --json - " + arguments);
    EXPECT_EQ(run.code, 1) << arguments;
    const json plan = json::parse(run.out);
    EXPECT_FALSE(plan.at("success").get<bool>());
    const auto reason = plan.at("reason").get<std::string>();
    EXPECT_EQ(reason.substr(0, beginning.size()), beginning);
    EXPECT_EQ(run.err, "fairway: " + reason + "\n");
  };
  refused("--start 4.05,0.5 --goal 7,2",
          "the robot does not fit at the start (4.05, 0.50): it is ");
  refused("--start 1,2 --goal 7.95,2", "the robot does not fit at the goal (7.95, 2.00): it is ");
  const std::string narrow =
      "there is no path wide enough: the narrowest gap on the best route, at ";
  refused("--start 1,2 --goal 7,2 --robot-radius 0.6", narrow);
  refused("--start 1,2 --goal 7,2 --clearance 0.55", narrow);
}

TEST(Plan, DrawsEveryKindOfPicture) {
  const TemporaryFolder folder;
  write_room(folder);
  const std::string plan = "plan room.yaml --start 1,2 --goal 7,2 --picture ";
  ASSERT_EQ(run_tool(folder, plan + "p.svg").code, 0);
  ASSERT_EQ(run_tool(folder, plan + "p.PNG").code, 0);
  ASSERT_EQ(run_tool(folder, plan + "p.pdf").code, 0);
  EXPECT_TRUE(content_of(folder.path("p.svg")).starts_with("<?xml"));
  EXPECT_TRUE(content_of(folder.path("p.PNG")).starts_with("\x89PNG"));
  EXPECT_TRUE(content_of(folder.path("p.pdf")).starts_with("%PDF"));
}

}  // namespace
}  // namespace fairway::test
