// SPDX-License-Identifier: Apache-2.0
#include "cli/provenance.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "cli/command_line.hpp"
#include "fairway/io/mcap/mcap_format.hpp"
#include "fairway/io/number_text.hpp"
#include "fairway/io/yaml/settings_file.hpp"

namespace fairway::app {

namespace {

struct Checksum {
  std::uintmax_t bytes = 0;
  std::uint32_t crc = 0;

  void add(std::string_view text) {
    crc = io::mcap::crc32(text, crc);
    bytes += text.size();
  }
};

std::string hexadecimal(std::uint32_t crc) { return fmt::format("{:08x}", crc); }

void add_file(const std::filesystem::path& path, Checksum& sum) {
  std::ifstream file(path, std::ios::binary);
  std::array<char, 1U << 16U> buffer{};
  while (file.read(buffer.data(), buffer.size()) || file.gcount() > 0)
    sum.add({buffer.data(), static_cast<std::size_t>(file.gcount())});
}

// A folder's files count in the order of their names, each with its name before its content.
Json input_json(const std::string& name) {
  Json input{{"file", name}};
  Checksum sum;
  std::error_code failed;
  if (std::filesystem::is_directory(name, failed)) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(name, failed)) {
      if (entry.is_regular_file(failed)) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files) {
      sum.crc = io::mcap::crc32(file.lexically_relative(name).generic_string(), sum.crc);
      add_file(file, sum);
    }
    input["files"] = files.size();
  } else {
    add_file(name, sum);
  }
  input["bytes"] = sum.bytes;
  input["crc32"] = hexadecimal(sum.crc);
  return input;
}

// The given files and folders, and what was read besides: the files that they name, such as maps
// and their pictures.
std::vector<std::string> all_inputs(const std::vector<std::string>& given) {
  std::vector<std::string> inputs;
  for (const std::string& name : given) {
    if (!name.empty()) inputs.push_back(name);
  }
  std::error_code failed;
  const auto is_in = [&](const std::string& input, const std::string& file) {
    const auto part = std::filesystem::relative(file, input, failed).generic_string();
    return part == "." || (std::filesystem::is_directory(input, failed) && !part.starts_with(".."));
  };
  for (const std::string& file : noted_inputs()) {
    if (std::none_of(inputs.begin(), inputs.end(),
                     [&](const std::string& input) { return is_in(input, file); }))
      inputs.push_back(file);
  }
  return inputs;
}

Json map_json(const OccupancyGrid& map) {
  const GridFrame& frame = map.frame();
  std::uint32_t crc = 0;
  std::string row(static_cast<std::size_t>(frame.width), '\0');
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x)
      row[static_cast<std::size_t>(x)] = static_cast<char>(map.at({.x = x, .y = y}));
    crc = io::mcap::crc32(row, crc);
  }
  const Pose2& origin = frame.origin;
  return {{"width", frame.width},
          {"height", frame.height},
          {"resolution", frame.resolution},
          {"origin", Json::array({origin.position.x(), origin.position.y(), origin.heading})},
          {"cells_crc32", hexadecimal(crc)}};
}

// Returns a setting's text as the JSON value that it denotes.
Json setting_json(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  if (const std::optional<double> number = io::parse_number(text)) return *number;
  return text;
}

}  // namespace

void add_provenance(Json& result, const Provenance& provenance) {
  result["schema"] = std::string("fairway/") + provenance.schema;
  Json from{{"version", tool_version()}, {"command", given_command_line()}};
  from["inputs"] = Json::array();
  for (const std::string& file : all_inputs(provenance.files))
    from["inputs"].push_back(input_json(file));
  if (provenance.map != nullptr) from["map"] = map_json(*provenance.map);
  if (provenance.seed) from["seed"] = *provenance.seed;
  if (provenance.settings != nullptr) {
    from["settings"] = Json::object();
    for (const io::SettingDifference& d : io::setting_differences(*provenance.settings))
      from["settings"][d.name] = setting_json(d.value);
  }
  result["provenance"] = std::move(from);
}

}  // namespace fairway::app
