// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tool_run.hpp"

namespace fairway::test {
namespace {

using nlohmann::json;

constexpr const char* kPlan = "plan room.yaml --start 1,2 --goal 7,2";

// A result of a batch as a command writes it, with one run per world.
json batch(std::initializer_list<int> worlds, double score) {
  json result{{"worlds", json::array()},
              {"success_rate", 1.0},
              {"mean_score", score},
              {"cycle_us", {{"median", 10.0 * score}, {"p99", score}, {"max", score}}},
              {"schema", "fairway/barn.v1"},
              {"provenance", {{"version", "1"}, {"seed", 1}, {"settings", json::object()}}}};
  for (const int world : worlds)
    result["worlds"].push_back({{"world", world}, {"trial", 0}, {"score", score}});
  return result;
}

TEST(Provenance, NamesTheInputsOfAResult) {
  const TemporaryFolder folder;
  write_room(folder);
  folder.write("own.yaml", "robot: {radius: 0.2}\n");
  const ToolRun run = run_tool(
      folder, std::string(kPlan) + " --settings own.yaml --set path.any_angle=false --json -");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_EQ(result.at("schema"), "fairway/plan.v1");
  const json& from = result.at("provenance");
  EXPECT_EQ(from.at("version"), json(FAIRWAY_VERSION));
  EXPECT_EQ(from.at("command").at(1), "plan");
  EXPECT_EQ(from.at("command").back(), "-");
  EXPECT_EQ(from.at("settings"), json({{"robot.radius", 0.2}, {"path.any_angle", false}}));
  EXPECT_EQ(from.at("inputs").at(1).at("file"), "own.yaml");
  EXPECT_EQ(from.at("inputs").at(1).at("bytes"), 21);
  EXPECT_EQ(from.at("inputs").at(1).at("crc32"), "640c1d04") << "as zlib's crc32 has it";
  EXPECT_EQ(from.at("map").at("width"), 80);
}

// The files that the given ones name, each once.
TEST(Provenance, NamesTheMapAndThePictureOfAScenario) {
  const TemporaryFolder folder;
  write_room(folder);
  folder.write("run.yaml", "map: room.yaml\nrobots: [{start: [1, 1, 0], goal: [3, 1]}]\n");
  const ToolRun run = run_tool(folder, "simulate run.yaml --json result.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const json result = json::parse(content_of(folder.path("result.json")));
  std::vector<std::string> names;
  for (const json& input : result.at("provenance").at("inputs"))
    names.push_back(std::filesystem::path(input.at("file").get<std::string>()).filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{"run.yaml", "room.yaml", "room.pgm"}));
}

TEST(Provenance, DistinguishesMapsByTheirCells) {
  const TemporaryFolder folder;
  write_room(folder);
  const auto sum = [&] {
    return json::parse(run_tool(folder, std::string(kPlan) + " --json -").out)
        .at("provenance")
        .at("map")
        .at("cells_crc32");
  };
  const json before = sum();
  EXPECT_EQ(sum(), before);
  std::string image = content_of(folder.path("room.pgm"));
  image[image.size() - 100] = '\0';
  folder.write("room.pgm", image);
  EXPECT_NE(sum(), before);
}

TEST(Compare, IsSilentAboutTimesAndFailsWhereResultsDiffer) {
  const TemporaryFolder folder;
  write_room(folder);
  ASSERT_EQ(run_tool(folder, std::string(kPlan) + " --json a.json").code, 0);
  ASSERT_EQ(run_tool(folder, std::string(kPlan) + " --json b.json").code, 0);
  EXPECT_EQ(run_tool(folder, "compare a.json b.json").code, 0);
  ASSERT_EQ(run_tool(folder, std::string(kPlan) + " --set robot.radius=0.2 --json b.json").code, 0);
  const ToolRun run = run_tool(folder, "compare a.json b.json");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("provenance.settings.robot.radius"), std::string::npos);
  EXPECT_NE(run.out.find("robot_radius"), std::string::npos);
  EXPECT_EQ(run.out.find("seconds"), std::string::npos);
  const json differences = json::parse(run_tool(folder, "compare a.json b.json --json -").out);
  EXPECT_FALSE(differences.at("same").get<bool>());
}

TEST(Compare, MatchesRunsByNameAndToleratesTheGivenDifference) {
  const TemporaryFolder folder;
  folder.write("a.json", R"({"worlds": [{"world": 1, "time": 5.0}, {"world": 2, "time": 6.0}]})");
  folder.write("b.json", R"({"worlds": [{"world": 2, "time": 6.006}, {"world": 1, "time": 5.0}]})");
  const ToolRun run = run_tool(folder, "compare a.json b.json");
  EXPECT_EQ(run.code, 1);
  EXPECT_NE(run.out.find("worlds[2].time  6.0 -> 6.006  +0.006 (+0.10 %)"), std::string::npos)
      << run.out;
  EXPECT_EQ(run_tool(folder, "compare a.json b.json --tolerance 0.01").code, 0);
}

TEST(Compare, RefusesOtherFilesInOneLine) {
  const TemporaryFolder folder;
  folder.write("a.json", "{}");
  folder.write("list.json", "[1]");
  folder.write("broken.json", "{\n\"a\": \n}");
  folder.write("deep.json", std::string(100000, '['));
  for (const char* file : {"list.json", "broken.json", "deep.json", "absent.json"}) {
    const ToolRun run = run_tool(folder, std::string("compare a.json ") + file);
    EXPECT_EQ(run.code, 2) << file;
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_NE(run.err.find(file), std::string::npos) << run.err;
  }
}

TEST(Merge, JoinsShardsAsOneBatch) {
  const TemporaryFolder folder;
  folder.write("a.json", batch({0, 2}, 0.5).dump());
  folder.write("b.json", batch({1}, 0.2).dump());
  const ToolRun run = run_tool(folder, "merge b.json a.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const json merged = json::parse(run.out);
  ASSERT_EQ(merged.at("worlds").size(), 3U);
  for (int world = 0; world < 3; ++world)
    EXPECT_EQ(merged.at("worlds").at(static_cast<std::size_t>(world)).at("world"), world);
  EXPECT_NEAR(merged.at("mean_score").get<double>(), 0.4, 1e-12);
  EXPECT_NEAR(merged.at("cycle_us").at("median").get<double>(), 4.0, 1e-12);
  EXPECT_EQ(merged.at("cycle_us").at("max"), 0.5);
}

// As a safety campaign writes them: counts, and the runs that ended badly.
TEST(Merge, AddsTheTotalsOfACampaign) {
  const TemporaryFolder folder;
  const auto shard = [](int runs, double least, json list) {
    return json{{"seed", 1},
                {"totals", {{"runs", runs}, {"least_clearance", least}, {"contacts", {{"x", 1}}}}},
                {"runs", std::move(list)}};
  };
  folder.write("a.json", shard(10, 0.2, {{{"run", 4}, {"contact", "x"}}}).dump());
  folder.write("b.json", shard(7, 0.1, json::array()).dump());
  const ToolRun run = run_tool(folder, "merge a.json b.json");
  ASSERT_EQ(run.code, 0) << run.err;
  const json merged = json::parse(run.out);
  EXPECT_EQ(merged.at("totals").at("runs"), 17);
  EXPECT_EQ(merged.at("totals").at("least_clearance"), 0.1);
  EXPECT_EQ(merged.at("totals").at("contacts").at("x"), 2);
  EXPECT_EQ(merged.at("runs").size(), 1U);
  EXPECT_EQ(merged.at("seed"), 1);
}

TEST(Merge, RefusesShardsThatDoNotBelongTogether) {
  const TemporaryFolder folder;
  folder.write("a.json", batch({0, 2}, 0.5).dump());
  json other = batch({1}, 0.5);
  other["provenance"]["settings"]["robot.radius"] = 0.3;
  folder.write("settings.json", other.dump());
  folder.write("twice.json", batch({2}, 0.5).dump());
  folder.write("none.json", "{}");
  other = batch({1}, 0.5);
  other["schema"] = "fairway/bodies.v1";
  folder.write("schema.json", other.dump());
  for (const char* file : {"settings.json", "twice.json", "none.json", "schema.json"}) {
    const ToolRun run = run_tool(folder, std::string("merge a.json ") + file);
    EXPECT_EQ(run.code, 2) << file;
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_EQ(run.out, "");
  }
}

TEST(Statuses, ExplainEachByItsName) {
  const TemporaryFolder folder;
  const ToolRun all = run_tool(folder, "statuses --json -");
  ASSERT_EQ(all.code, 0);
  const json guide = json::parse(all.out);
  EXPECT_EQ(guide.at("statuses").size(), 13U);
  for (const char* list : {"statuses", "limiting_factors"}) {
    for (const json& entry : guide.at(list)) {
      EXPECT_NE(entry.at("meaning"), "") << entry.at("name");
      const auto name = entry.at("name").get<std::string>();
      const ToolRun one = run_tool(folder, "statuses '" + name + "'");
      EXPECT_EQ(one.code, 0) << name;
      EXPECT_NE(one.out.find(entry.at("meaning").get<std::string>()), std::string::npos);
    }
  }
  EXPECT_EQ(run_tool(folder, "statuses nothing").code, 2);
}

TEST(Completion, KnowsCommandsOptionsAndValues) {
  const TemporaryFolder folder;
  folder.write("complete.sh",
               "source <('" FAIRWAY_TOOL
               "' completion bash)\n"
               "complete_words() { COMP_WORDS=(fairway \"$@\"); COMP_CWORD=$#; _fairway; "
               "echo \"${COMPREPLY[@]}\"; }\n"
               "complete_words simu\ncomplete_words simulate --phy\n"
               "complete_words simulate --physics ''\n");
  ASSERT_EQ(std::system(("cd '" + folder.path("") + "' && bash complete.sh > out").c_str()), 0);
  EXPECT_EQ(content_of(folder.path("out")), "simulate\n--physics\nunicycle mujoco\n");
}

TEST(Manual, HasEveryCommandAndOption) {
  const TemporaryFolder folder;
  const std::string page = run_tool(folder, "manual").out;
  for (const char* text : {".SS \"fairway plan MAP\"", "\\fB\\-\\-swap\\fR", ".SH EXIT STATUS"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace fairway::test
