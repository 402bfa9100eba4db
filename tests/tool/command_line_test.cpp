// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/left_out.hpp"

namespace fairway::app {
namespace {

struct Ride {
  std::string animal = "horse";
  int legs = 4;
  int seed = 0;
};

// Runs `fairway WORDS`, and returns the exit code and the standard error.
struct Answer {
  int code = -1;
  std::string error;
};

Answer run(std::vector<std::string> words) {
  Ride ride;
  CommandLine tool;
  const Options options = tool.add_command("ride", "Ride an animal", [&] { return ride.legs; });
  options.add("--animal", ride.animal, "Which").one_of({"horse", "camel"});
  options.add("--legs", ride.legs, "How many").between(1, 8);
  options.add("--seed", ride.seed, "Of its temper").not_negative();
  std::string name;
  tool.add_command("call", "Call an animal", [] { return 0; }).add("NAME", name, "Its").required();
  add_left_out_command(tool, "fly", "Fly a kite", "libkite-dev");
  words.insert(words.begin(), "fairway");
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(word.data());
  testing::internal::CaptureStderr();
  const int code = tool.run(static_cast<int>(arguments.size()), arguments.data());
  return {.code = code, .error = testing::internal::GetCapturedStderr()};
}

TEST(CommandLine, RunsTheNamedCommand) {
  EXPECT_EQ(run({"ride"}).code, 4);
  EXPECT_EQ(run({"ride", "--animal", "camel", "--legs", "3", "--seed", "7"}).code, 3);
}

TEST(CommandLine, ReportsInOneLineHowToGetACommandThatTheBuildLeftOut) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"fly"}, {"fly", "--port", "80", "x.yaml"}}) {
    const Answer answer = run(words);
    EXPECT_EQ(answer.code, kBadInput);
    EXPECT_EQ(answer.error,
              "fairway: expected a command of this build, found fly, which this build left out; to "
              "get it: tools/install_packages.sh libkite-dev && cmake --preset release && "
              "cmake --build --preset release\n");
  }
}

TEST(CommandLine, ReportsWhatItExpectedAndWhatItFound) {
  const auto refused = [](const std::vector<std::string>& words, const std::string& line) {
    const Answer answer = run(words);
    EXPECT_EQ(answer.code, kBadInput);
    EXPECT_EQ(answer.error, "fairway: " + line + "\n");
  };
  refused({"walk"}, "expected a command, see fairway --help; found walk");
  refused({"ride", "--animal", "cow"}, "--animal: expected horse or camel, found 'cow'");
  refused({"ride", "--legs", "9"}, "--legs: expected an integer from 1 to 8, found '9'");
  refused({"ride", "--legs", "2.5"}, "--legs: expected an integer from 1 to 8, found '2.5'");
  refused({"ride", "--animal", ""}, "--animal: expected a value, found an empty one");
  refused({"call", ""}, "NAME: expected a value, found an empty one");
  refused({"ride", "--seed", "-1"}, "--seed: expected an integer from 0 on, found '-1'");
  refused({"ride", "--seed", "nan"}, "--seed: expected an integer from 0 on, found 'nan'");
  refused({"ride", "--saddle", "red"},
          "expected the arguments that fairway ride --help lists, found '--saddle red'");
  refused({"call"}, "NAME: expected a value, see fairway call --help; found none");
}

TEST(CommandLine, EachHelpNamesTheDocumentsAndTheManualNamesThemOnce) {
  CommandLine tool;
  tool.add_command("call", "Call an animal", [] { return 0; }).footer("It may not come.");
  tool.add_command("ride", "Ride an animal", [] { return 0; });
  for (const CommandHelp& command : tool.help())
    EXPECT_EQ(command.footer, command.name == "call" ? "It may not come." : "");
  for (const char* command : {"call", "ride"}) {
    std::string words[] = {"fairway", command, "--help"};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data()};
    testing::internal::CaptureStdout();
    EXPECT_EQ(tool.run(3, arguments), 0);
    EXPECT_NE(testing::internal::GetCapturedStdout().find("docs/command_line.md"),
              std::string::npos)
        << command;
  }
}

}  // namespace
}  // namespace fairway::app
