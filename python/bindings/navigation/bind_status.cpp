// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>

#include "bindings.hpp"
#include "fairway/navigation/explanation/status_guide.hpp"
#include "fairway/navigation/explanation/status_label.hpp"

namespace fairway::python {

namespace {

constexpr std::array kStatusNames = {"Ok",       "Degraded", "Stopping",   "Blocked", "Recovering",
                                     "Stale",    "BadInput", "Infeasible", "NoPlan",  "GoalReached",
                                     "Planning", "GaveUp",   "Holding"};
constexpr std::array kLimitNames = {
    "None_",         "Speed",           "Acceleration", "Corridor",     "MovingObstacle",
    "StopNotProven", "OutsideCorridor", "StalePose",    "StaleMap",     "StaleTracks",
    "InvalidPose",   "InvalidTracks",   "PoseJump",     "SolverFailed", "NoPath",
    "InvalidGoal",   "InvalidTime",     "SmallerPlan",  "InvalidScan",  "LateCycle",
    "KeepOutZone",   "Strip",           "SpeedZone",    "OneWayZone",   "Hold"};

// A value that is not listed yet gets a name from its text: "goal reached" becomes GoalReached.
std::string name_from(const char* text) {
  std::string name;
  bool begins = true;
  for (const char* c = text; *c != '\0'; ++c) {
    if (*c != ' ')
      name += static_cast<char>(begins && *c >= 'a' && *c <= 'z' ? *c - 'a' + 'A' : *c);
    begins = *c == ' ';
  }
  return name;
}

template <typename Status, std::size_t kNames>
void bind_guided_status(py::module_& module,
                        const char* type,
                        const char* doc,
                        const std::array<const char*, kNames>& names,
                        std::size_t count) {
  py::enum_<Status> values(module, type, doc);
  for (std::size_t i = 0; i < count; ++i) {
    const auto status = static_cast<Status>(i);
    const std::string name = i < kNames ? names[i] : name_from(to_text(status));
    values.value(name.c_str(), status, guide_of(status).meaning);
  }
  values
      .def_property_readonly(
          "text", [](Status status) { return to_text(status); }, "As files of the tool write it.")
      .def_property_readonly(
          "label", [](Status status) { return label_of(status); },
          "For people, as the tool and pages show it.")
      .def_property_readonly(
          "meaning", [](Status status) { return guide_of(status).meaning; },
          "What the robot does, or what limits it.")
      .def_property_readonly(
          "causes", [](Status status) { return guide_of(status).causes; }, "Usual causes.")
      .def_property_readonly(
          "remedy", [](Status status) { return guide_of(status).remedy; },
          "What to do; empty if nothing is wrong.");
}

}  // namespace

void bind_status(py::module_& module) {
  bind_guided_status<NavigationStatus>(module, "NavigationStatus",
                                       "State of the navigator in a cycle.", kStatusNames,
                                       kNavigationStatuses);
  bind_guided_status<LimitingFactor>(module, "LimitingFactor",
                                     "The reason why a robot is slow, turns or stops in a cycle.",
                                     kLimitNames, kLimitingFactors);
}

}  // namespace fairway::python
