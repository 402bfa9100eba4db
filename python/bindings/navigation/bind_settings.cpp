// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>

#include <pybind11/stl/filesystem.h>

#include "bindings.hpp"
#include "fairway/io/yaml/settings_file.hpp"
#include "navigation/setting_attributes.hpp"
#include "results.hpp"

namespace fairway::python {

namespace {

Settings settings_of_preset(const std::string& name) {
  const std::optional<Settings> settings = io::preset_settings(name);
  if (!settings) throw py::value_error("preset: expected default or paper, found '" + name + "'");
  return *settings;
}

Settings read_settings_file(const std::filesystem::path& path) {
  std::vector<std::string> warnings;
  Settings settings = value_of(io::read_settings(path.string(), {}, &warnings));
  warn(warnings);
  return settings;
}

Settings parse_settings_text(const std::string& text) {
  std::vector<std::string> warnings;
  Settings settings = value_of(io::parse_settings(text, "settings", {}, &warnings));
  warn(warnings);
  return settings;
}

void assign_text(Settings& settings, const std::string& assignment) {
  std::vector<std::string> warnings;
  value_of(io::assign_setting(settings, assignment, &warnings));
  warn(warnings);
}

std::string yaml_text(const Settings& settings, bool essential) {
  return io::settings_yaml(settings,
                           essential ? io::SettingsChoice::Essential : io::SettingsChoice::All);
}

py::dict changed_settings(const Settings& settings) {
  py::dict changed;
  for (const io::SettingDifference& d : io::setting_differences(settings))
    changed[d.name.c_str()] = d.value;
  return changed;
}

}  // namespace

void bind_settings(py::module_& module) {
  py::class_<Settings> type(module, "Settings",
                            "All settings of Fairway, by groups: `settings.robot.radius = 0.3`. "
                            "An assignment checks type and range.");
  add_setting_attributes(module, type);
  type.def(py::init(&settings_of_preset), py::arg("preset") = "default",
           "Makes the default settings, or those of a preset: default or paper.")
      .def_static("read", &read_settings_file, py::arg("path"), "Reads a settings file.")
      .def_static("parse", &parse_settings_text, py::arg("text"),
                  "Parses the text of a settings file.")
      .def("assign", &assign_text, py::arg("assignment"),
           "Applies `group.name=value`, as `--set` of the tool does.")
      .def(
          "validate", [](const Settings& settings) { value_of(validate(settings)); },
          "Checks all ranges and the consistency of the groups; raises a ValueError.")
      .def("yaml", &yaml_text, py::arg("essential") = false,
           "Returns the settings as a file that `read` takes; a comment explains each.")
      .def("changed", &changed_settings,
           "Returns the settings that differ from the defaults: name to value, as in files.")
      .def(
          "copy", [](const Settings& settings) { return settings; }, "Returns a copy.")
      .def("__copy__", [](const Settings& settings) { return settings; })
      .def(
          "__deepcopy__",
          [](const Settings& settings, const py::dict& /*memo*/) { return settings; },
          py::arg("memo"))
      .def("__eq__",
           [](const Settings& a, const py::object& b) {
             return py::isinstance<Settings>(b) &&
                    io::setting_differences(a, b.cast<const Settings&>()).empty();
           })
      .def("__repr__",
           [](const Settings& settings) {
             return py::str("<Settings, changed: {}>").format(changed_settings(settings));
           })
      .def(py::pickle([](const Settings& settings) { return yaml_text(settings, false); },
                      &parse_settings_text));
  type.attr("__hash__") = py::none();
}

}  // namespace fairway::python
