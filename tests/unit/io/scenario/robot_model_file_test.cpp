// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/scenario/robot_model_file.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "fairway/io/scenario/scenario_file.hpp"
#include "small_map.hpp"
#include "support/runs/temporary_folder.hpp"

namespace fairway::io {
namespace {

using test::TemporaryFolder;
using test::write_map;

TEST(RobotModelFile, ReadsTheBodyAndTheBaseOfARobot) {
  const TemporaryFolder folder;
  write_map(folder);
  folder.write(
      "mecanum.yaml",
      "kind: omni\nfootprint: [[-0.5, -0.3], [0.5, -0.3], [0.6, 0], [0.5, 0.3], [-0.5, 0.3]]\n"
      "linear_min: -1\nlinear_max: 1\nlateral_max: 0.6\nangular_max: 1.2\nlinear_acceleration: "
      "0.8\n"
      "lateral_acceleration: 0.7\nangular_acceleration: 2\n"
      "wheels: {type: mecanum, half_sum: 0.9, speed_max: 1.2}\n");
  FileNotes notes;
  const auto scenario = read_scenario(
      folder.write("s.yaml",
                   "map: m.yaml\nrobots:\n"
                   "  - name: car\n    start: [1, 2, 0]\n    goal: [8, 4]\n    robot: {kind: car, "
                   "length: 1.6, "
                   "width: 0.7, reference_to_front: 1.3, wheelbase: 1, steering_max: 0.6, "
                   "steering_rate_max: 0.8, linear_min: -0.5, linear_max: 1.2, angular_max: 1.5, "
                   "linear_acceleration: 0.8, angular_acceleration: 3}\n"
                   "  - {start: [2, 2, 0], goal: [1, 1, -1.5], robot: {file: mecanum.yaml}}\n"
                   "  - {start: [5, 2, 0], goal: [6, 1]}\n"),
      &notes);
  ASSERT_TRUE(scenario) << scenario.error().message;
  const auto& robots = scenario->robots;
  ASSERT_TRUE(robots[0].model && robots[1].model);
  EXPECT_FALSE(robots[2].model);
  EXPECT_EQ(robots[0].model->base.kind, BaseKind::Car);
  EXPECT_EQ(robots[0].model->base.wheelbase, 1.0);
  EXPECT_DOUBLE_EQ(robots[0].model->body.high().x(), 1.3);
  EXPECT_EQ(robots[1].model->base.wheels.kind, WheelKind::Mecanum);
  EXPECT_EQ(robots[1].model->body.parts()[0].count, 5);
  EXPECT_EQ(scenario->settings.robot.linear_max, 1.2);  // pages show the first robot
  EXPECT_TRUE(scenario->radio.on);
  EXPECT_NE(std::find(notes.files.begin(), notes.files.end(), folder.path("mecanum.yaml")),
            notes.files.end());
}

TEST(RobotModelFile, ABodyIsWrittenAsItIsRead) {
  const TemporaryFolder folder;
  const std::string text =
      "kind: tricycle\ndiscs: [[0.1, 0, 0.4], [0.9, 0, 0.3]]\nwheelbase: 1.1\nsteering_max: 1.2\n"
      "steering_rate_max: 1\nlinear_min: -0.5\nlinear_max: 1.2\nangular_max: 1.5\n"
      "linear_acceleration: 0.8\nangular_acceleration: 3\nwheels: {type: steered, speed_max: "
      "1.3}\n";
  const auto model = read_robot_model(folder.write("a.yaml", text));
  ASSERT_TRUE(model) << model.error().message;
  const std::string written = robot_model_yaml(*model, 0);
  const auto again = read_robot_model(folder.write("b.yaml", written));
  ASSERT_TRUE(again) << again.error().message << written;
  EXPECT_EQ(robot_model_yaml(*again, 0), written);
  EXPECT_EQ(again->body.parts().size(), 2U);
  EXPECT_EQ(again->base.wheels.speed_max, 1.3);
}

TEST(RobotModelFile, RefusesABodyThatIsNone) {
  const TemporaryFolder folder;
  write_map(folder);
  const auto refused = [&](const std::string& robot, const std::string& extra = "") {
    const auto scenario = read_scenario(folder.write(
        "s.yaml", "map: m.yaml\n" + extra +
                      "robots:\n  - start: [1, 2, 0]\n    goal: [8, 4]\n    robot: " + robot +
                      "\n"));
    return scenario ? std::string() : scenario.error().message;
  };
  const std::string base =
      "linear_min: 0, linear_max: 1, angular_max: 1, linear_acceleration: 1, angular_acceleration: "
      "1";
  EXPECT_EQ(refused("{kind: unicycle, length: 1, width: 0.5, " + base + "}"), "");
  EXPECT_NE(refused("{kind: boat, length: 1, width: 0.5, " + base + "}").find("s.yaml:5: "),
            std::string::npos);
  EXPECT_NE(refused("{kind: unicycle, " + base + "}").find("expected length and width"),
            std::string::npos);
  EXPECT_NE(refused("{kind: car, length: 1, width: 0.5, " + base + "}").find("wheelbase"),
            std::string::npos);
  EXPECT_NE(
      refused("{kind: unicycle, length: 1, width: 0.5, sides: 3, " + base + "}").find("sides"),
      std::string::npos);
  EXPECT_NE(refused("{file: nowhere.yaml}").find("nowhere.yaml"), std::string::npos);
  const std::string plain = "{kind: unicycle, length: 1, width: 0.5, " + base + "}";
  EXPECT_EQ(refused(plain, "sensing: lidar\n"), "");
  EXPECT_EQ(refused(plain, "zones:\n  - {kind: keep_out, polygon: [[2, 0], [3, 0], [3, 1]]}\n"),
            "");
  EXPECT_NE(refused(plain, "physics: mujoco\n").find("physics: expected unicycle"),
            std::string::npos);
}

}  // namespace
}  // namespace fairway::io
