// SPDX-License-Identifier: Apache-2.0
#include "fairway/simulation/physics/mujoco_loading.hpp"

#include <array>
#include <cstring>
#include <memory>
#include <stdexcept>

#include <mujoco/mujoco.h>

namespace fairway {

mjModel_* load_mujoco_model(const std::string& xml) {
  constexpr const char* kName = "fairway.xml";
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  if (mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(xml.size())) != 0) {
    throw std::runtime_error("MuJoCo: no memory for the model");
  }
  const int index = mj_findFileVFS(files.get(), kName);
  std::memcpy(files->filedata[index], xml.data(), xml.size());
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML(kName, files.get(), error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(files.get());
  if (model == nullptr) throw std::runtime_error("MuJoCo: " + std::string(error.data()));
  return model;
}

}  // namespace fairway
