// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"

namespace fairway {

/// When plans are made.
struct PlanningSettings {
  bool background = false;      ///< plan in a thread; false: the cycle that needs a plan makes it
  double rebuild_period = 0.0;  ///< time between plans [s], 0 to 1000 (DuringTime); 0: when needed
  double retry_period = 0.5;    ///< time between attempts while no plan is found [s], 0.05 to 1000
};

template <typename Settings, typename Visitor>
void visit_planning(Settings& s, Visitor&& field) {
  field(s.background,
        SettingInfo{"background", "",
                    "make plans in a thread, so that no control cycle waits; if not, the cycle "
                    "that needs a plan makes it"});
  field(s.rebuild_period,
        SettingInfo{"rebuild_period", "s", "time between plans; 0: only when needed", 0, 1000});
  field(s.retry_period,
        SettingInfo{"retry_period", "s",
                    "time between attempts while no plan is found, or a better one is wanted", 0.05,
                    1000});
}

}  // namespace fairway
