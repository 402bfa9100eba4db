// SPDX-License-Identifier: Apache-2.0
// Which orders are refused, and with which error, in every version.
#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "vda5050/driving/fleet_double.hpp"

namespace fairway::vda5050::test {
namespace {

class RefusedOrders : public testing::TestWithParam<ProtocolVersion> {
 protected:
  FleetDouble fleet{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Versions,
                         RefusedOrders,
                         testing::Values(ProtocolVersion::V2_0_0,
                                         ProtocolVersion::V2_1_0,
                                         ProtocolVersion::V3_0_0));

TEST_P(RefusedOrders, AreRefusedWhileAnotherOneIsActive) {
  fleet.send_order({});
  fleet.send_order({.id = "other"});
  EXPECT_TRUE(fleet.has_error(Fault::OtherOrderActive));
  const json state = fleet.state();
  EXPECT_EQ(state["orderId"], "lanes");
  EXPECT_EQ(state["errors"][0]["errorReferences"][0]["referenceValue"], "other");
}

TEST_P(RefusedOrders, AreRefusedFarFromTheirFirstNode) {
  fleet.send_order({.first = 1, .nodes = 2, .released = 2});
  EXPECT_TRUE(fleet.has_error(Fault::StartNode));
  EXPECT_EQ(fleet.state()["orderId"], "");
}

TEST_P(RefusedOrders, OfAnotherMapAreRefused) {
  json order = fleet.lanes({});
  order["nodes"][2]["nodePosition"]["mapId"] = "roof";
  fleet.send(Topic::Order, order);
  EXPECT_TRUE(fleet.has_error(Fault::UnknownMap));
}

TEST_P(RefusedOrders, WithoutAPathAreRefused) {
  fleet.vehicle.set_route_check([](const Route& route, const std::vector<Zone>&) {
    return std::optional<std::size_t>(route.legs.size() - 1);
  });
  fleet.send_order({});
  EXPECT_TRUE(fleet.has_error(Fault::NoRoute));
  EXPECT_EQ(fleet.state()["errors"][0]["errorReferences"][2]["referenceValue"], "n3");
}

TEST_P(RefusedOrders, RefuseAnOldUpdateAndDriveOn) {
  fleet.send_order({.update = 0, .nodes = 4, .released = 2});
  fleet.send_order({.update = 2, .first = 1, .nodes = 2, .released = 2});
  fleet.send_order({.update = 1, .first = 1, .nodes = 2, .released = 2});
  EXPECT_TRUE(fleet.has_error(Fault::OutdatedUpdate));
  EXPECT_TRUE(fleet.vehicle.may_drive());
  EXPECT_EQ(fleet.state()["orderUpdateId"], 2);
}

TEST_P(RefusedOrders, RefuseAnUpdateThatDoesNotBeginAtTheEndOfTheBase) {
  fleet.send_order({.nodes = 4, .released = 2});
  fleet.send_order({.update = 1, .first = 3, .nodes = 2, .released = 2});
  EXPECT_TRUE(fleet.has_error(Fault::Stitching));
  EXPECT_EQ(fleet.state()["orderUpdateId"], 0);
}

TEST_P(RefusedOrders, KeepARefusalUntilAnOrderIsAccepted) {
  fleet.send_order({.first = 1, .nodes = 2, .released = 2});
  fleet.send_order({.first = 1, .nodes = 2, .released = 2});
  EXPECT_EQ(fleet.errors().size(), 1U);
  fleet.send_order({.id = "second"});
  EXPECT_TRUE(fleet.errors().empty());
}

TEST_P(RefusedOrders, AreNotTakenInManualMode) {
  fleet.vehicle.set_mode(OperatingMode::Manual);
  fleet.send_order({});
  EXPECT_TRUE(fleet.has_error(Fault::NotAvailable));
  fleet.vehicle.set_mode(OperatingMode::Automatic);
  EXPECT_FALSE(fleet.has_error(Fault::NotAvailable));
}

// One change of a sound order, and the refusal that it must cause.
struct Spoiled {
  const char* name;
  std::function<void(json&)> spoil;
  Fault fault;
};

TEST_P(RefusedOrders, WithAFaultNameIt) {
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

TEST_P(RefusedOrders, SurviveAnyChangeOfAField) {
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

TEST_P(RefusedOrders, ThatAreNoJsonAreRefused) {
  for (const char* text : {"", "{", "[]", "null", "{\"orderId\": NaN}", "\xff\xfe"}) {
    FleetDouble other(GetParam());
    other.vehicle.receive(Topic::Order, text, other.time);
    EXPECT_EQ(other.errors(), std::vector<std::string>{other.type(Fault::Validation)}) << text;
  }
}

TEST_P(RefusedOrders, TooLargeAreRefused) {
  FleetDouble small(GetParam(), {.robot = {}, .most_nodes = 3});
  small.send_order({});
  EXPECT_EQ(small.errors(), std::vector<std::string>{small.type(Fault::TooLarge)});
}

TEST(RefusedOrdersOfVersion3, BeginWithUpdate0) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({.update = 3});
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"VALIDATION_FAILURE"});
}

TEST(RefusedOrdersOfVersion3, RefuseTheSameUpdateWithOtherContent) {
  FleetDouble fleet(ProtocolVersion::V3_0_0);
  fleet.send_order({.nodes = 3, .released = 3});
  fleet.send_order({.nodes = 4, .released = 4});
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"SAME_ORDER_UPDATE_ID"});
}

TEST(RefusedOrdersOfVersion2, HaveEndsThatBelongToTheirNodes) {
  FleetDouble fleet(ProtocolVersion::V2_1_0);
  json order = fleet.lanes({});
  order["edges"][1]["endNodeId"] = "n9";
  fleet.send(Topic::Order, order);
  EXPECT_EQ(fleet.errors(), std::vector<std::string>{"validationError"});
}

}  // namespace
}  // namespace fairway::vda5050::test
