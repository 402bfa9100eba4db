// SPDX-License-Identifier: Apache-2.0
#include "nav2_fairway_controller/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "fairway/navigation/renamed_settings.hpp"

namespace fairway::nav2 {

namespace {

template <typename Value>
constexpr bool kIsPlain =
    std::is_same_v<Value, bool> || std::is_same_v<Value, int> || std::is_same_v<Value, double>;

template <typename Value>
rclcpp::ParameterValue stored(const Value& value) {
  if constexpr (kIsPlain<Value>) {
    return rclcpp::ParameterValue(value);
  } else if constexpr (std::is_same_v<Value, BodyDiscs>) {
    return rclcpp::ParameterValue(to_text(value));
  } else {
    return rclcpp::ParameterValue(
        std::string(setting_names(value)[static_cast<std::size_t>(value)]));
  }
}

template <typename Value>
rcl_interfaces::msg::ParameterDescriptor describe(const SettingInfo& info) {
  rcl_interfaces::msg::ParameterDescriptor descriptor;
  descriptor.description = info.meaning;
  if (*info.unit != '\0') descriptor.description += std::string(" [") + info.unit + "]";
  if (!std::isfinite(info.min) || !std::isfinite(info.max)) return descriptor;
  if constexpr (std::is_same_v<Value, int>) {
    descriptor.integer_range.resize(1);
    descriptor.integer_range[0].from_value = static_cast<std::int64_t>(info.min);
    descriptor.integer_range[0].to_value = static_cast<std::int64_t>(info.max);
  } else if constexpr (std::is_same_v<Value, double>) {
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].from_value = info.min;
    descriptor.floating_point_range[0].to_value = info.max;
  }
  return descriptor;
}

// Copies a parameter to a setting; returns the expectation after an error, else an empty text.
template <typename Value>
std::string assign(const rclcpp::Parameter& parameter, const SettingInfo& info, Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    value = parameter.as_bool();
  } else if constexpr (kIsPlain<Value>) {
    const double number = std::is_same_v<Value, int> ? static_cast<double>(parameter.as_int())
                                                     : parameter.as_double();
    if (!(number >= info.min && number <= info.max)) {
      return "expected a number from " + std::to_string(info.min) + " to " +
             std::to_string(info.max);
    }
    value = static_cast<Value>(number);
  } else if constexpr (std::is_same_v<Value, BodyDiscs>) {
    const auto parsed = parse_body_discs(parameter.as_string());
    if (!parsed) return std::string("expected ") + kBodyDiscsExpected;
    value = *parsed;
  } else {
    const auto names = setting_names(value);
    const auto found = std::find(names.begin(), names.end(), parameter.as_string());
    if (found == names.end()) return "expected one of the names that its documentation lists";
    value = static_cast<Value>(found - names.begin());
  }
  return {};
}

// Reads the value that a parameter file gives under the old name of a setting; it becomes the
// default of the new name. Old names work until 1.0.
template <typename Node>
void read_renamed(Node& node, const std::string& prefix, Settings& settings) {
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](auto& value, const SettingInfo& info) {
      using Value = std::remove_cv_t<std::remove_reference_t<decltype(value)>>;
      const std::string name = std::string(group) + "." + info.name;
      for (const RenamedSetting& renamed : kRenamedSettings) {
        if (renamed.name != name) continue;
        const std::string old_name = prefix + std::string(renamed.old_name);
        if (!node.has_parameter(old_name)) {
          node.declare_parameter(old_name, stored(value), describe<Value>(info));
        }
        const std::string fault = assign(node.get_parameter(old_name), info, value);
        if (!fault.empty()) throw ControllerSetupError(old_name + ": " + fault);
      }
    });
  });
}

}  // namespace

Parameters::Parameters(std::shared_ptr<LifecycleNode> node, std::string plugin)
    : prefix_(std::move(plugin) + ".") {
  std::vector<rclcpp::Parameter> given;
  Settings defaults = settings_;
  read_renamed(*node, prefix_, defaults);
  visit_settings(defaults, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cv_t<std::remove_reference_t<decltype(value)>>;
      const std::string name = prefix_ + group + "." + info.name;
      if (!node->has_parameter(name)) {
        node->declare_parameter(name, stored(value), describe<Value>(info));
      }
      given.push_back(node->get_parameter(name));
    });
  });
  const auto result = on_change(given);
  if (!result.successful) throw ControllerSetupError(result.reason);
  changed_ = false;
  callback_ = node->add_on_set_parameters_callback(
      [this](const std::vector<rclcpp::Parameter>& changes) { return on_change(changes); });
}

Settings Parameters::settings() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return settings_;
}

std::optional<Settings> Parameters::take_change() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(changed_, false) ? std::optional(settings_) : std::nullopt;
}

rcl_interfaces::msg::SetParametersResult Parameters::on_change(
    const std::vector<rclcpp::Parameter>& changes) {
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  const std::lock_guard<std::mutex> lock(mutex_);
  Settings wanted = settings_;
  visit_settings(wanted, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](auto& value, const SettingInfo& info) {
      const std::string name = prefix_ + group + "." + info.name;
      for (const rclcpp::Parameter& change : changes) {
        if (change.get_name() != name || !result.successful) continue;
        const std::string fault = assign(change, info, value);
        result.successful = fault.empty();
        if (!fault.empty()) result.reason = name + ": " + fault;
      }
    });
  });
  if (!result.successful) return result;
  if (const auto valid = validate(wanted); !valid) {
    result.successful = false;
    result.reason = prefix_ + valid.error().message;
    return result;
  }
  settings_ = wanted;
  changed_ = true;
  return result;
}

}  // namespace fairway::nav2
