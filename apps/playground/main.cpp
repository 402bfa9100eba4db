// SPDX-License-Identifier: Apache-2.0
// What the page's worker calls: a live world with one client, which speaks as `fairway serve` does.
// Texts and bytes are given by address and length; the worker's functions receive the answers.
#include <emscripten.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/io/trace_file.hpp"
#include "fairway/io/whole_file.hpp"
#include "playground/stepped_world.hpp"
#include "server/live_maps.hpp"
#include "server/page_dialogue.hpp"
#include "server/uploads/uploaded_map.hpp"

// clang-format off
EM_JS(void, playground_text, (const char* text, int size), { Module.onText(UTF8ToString(text, size)); })
EM_JS(void, playground_bytes, (const char* bytes, int size), { Module.onBytes(HEAPU8.slice(bytes, bytes + size)); })
EM_JS(void, playground_file, (int request, const char* bytes, int size),
      { Module.onFile(request, HEAPU8.slice(bytes, bytes + size)); })
// clang-format on

namespace fairway::app {

namespace {

int size_of(std::string_view text) { return static_cast<int>(text.size()); }

// The page at the other end.
class PageConnection final : public Connection {
 public:
  void send(std::shared_ptr<const std::string> message, bool binary) override {
    (binary ? playground_bytes : playground_text)(message->data(), size_of(*message));
  }
};

class Playground {
 public:
  explicit Playground(std::vector<MapChoice> choices) : stepped_(std::move(choices), listener()) {
    dialogue_.on_open(page_);
  }

  double advance() { return stepped_.advance(); }
  void receive(std::string_view message) { dialogue_.on_message(page_, message, false); }
  LiveWorld& world() { return stepped_.world(); }

 private:
  LiveListener listener() {
    const auto handed = [this](auto member) {
      return [this, member](auto what) { (dialogue_.*member)(std::move(what)); };
    };
    return {.on_run = handed(&PageDialogue::run),
            .on_records = handed(&PageDialogue::records),
            .on_beginning = handed(&PageDialogue::beginning),
            .on_messages = [](const LiveMessages::Batch&) {},
            .on_state = handed(&PageDialogue::state),
            .on_notice = handed(&PageDialogue::notice),
            .on_refusal = handed(&PageDialogue::refusal)};
  }

  SteppedWorld stepped_;
  PageDialogue dialogue_{stepped_.world()};
  PageConnection page_;
};

std::unique_ptr<Playground> playground;

void send_notice(const std::string& text) {
  const std::string json = nlohmann::json{{"notice", text}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
  playground_text(json.data(), size_of(json));
}

}  // namespace

}  // namespace fairway::app

using namespace fairway;
using namespace fairway::app;

extern "C" {

/// Makes a folder for such files.
EMSCRIPTEN_KEEPALIVE void folder_make(const char* path) {
  std::error_code ignored;
  std::filesystem::create_directories(path, ignored);
}

/// Writes a file that `world_begin` or `run_scenario` reads.
EMSCRIPTEN_KEEPALIVE int file_write(const char* path, const char* bytes, int size) {
  return io::write_file_atomically(path, {bytes, static_cast<std::size_t>(size)}) ? 1 : 0;
}

/// Begins with the built-in maps, and before them the scenario in a file, if its path is not empty.
EMSCRIPTEN_KEEPALIVE void world_begin(const char* scenario_path) {
  std::vector<MapChoice> choices = built_in_maps();
  std::string problem;
  if (*scenario_path != '\0') {
    if (Expected<Scenario> scenario = io::read_scenario(scenario_path)) {
      choices.insert(choices.begin(), {.name = scenario->name,
                                       .make = [given = *scenario] { return given; },
                                       .own_settings = true});
    } else {
      problem = scenario.error().message;
    }
  }
  playground = std::make_unique<Playground>(std::move(choices));
  if (!problem.empty()) send_notice(problem);
}

/// Serves what was asked, and computes a cycle if it is due. @return when to call again [s].
EMSCRIPTEN_KEEPALIVE double world_advance() { return playground->advance(); }

/// A command of the page, as JSON.
EMSCRIPTEN_KEEPALIVE void world_receive(const char* text, int size) {
  playground->receive({text, static_cast<std::size_t>(size)});
}

/// A map that the page uploads; see read_uploaded_map.
EMSCRIPTEN_KEEPALIVE void world_upload(const char* json, int size) {
  Expected<UploadedMap> map = read_uploaded_map({json, static_cast<std::size_t>(size)});
  if (!map) return send_notice(map.error().message);
  if (!playground->world().use_map(scenario_on(map->name, map->map)))
    send_notice("Too many maps are waiting");
}

/// Asks for a file: 0 the recording, 1 the scenario, 2 the report.
EMSCRIPTEN_KEEPALIVE void world_download(int request, int what) {
  playground->world().download(static_cast<LiveWorld::Download>(what),
                               [request](const std::string& bytes) {
                                 playground_file(request, bytes.data(), size_of(bytes));
                               });
}

/// Runs a scenario to its end, and sends its trace as text. Errors are sent as a notice.
EMSCRIPTEN_KEEPALIVE int run_scenario(const char* path) {
  const Expected<Scenario> scenario = io::read_scenario(path);
  if (!scenario) {
    send_notice(scenario.error().message);
    return 0;
  }
  const std::string trace = io::trace_csv(run_episode(*scenario));
  playground_text(trace.data(), size_of(trace));
  return 1;
}

}  // extern "C"
