// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a settings file: the settings are valid, and read back from their own text.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fairway/io/yaml/settings_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto settings = fairway::io::parse_settings(text, "s.yaml");
  if (!settings) {
    if (settings.error().message.find('\n') != std::string::npos) std::abort();
    return 0;
  }
  if (!fairway::validate(*settings)) std::abort();
  const std::string printed = fairway::io::settings_yaml(*settings);
  const auto again = fairway::io::parse_settings(printed, "s.yaml");
  if (!again || fairway::io::settings_yaml(*again) != printed) std::abort();
  return 0;
}
