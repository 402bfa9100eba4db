// SPDX-License-Identifier: Apache-2.0
#include "results/merged_results.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/core.h>

namespace fairway::app {

namespace {

constexpr std::array kLists = {"worlds", "tasks", "cases", "runs"};
// What runs are sorted by, in this order, as far as they have it.
constexpr std::array kKeys = {"world", "task", "case", "run", "trial"};

const char* list_of(const Json& result) {
  for (const char* list : kLists) {
    const auto found = result.find(list);
    if (found != result.end() && found->is_array() &&
        std::all_of(found->begin(), found->end(), [](const Json& run) { return run.is_object(); }))
      return list;
  }
  return nullptr;
}

Json key_of(const Json& run) {
  Json key = Json::array();
  for (const char* name : kKeys) {
    if (run.contains(name)) key.push_back(run.at(name));
  }
  return key;
}

Json part(const Json& result, const char* field) {
  const auto provenance = result.find("provenance");
  if (provenance == result.end() || !provenance->is_object()) return nullptr;
  const auto found = provenance->find(field);
  return found == provenance->end() ? Json(nullptr) : *found;
}

Expected<void> check_alike(const ShardResult& first, const ShardResult& other, const char* list) {
  const char* const of_other = list_of(other.result);
  if (of_other == nullptr || std::string_view(of_other) != list) {
    return fail(fmt::format("{}: {}: expected a list of runs as {} has it, found none", other.file,
                            list, first.file));
  }
  const auto differs = [&](const char* what, const Json& a, const Json& b) -> Expected<void> {
    if (a == b) return {};
    return fail(fmt::format("{}: {}: expected {} as {} has it, found {}", other.file, what,
                            a.dump(), first.file, b.dump()));
  };
  if (auto same = differs("schema", first.result.value("schema", Json()),
                          other.result.value("schema", Json()));
      !same) {
    return same;
  }
  for (const char* field : {"version", "seed", "settings"}) {
    if (auto same = differs(field, part(first.result, field), part(other.result, field)); !same)
      return same;
  }
  return {};
}

struct Weighted {
  const Json* value;
  double weight;
};

// Counts of all runs from those of the parts: sums, and the least of what begins with "least".
Json total(std::string_view key, const std::vector<const Json*>& parts) {
  const Json& first = *parts.front();
  if (first.is_object()) {
    Json object = Json::object();
    for (const auto& [name, value] : first.items()) {
      std::vector<const Json*> inner;
      for (const Json* one : parts) {
        if (one->is_object() && one->contains(name)) inner.push_back(&one->at(name));
      }
      object[name] = total(name, inner);
    }
    return object;
  }
  Json sum = first;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Json& other = *parts[i];
    if (!other.is_number()) continue;
    if (!sum.is_number()) {
      sum = other;
    } else if (key.substr(0, 5) == "least") {
      sum = std::min(sum.get<double>(), other.get<double>());
    } else if (sum.is_number_integer() && other.is_number_integer()) {
      sum = sum.get<std::int64_t>() + other.get<std::int64_t>();
    } else {
      sum = sum.get<double>() + other.get<double>();
    }
  }
  return sum;
}

// A summary of all runs from those of the parts.
Json joined(std::string_view key, const std::vector<Weighted>& parts) {
  const Json& first = *parts.front().value;
  if (first.is_number_float() || (first.is_number() && key != "seed")) {
    double sum = 0.0;
    double weight = 0.0;
    double most = first.get<double>();
    for (const Weighted& one : parts) {
      if (!one.value->is_number()) continue;
      sum += one.weight * one.value->get<double>();
      weight += one.weight;
      most = std::max(most, one.value->get<double>());
    }
    return key == "max" || key == "p99" ? Json(most) : Json(weight > 0.0 ? sum / weight : 0.0);
  }
  if (!first.is_object()) return first;
  Json object = Json::object();
  for (const auto& [name, value] : first.items()) {
    std::vector<Weighted> inner;
    for (const Weighted& one : parts) {
      if (one.value->is_object() && one.value->contains(name))
        inner.push_back({&one.value->at(name), one.weight});
    }
    object[name] = joined(name, inner);
  }
  return object;
}

// Returns the weight of a part in a summary. Means of `fairway people` are over its successes, and
// its rate of danger is over its steps; everything else is over all runs.
double weight_of(std::string_view key, const Json& runs) {
  double weight = 0.0;
  for (const Json& run : runs) {
    if (run.contains("outcome") && key.rfind("mean_", 0) == 0) {
      weight += run.at("outcome") == "success" ? 1.0 : 0.0;
    } else if (key == "danger_rate") {
      weight += run.value("steps", 0.0);
    } else {
      weight += 1.0;
    }
  }
  return weight;
}

}  // namespace

Expected<Json> merge_results(std::span<const ShardResult> shards) {
  const ShardResult& first = shards.front();
  const char* const list = list_of(first.result);
  if (list == nullptr) {
    return fail(
        fmt::format("{}: expected a result with a list of worlds, tasks, cases or runs, found none",
                    first.file));
  }
  std::vector<std::pair<Json, const Json*>> runs;
  for (const ShardResult& shard : shards) {
    if (auto alike = check_alike(first, shard, list); !alike) return tl::unexpected(alike.error());
    for (const Json& run : shard.result.at(list))
      runs.emplace_back(key_of(run), &run);
  }
  std::stable_sort(runs.begin(), runs.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  const auto twice = std::adjacent_find(runs.begin(), runs.end(), [](const auto& a, const auto& b) {
    return a.first == b.first && !a.first.empty();
  });
  if (twice != runs.end()) {
    return fail(fmt::format("{}: {}: expected each run once, found {} twice", first.file, list,
                            twice->first.dump()));
  }
  Json merged = Json::object();
  for (const auto& [key, value] : first.result.items()) {
    if (key == list) {
      merged[key] = Json::array();
      for (const auto& run : runs)
        merged[key].push_back(*run.second);
    } else if (key == "provenance" || key == "schema") {
      merged[key] = value;
    } else if (key != "shard") {
      std::vector<Weighted> parts;
      for (const ShardResult& shard : shards) {
        if (shard.result.contains(key)) {
          parts.push_back({&shard.result.at(key), weight_of(key, shard.result.at(list))});
        }
      }
      if (key == "totals") {
        std::vector<const Json*> counts;
        for (const Weighted& one : parts)
          counts.push_back(one.value);
        merged[key] = total(key, counts);
      } else {
        merged[key] = joined(key, parts);
      }
    }
  }
  merged["merged"] = Json::array();
  for (const ShardResult& shard : shards)
    merged["merged"].push_back(shard.file);
  return merged;
}

}  // namespace fairway::app
