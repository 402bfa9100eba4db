// SPDX-License-Identifier: Apache-2.0
// Runs scenarios with several robots, with and without the messages between robots and the
// prediction of moving obstacles.
//
//   fleet_scenarios SCENARIO.yaml...
#include <algorithm>
#include <cstdio>

#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/simulation/episode.hpp"

namespace {

using namespace fairway;

void run(Scenario scenario, bool messages, bool prediction) {
  scenario.radio.on = messages;
  scenario.settings.prediction.predict_motion = prediction;
  const EpisodeResult result = run_episode(scenario);
  int arrived = 0;
  int touched = 0;
  double last = 0.0;
  double separation = 1e9;
  for (const RobotResult& robot : result.robots) {
    arrived += robot.reached ? 1 : 0;
    touched += robot.collided ? 1 : 0;
    last = std::max(last, robot.time);
    separation = std::min(separation, robot.min_separation);
  }
  std::printf(
      "%s, messages %s, prediction %s: %d of %zu arrived, %d touched, last after %.1f s, least "
      "separation %.3f m\n",
      scenario.name.c_str(), messages ? "on" : "off", prediction ? "on" : "off", arrived,
      result.robots.size(), touched, last, separation);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const Expected<Scenario> scenario = io::read_scenario(argv[i]);
    if (!scenario) {
      std::fprintf(stderr, "fleet_scenarios: %s\n", scenario.error().message.c_str());
      return 2;
    }
    for (const bool messages : {true, false}) {
      for (const bool prediction : {true, false})
        run(*scenario, messages, prediction);
    }
  }
  return 0;
}
