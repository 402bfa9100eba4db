// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include "bindings.hpp"
#include "fairway/simulation/episode.hpp"

namespace fairway::python {

/// Runs a scenario without the GIL, with callbacks of Python, and writes recording and page.
[[nodiscard]] EpisodeResult run_scenario(const Scenario& scenario,
                                         const py::object& on_cycle,
                                         const py::object& on_plan,
                                         const py::object& on_step,
                                         const py::object& play,
                                         const std::optional<std::filesystem::path>& log,
                                         const std::optional<std::filesystem::path>& report);

}  // namespace fairway::python
