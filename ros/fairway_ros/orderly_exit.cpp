// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/orderly_exit.hpp"

#include <atomic>
#include <csignal>

#include <ros/xmlrpc_manager.h>

namespace fairway::ros1 {

namespace {

std::atomic<int> wanted{0};  // number of requests; lock-free, as signal handlers need
static_assert(std::atomic<int>::is_always_lock_free);

void on_signal(int /*signal*/) { ++wanted; }

void on_shutdown_call(XmlRpc::XmlRpcValue& parameters, XmlRpc::XmlRpcValue& result) {
  const int count = parameters.getType() == XmlRpc::XmlRpcValue::TypeArray ? parameters.size() : 0;
  if (count > 1) ++wanted;
  result = ros::xmlrpc::responseInt(1, "", 0);
}

}  // namespace

void take_over_exit() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  ros::XMLRPCManager::instance()->unbind("shutdown");
  ros::XMLRPCManager::instance()->bind("shutdown", on_shutdown_call);
}

bool exit_wanted() noexcept { return wanted > 0; }
bool exit_urgent() noexcept { return wanted > 1; }

}  // namespace fairway::ros1
