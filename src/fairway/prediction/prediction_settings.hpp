// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/base/setting.hpp"

namespace fairway {

/// How moving obstacles are predicted, and the distance kept from the prediction.
struct PredictionSettings {
  double obstacle_margin = 0.1;      ///< distance kept beyond both radii [m], 0 to 10
  bool predict_motion = true;        ///< obstacles keep their velocity; false: they stand still
  double obstacle_growth = 0.1;      ///< growth of that distance per second ahead [m/s], 0 to 10
  double obstacle_growth_max = 0.2;  ///< greatest growth of that distance [m], 0 to 10
};

template <typename Settings, typename Visitor>
void visit_prediction(Settings& s, Visitor&& field) {
  field(s.obstacle_margin,
        SettingInfo{"obstacle_margin", "m", "distance kept from moving obstacles beyond both radii",
                    0, 10, kEssential});
  field(s.predict_motion,
        SettingInfo{"predict_motion", "",
                    "predict that moving obstacles keep their velocity; if not, that they stand "
                    "still"});
  field(s.obstacle_growth,
        SettingInfo{"obstacle_growth", "m/s",
                    "growth of that distance per second ahead, since predictions err", 0, 10});
  field(s.obstacle_growth_max,
        SettingInfo{"obstacle_growth_max", "m", "greatest growth of that distance", 0, 10});
}

}  // namespace fairway
