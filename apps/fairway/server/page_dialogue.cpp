// SPDX-License-Identifier: Apache-2.0
#include "server/page_dialogue.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace fairway::app {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostStretches = 6;

std::shared_ptr<const std::string> dumped(const Json& json) {
  return shared(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

void PageDialogue::on_open(Connection& connection) {
  connections_.emplace(&connection, next_client_++);
  if (state_) connection.send(state_, false);
  if (past_.empty()) return;
  connection.send(past_.front().beginning, true);
  for (const Stretch& stretch : past_) {
    if (!stretch.records.empty()) connection.send(shared(stretch.records), true);
  }
}

void PageDialogue::on_message(Connection& connection, std::string_view message, bool binary) {
  Expected<ClientCommand> command = binary ? fail("expected text") : parse_command(message);
  if (command) {
    world_.ask(*std::move(command), connections_.at(&connection));
  } else {
    connection.send(dumped({{"notice", command.error().message}}), false);
  }
}

void PageDialogue::on_closed(Connection& connection) { connections_.erase(&connection); }

void PageDialogue::run(std::string records) {
  past_.clear();
  beginning(records);
  send_all(past_.back().beginning, true);
}

void PageDialogue::records(std::string records) {
  if (past_.empty()) return;
  past_.back().records += records;
  send_all(shared(std::move(records)), true);
}

void PageDialogue::beginning(std::string records) {
  past_.push_back({.beginning = shared(std::move(records)), .records = {}});
  if (past_.size() > kMostStretches) past_.pop_front();
}

void PageDialogue::state(const LiveState& state) {
  state_ =
      dumped({{"state",
               {{"paused", state.paused},
                {"speed", state.speed},
                {"map", state.map},
                {"maps", state.maps},
                {"halted", state.halted},
                {"waiting", state.waiting},
                {"edited", state.edited},
                {"undo", state.undo},
                {"redo", state.redo},
                {"sensing", setting_names(state.sensing)[static_cast<std::size_t>(state.sensing)]},
                {"noise", setting_names(state.noise)[static_cast<std::size_t>(state.noise)]}}}});
  send_all(state_, false);
}

void PageDialogue::notice(const std::string& text) { send_all(dumped({{"notice", text}}), false); }

void PageDialogue::refusal(const Refusal& refusal) {
  Json json{{"text", refusal.text}};
  if (refusal.at) json["at"] = {{"x", refusal.at->x()}, {"y", refusal.at->y()}};
  if (!refusal.settings.empty()) json["settings"] = refusal.settings;
  for (const auto& [connection, client] : connections_) {
    if (client == refusal.client) connection->send(dumped({{"refused", json}}), false);
  }
}

void PageDialogue::send_all(const Bytes& message, bool binary) {
  for (const auto& [connection, client] : connections_)
    connection->send(message, binary);
}

}  // namespace fairway::app
