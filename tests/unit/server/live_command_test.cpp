// SPDX-License-Identifier: Apache-2.0
#include "server/live_command.hpp"

#include <gtest/gtest.h>

#include "support/random/random_world.hpp"

namespace fairway::app {
namespace {

template <typename Command>
Command parsed(const char* text) {
  const auto command = parse_command(text);
  EXPECT_TRUE(command) << text;
  return std::get<Command>(*command);
}

TEST(LiveCommand, ReadsEachKind) {
  EXPECT_TRUE(parsed<PauseCommand>(R"({"do":"pause","paused":true})").paused);
  static_cast<void>(parsed<StepCommand>(R"({"do":"step"})"));
  EXPECT_EQ(parsed<SpeedCommand>(R"({"do":"speed","factor":2.5})").factor, 2.5);
  static_cast<void>(parsed<RestartCommand>(R"({"do":"restart"})"));
  const auto goal = parsed<GoalCommand>(R"({"do":"goal","robot":3,"x":1.5,"y":-2,"heading":7})");
  EXPECT_EQ(goal.robot, 3U);
  EXPECT_EQ(goal.goal.position, Eigen::Vector2d(1.5, -2.0));
  EXPECT_NEAR(*goal.goal.heading, 7.0 - 2.0 * std::numbers::pi, 1e-12);
  EXPECT_FALSE(parsed<GoalCommand>(R"({"do":"goal","robot":0,"x":1,"y":1})").goal.heading);
  EXPECT_EQ(parsed<PoseCommand>(R"({"do":"pose","robot":1,"x":1,"y":2,"heading":0})").robot, 1U);
  EXPECT_EQ(parsed<CancelCommand>(R"({"do":"cancel","robot":2})").robot, 2U);
  EXPECT_EQ(parsed<ResetRobotCommand>(R"({"do":"reset_robot","robot":2})").robot, 2U);
  EXPECT_TRUE(parsed<HaltCommand>(R"({"do":"halt","halted":true})").halted);
  EXPECT_FALSE(parsed<UndoCommand>(R"({"do":"undo"})").redo);
  EXPECT_TRUE(parsed<UndoCommand>(R"({"do":"redo"})").redo);
  static_cast<void>(parsed<RevertCommand>(R"({"do":"revert"})"));
  EXPECT_EQ(parsed<AddRobotCommand>(R"({"do":"add_robot","x":4,"y":2,"heading":1})").pose.heading,
            1.0);
  EXPECT_EQ(parsed<RemoveRobotCommand>(R"({"do":"remove_robot","robot":2})").robot, 2U);
  const auto paint = parsed<PaintCommand>(
      R"({"do":"paint","from":{"x":0,"y":0},"to":{"x":1,"y":1},"radius":0.2,"blocked":false})");
  EXPECT_FALSE(paint.blocked);
  EXPECT_EQ(paint.to, Eigen::Vector2d(1.0, 1.0));
  EXPECT_FALSE(parsed<WalkCommand>(R"({"do":"walk","x":1,"y":1})").body);
  EXPECT_EQ(parsed<WalkCommand>(R"({"do":"walk","body":4,"x":1,"y":1})").body, 4U);
  EXPECT_EQ(parsed<RemoveBodyCommand>(R"({"do":"remove_body","body":1})").body, 1U);
  const auto zone = parsed<ZoneCommand>(
      R"({"do":"zone","index":2,"zone":{"kind":"one_way","polygon":[{"x":0,"y":0},{"x":1,"y":0},{"x":1,"y":2}],"direction":7}})");
  EXPECT_EQ(zone.index, 2U);
  EXPECT_EQ(zone.zone.kind, ZoneKind::OneWay);
  EXPECT_EQ(zone.zone.polygon.back(), Eigen::Vector2d(1, 2));
  EXPECT_NEAR(zone.zone.direction, 7.0 - 2.0 * std::numbers::pi, 1e-12);
  EXPECT_EQ(parsed<RemoveZoneCommand>(R"({"do":"remove_zone","index":1})").index, 1U);
  EXPECT_EQ(parsed<SettingCommand>(R"({"do":"set","assignment":"a.b=1"})").assignments,
            std::vector<std::string>{"a.b=1"});
  EXPECT_EQ(
      parsed<SettingCommand>(R"({"do":"set","assignments":["a.b=1","a.c=2"]})").assignments.size(),
      2U);
  EXPECT_EQ(parsed<ChooseMapCommand>(R"({"do":"map","index":1})").index, 1U);
}

TEST(LiveCommand, RefusesWhatIsOutOfRange) {
  for (const char* text :
       {R"({"do":"speed","factor":0})", R"({"do":"speed","factor":1e9})",
        R"({"do":"goal","robot":0,"x":1e7,"y":0})", R"({"do":"goal","robot":-1,"x":0,"y":0})",
        R"({"do":"zone","zone":{"kind":"wet","polygon":[]}})",
        R"({"do":"zone","zone":{"kind":"keep_out","polygon":3}})",
        R"({"do":"zone","zone":{"kind":"keep_out","polygon":[{"x":1e9,"y":0}]}})",
        R"({"do":"goal","robot":0.5,"x":0,"y":0})", R"({"do":"map","index":1000000})",
        R"({"do":"paint","from":{"x":0,"y":0},"to":{"x":0,"y":0},"radius":50,"blocked":true})"})
    EXPECT_FALSE(parse_command(text)) << text;
}

TEST(LiveCommand, SurvivesAnyBytes) {
  test::Random random(9);
  const std::string good =
      R"({"do":"paint","from":{"x":0,"y":0},"to":{"x":1,"y":1},"radius":0.2,"blocked":false})";
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text = good;
    for (int n = random.integer(1, 4); n > 0; --n) {
      const auto at =
          static_cast<std::size_t>(random.integer(0, static_cast<int>(text.size()) - 1));
      text[at] = static_cast<char>(random.integer(0, 255));
    }
    static_cast<void>(parse_command(text));
  }
  EXPECT_FALSE(parse_command(std::string(50'000, '[')));
}

TEST(LiveCommand, SelectsWhatRobotsSense) {
  const auto command = parse_command(R"({"do": "sense", "sensing": "lidar", "noise": "standard"})");
  ASSERT_TRUE(command);
  EXPECT_EQ(std::get<SenseCommand>(*command).sensing, Sensing::Lidar);
  EXPECT_EQ(std::get<SenseCommand>(*command).noise, SensorNoise::Standard);
  for (const char* bad :
       {R"({"do": "sense"})", R"({"do": "sense", "sensing": "radar", "noise": "none"})",
        R"({"do": "sense", "sensing": "lidar", "noise": 1})"}) {
    EXPECT_FALSE(parse_command(bad)) << bad;
  }
}

}  // namespace
}  // namespace fairway::app
