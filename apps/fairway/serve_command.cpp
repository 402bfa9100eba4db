// SPDX-License-Identifier: Apache-2.0
#include "serve_command.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "fairway/io/scenario_file.hpp"
#include "output.hpp"
#include "server/live_server.hpp"

namespace fairway::app {

namespace {

struct ServeCommand {
  std::vector<std::string> scenarios;
  ServerSettings server;

  [[nodiscard]] Expected<int> run() const;
};

Expected<int> ServeCommand::run() const {
  std::vector<MapChoice> maps;
  for (const std::string& file : scenarios) {
    Expected<Scenario> scenario = io::read_scenario(file);
    if (!scenario) return tl::unexpected(scenario.error());
    scenario->engine = Engine::Unicycle;  // MuJoCo's worlds cannot be changed while they run
    maps.push_back({.name = scenario->name,
                    .make = [scenario = *scenario] { return scenario; },
                    .own_settings = true});
  }
  std::ranges::copy(built_in_maps(), std::back_inserter(maps));
  const auto on_ready = [](const std::string& url) {
    static_cast<void>(print("The live page is at " + url + " (Ctrl+C ends it)\n"));
  };
  const auto served = serve_live(std::move(maps), server, on_ready);
  if (!served) return tl::unexpected(served.error());
  return kDone;
}

}  // namespace

void add_serve_command(CLI::App& tool, Command& chosen) {
  const auto command = std::make_shared<ServeCommand>();
  CLI::App* sub = tool.add_subcommand("serve", "Show a world that can be played with, as a page");
  sub->add_option("SCENARIO", command->scenarios, "Scenario YAML files to choose from")
      ->type_name("SCENARIO.yaml");
  sub->add_option("--port", command->server.port, "Port; 0 takes a free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  sub->add_option("--address", command->server.address,
                  "Address to listen at; others than this machine's own reach the page only if it "
                  "is not 127.0.0.1")
      ->capture_default_str();
  sub->add_option("--allow-host", command->server.check.hosts,
                  "Further name by which the page may be addressed")
      ->type_name("NAME");
  sub->add_option("--allow-origin", command->server.check.origins,
                  "Further site whose pages may connect, as https://app.foxglove.dev")
      ->type_name("ORIGIN");
  sub->callback([&chosen, command] {
    chosen = [command] {
      command->server.check.any_address = command->server.address != "127.0.0.1";
      return command->run();
    };
  });
}

}  // namespace fairway::app
