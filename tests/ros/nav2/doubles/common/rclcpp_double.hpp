// SPDX-License-Identifier: Apache-2.0
// Not ROS 2: hand-written doubles of the few types that the Nav2 plugins use. The plugins compile
// against them for every distribution; for jazzy they also run, in one process without messages.
#pragma once

#include <any>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "ros2_messages_double.hpp"

namespace rclcpp {
enum class ParameterType : std::uint8_t {
  PARAMETER_NOT_SET,
  PARAMETER_BOOL,
  PARAMETER_INTEGER,
  PARAMETER_DOUBLE,
  PARAMETER_STRING,
  PARAMETER_BYTE_ARRAY
};
class ParameterValue {
 public:
  ParameterValue() = default;
  explicit ParameterValue(std::int64_t value) : value_(value) {}
  explicit ParameterValue(bool value) : value_(value) {}
  explicit ParameterValue(int value) : value_(std::int64_t{value}) {}
  explicit ParameterValue(double value) : value_(value) {}
  explicit ParameterValue(const std::string& value) : value_(value) {}
  ParameterType get_type() const { return static_cast<ParameterType>(value_.index()); }
  template <typename Value>
  const Value& get() const {
    return std::get<Value>(value_);
  }

 private:
  std::variant<std::monostate, bool, std::int64_t, double, std::string> value_;
};
class Parameter {
 public:
  template <typename Value>
  Parameter(std::string name, const Value& value) : name_(std::move(name)),
                                                    value_(value) {}
  Parameter(std::string name, const ParameterValue& value)
      : name_(std::move(name)),
        value_(value) {}
  const std::string& get_name() const { return name_; }
  const ParameterValue& get_parameter_value() const { return value_; }
  bool as_bool() const { return value_.get<bool>(); }
  std::int64_t as_int() const { return value_.get<std::int64_t>(); }
  double as_double() const { return value_.get<double>(); }
  const std::string& as_string() const { return value_.get<std::string>(); }

 private:
  std::string name_;
  ParameterValue value_;
};
class Duration {
 public:
  static Duration from_seconds(double seconds) { return Duration(std::llround(seconds * 1e9)); }
  std::int64_t nanoseconds() const { return nanoseconds_; }

 private:
  explicit Duration(std::int64_t nanoseconds) : nanoseconds_(nanoseconds) {}
  std::int64_t nanoseconds_;
};
class Time {
 public:
  explicit Time(std::int64_t nanoseconds = 0) : nanoseconds_(nanoseconds) {}
  explicit Time(const builtin_interfaces::msg::Time& stamp)
      : nanoseconds_(std::int64_t{stamp.sec} * 1000000000 + stamp.nanosec) {}
  double seconds() const { return 1e-9 * static_cast<double>(nanoseconds_); }
  Time operator+(const Duration& duration) const {
    return Time(nanoseconds_ + duration.nanoseconds());
  }
  operator builtin_interfaces::msg::Time() const {
    return {.sec = static_cast<std::int32_t>(nanoseconds_ / 1000000000),
            .nanosec = static_cast<std::uint32_t>(nanoseconds_ % 1000000000)};
  }

 private:
  std::int64_t nanoseconds_;
};
class Logger {};
class Clock {};
class QoS {
 public:
  QoS(std::size_t /*depth*/ = 10) {}
  QoS& transient_local() { return *this; }
};
class SensorDataQoS : public QoS {};
namespace node_interfaces {
using Changes = std::vector<Parameter>;
struct NodeParametersInterface {
  using SharedPtr = std::shared_ptr<NodeParametersInterface>;
  const std::map<std::string, ParameterValue>& get_parameter_overrides() const { return overrides; }
  std::map<std::string, ParameterValue> overrides;
};
struct OnSetParametersCallbackHandle {
  using SharedPtr = std::shared_ptr<OnSetParametersCallbackHandle>;
  std::function<rcl_interfaces::msg::SetParametersResult(const Changes&)> callback;
};
}  // namespace node_interfaces
}  // namespace rclcpp

#define RCLCPP_WARN_THROTTLE(logger, clock, milliseconds, ...) \
  ros2_double::log(logger, clock, milliseconds, __VA_ARGS__)
#define RCLCPP_ERROR_THROTTLE(logger, clock, milliseconds, ...) \
  ros2_double::log(logger, clock, milliseconds, __VA_ARGS__)
namespace ros2_double {
inline void log(const rclcpp::Logger&, rclcpp::Clock&, int, const char*, const char*) {}
}  // namespace ros2_double

namespace rclcpp_lifecycle {
class LifecycleNode {
 public:
  using WeakPtr = std::weak_ptr<LifecycleNode>;
  bool has_parameter(const std::string& name) const {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return parameters_.count(name) > 0;
  }
  const rclcpp::ParameterValue& declare_parameter(
      const std::string& name,
      const rclcpp::ParameterValue& value,
      const rcl_interfaces::msg::ParameterDescriptor& descriptor = {},
      bool ignore_override = false) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    if (has_parameter(name)) throw std::runtime_error("already declared: " + name);
    const auto given = interface_->overrides.find(name);
    const bool overridden = !ignore_override && given != interface_->overrides.end();
    if (overridden && given->second.get_type() != value.get_type()) {
      throw std::runtime_error("another type: " + name);
    }
    read_only_[name] = descriptor.read_only;
    return parameters_[name] = overridden ? given->second : value;
  }
  rclcpp::node_interfaces::NodeParametersInterface::SharedPtr get_node_parameters_interface() {
    return interface_;
  }
  rclcpp::Parameter get_parameter(const std::string& name) const {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) throw std::runtime_error("not declared: " + name);
    return {name, found->second};
  }
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(
      std::function<rcl_interfaces::msg::SetParametersResult(const std::vector<rclcpp::Parameter>&)>
          callback) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    auto handle = std::make_shared<rclcpp::node_interfaces::OnSetParametersCallbackHandle>();
    handle->callback = std::move(callback);
    callbacks_.push_back(handle);
    return handle;
  }
  rclcpp::Logger get_logger() const { return {}; }
  std::shared_ptr<rclcpp::Clock> get_clock() { return clock_; }
  rclcpp::Time now() const {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    return time_;
  }

  // For tests only.
  void set_time(double seconds) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    time_ = rclcpp::Time(std::llround(seconds * 1e9));
  }
  // As a node does: asks the callbacks, then stores; all values or none.
  rcl_interfaces::msg::SetParametersResult set_parameters(
      const std::vector<rclcpp::Parameter>& changes) {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    for (const rclcpp::Parameter& change : changes) {
      const std::string& name = change.get_name();
      if (!has_parameter(name)) return {.successful = false, .reason = "not declared"};
      if (read_only_[name]) return {.successful = false, .reason = "read-only"};
      if (parameters_[name].get_type() != change.get_parameter_value().get_type()) {
        return {.successful = false, .reason = "another type"};
      }
    }
    for (const auto& weak : callbacks_) {
      const auto handle = weak.lock();
      const auto result =
          handle ? handle->callback(changes) : rcl_interfaces::msg::SetParametersResult{true, ""};
      if (!result.successful) return result;
    }
    for (const rclcpp::Parameter& change : changes)
      parameters_[change.get_name()] = change.get_parameter_value();
    return {.successful = true, .reason = ""};
  }
  void subscribe(const std::string& topic, std::weak_ptr<std::any> subscription) {
    subscriptions_[topic].push_back(std::move(subscription));
  }
  template <typename Message>
  int publish(const std::string& topic, const Message& message) {
    int received = 0;
    for (const auto& weak : subscriptions_[topic]) {
      const auto subscription = weak.lock();
      if (!subscription) continue;
      std::any_cast<const std::function<void(const Message&)>&> (*subscription)(message);
      ++received;
    }
    return received;
  }
  std::map<std::string, std::any> published;  // the last message of each topic

 private:
  mutable std::recursive_mutex mutex_;
  std::map<std::string, rclcpp::ParameterValue> parameters_;
  std::map<std::string, bool> read_only_;
  std::vector<std::weak_ptr<rclcpp::node_interfaces::OnSetParametersCallbackHandle>> callbacks_;
  std::shared_ptr<rclcpp::node_interfaces::NodeParametersInterface> interface_ =
      std::make_shared<rclcpp::node_interfaces::NodeParametersInterface>();
  std::shared_ptr<rclcpp::Clock> clock_ = std::make_shared<rclcpp::Clock>();
  rclcpp::Time time_;
  std::map<std::string, std::vector<std::weak_ptr<std::any>>> subscriptions_;
};
}  // namespace rclcpp_lifecycle

namespace rclcpp {
template <typename Message, typename Node, typename Callback>
std::shared_ptr<std::any> create_subscription(Node& node,
                                              const std::string& topic,
                                              const QoS& /*qos*/,
                                              Callback&& callback) {
  auto subscription =
      std::make_shared<std::any>(std::function<void(const Message&)>(std::move(callback)));
  node->subscribe(topic, subscription);
  return subscription;
}
template <typename Message>
class Publisher {
 public:
  using SharedPtr = std::shared_ptr<Publisher>;
  Publisher(std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node, std::string topic)
      : node_(std::move(node)),
        topic_(std::move(topic)) {}
  void publish(const Message& message) { node_->published[topic_] = message; }
  std::size_t get_subscription_count() const { return 1; }

 private:
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node_;
  std::string topic_;
};
template <typename Message, typename Node>
std::shared_ptr<Publisher<Message>> create_publisher(Node& node,
                                                     const std::string& topic,
                                                     const QoS& /*qos*/) {
  return std::make_shared<Publisher<Message>>(node, topic);
}
}  // namespace rclcpp
