// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/mpc/solution.hpp"
#include "fairway/navigation/navigation_status.hpp"

namespace fairway {

/// The constraint that holds a plan back most, in the words of the navigator.
[[nodiscard]] LimitingFactor limit_of(const RowName& row) noexcept;

}  // namespace fairway
