// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/fleet_radio.hpp"

#include <gtest/gtest.h>

namespace fairway {
namespace {

SharedMotion motion_at(double x, double time) {
  SharedMotion motion;
  motion.position = {x, 0.0};
  motion.time = time;
  return motion;
}

TEST(FleetRadio, ReceivesRobotsInRangeByTheirNewestMessage) {
  FleetRadio radio({.on = true, .range = 10.0}, 3, 1);
  radio.tell(0, motion_at(0.0, 0.0));
  radio.tell(1, motion_at(9.0, 0.0));
  radio.tell(2, motion_at(11.0, 0.0));
  ASSERT_EQ(radio.hear(0, {0.0, 0.0}, 0.0).size(), 1U);
  // One robot leaves the range, the other one enters it.
  radio.tell(1, motion_at(10.5, 0.1));
  radio.tell(2, motion_at(9.5, 0.1));
  const Fleet heard = radio.hear(0, {0.0, 0.0}, 0.1);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].motion->position.x(), 9.5);
}

TEST(FleetRadio, ALateMessageCountsAtThePlaceInIt) {
  FleetRadio radio({.on = true, .delay = 0.2, .range = 10.0}, 2, 1);
  radio.tell(0, motion_at(0.0, 0.0));
  radio.tell(1, motion_at(9.5, 0.0));
  radio.tell(1, motion_at(10.5, 0.1));
  EXPECT_EQ(radio.hear(0, {0.0, 0.0}, 0.2).size(), 1U) << "the second one has not arrived";
  EXPECT_EQ(radio.hear(0, {0.0, 0.0}, 0.3).size(), 0U);
}

TEST(FleetRadio, ARobotThatHasPublishedNothingIsNotReceived) {
  FleetRadio radio({.on = true, .range = 10.0}, 1, 1);
  radio.add_robot();
  EXPECT_EQ(radio.hear(0, {0.0, 0.0}, 0.0).size(), 0U);
  radio.tell(1, motion_at(1.0, 0.0));
  EXPECT_EQ(radio.hear(0, {0.0, 0.0}, 0.0).size(), 1U);
  radio.forget(1);
  EXPECT_EQ(radio.hear(0, {0.0, 0.0}, 0.0).size(), 0U);
}

}  // namespace
}  // namespace fairway
