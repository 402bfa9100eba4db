// SPDX-License-Identifier: Apache-2.0
// What `fairway order` makes of a vehicle's states.
#include <gtest/gtest.h>

#include "node/order_client.hpp"

namespace fairway::vda5050 {
namespace {

using nlohmann::json;

json state_of(const char* order_id, const json& nodes, bool driving = false) {
  return {{"orderId", order_id},    {"orderUpdateId", 0}, {"lastNodeId", "n1"},
          {"nodeStates", nodes},    {"driving", driving}, {"actionStates", json::array()},
          {"errors", json::array()}};
}

const json kOrder{{"orderId", "a"}, {"orderUpdateId", 0}, {"nodes", json::array()}};

TEST(OrderClient, RecognisesMessages) {
  EXPECT_EQ(topic_of(kOrder), Topic::Order);
  EXPECT_EQ(topic_of({{"actions", json::array()}}), Topic::InstantActions);
  EXPECT_EQ(topic_of({{"zoneSet", json::object()}}), Topic::ZoneSet);
  EXPECT_FALSE(topic_of({{"nodes", 1}}));
  EXPECT_FALSE(topic_of(json::array()));
}

TEST(OrderClient, WaitsUntilTheOrderIsDriven) {
  const json ahead = json::array({{{"nodeId", "n2"}, {"released", true}}});
  const json horizon = json::array({{{"nodeId", "n2"}, {"released", false}}});
  EXPECT_FALSE(result_of(kOrder, state_of("other", json::array())));
  EXPECT_FALSE(result_of(kOrder, state_of("a", ahead, true)));
  EXPECT_FALSE(result_of(kOrder, state_of("a", json::array(), true)));
  ASSERT_TRUE(result_of(kOrder, state_of("a", json::array())));
  EXPECT_TRUE(result_of(kOrder, state_of("a", json::array()))->done);
  EXPECT_TRUE(result_of(kOrder, state_of("a", horizon))->done) << "the base is driven";
}

TEST(OrderClient, ReportsARefusal) {
  json state = state_of("", json::array());
  state["errors"].push_back(
      {{"errorType", "orderError"},
       {"errorDescription", "no map"},
       {"errorReferences", {{{"referenceKey", "orderId"}, {"referenceValue", "a"}}}}});
  const auto result = result_of(kOrder, state);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->done);
  EXPECT_EQ(result->text, "orderError: no map");
}

TEST(OrderClient, WaitsForInstantActions) {
  const json sent{{"actions", {{{"actionId", "p"}}}}};
  json state = state_of("", json::array());
  EXPECT_FALSE(result_of(sent, state));
  state["instantActionStates"] = {{{"actionId", "p"}, {"actionStatus", "RUNNING"}}};
  EXPECT_FALSE(result_of(sent, state));
  state["instantActionStates"][0]["actionStatus"] = "FAILED";
  EXPECT_FALSE(result_of(sent, state)->done);
  state["instantActionStates"][0]["actionStatus"] = "FINISHED";
  EXPECT_TRUE(result_of(sent, state)->done);
}

}  // namespace
}  // namespace fairway::vda5050
