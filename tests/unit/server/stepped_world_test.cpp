// SPDX-License-Identifier: Apache-2.0
#include "playground/stepped_world.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"

namespace fairway::app {
namespace {

struct Told {
  int records = 0;
  bool paused = false;
  std::string notice;
};

LiveListener listener(Told& told) {
  return {.on_run = [](std::string) {},
          .on_records = [&told](std::string) { ++told.records; },
          .on_beginning = [](std::string) {},
          .on_messages = [](LiveMessages::Batch) {},
          .on_state = [&told](const LiveState& state) { told.paused = state.paused; },
          .on_notice = [&told](const std::string& notice) { told.notice = notice; }};
}

std::string downloaded(SteppedWorld& stepped, LiveWorld::Download what) {
  std::string bytes;
  stepped.world().download(what, [&](std::string got) { bytes = std::move(got); });
  stepped.advance();
  return bytes;
}

TEST(SteppedWorld, WaitsWhilePausedAndGoesStepByStep) {
  Told told;
  SteppedWorld stepped(built_in_maps(), listener(told));
  EXPECT_TRUE(std::isfinite(stepped.advance()));  // begins to run
  stepped.world().ask(PauseCommand{.paused = true});
  EXPECT_TRUE(std::isinf(stepped.advance()));
  EXPECT_TRUE(told.paused);
  const int before = told.records;
  for (int i = 0; i < 3; ++i) {
    stepped.world().ask(StepCommand{});
    stepped.advance();
  }
  EXPECT_EQ(told.records, before + 3);
  stepped.advance();
  EXPECT_EQ(told.records, before + 3);
}

TEST(SteppedWorld, ItsChangesReplayToTheBit) {
  Told told;
  SteppedWorld stepped({built_in_maps().back()}, listener(told));
  stepped.world().ask(PauseCommand{.paused = true});
  const auto steps = [&](int count) {
    for (int i = 0; i < count; ++i) {
      stepped.world().ask(StepCommand{});
      stepped.advance();
    }
  };
  stepped.advance();
  steps(20);
  stepped.world().ask(
      PaintCommand{.from = {6.0, 2.0}, .to = {8.0, 9.0}, .radius = 0.2, .blocked = true});
  steps(20);
  stepped.world().ask(SettingCommand{.assignments = {"robot.linear_max=0.6"}});
  steps(40);
  ReplayCheck check;
  const auto read =
      io::read_recording(downloaded(stepped, LiveWorld::Download::Recording), "stepped", check);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_GT(check.cycles(), 70);
  EXPECT_EQ(check.different(), 0);
}

TEST(SteppedWorld, BeginsAgainOnAnotherMap) {
  Told told;
  SteppedWorld stepped(built_in_maps(), listener(told));
  stepped.advance();
  const std::string before = downloaded(stepped, LiveWorld::Download::Scenario);
  stepped.world().ask(ChooseMapCommand{.index = 3});
  stepped.advance();
  const std::string after = downloaded(stepped, LiveWorld::Download::Scenario);
  EXPECT_FALSE(before.empty());
  EXPECT_NE(before, after);
}

}  // namespace
}  // namespace fairway::app
