// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <string>

#include <fmt/core.h>

#include "cli/json_file.hpp"
#include "cli/number_option.hpp"
#include "cli/output.hpp"
#include "cli/provenance.hpp"
#include "commands/commands.hpp"
#include "node/order_client.hpp"

namespace fairway::app {

namespace {

struct OrderCommand {
  std::string file;
  std::string version = "2.1.0";
  std::string json;
  std::optional<double> time_limit;
  std::uint16_t port = 1883;
  vda5050::ClientRequest request;

  [[nodiscard]] Expected<int> run();
};

Expected<int> OrderCommand::run() {
  vda5050::VehicleIdentity& vehicle = request.vehicle;
  vehicle.version = *vda5050::version_of(version);
  if (!vda5050::is_serial_number(vehicle.serial))
    return fail("--serial: expected letters, digits and _ . : -, found " + vehicle.serial);
  if (!vda5050::is_topic_level(vehicle.manufacturer))
    return fail("--manufacturer: expected a text without / + # $, found " + vehicle.manufacturer);
  note_input(file);
  const Expected<Json> message = read_json_object(file);
  if (!message) return tl::unexpected(message.error());
  if (const auto output = check_output(json); !output) return tl::unexpected(output.error());
  if (const auto apart = check_apart({{"--json", json}}); !apart)
    return tl::unexpected(apart.error());
  request.message = nlohmann::json(*message);
  if (!vda5050::topic_of(request.message))
    return fail(file + ": expected an order, instant actions, a zone set or responses");
  request.port = port;
  request.patience = time_limit.value_or(request.patience);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const Expected<vda5050::ClientResult> result =
      vda5050::send_message(request, [terminal](const std::string& line) {
        if (terminal) std::fprintf(stderr, "%s\n", line.c_str());
      });
  if (!result) return tl::unexpected(result.error());
  if (json != "-") {
    const auto printed = print((result->done ? "done: " : "not done: ") + result->text + "\n");
    if (!printed) return tl::unexpected(printed.error());
  }
  if (!json.empty()) {
    Json written{{"success", result->done}, {"text", result->text}, {"state", result->last_state}};
    add_provenance(written, {.schema = "order.v1", .files = {file}});
    if (const auto done = write_output(json, json_text(written)); !done)
      return tl::unexpected(done.error());
  }
  return result->done ? kDone : kFailed;
}

}  // namespace

void add_order_command(CommandLine& tool) {
  auto command = std::make_shared<OrderCommand>();
  const Options options =
      tool.add_command("order", "Send an order to a vehicle of VDA 5050 and follow it",
                       [command] { return command->run(); });
  options.add("FILE", command->file, "JSON file: an order, instant actions or a zone set")
      .required();
  options.add("--broker", command->request.host, "Host of the MQTT broker").shows_default();
  options.add("--port", command->port, "Port of the broker").shows_default();
  options
      .add("--interface", command->request.vehicle.interface_name,
           "First level of the topics (default: uagv for 2.x, vda5050 for 3.0)")
      .type_name("NAME");
  options
      .add("--manufacturer", command->request.vehicle.manufacturer, "Manufacturer of the vehicle")
      .shows_default();
  options.add("--serial", command->request.vehicle.serial, "Serial number of the vehicle")
      .shows_default();
  options.add("--version", command->version, "Version of VDA 5050")
      .one_of({"2.0.0", "2.1.0", "3.0.0"})
      .shows_default();
  options
      .add("--time-limit", command->time_limit, "Until the order must be done [s] (default: 600)")
      .check(number_between(0.1, 1e6));
  options.add("--json", command->json, "Write the result as JSON; - is standard output")
      .type_name("FILE");
}

}  // namespace fairway::app
