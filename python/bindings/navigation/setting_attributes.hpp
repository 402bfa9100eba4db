// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "bindings.hpp"
#include "fairway/navigation/settings.hpp"

namespace fairway::python {

/// Adds one attribute per group to the class of the settings, for example `settings.robot`. A group
/// has one attribute per setting; assigning to it checks type and range.
///
/// The classes come from the table of all settings (`visit_settings`), so a new setting needs no
/// line here.
void add_setting_attributes(py::module_& module, py::class_<Settings>& settings);

}  // namespace fairway::python
