// SPDX-License-Identifier: Apache-2.0
#include "cli/shard_option.hpp"

#include <optional>

#include "fairway/io/number_text.hpp"

namespace fairway::app {

namespace {

constexpr int kMostShards = 10000;

std::optional<Shard> shard_of(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) return std::nullopt;
  const std::optional<int> index = io::parse_integer(text.substr(0, slash));
  const std::optional<int> count = io::parse_integer(text.substr(slash + 1));
  if (!index || !count || *count < 1 || *count > kMostShards || *index < 1 || *index > *count)
    return std::nullopt;
  return Shard{.index = static_cast<std::size_t>(*index),
               .count = static_cast<std::size_t>(*count)};
}

}  // namespace

void add_shard_option(const Options& options, std::string& text) {
  options
      .add("--shard", text, "Only part I of N equal parts of the runs; `fairway merge` joins them")
      .type_name("I/N")
      .check([](const std::string& given) {
        return shard_of(given)
                   ? std::string()
                   : "expected I/N with 1 <= I <= N <= 10000, found " + io::excerpt(given);
      });
}

Shard parse_shard(const std::string& text) { return shard_of(text).value_or(Shard{}); }

}  // namespace fairway::app
