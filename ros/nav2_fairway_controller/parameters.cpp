// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/parameters.hpp"

#include <cstdint>
#include <exception>
#include <utility>

#include "fairway/navigation/settings.hpp"
#include "nav2_fairway_controller/following/speed_limit.hpp"

namespace fairway::nav2 {

namespace {

constexpr const char* kFrequency = "controller_frequency";

// Returns the value, or none for the types that no setting has.
std::optional<SettingValue> value_of(const rclcpp::ParameterValue& value) {
  const rclcpp::ParameterType type = value.get_type();
  if (type == rclcpp::ParameterType::PARAMETER_BOOL) return value.get<bool>();
  if (type == rclcpp::ParameterType::PARAMETER_DOUBLE) return value.get<double>();
  if (type == rclcpp::ParameterType::PARAMETER_STRING) return value.get<std::string>();
  if (type != rclcpp::ParameterType::PARAMETER_INTEGER) return std::nullopt;
  return SettingValue(std::int64_t{value.get<std::int64_t>()});
}

rcl_interfaces::msg::ParameterDescriptor describe(const SettingDeclaration& setting) {
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = setting.meaning;
  if (!setting.least || !setting.greatest) return descriptor;
  if (std::holds_alternative<std::int64_t>(setting.value)) {
    descriptor.integer_range.resize(1);
    descriptor.integer_range[0].from_value = static_cast<std::int64_t>(*setting.least);
    descriptor.integer_range[0].to_value = static_cast<std::int64_t>(*setting.greatest);
  } else if (std::holds_alternative<double>(setting.value)) {
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].from_value = *setting.least;
    descriptor.floating_point_range[0].to_value = *setting.greatest;
  }
  return descriptor;
}

FollowerSettings defaults_at(const std::optional<double>& frequency) {
  FollowerSettings defaults;
  if (frequency) defaults.robot.navigation.control_period = period_of(*frequency);
  return defaults;
}

rcl_interfaces::msg::ParameterDescriptor fixed(const std::string& meaning) {
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = meaning;
  descriptor.read_only = true;
  return descriptor;
}

}  // namespace

Parameters::Parameters(std::shared_ptr<LifecycleNode> node,
                       const std::string& plugin,
                       const std::optional<double>& frequency)
    : node_(std::move(node)),
      prefix_(plugin + "."),
      frequency_(frequency),
      store_(defaults_at(frequency), frequency.has_value()) {
  // The values of parameter files are read before the declaration. So a whole number may be given
  // for a real one.
  const auto& given = node_->get_node_parameters_interface()->get_parameter_overrides();
  std::vector<SettingChange> changes;
  const auto add = [&](const std::string& name, const rclcpp::ParameterValue& value) {
    if (auto read = value_of(value)) changes.push_back({.name = name, .value = *std::move(read)});
  };
  for (const RenamedSetting& renamed : kRenamedSettings) {
    const auto found = given.find(prefix_ + std::string(renamed.old_name));
    if (found != given.end()) add(std::string(renamed.name), found->second);
  }
  const std::vector<SettingDeclaration> settings = store_.declarations();
  for (const SettingDeclaration& setting : settings) {
    const std::string name = prefix_ + setting.name;
    if (node_->has_parameter(name)) {
      add(setting.name, node_->get_parameter(name).get_parameter_value());
    } else if (const auto found = given.find(name); found != given.end()) {
      add(setting.name, found->second);
    }
  }
  std::string fault = store_.set(changes);
  if (fault.empty() && frequency_) {
    fault = frequency_fault(store_.settings().robot.navigation.control_period, *frequency_);
  }
  if (!fault.empty()) throw ControllerSetupError(prefix_ + fault);
  for (const SettingDeclaration& setting : store_.declarations()) {
    const std::string name = prefix_ + setting.name;
    if (node_->has_parameter(name)) continue;
    const auto declare = [&](const auto& value) {
      node_->declare_parameter(name, rclcpp::ParameterValue(value), describe(setting), true);
    };
    std::visit(declare, setting.value);
  }
  callback_ = node_->add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& parameters) {
        rcl_interfaces::msg::SetParametersResult result;
        result.reason = fault_of(parameters);
        result.successful = result.reason.empty();
        return result;
      });
}

// Returns why the node must not store these values, or an empty text. Does not throw.
std::string Parameters::fault_of(const std::vector<rclcpp::Parameter>& parameters) {
  try {
    std::vector<SettingChange> changes;
    double period = store_.settings().robot.navigation.control_period;
    for (const rclcpp::Parameter& parameter : parameters) {
      const std::string& name = parameter.get_name();
      const auto value = value_of(parameter.get_parameter_value());
      if (frequency_ && name == kFrequency) {
        return std::string(kFrequency) + ": expected no change while " + prefix_ +
               "navigation.control_period depends on it; configure the server again";
      }
      if (!name.starts_with(prefix_)) continue;
      if (!value) continue;
      changes.push_back({.name = name.substr(prefix_.size()), .value = *value});
      const double* number = std::get_if<double>(&*value);
      if (number != nullptr && changes.back().name == "navigation.control_period") period = *number;
    }
    if (changes.empty()) return {};
    std::string fault = frequency_ ? frequency_fault(period, *frequency_) : std::string();
    if (fault.empty()) fault = store_.propose(changes, node_->now().seconds());
    return fault.empty() ? fault : prefix_ + fault;
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::optional<FollowerSettings> Parameters::take_change() {
  return store_.take_change(node_->now().seconds(), [this](const std::string& name) {
    return value_of(node_->get_parameter(prefix_ + name).get_parameter_value());
  });
}

std::string read_text(LifecycleNode& node,
                      const std::string& name,
                      const std::string& otherwise,
                      const std::string& meaning) {
  if (!node.has_parameter(name)) {
    node.declare_parameter(name, rclcpp::ParameterValue(otherwise), fixed(meaning));
  }
  return node.get_parameter(name).as_string();
}

bool read_switch(LifecycleNode& node,
                 const std::string& name,
                 bool otherwise,
                 const std::string& meaning) {
  if (!node.has_parameter(name)) {
    node.declare_parameter(name, rclcpp::ParameterValue(otherwise), fixed(meaning));
  }
  return node.get_parameter(name).as_bool();
}

}  // namespace fairway::nav2
