// SPDX-License-Identifier: Apache-2.0
// Which orders are taken and what becomes of them, in every version.
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

class Orders : public testing::TestWithParam<ProtocolVersion> {
 protected:
  FleetDouble fleet{GetParam()};

  [[nodiscard]] bool has_error(Fault fault) const {
    const auto errors = fleet.errors();
    return std::find(errors.begin(), errors.end(), fleet.type(fault)) != errors.end();
  }
};

INSTANTIATE_TEST_SUITE_P(Versions,
                         Orders,
                         testing::Values(ProtocolVersion::V2_0_0,
                                         ProtocolVersion::V2_1_0,
                                         ProtocolVersion::V3_0_0));

TEST_P(Orders, ListsAllNodesButTheFirst) {
  fleet.send_order({});
  const json state = fleet.state();
  EXPECT_EQ(state["orderId"], "lanes");
  EXPECT_EQ(state["lastNodeId"], "n0");
  ASSERT_EQ(state["nodeStates"].size(), 3U);
  EXPECT_EQ(state["nodeStates"][0]["nodeId"], "n1");
  EXPECT_EQ(state["edgeStates"].size(), 3U);
  EXPECT_TRUE(state["errors"].empty()) << state["errors"];
}

TEST_P(Orders, RemoveNodesAndEdgesOnTheWay) {
  fleet.send_order({});
  fleet.drive(0.0, 2.5);
  const json state = fleet.state();
  EXPECT_EQ(state["lastNodeId"], "n1");
  EXPECT_EQ(state["lastNodeSequenceId"], 2);
  EXPECT_EQ(state["nodeStates"].size(), 2U);
  EXPECT_EQ(state["edgeStates"].size(), 2U);
  EXPECT_NEAR(state["distanceSinceLastNode"].get<double>(), 0.5, 0.15);
}

TEST_P(Orders, EndAtTheLastNodeOnlyOnArrival) {
  fleet.send_order({});
  fleet.drive(0.0, 6.0);
  EXPECT_FALSE(fleet.vehicle.idle());
  fleet.arrive(6.0);
  EXPECT_TRUE(fleet.vehicle.idle());
  EXPECT_EQ(fleet.state()["lastNodeId"], "n3");
}

TEST_P(Orders, NeverEnterTheHorizon) {
  fleet.send_order({.nodes = 4, .released = 2});
  ASSERT_EQ(fleet.vehicle.route().legs.size(), 1U);
  fleet.drive(0.0, 2.0);
  fleet.arrive(2.0);
  EXPECT_EQ(fleet.state()["lastNodeId"], "n1");
  EXPECT_FALSE(fleet.vehicle.idle());
  EXPECT_FALSE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["newBaseRequest"], true);
}

TEST_P(Orders, AreExtendedAtTheEndOfTheBase) {
  fleet.send_order({.nodes = 4, .released = 2});
  fleet.drive(0.0, 1.0);
  fleet.send_order({.update = 1, .first = 1, .nodes = 5, .released = 3});
  const json state = fleet.state();
  EXPECT_EQ(state["orderUpdateId"], 1);
  EXPECT_EQ(state["nodeStates"].size(), 5U);
  EXPECT_EQ(fleet.vehicle.route().legs.size(), 3U);
  EXPECT_TRUE(state["errors"].empty()) << state["errors"];
}

TEST_P(Orders, AreExtendedAfterTheEndToo) {
  fleet.send_order({.nodes = 2, .released = 2});
  fleet.drive(0.0, 2.0);
  fleet.arrive(2.0);
  ASSERT_TRUE(fleet.vehicle.idle());
  fleet.send_order({.update = 1, .first = 1, .nodes = 2, .released = 2});
  EXPECT_TRUE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["nodeStates"].size(), 1U);
}

TEST_P(Orders, LoseTheirHorizonByAnUpdateOfOneNode) {
  fleet.send_order({.nodes = 4, .released = 2});
  fleet.send_order({.update = 1, .first = 1, .nodes = 1, .released = 1});
  EXPECT_EQ(fleet.state()["nodeStates"].size(), 1U);
}

TEST_P(Orders, AreRefusedWhileAnotherOneIsActive) {
  fleet.send_order({});
  fleet.send_order({.id = "other"});
  EXPECT_TRUE(has_error(Fault::OtherOrderActive));
  const json state = fleet.state();
  EXPECT_EQ(state["orderId"], "lanes");
  EXPECT_EQ(state["errors"][0]["errorReferences"][0]["referenceValue"], "other");
}

TEST_P(Orders, AreRefusedFarFromTheirFirstNode) {
  fleet.send_order({.first = 1, .nodes = 2, .released = 2});
  EXPECT_TRUE(has_error(Fault::StartNode));
  EXPECT_EQ(fleet.state()["orderId"], "");
}

TEST_P(Orders, OfAnotherMapAreRefused) {
  json order = fleet.lanes({});
  order["nodes"][2]["nodePosition"]["mapId"] = "roof";
  fleet.send(Topic::Order, order);
  EXPECT_TRUE(has_error(Fault::UnknownMap));
}

TEST_P(Orders, WithoutAPathAreRefused) {
  fleet.vehicle.set_route_check([](const Route& route, const std::vector<Zone>&) {
    return std::optional<std::size_t>(route.legs.size() - 1);
  });
  fleet.send_order({});
  EXPECT_TRUE(has_error(Fault::NoRoute));
  EXPECT_EQ(fleet.state()["errors"][0]["errorReferences"][2]["referenceValue"], "n3");
}

TEST_P(Orders, IgnoreARepeatedMessage) {
  fleet.send_order({});
  fleet.drive(0.0, 2.5);
  fleet.send_order({});
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_EQ(fleet.state()["nodeStates"].size(), 2U);
}

TEST_P(Orders, RefuseAnOldUpdateAndDriveOn) {
  fleet.send_order({.update = 0, .nodes = 4, .released = 2});
  fleet.send_order({.update = 2, .first = 1, .nodes = 2, .released = 2});
  fleet.send_order({.update = 1, .first = 1, .nodes = 2, .released = 2});
  EXPECT_TRUE(has_error(Fault::OutdatedUpdate));
  EXPECT_TRUE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["orderUpdateId"], 2);
}

TEST_P(Orders, RefuseAnUpdateThatDoesNotBeginAtTheEndOfTheBase) {
  fleet.send_order({.nodes = 4, .released = 2});
  fleet.send_order({.update = 1, .first = 3, .nodes = 2, .released = 2});
  EXPECT_TRUE(has_error(Fault::Stitching));
  EXPECT_EQ(fleet.state()["orderUpdateId"], 0);
}

TEST_P(Orders, KeepARefusalUntilAnOrderIsAccepted) {
  fleet.send_order({.first = 1, .nodes = 2, .released = 2});
  fleet.send_order({.first = 1, .nodes = 2, .released = 2});
  EXPECT_EQ(fleet.errors().size(), 1U);
  fleet.send_order({.id = "second"});
  EXPECT_TRUE(fleet.errors().empty());
}

TEST_P(Orders, AreNotTakenInManualMode) {
  fleet.vehicle.set_mode(OperatingMode::Manual);
  fleet.send_order({});
  EXPECT_TRUE(has_error(Fault::NotAvailable));
  fleet.vehicle.set_mode(OperatingMode::Automatic);
  EXPECT_FALSE(has_error(Fault::NotAvailable));
}

TEST_P(Orders, AreClearedByManualMode) {
  fleet.send_order({});
  fleet.vehicle.set_mode(OperatingMode::Manual);
  EXPECT_TRUE(fleet.vehicle.idle());
  EXPECT_FALSE(fleet.vehicle.may_drive());
}

// One change of a sound order, and the refusal that it must cause.
struct Spoiled {
  const char* name;
  std::function<void(json&)> spoil;
  Fault fault;
};

TEST_P(Orders, WithAFaultNameIt) {
  const char* speed = fleet.third() ? "maximumSpeed" : "maxSpeed";
  const std::vector<Spoiled> table{
      {"no nodes", [](json& o) { o.erase("nodes"); }, Fault::Validation},
      {"empty nodes",
       [](json& o) {
         o["nodes"] = json::array();
         o["edges"] = json::array();
       },
       Fault::Validation},
      {"text for a number", [](json& o) { o["nodes"][0]["nodePosition"]["x"] = "1"; },
       Fault::Validation},
      {"negative width", [](json& o) { o["edges"][0]["corridor"]["leftWidth"] = -0.1; },
       Fault::Validation},
      {"edge missing", [](json& o) { o["edges"].erase(1); }, Fault::Validation},
      {"gap", [](json& o) { o["edges"][1]["sequenceId"] = 5; }, Fault::Validation},
      {"released after horizon", [](json& o) { o["nodes"][1]["released"] = false; },
       Fault::Validation},
      {"first not released",
       [](json& o) {
         for (auto& n : o["nodes"])
           n["released"] = false;
         for (auto& e : o["edges"])
           e["released"] = false;
       },
       Fault::Validation},
      {"speed 0", [=](json& o) { o["edges"][0][speed] = 0.0; }, Fault::Validation},
      {"heading in degrees", [](json& o) { o["nodes"][1]["nodePosition"]["theta"] = 90.0; },
       Fault::Validation},
      {"curve that ends elsewhere",
       [](json& o) {
         o["edges"][0]["trajectory"] = {
             {"degree", 1},
             {"knotVector", {0, 0, 1, 1}},
             {"controlPoints", {{{"x", 0.0}, {"y", 0.0}}, {{"x", 2.0}, {"y", 5.0}}}}};
       },
       Fault::Validation},
      {"no position", [](json& o) { o["nodes"][1].erase("nodePosition"); },
       Fault::UnsupportedField},
      {"backwards", [](json& o) { o["edges"][0]["orientation"] = 3.14159; },
       Fault::UnsupportedField},
      {"global", [](json& o) { o["edges"][0]["orientationType"] = "GLOBAL"; },
       Fault::UnsupportedField},
      {"direction", [](json& o) { o["edges"][0]["direction"] = "left"; }, Fault::UnsupportedField},
      {"unknown action",
       [](json& o) {
         o["nodes"][1]["actions"].push_back(
             {{"actionType", "beep"}, {"actionId", "a"}, {"blockingType", "NONE"}});
       },
       Fault::UnknownAction},
      {"old header", [](json& o) { o["version"] = "1.1.0"; }, Fault::Validation},
      {"no timestamp", [](json& o) { o["timestamp"] = "now"; }, Fault::Validation},
  };
  for (const Spoiled& row : table) {
    FleetDouble other(GetParam());
    json order = other.lanes({});
    row.spoil(order);
    other.send(Topic::Order, order);
    ASSERT_EQ(other.errors().size(), 1U) << row.name;
    EXPECT_EQ(other.errors()[0], other.type(row.fault)) << row.name;
    EXPECT_EQ(other.state()["orderId"], "") << row.name;
  }
}

TEST_P(Orders, SurviveAnyChangeOfAField) {
  const json others{nullptr, -1, 1e300, "x", json::array(), json::object(), true, 4294967296.0};
  std::size_t refused = 0;
  json order = fleet.lanes({.nodes = 2, .released = 2});
  order["edges"][0]["trajectory"] = {
      {"degree", 1},
      {"knotVector", {0, 0, 1, 1}},
      {"controlPoints", {{{"x", 0.0}, {"y", 0.0}}, {{"x", 2.0}, {"y", 0.0}}}}};
  const json fields = order.flatten();
  for (const auto& [path, value] : fields.items()) {
    for (const json& other : others) {
      FleetDouble one(GetParam());
      json changed = order;
      changed[json::json_pointer(path)] = other;
      one.send(Topic::Order, changed);
      one.move_to({0.1, 0.0}, true);
      const json state = one.state();
      ASSERT_TRUE(state.contains("errors")) << path << " " << other;
      ASSERT_EQ(state["orderId"] == "", !state["errors"].empty()) << path << " " << other;
      refused += state["errors"].empty() ? 0U : 1U;
    }
  }
  EXPECT_GT(refused, 150U);
}

TEST_P(Orders, ThatAreNoJsonAreRefused) {
  for (const char* text : {"", "{", "[]", "null", "{\"orderId\": NaN}", "\xff\xfe"}) {
    FleetDouble other(GetParam());
    other.vehicle.receive(Topic::Order, text, other.time);
    EXPECT_EQ(other.errors(), std::vector<std::string>{other.type(Fault::Validation)}) << text;
  }
}

TEST_P(Orders, TooLargeAreRefused) {
  FleetDouble small(GetParam(), {.robot = {}, .most_nodes = 3});
  small.send_order({});
  EXPECT_EQ(small.errors(), std::vector<std::string>{small.type(Fault::TooLarge)});
}

TEST(OrdersOfVersion3, BeginWithUpdate0) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({.update = 3});
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"VALIDATION_FAILURE"});
}

TEST(OrdersOfVersion3, RefuseTheSameUpdateWithOtherContent) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({.nodes = 3, .released = 3});
  fleet.send_order({.nodes = 4, .released = 4});
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"SAME_ORDER_UPDATE_ID"});
}

TEST(OrdersOfVersion2, HaveEndsThatBelongToTheirNodes) {
  FleetDouble fleet(ProtocolVersion::V2_1_0);
  json order = fleet.lanes({});
  order["edges"][1]["endNodeId"] = "n9";
  fleet.send(Topic::Order, order);
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"validationError"});
}

TEST_P(Orders, NameTheEdgeWhoseCorridorIsLeft) {
  fleet.send_order({});
  fleet.drive(0.0, 1.0);
  fleet.move_to({1.0, 0.6});
  EXPECT_TRUE(has_error(Fault::OutsideCorridor));
  EXPECT_FALSE(fleet.vehicle.may_drive());
  const json error = fleet.state()["errors"][0];
  EXPECT_EQ(error["errorLevel"], fleet.third() ? "CRITICAL" : "WARNING");
  EXPECT_EQ(error["errorReferences"][0]["referenceValue"], "e0");
  fleet.move_to({1.0, 0.4});
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_TRUE(fleet.vehicle.may_drive());
}

TEST_P(Orders, WaitForAClosedCorridorAndThenGiveUp) {
  fleet.send_order({});
  const auto wait = [&](double seconds, bool gave_up) {
    fleet.time += seconds;
    VehicleMotion motion;
    fleet.vehicle.update(
        motion, {.route = fleet.vehicle.route_revision(), .closed_leg = 0, .gave_up = gave_up},
        fleet.time);
  };
  wait(0.0, false);
  EXPECT_TRUE(fleet.errors().empty());
  wait(4.0, false);
  EXPECT_TRUE(has_error(Fault::CorridorClosed));
  wait(20.0, true);
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{fleet.type(Fault::NodeUnreachable)});
  EXPECT_FALSE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["errors"][0]["errorReferences"][0]["referenceValue"], "n1");
  fleet.send_instant("cancelOrder", "c");
  EXPECT_TRUE(fleet.errors().empty());
  EXPECT_TRUE(fleet.vehicle.idle());
}

}  // namespace
}  // namespace fairway::vda5050::test
