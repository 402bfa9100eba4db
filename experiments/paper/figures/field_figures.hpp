// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "experiments/paper/chapter.hpp"
#include "experiments/paper/tables/field_tables.hpp"

namespace fairway::reproduction {

/// Figure 9: the fields of the first seed with their points and rectangles.
[[nodiscard]] Figure field_map_figure(const std::shared_ptr<const FieldSample>& sample);
/// Figure 10: mean area and number over the number of obstacles.
[[nodiscard]] Figure field_chart_figure(const std::shared_ptr<const FieldSample>& sample);
/// The gain of MDSRC over SRC, field by field, over the number of obstacles.
[[nodiscard]] Figure field_gain_figure(const std::shared_ptr<const FieldSample>& sample);

}  // namespace fairway::reproduction
