// SPDX-License-Identifier: Apache-2.0
#include "fairway_ros/setting_parameters.hpp"

#include <dynamic_reconfigure/ConfigDescription.h>

#include "bridge/polygon_text.hpp"
#include "fairway/io/scenario/robot_model_file.hpp"
#include "fairway/io/scenario/zones_file.hpp"
#include "fairway/io/yaml/setting_text.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::ros1 {

namespace {

using dynamic_reconfigure::Config;
using XmlRpc::XmlRpcValue;

// Formats a parameter as in a settings file.
std::string text_of(const XmlRpcValue& value) {
  XmlRpcValue copy = value;  // its conversions are not const
  switch (copy.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(copy) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(copy));
    case XmlRpcValue::TypeDouble:
      return io::number_text(static_cast<double>(copy));
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(copy);
    case XmlRpcValue::TypeArray: {
      std::string list = "[";
      for (int i = 0; i < copy.size(); ++i)
        list.append(i == 0 ? "" : ", ").append(text_of(copy[i]));
      return list.append("]");
    }
    case XmlRpcValue::TypeInvalid:
    case XmlRpcValue::TypeDateTime:
    case XmlRpcValue::TypeBase64:
    case XmlRpcValue::TypeStruct:
      break;
  }
  return "a mapping";
}

Expected<void> assign_group(XmlRpcValue& group, const std::string& name, Settings& settings) {
  for (auto& [key, value] : group) {
    std::string assignment = name;
    assignment += "." + key + "=" + text_of(value);
    if (Expected<void> done = io::assign_setting(settings, assignment); !done) return done;
  }
  return {};
}

Expected<void> assign_option(const std::string& key,
                             const XmlRpcValue& value,
                             NodeOptions& options) {
  const std::string text = text_of(value);
  const auto expected = [&](const char* what) {
    return fail(key + ": expected " + what + ", found " + text);
  };
  for (const auto& [name, flag] : {std::pair{"use_map", &options.pilot.use_map},
                                   std::pair{"use_scan", &options.pilot.use_scan},
                                   std::pair{"use_monitor", &options.pilot.use_monitor},
                                   std::pair{"cancel_with_client", &options.cancel_with_client}}) {
    if (key != name) continue;
    if (text != "true" && text != "false") return expected("true or false");
    *flag = text == "true";
    return {};
  }
  for (const auto& [name, number] :
       {std::pair{"patience", &options.pilot.patience},
        std::pair{"localisation_timeout", &options.pilot.localisation_timeout}}) {
    if (key != name) continue;
    const auto parsed = io::parse_value<double>(text, SettingInfo{name, "s", "", 0.001, 1e6});
    if (!parsed) return expected("a number from 0.001 to 1000000");
    *number = *parsed;
    return {};
  }
  for (const auto& [name, frame] :
       {std::pair{"map_frame", &options.map_frame}, std::pair{"base_frame", &options.base_frame}}) {
    if (key != name) continue;
    if (text.empty() || text.front() == '/') return expected("a frame without a leading slash");
    *frame = text;
    return {};
  }
  for (const auto& [name, polygon] :
       {std::pair{"monitor_stop_zone", &options.pilot.monitor_stop_zone},
        std::pair{"monitor_slow_zone", &options.pilot.monitor_slow_zone}}) {
    if (key != name) continue;
    Expected<Polygon> given = bridge::polygon_of(key, text);
    if (!given) return tl::unexpected(given.error());
    *polygon = *std::move(given);
    return {};
  }
  if (key == "monitor_slow_speed") {
    const auto speed = io::parse_value<double>(text, SettingInfo{"", "m/s", "", 0.01, 10.0});
    if (!speed) return expected("a number from 0.01 to 10");
    options.pilot.monitor_slow_speed = *speed;
    return {};
  }
  if (key == "zones") {
    if (text.empty()) return {};
    Expected<Zones> zones = io::read_zones_file(text);
    if (!zones) return tl::unexpected(zones.error());
    options.pilot.zones = *std::move(zones);
    return {};
  }
  if (key == "body") {
    if (text.empty()) return {};
    const Expected<RobotModel> body = io::read_robot_model(text);
    if (!body) return tl::unexpected(body.error());
    options.pilot.body = *body;
    return {};
  }
  return fail(key +
              ": expected a group of settings, or one of preset, use_map, use_scan, use_monitor, "
              "patience, localisation_timeout, map_frame, base_frame, cancel_with_client, zones, "
              "body, monitor_stop_zone, monitor_slow_zone, monitor_slow_speed, found an "
              "unknown parameter");
}

Config config_of(const Settings& settings) {
  Config config;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      const auto add = [&](auto& list, const auto& stored) {
        list.emplace_back();
        list.back().name = std::string(group) + "." + info.name;
        list.back().value = stored;
      };
      if constexpr (std::same_as<Value, bool>) {
        add(config.bools, value);
      } else if constexpr (std::same_as<Value, int>) {
        add(config.ints, value);
      } else if constexpr (std::same_as<Value, double>) {
        add(config.doubles, value);
      } else {
        add(config.strs, io::value_text(value));
      }
    });
  });
  config.groups.emplace_back();
  config.groups.back().name = "Default";
  config.groups.back().state = 1;
  return config;
}

// Moves every number to its lower (or upper) limit.
Settings at_limits(bool greatest) {
  Settings limits;
  visit_settings(limits, [&](const char* /*group*/, auto&& visit_fields) {
    visit_fields([&](auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      const double limit = greatest ? info.max : info.min;
      if constexpr (std::same_as<Value, bool>) {
        value = greatest;
      } else if constexpr (std::same_as<Value, int>) {
        value = static_cast<int>(std::clamp(limit, -2147483647.0, 2147483647.0));
      } else if constexpr (std::same_as<Value, double>) {
        value = limit;
      }
    });
  });
  return limits;
}

template <typename Value>
std::string choices_of() {
  std::string list;
  if constexpr (io::NamedEnumeration<Value>) {
    for (const char* name : setting_names(Value{})) {
      const std::string quoted = std::string("'") + name + "'";
      list += list.empty() ? "" : ", ";
      list += "{'name': " + quoted + ", 'type': 'str', 'value': " + quoted + ", 'description': ''}";
    }
    list = "{'enum_description': '', 'enum': [" + list + "]}";
  }
  return list;
}

dynamic_reconfigure::ConfigDescription description() {
  dynamic_reconfigure::ConfigDescription all;
  all.groups.emplace_back();
  all.groups.back().name = "Default";
  const Settings settings;
  visit_settings(settings, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      dynamic_reconfigure::ParamDescription parameter;
      parameter.name = std::string(group) + "." + info.name;
      parameter.type = std::same_as<Value, bool>     ? "bool"
                       : std::same_as<Value, int>    ? "int"
                       : std::same_as<Value, double> ? "double"
                                                     : "str";
      parameter.description = *info.unit == '\0'
                                  ? std::string(info.meaning)
                                  : std::string(info.meaning) + " [" + info.unit + "]";
      parameter.edit_method = choices_of<Value>();
      all.groups.back().parameters.push_back(parameter);
    });
  });
  all.dflt = config_of(settings);
  all.min = config_of(at_limits(false));
  all.max = config_of(at_limits(true));
  return all;
}

}  // namespace

Expected<void> read_parameters(const ros::NodeHandle& node,
                               NodeOptions& options,
                               Settings& settings) {
  XmlRpcValue all;
  if (!node.getParam(node.getNamespace(), all) || all.getType() != XmlRpcValue::TypeStruct) {
    return {};
  }
  if (all.hasMember("preset")) {
    const std::string name = text_of(all["preset"]);
    const auto preset = io::preset_settings(name);
    if (!preset) return fail("preset: expected default or paper, found " + name);
    settings = *preset;
  }
  for (auto& [key, value] : all) {
    if (key == "preset") continue;
    const Expected<void> done = value.getType() == XmlRpcValue::TypeStruct
                                    ? assign_group(value, key, settings)
                                    : assign_option(key, value, options);
    if (!done) return done;
  }
  if (Expected<void> valid = validate(settings); !valid) return valid;
  return bridge::validate(options.pilot);
}

SettingParameters::SettingParameters(ros::NodeHandle node,
                                     const Settings& settings,
                                     std::function<void(const Settings&)> changed)
    : node_(std::move(node)),
      settings_(settings),
      changed_(std::move(changed)),
      descriptions_(node_.advertise<dynamic_reconfigure::ConfigDescription>(
          "parameter_descriptions", 1, true)),
      updates_(node_.advertise<Config>("parameter_updates", 1, true)),
      service_(node_.advertiseService("set_parameters", &SettingParameters::reconfigure, this)) {
  descriptions_.publish(description());
  updates_.publish(config_of(settings_));
  store();
}

bool SettingParameters::reconfigure(dynamic_reconfigure::Reconfigure::Request& request,
                                    dynamic_reconfigure::Reconfigure::Response& response) {
  Settings wanted = settings_;
  Expected<void> good;
  const auto assign = [&](const std::string& name, const std::string& text) {
    if (good) good = io::assign_setting(wanted, name + "=" + text);
  };
  for (const auto& p : request.config.bools)
    assign(p.name, p.value != 0 ? "true" : "false");
  for (const auto& p : request.config.ints)
    assign(p.name, std::to_string(p.value));
  for (const auto& p : request.config.doubles)
    assign(p.name, io::number_text(p.value));
  for (const auto& p : request.config.strs)
    assign(p.name, p.value);
  if (good) good = validate(wanted);
  if (good) {
    settings_ = wanted;
    changed_(settings_);
    store();
    updates_.publish(config_of(settings_));
  } else {
    ROS_ERROR("%s; nothing was changed", good.error().message.c_str());
  }
  response.config = config_of(settings_);
  return good.has_value();
}

// Stored on the parameter server, so that `rosparam dump` shows the active values.
void SettingParameters::store() const {
  XmlRpcValue all;
  visit_settings(settings_, [&](const char* group, auto&& visit_fields) {
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_arithmetic_v<Value>) {
        all[group][info.name] = value;
      } else {
        all[group][info.name] = io::value_text(value);
      }
    });
  });
  for (auto& [group, values] : all)
    node_.setParam(group, values);
}

}  // namespace fairway::ros1
