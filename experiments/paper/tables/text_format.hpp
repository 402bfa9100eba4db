// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <string>

#include <fmt/core.h>

#include "experiments/paper/studies/sample_statistics.hpp"

namespace fairway::reproduction {

/// `value` with a true minus sign; a dash when it is not finite.
[[nodiscard]] inline std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) return "\u2013";
  const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return fmt::format("{}{}", value < 0.0 && !zero ? "\u2212" : "", digits);
}

/// Mean and half width of the 95 % interval; only the mean if there is no interval.
[[nodiscard]] inline std::string with_interval(const Estimate& e, int decimals) {
  if (e.count < 2) return fixed(e.mean, decimals);
  return fmt::format("{} \u00b1 {}", fixed(e.mean, decimals), fixed(e.half_width(), decimals));
}

/// Formats the same as a signed percentage.
[[nodiscard]] inline std::string percent_interval(const Estimate& e) {
  return fmt::format("{}{} %", e.mean > 0.0 ? "+" : "", with_interval(e, 1));
}

/// Formats a p-value as in papers.
[[nodiscard]] inline std::string p_text(double p) {
  return p < 0.0001 ? std::string("p < 0.0001") : fmt::format("p = {:.4f}", p);
}

}  // namespace fairway::reproduction
