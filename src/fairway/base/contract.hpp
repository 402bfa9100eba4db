// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

namespace fairway::detail {

[[noreturn]] inline void contract_broken(const char* kind,
                                         const char* condition,
                                         const char* file,
                                         int line) noexcept {
  std::fprintf(stderr, "%s:%d: %s broken: %s\n", file, line, kind, condition);
  std::abort();
}

}  // namespace fairway::detail

/// Checks a precondition. A violation aborts the process; the watchdog of the base then stops the
/// robot.
#define FAIRWAY_EXPECTS(condition) \
  ((condition)                     \
       ? static_cast<void>(0)      \
       : ::fairway::detail::contract_broken("precondition", #condition, __FILE__, __LINE__))

/// Checks an invariant or a result of the function itself.
#define FAIRWAY_ENSURES(condition)    \
  ((condition) ? static_cast<void>(0) \
               : ::fairway::detail::contract_broken("invariant", #condition, __FILE__, __LINE__))
