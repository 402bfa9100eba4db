// SPDX-License-Identifier: Apache-2.0
#include "server/editing/edit_history.hpp"

#include <gtest/gtest.h>

#include "fairway/simulation/episode.hpp"

namespace fairway::app {
namespace {

// Edits of a number, made in a running world.
class EditHistoryTest : public ::testing::Test {
 protected:
  void edit(int to, std::uint64_t stroke = 0) {
    const int from = value_;
    value_ = to;
    history_.add({.label = "to " + std::to_string(to),
                  .undo = [this, from](EpisodeControl&) { value_ = from; },
                  .redo = [this, to](EpisodeControl&) { value_ = to; },
                  .stroke = stroke});
  }

  // Calls `act` with the control of a run.
  static void play(const std::function<void(EpisodeControl&)>& act) {
    Scenario scenario;
    scenario.map =
        OccupancyGrid(GridFrame{.width = 40, .height = 40, .resolution = 0.05, .origin = {}});
    EpisodeHooks hooks;
    hooks.play = [&](EpisodeControl& control) {
      act(control);
      return false;
    };
    static_cast<void>(run_episode(scenario, hooks));
  }

  EditHistory history_;
  int value_ = 0;
};

TEST_F(EditHistoryTest, UndoesAndRedoesInOrder) {
  edit(1);
  edit(2);
  EXPECT_EQ(history_.undo_label(), "to 2");
  play([&](EpisodeControl& control) {
    EXPECT_TRUE(history_.undo(control));
    EXPECT_EQ(value_, 1);
    EXPECT_EQ(history_.redo_label(), "to 2");
    EXPECT_TRUE(history_.undo(control));
    EXPECT_EQ(value_, 0);
    EXPECT_FALSE(history_.undo(control));
    EXPECT_TRUE(history_.redo(control));
    EXPECT_TRUE(history_.redo(control));
    EXPECT_FALSE(history_.redo(control));
  });
  EXPECT_EQ(value_, 2);
}

TEST_F(EditHistoryTest, PartsOfAStrokeAreOne) {
  edit(1, 7);
  edit(2, 7);
  edit(3, 8);
  play([&](EpisodeControl& control) {
    EXPECT_TRUE(history_.undo(control));
    EXPECT_EQ(value_, 2);
    EXPECT_TRUE(history_.undo(control));
    EXPECT_EQ(value_, 0);
    EXPECT_FALSE(history_.undo(control));
  });
}

TEST_F(EditHistoryTest, AnEditAfterUndoEndsWhatCanBeRedone) {
  edit(1);
  play([&](EpisodeControl& control) { EXPECT_TRUE(history_.undo(control)); });
  edit(5);
  EXPECT_EQ(history_.redo_label(), "");
}

TEST_F(EditHistoryTest, ForgetsTheOldest) {
  for (int i = 1; i <= 300; ++i)
    edit(i);
  play([&](EpisodeControl& control) {
    while (history_.undo(control)) {
    }
  });
  EXPECT_EQ(value_, 300 - static_cast<int>(EditHistory::kMost));
}

}  // namespace
}  // namespace fairway::app
