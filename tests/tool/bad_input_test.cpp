// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "fairway/base/utf8_text.hpp"
#include "tool_run.hpp"

namespace fairway::test {
namespace {

constexpr const char* kEnds = " --start 1,2 --goal 7,2 ";
constexpr const char* kOutputs = " --json out.json --picture out.svg";

// Checks for exit code 2, one line that starts with "fairway: ", and no new file.
void expect_refused(const TemporaryFolder& folder,
                    const std::string& arguments,
                    const std::string& part) {
  const std::size_t files = folder.count_files();
  const ToolRun run = run_tool(folder, arguments);
  EXPECT_EQ(run.code, 2) << arguments << '\n' << run.err;
  EXPECT_TRUE(run.err.starts_with("fairway: ")) << arguments << '\n' << run.err;
  EXPECT_EQ(count_lines(run.err), 1) << arguments << '\n' << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << arguments << '\n' << run.err;
  EXPECT_EQ(run.out, "") << arguments;
  EXPECT_EQ(folder.count_files(), files) << arguments;
}

void expect_plan_refused(const TemporaryFolder& folder,
                         const std::string& map,
                         const std::string& part) {
  expect_refused(folder, "plan " + map + kEnds + kOutputs, part);
}

// The room's YAML file with one line replaced.
std::string with_line(const TemporaryFolder& folder,
                      const std::string& key,
                      const std::string& line) {
  std::string text = content_of(folder.path("room.yaml"));
  const std::size_t begin = text.find(key + ":");
  return folder.write("bad.yaml", text.replace(begin, text.find('\n', begin) - begin, line));
}

class BadInput : public testing::Test {
 protected:
  BadInput() { write_room(folder_); }
  TemporaryFolder folder_;
};

TEST_F(BadInput, MissingFilesAreNamed) {
  expect_plan_refused(folder_, "none.yaml", "none.yaml: expected a file");
  expect_plan_refused(folder_, ".", "found a folder");
  with_line(folder_, "image", "image: none.pgm");
  expect_plan_refused(folder_, "bad.yaml", "none.pgm");
  with_line(folder_, "image", "image: .");
  expect_plan_refused(folder_, "bad.yaml", "found a folder");
  expect_refused(folder_, "simulate none.yaml", "none.yaml");
}

TEST_F(BadInput, IncompletePicturesAreRefused) {
  const std::string good = content_of(folder_.path("room.pgm"));
  folder_.write("room.pgm", good.substr(0, good.size() - 1));
  expect_plan_refused(folder_, "room.yaml", "truncated");
  folder_.write("room.pgm", "");
  expect_plan_refused(folder_, "room.yaml", "empty");
  folder_.write("room.pgm", "GIF89a not a map");
  expect_plan_refused(folder_, "room.yaml", "PGM");
  folder_.write("room.pgm", "P5\n1000000 1000000\n255\n");
  expect_plan_refused(folder_, "room.yaml", "1000000 x 1000000");
}

TEST_F(BadInput, WrongMapValuesAreNamedWithFileAndLine) {
  for (const char* value : {"0", "-0.05", "nan", ".nan", "inf", "1e400", "abc", "[1]"}) {
    with_line(folder_, "resolution", std::string("resolution: ") + value);
    expect_plan_refused(folder_, "bad.yaml", "bad.yaml:3: resolution: expected");
  }
  with_line(folder_, "origin", "origin: [.nan, 0, 0]");
  expect_plan_refused(folder_, "bad.yaml", "bad.yaml:4: origin: expected");
  with_line(folder_, "free_thresh", "free_thresh: 0.9");
  expect_plan_refused(folder_, "bad.yaml", "bad.yaml:7: free_thresh: expected");
  with_line(folder_, "negate", "negatee: 0");
  expect_plan_refused(folder_, "bad.yaml", "negate");
  with_line(folder_, "mode", "mode: trinary\ncolour: red");
  expect_plan_refused(folder_, "bad.yaml", "bad.yaml:3: 'colour': expected");
}

TEST_F(BadInput, InvalidYamlIsRefused) {
  for (const std::string& text :
       {std::string(), std::string("\x7f\x45LF\0\1\2", 7), std::string("a: [1"), std::string("- 1"),
        std::string(100000, '[')}) {
    folder_.write("bad.yaml", text);
    expect_plan_refused(folder_, "bad.yaml", "bad.yaml");
    expect_refused(folder_, "plan room.yaml --settings bad.yaml" + std::string(kEnds), "bad.yaml");
    expect_refused(folder_, "simulate bad.yaml", "bad.yaml");
  }
}

TEST_F(BadInput, PointsOutsideTheMapGiveItsBounds) {
  expect_refused(folder_, "plan room.yaml --start 1,2 --goal 9,2" + std::string(kOutputs),
                 "--goal: expected a point on the map, x from 0 to 8 and y from 0 to 4, found 9,2");
  expect_refused(folder_, "plan room.yaml --start -1,-2 --goal 7,2", "--start");
  expect_refused(folder_, "simulate --map room.yaml --start 1,2 --goal 1e9,2", "--goal");
}

TEST_F(BadInput, InvalidPointsAreRefused) {
  for (const char* text : {"1", "1,2,3,4", "1,,2", "1,2,", ",1,2", "nan,1", "1,inf", "1e400,2",
                           "a,b", "''", "'1;2'", "'1, 2'", "0x1,2"}) {
    expect_refused(folder_, std::string("plan room.yaml --goal 7,2 --start ") + text, "--start");
  }
}

TEST_F(BadInput, WrongSettingsAreNamed) {
  const std::string plan = std::string("plan room.yaml") + kEnds;
  expect_refused(folder_, plan + "--set robot.radius=-1", "robot.radius: expected a number from");
  expect_refused(folder_, plan + "--set robot.radius=nan", "robot.radius");
  expect_refused(folder_, plan + "--set robot.size=1", "'robot.size'");
  expect_refused(folder_, plan + "--set robo.radius=1", "'robo.radius'");
  expect_refused(folder_, plan + "--set robot.radius", "group.name=value");
  expect_refused(folder_, plan + "--preset fastest", "--preset");
  expect_refused(folder_, plan + "--set mpc.decay_rate=50", "mpc.decay_rate");
  folder_.write("bad.yaml", "mpc:\n  horizon: 1000\n");
  expect_refused(folder_, plan + "--settings bad.yaml", "bad.yaml:2: mpc.horizon: expected");
  expect_refused(folder_, "settings --settings bad.yaml", "bad.yaml:2: mpc.horizon: expected");
}

TEST_F(BadInput, WrongOptionsAreNamed) {
  const std::string plan = std::string("plan room.yaml") + kEnds;
  expect_refused(folder_, plan + "--corridor best", "--corridor");
  expect_refused(folder_, plan + "--clearance nan", "--clearance");
  expect_refused(folder_, plan + "--clearance -1", "--clearance");
  expect_refused(folder_, plan + "--robot-radius 1e400", "--robot-radius");
  expect_refused(folder_, plan + "--robot-radius 0.3 --clearance 0.1", "--clearance");
  expect_refused(folder_, plan + "--inward-offset x", "--inward-offset");
  expect_refused(folder_, plan + "--repeat 0", "--repeat");
  expect_refused(folder_, plan + "--no-such-option", "--no-such-option");
  expect_refused(folder_, "plan", "MAP");
  expect_refused(folder_, "plan room.yaml --start 1,2", "--goal");
  expect_refused(folder_, "", "subcommand");
  expect_refused(folder_, "fly", "fly");
  expect_refused(folder_, "simulate", "SCENARIO");
  expect_refused(folder_, "simulate room.yaml --map room.yaml", "SCENARIO");
  expect_refused(folder_, "simulate --map room.yaml --start 1,2", "--goal");
}

TEST_F(BadInput, OutputsThatCannotBeWrittenAreRefusedBeforeTheWork) {
  const std::string plan = std::string("plan room.yaml") + kEnds;
  expect_refused(folder_, plan + "--picture out.jpg --json out.json", "out.jpg");
  expect_refused(folder_, plan + "--picture out --json out.json", "out: expected");
  expect_refused(folder_, plan + "--json none/out.json --picture out.png", "none/out.json");
  expect_refused(folder_, plan + "--json .", "folder");
  expect_refused(folder_, "plan room.yaml --json /dev/full" + std::string(kEnds), "/dev/full");
}

TEST_F(BadInput, OutputsThatCollideAreRefusedBeforeTheWork) {
  folder_.write("s.yaml",
                "map: room.yaml\nrobots:\n  - {start: [1, 2, 0], goal: [7, 2]}\nsettings: {}\n");
  folder_.write("t.yaml", "robot: {radius: 0.2}\n");
  std::filesystem::create_symlink("room.pgm", folder_.path("link.png"));
  const std::string plan = std::string("plan room.yaml") + kEnds;
  expect_refused(folder_, plan + "--json x.svg --picture ./x.svg", "--picture: expected a file");
  expect_refused(folder_, plan + "--json room.yaml",
                 "--json: expected a file other than the input");
  expect_refused(folder_, plan + "--picture link.png", "other than the input, found link.png");
  expect_refused(folder_, plan + "--settings t.yaml --json t.yaml", "other than the input");
  const std::string run = "simulate s.yaml --time-limit 0.2 ";
  expect_refused(folder_, run + "--log a --trace a", "--log: expected a file other than that of");
  expect_refused(folder_, run + "--report s.yaml", "other than the input, found s.yaml");
  expect_refused(folder_, run + "--log room.pgm", "other than the input");
  expect_refused(folder_, run + "--json - --trace -", "standard output for both");
  folder_.write("a.json", "{\"a\": 1}");
  for (const char* command : {"merge a.json ", "compare a.json a.json "})
    expect_refused(folder_, std::string(command) + "--json ./a.json", "other than the input");
  EXPECT_EQ(content_of(folder_.path("a.json")), "{\"a\": 1}");
  EXPECT_TRUE(content_of(folder_.path("room.yaml")).starts_with("image: room.pgm"));
}

// Messages are valid UTF-8 on one line, whatever a file or a name holds.
TEST_F(BadInput, BytesThatAreNoTextAreNotQuoted) {
  const std::string robots = "robots:\n  - {name: \"r\xff\", start: [1, 2, 0], goal: [7, 2]}\n";
  folder_.write("s.yaml", "map: room.yaml\n" + robots);
  expect_refused(folder_, "simulate s.yaml --json j.json --log l.mcap",
                 "s.yaml:3: expected text in UTF-8, found byte 0xff");
  for (const std::string& text : {std::string("\x89PNG\r\n"), std::string("a: \xfe\n"),
                                  std::string("\"\\\xc3\x28\": 1"), std::string("%\xa0\n")}) {
    folder_.write("bad.yaml", text);
    const ToolRun run = run_tool(folder_, "plan bad.yaml" + std::string(kEnds));
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(count_lines(run.err), 1) << run.err;
    EXPECT_FALSE(first_not_utf8(run.err)) << run.err;
  }
  const ToolRun named = run_tool(folder_, "plan 'no\xff\xc2\x9b.yaml'" + std::string(kEnds));
  EXPECT_EQ(named.code, 2);
  EXPECT_FALSE(first_not_utf8(named.err)) << named.err;
  EXPECT_EQ(named.err.find("\xc2\x9b"), std::string::npos) << "a control character";
}

TEST_F(BadInput, WrongScenariosAreNamedWithFileAndLine) {
  const auto refuse = [&](const std::string& text, const std::string& part) {
    folder_.write("s.yaml", text);
    expect_refused(folder_, "simulate s.yaml --trace t.csv --json j.json --picture p.png", part);
  };
  const std::string map = "map: room.yaml\n";
  const std::string robots = "robots:\n  - {start: [1, 2, 0], goal: [7, 2]}\n";
  refuse(robots, "map: expected");
  refuse(map, "robots: expected");
  refuse(map + "robots: []\n", "robots: expected at least one");
  refuse(map + robots + "speed: 3\n", "s.yaml:4: 'speed': expected one of");
  refuse(map + "robots:\n  - {start: [1, 2], goal: [7, 2]}\n",
         "s.yaml:3: robots[0].start: expected");
  refuse(map + "robots:\n  - {start: [1, 2, 0], goal: [70, 2]}\n",
         "robots[0].goal: expected a point");
  refuse(map + "robots:\n  - {start: [1, 2, nan], goal: [7, 2]}\n", "robots[0].start");
  refuse(map + "robots:\n  - {start: [1, 2, 0], goal: [7, 2], size: 1}\n", "robots[0].'size'");
  refuse(map + robots + "time_limit: -1\n", "s.yaml:4: time_limit: expected");
  refuse(map + robots + "time_limit: .inf\n", "time_limit");
  refuse(map + robots + "seed: 1.5\n", "seed");
  refuse(map + robots + "settings: {mpc: {horizon: 0}}\n", "settings.mpc.horizon: expected");
  refuse(map + robots + "settings:\n  mpc:\n    decay_rate: 50\n",
         "s.yaml:6: settings.mpc.decay_rate");
  refuse(map + robots + "obstacles:\n  - {radius: 0.3}\n", "obstacles[0].key_frames: expected");
  refuse(map + robots + "obstacles:\n  - {key_frames: [[0, 1, 1], [0, 2, 2]]}\n", "increasing");
  refuse(map + robots + "obstacles:\n  - {key_frames: [[0, 1]]}\n",
         "key_frames: expected lists of 3");
  refuse(map + robots + "obstacles: 3\n", "obstacles: expected a list");
  refuse("map: none.yaml\n" + robots, "s.yaml:1: map: ");
}

}  // namespace
}  // namespace fairway::test
