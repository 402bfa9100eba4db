// SPDX-License-Identifier: Apache-2.0
#include "setting_attributes.hpp"

#include <string>

#include "fairway/io/yaml/setting_text.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "numbers.hpp"
#include "results.hpp"

namespace fairway::python {

namespace {

template <typename Value>
py::object setting_value(const Value& value) {
  if constexpr (std::same_as<Value, BodyDiscs>) {
    py::array_t<double> table = new_table(static_cast<std::size_t>(value.count), 3);
    double* out = table.mutable_data();
    for (int i = 0; i < value.count; ++i) {
      const Footprint::Disc& disc = value.discs[static_cast<std::size_t>(i)];
      *out++ = disc.center.x();
      *out++ = disc.center.y();
      *out++ = disc.radius;
    }
    return table;
  } else if constexpr (io::NamedEnumeration<Value>) {
    return py::str(io::value_text(value));
  } else {
    return py::cast(value);
  }
}

// The value as text for a file. Python's numbers have the shortest text that is read back exactly.
std::string text_of(py::handle value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::hasattr(value, "tolist")) return text_of(value.attr("tolist")());  // of NumPy
  return py::repr(value).cast<std::string>();
}

py::object value_of_setting(const Settings& settings,
                            const std::string& group,
                            const std::string& name) {
  py::object found;
  visit_settings(settings, [&](const char* group_name, auto&& visit_fields) {
    if (group != group_name) return;
    visit_fields([&](const auto& value, const SettingInfo& info) {
      if (name == info.name) found = setting_value(value);
    });
  });
  return found;
}

py::object setting_property(const std::string& group,
                            const std::string& name,
                            const std::string& doc) {
  const py::cpp_function get([group, name](const py::object& self) {
    return value_of_setting(self.attr("_settings").cast<const Settings&>(), group, name);
  });
  const py::cpp_function set([group, name](const py::object& self, const py::object& value) {
    const std::string assignment = group + "." + name + "=" + text_of(value);
    value_of(io::assign_setting(self.attr("_settings").cast<Settings&>(), assignment));
  });
  return py::module_::import("builtins").attr("property")(get, set, py::none(), doc);
}

// "robot" becomes "RobotSettings", as the struct in C++.
std::string class_name(std::string group) {
  group.front() = static_cast<char>(group.front() - 'a' + 'A');
  return group + "Settings";
}

}  // namespace

void add_setting_attributes(py::module_& module, py::class_<Settings>& settings) {
  const py::object type = py::module_::import("builtins").attr("type");
  const Settings defaults;
  visit_settings(defaults, [&](const char* group, auto&& visit_fields) {
    py::dict members;
    visit_fields([&](const auto& value, const SettingInfo& info) {
      using Value = std::remove_cvref_t<decltype(value)>;
      std::string doc = std::string(info.meaning) + " (" + io::expected_text<Value>(info) +
                        "; default " + io::value_text(value) + ")";
      if (*info.unit != '\0') doc = "[" + std::string(info.unit) + "] " + doc;
      members[info.name] = setting_property(group, info.name, doc);
    });
    members["__slots__"] = py::make_tuple("_settings");
    members["__module__"] = module.attr("__name__");
    members["__doc__"] = "Settings of the group `" + std::string(group) + "`.";
    const py::object made = type(class_name(group), py::make_tuple(), members);
    module.attr(class_name(group).c_str()) = made;
    settings.attr(group) = py::module_::import("builtins")
                               .attr("property")(py::cpp_function([made](const py::object& self) {
                                                   py::object view = made();
                                                   py::setattr(view, "_settings", self);
                                                   return view;
                                                 }),
                                                 py::none(), py::none(), made.attr("__doc__"));
  });
}

}  // namespace fairway::python
