// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/setting_store.hpp"

#include <gtest/gtest.h>

namespace fairway::nav2 {
namespace {

using Changes = std::vector<SettingChange>;

// A node that stores what it is given; another validator may refuse everything.
struct Node {
  std::map<std::string, SettingValue> values;
  std::optional<SettingValue> operator()(const std::string& name) const {
    const auto found = values.find(name);
    return found == values.end() ? std::nullopt : std::optional(found->second);
  }
};

TEST(SettingStore, DeclaresEverySettingWithItsRange) {
  const SettingStore store({}, true);
  bool found = false;
  for (const SettingDeclaration& declaration : store.declarations()) {
    if (declaration.name != "following.max_deviation") continue;
    found = true;
    EXPECT_EQ(std::get<double>(declaration.value), 0.0);
    EXPECT_EQ(declaration.greatest, 10.0);
    EXPECT_NE(declaration.meaning.find("[m]"), std::string::npos);
  }
  EXPECT_TRUE(found);
  for (const SettingDeclaration& declaration : SettingStore({}, false).declarations())
    EXPECT_FALSE(declaration.name.starts_with("following."));
}

TEST(SettingStore, AcceptsWholeNumbersForRealOnes) {
  SettingStore store({}, true);
  EXPECT_EQ(store.set(Changes{{"robot.linear_max", std::int64_t{2}}}), "");
  EXPECT_EQ(store.settings().robot.robot.linear_max, 2.0);
  EXPECT_EQ(store.set(Changes{{"mpc.horizon", 10.0}}), "");
  EXPECT_NE(store.set(Changes{{"mpc.horizon", 10.5}}), "");
  EXPECT_NE(store.set(Changes{{"robot.linear_max", std::string("fast")}}), "");
  EXPECT_NE(store.set(Changes{{"robot.linear_max", true}}), "");
  EXPECT_NE(store.set(Changes{{"map.unknown_is_occupied", 1.0}}), "");
}

TEST(SettingStore, SetsAllValuesOrNoneAndNamesTheFault) {
  SettingStore store({}, true);
  const std::string fault = store.set(Changes{{"robot.radius", 0.4}, {"robot.linear_max", -1.0}});
  EXPECT_NE(fault.find("robot.linear_max: expected a number from 0.01 to 10, found -1"),
            std::string::npos)
      << fault;
  EXPECT_EQ(store.settings().robot.robot.radius, RobotSettings{}.radius);
  EXPECT_NE(store.set(Changes{{"robot.length", 0.5}}).find("robot.width"), std::string::npos);
  EXPECT_NE(store.set(Changes{{"corridor.method", std::string("x")}}).find("mdsrc"),
            std::string::npos);
}

TEST(SettingStore, TakesAProposalOnceTheNodeHasStoredIt) {
  SettingStore store({}, true);
  Node node;
  EXPECT_EQ(store.propose(Changes{{"robot.linear_max", 0.5}}, 10.0), "");
  EXPECT_FALSE(store.take_change(10.01, node)) << "the callback runs before the node stores it";
  node.values["robot.linear_max"] = 0.5;
  const auto changed = store.take_change(10.02, node);
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->robot.robot.linear_max, 0.5);
  EXPECT_FALSE(store.take_change(10.03, node)) << "only once";
}

TEST(SettingStore, ForgetsAProposalThatAnotherValidatorRefused) {
  SettingStore store({}, true);
  Node node;
  node.values["robot.linear_max"] = 1.0;
  EXPECT_EQ(store.propose(Changes{{"robot.linear_max", 0.5}}, 10.0), "");
  EXPECT_FALSE(store.take_change(10.5, node));
  EXPECT_FALSE(store.take_change(11.5, node));
  node.values["robot.linear_max"] = 0.5;
  EXPECT_FALSE(store.take_change(11.6, node));
  EXPECT_EQ(store.settings().robot.robot.linear_max, 1.0);
}

TEST(SettingStore, ChecksProposalsTogether) {
  SettingStore store({}, true);
  Node node;
  EXPECT_EQ(store.propose(Changes{{"robot.linear_min", -0.2}}, 0.0), "");
  EXPECT_EQ(store.propose(Changes{{"robot.length", 0.5}, {"robot.width", 0.3}}, 0.1), "");
  EXPECT_NE(store.propose(Changes{{"robot.width", 0.0}}, 0.2), "") << "the length is proposed";
  node.values = {{"robot.linear_min", -0.2}, {"robot.length", 0.5}, {"robot.width", 0.3}};
  EXPECT_EQ(store.take_change(0.3, node)->robot.robot.width, 0.3);
}

}  // namespace
}  // namespace fairway::nav2
