// SPDX-License-Identifier: Apache-2.0
// The schemas in a recording and docs/formats.md name every key of the messages.
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fairway/io/recording/run_messages.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/simulation/episode.hpp"

namespace fairway::io {
namespace {

using SchemaJson = nlohmann::json;

/// Keeps the keys of all fairway.* messages, and compares their values with the schemas.
class KeySink final : public MessageSink {
 public:
  std::uint16_t add_channel(const McapChannel& channel) override {
    channels_.push_back({channel.schema_name, SchemaJson::parse(channel.schema)});
    return static_cast<std::uint16_t>(channels_.size() - 1);
  }
  [[nodiscard]] bool wants(std::uint16_t /*channel*/) const override { return true; }
  void write(std::uint16_t channel, std::uint64_t /*time*/, std::string_view message) override {
    const auto& [name, schema] = channels_[channel];
    if (name.starts_with("fairway.")) compare(name, schema, SchemaJson::parse(message), true);
  }

  std::map<std::string, std::set<std::string>> keys;  // of each message
  std::set<std::string> faults;

 private:
  void compare(const std::string& name,
               const SchemaJson& schema,
               const SchemaJson& value,
               bool outer) {
    for (const auto& [key, field] : value.items()) {
      if (outer) keys[name].insert(key);
      const SchemaJson* const known =
          schema.contains("properties") && schema["properties"].contains(key)
              ? &schema["properties"][key]
              : nullptr;
      if (known == nullptr) {
        faults.insert(name + ": expected a schema of the key " + key + ", found none");
        continue;
      }
      const std::string type = field.is_string()           ? "string"
                               : field.is_boolean()        ? "boolean"
                               : field.is_number_integer() ? "integer"
                               : field.is_number()         ? "number"
                               : field.is_array()          ? "array"
                               : field.is_object()         ? "object"
                                                           : "null";
      const SchemaJson& allowed = (*known)["type"];
      const std::string wanted = allowed.is_array() ? allowed.dump() : allowed.get<std::string>();
      const bool is_allowed = wanted.find(type) != std::string::npos ||
                              (type == "integer" && wanted.find("number") != std::string::npos);
      if (!is_allowed)
        faults.insert(name + ": expected " + key + " to be " + wanted + ", found " + type);
      if (field.is_object()) compare(name + "." + key, *known, field, false);
    }
  }

  std::vector<std::pair<std::string, SchemaJson>> channels_;
};

TEST(MessageSchema, SchemasAndDocumentsNameEveryKey) {
  KeySink sink;
  for (const char* name : {"workshop", "fleet_doorway", "zones", "workshop_platform"}) {
    for (const Sensing sensing : {Sensing::Map, Sensing::Lidar}) {
      auto scenario = read_scenario(std::string(FAIRWAY_SOURCE_DIR "/scenarios/") + name + ".yaml");
      ASSERT_TRUE(scenario) << scenario.error().message;
      scenario->sensing.sensing = sensing;
      scenario->time_limit = 3.0;
      RunMessages messages(sink);
      static_cast<void>(run_episode(*scenario, {.observer = &messages}));
    }
  }
  EXPECT_EQ(sink.keys.size(), 8U) << "of the eight kinds of messages";
  std::ifstream file(FAIRWAY_SOURCE_DIR "/docs/formats.md");
  std::string line;
  std::map<std::string, std::string> rows;
  while (std::getline(file, line)) {
    if (line.starts_with("| `fairway.")) rows[line.substr(3, line.find('`', 3) - 3)] = line;
  }
  for (const auto& [name, keys] : sink.keys) {
    for (const std::string& key : keys) {
      if (rows[name].find('`' + key + '`') == std::string::npos)
        sink.faults.insert("docs/formats.md: expected the key " + key + " of " + name);
    }
  }
  std::ostringstream text;
  for (const std::string& fault : sink.faults)
    text << fault << '\n';
  EXPECT_TRUE(sink.faults.empty()) << text.str();
}

}  // namespace
}  // namespace fairway::io
