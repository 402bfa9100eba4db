// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "cli/output.hpp"
#include "cli/settings_options.hpp"
#include "commands/commands.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
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
    Expected<Scenario> scenario = load_scenario(file);
    if (!scenario) return tl::unexpected(scenario.error());
    scenario->engine = Engine::Unicycle;  // MuJoCo's worlds cannot change during a run
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

void add_serve_command(CommandLine& tool) {
  const auto command = std::make_shared<ServeCommand>();
  const Options options =
      tool.add_command("serve", "Serve a page with an interactive world", [command] {
        command->server.check.any_address = command->server.address != "127.0.0.1";
        return command->run();
      });
  options.add("SCENARIO", command->scenarios, "Scenario YAML files to choose from")
      .type_name("SCENARIO.yaml");
  options.add("--port", command->server.port, "Port; 0 selects a free one")
      .between(0, 65535)
      .shows_default();
  options
      .add("--address", command->server.address,
           "Address to listen on; other machines can reach the page only if it is not "
           "127.0.0.1")
      .shows_default();
  options.add("--allow-host", command->server.check.hosts, "Additional host name of the page")
      .type_name("NAME");
  options
      .add("--allow-origin", command->server.check.origins,
           "Additional site whose pages may connect, such as https://app.foxglove.dev")
      .type_name("ORIGIN");
}

}  // namespace fairway::app
