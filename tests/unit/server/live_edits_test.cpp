// SPDX-License-Identifier: Apache-2.0
// What a live world refuses, with the reason for the client that asked, and what it keeps.
#include <atomic>
#include <future>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "server/live_world.hpp"

namespace fairway::app {
namespace {

// A paused live world of the empty hall, whose refusals and states are kept.
class LiveEdits : public ::testing::Test {
 protected:
  LiveEdits() : world_({built_in_maps().back(), built_in_maps().front()}, listener()) {
    world_.ask(PauseCommand{.paused = true});
  }

  // Asks, and waits until it is done.
  void ask(ClientCommand command, std::uint64_t client = 1) {
    world_.ask(std::move(command), client);
    static_cast<void>(saved());
  }

  std::string saved() {
    std::promise<std::string> promise;
    world_.download(LiveWorld::Download::Scenario,
                    [&](std::string bytes) { promise.set_value(std::move(bytes)); });
    return promise.get_future().get();
  }

  LiveListener listener() {
    return {.on_run = [](std::string) {},
            .on_records = [](std::string) {},
            .on_beginning = [](std::string) {},
            .on_messages = [](LiveMessages::Batch) {},
            .on_state = [this](const LiveState& state) { state_ = state; },
            .on_notice = [](const std::string&) {},
            .on_refusal = [this](const Refusal& refusal) { refusals_.push_back(refusal); }};
  }

  LiveState state_;  // read after the world has answered
  std::vector<Refusal> refusals_;
  LiveWorld world_;
};

Zone slow_zone(double speed) {
  return {.kind = ZoneKind::SpeedLimit, .polygon = {{4, 4}, {7, 4}, {7, 6}}, .speed = speed};
}

TEST_F(LiveEdits, RefusesZonesThatAreNone) {
  Zone crossed = slow_zone(0.5);
  crossed.polygon = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  ask(ZoneCommand{.index = {}, .zone = crossed}, 4);
  ask(ZoneCommand{.index = {}, .zone = slow_zone(-1.0)}, 4);
  ask(ZoneCommand{.index = 0, .zone = slow_zone(0.5)}, 4);
  ask(RemoveZoneCommand{.index = 0}, 4);
  ASSERT_EQ(refusals_.size(), 4U);
  EXPECT_EQ(refusals_[0].text.find("Zone: polygon: expected "), 0U) << refusals_[0].text;
  EXPECT_EQ(refusals_[0].at, Eigen::Vector2d(0, 0));
  EXPECT_EQ(refusals_[1].text.find("Zone: speed: expected "), 0U) << refusals_[1].text;
  EXPECT_EQ(refusals_[2].text, "There is no such zone.");
  EXPECT_EQ(refusals_[3].text, "There is no such zone.");
  EXPECT_FALSE(state_.edited);
}

TEST_F(LiveEdits, RefusesPlacesOutsideTheMapAndOnObstacles) {
  const Pose2 corner{.position = {0.05, 0.05}, .heading = 0.0};
  ask(GoalCommand{.robot = 0, .goal = {.position = {-1.0, 2.0}, .heading = {}}}, 7);
  ask(PoseCommand{.robot = 0, .pose = corner}, 7);
  ask(AddRobotCommand{.pose = corner}, 7);
  ask(WalkCommand{.body = {}, .target = corner.position}, 7);
  ASSERT_EQ(refusals_.size(), 4U);
  for (const Refusal& refusal : refusals_) {
    EXPECT_EQ(refusal.client, 7U);
    EXPECT_TRUE(refusal.at.has_value());
  }
  EXPECT_NE(refusals_[0].text.find("(-1.00, 2.00) is outside the map."), std::string::npos);
  EXPECT_NE(refusals_[1].text.find("overlaps an obstacle by"), std::string::npos);
  EXPECT_NE(refusals_[3].text.find("0.30 m are needed"), std::string::npos);
  EXPECT_FALSE(state_.edited);
}

TEST_F(LiveEdits, ChangesSettingsTogetherOrNotAtAll) {
  ask(SettingCommand{.assignments = {"robot.length=0.8"}});
  ASSERT_EQ(refusals_.size(), 1U);
  EXPECT_EQ(refusals_[0].settings, std::vector<std::string>{"robot.length"});
  ask(SettingCommand{.assignments = {"robot.radius=0.5", "robot.length=0.8", "robot.width=0.5"}});
  EXPECT_EQ(refusals_.size(), 1U);
  EXPECT_EQ(state_.undo, "change robot.radius");
  EXPECT_NE(saved().find("length: 0.8"), std::string::npos);
}

TEST_F(LiveEdits, UndoesAndRedoesEachKindOfEdit) {
  const std::vector<ClientCommand> commands = {
      GoalCommand{.robot = 0, .goal = {.position = {5.0, 5.0}, .heading = {}}},
      CancelCommand{.robot = 0},
      PoseCommand{.robot = 0, .pose = {.position = {8.0, 8.0}, .heading = 0.0}},
      PaintCommand{.from = {10, 10}, .to = {12, 10}, .radius = 0.2, .blocked = true, .stroke = 3},
      WalkCommand{.body = {}, .target = {6.0, 12.0}},
      RemoveBodyCommand{.body = 0},
      AddRobotCommand{.pose = {.position = {3.0, 12.0}, .heading = 0.0}},
      RemoveRobotCommand{.robot = 1},
      ZoneCommand{.index = {}, .zone = slow_zone(0.5)},
      ZoneCommand{.index = 0, .zone = slow_zone(0.3)},
      RemoveZoneCommand{.index = 0},
      SettingCommand{.assignments = {"robot.linear_max=0.4"}}};
  std::vector<std::string> worlds = {saved()};
  for (const ClientCommand& command : commands) {
    ask(command);
    worlds.push_back(saved());
  }
  EXPECT_TRUE(refusals_.empty());
  for (std::size_t i = commands.size(); i-- > 0;) {
    ask(UndoCommand{.redo = false});
    EXPECT_EQ(saved(), worlds[i]) << i;
  }
  EXPECT_EQ(state_.undo, "");
  for (std::size_t i = 0; i < commands.size(); ++i) {
    ask(UndoCommand{.redo = true});
    EXPECT_EQ(saved(), worlds[i + 1]) << i;
  }
}

TEST_F(LiveEdits, KeepsEditsOfAMapThatIsLeft) {
  ask(PaintCommand{.from = {10, 10}, .to = {12, 10}, .radius = 0.2, .blocked = true});
  const std::string edited = saved();
  ask(ChooseMapCommand{.index = 1});
  EXPECT_FALSE(state_.edited);
  ask(ChooseMapCommand{.index = 0});
  EXPECT_TRUE(state_.edited);
  EXPECT_EQ(saved(), edited);
  ask(RevertCommand{});
  EXPECT_FALSE(state_.edited);
  EXPECT_NE(saved(), edited);
}

TEST_F(LiveEdits, PlansInAThreadWithoutChangingWhatIsSaved) {
  EXPECT_EQ(saved().find("background: true"), std::string::npos);
}

TEST(LiveWorldBegin, WaitsForItsFirstViewer) {
  std::promise<void> begins;
  std::atomic<int> told = 0;
  LiveListener listener{.on_run = [](std::string) {},
                        .on_records = [&](std::string) { ++told; },
                        .on_beginning = [](std::string) {},
                        .on_messages = [](LiveMessages::Batch) {},
                        .on_state =
                            [&, done = false](const LiveState& state) mutable {
                              if (!state.waiting && !std::exchange(done, true)) begins.set_value();
                            },
                        .on_notice = [](const std::string&) {}};
  LiveWorld world({built_in_maps().back()}, listener, LiveWorld::Begin::WithViewer);
  std::promise<void> answered;
  world.download(LiveWorld::Download::Scenario, [&](const std::string&) { answered.set_value(); });
  answered.get_future().get();
  const int before = told;
  EXPECT_LE(before, 1);
  world.welcome();
  begins.get_future().get();
  while (told < before + 3)
    std::this_thread::yield();
}

}  // namespace
}  // namespace fairway::app
