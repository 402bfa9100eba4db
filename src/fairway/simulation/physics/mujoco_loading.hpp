// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

struct mjModel_;  // NOLINT(readability-identifier-naming): MuJoCo's name

namespace fairway {

/// Compiles a model that lives in memory (MuJoCo itself reads files). To be given back to
/// mj_deleteModel.
/// @throws std::runtime_error with MuJoCo's words when it is wrong.
[[nodiscard]] mjModel_* load_mujoco_model(const std::string& xml);

}  // namespace fairway
