// SPDX-License-Identifier: Apache-2.0
// Changes values of a recording, and omits or repeats messages. The page and the replayed
// navigators refuse it or play it.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fairway/io/recording/reading/recording_reader.hpp"
#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/run_stream.hpp"
#include "fairway/simulation/recorded/observer_list.hpp"
#include "fairway/simulation/recorded/replay_check.hpp"
#include "fuzz/byte_source.hpp"
#include "support/runs/changed_recording.hpp"

namespace {

using namespace fairway;
using Json = test::ChangedRecording::Json;

Json another_value(test::ByteSource& source, const Json& value) {
  switch (source.integer(0, 7)) {
    case 0:
      return source.number();
    case 1:
      return source.integer(-2, 300);
    case 2:
      return value.is_number() ? Json(value.get<double>() + source.usual(-3.0, 3.0)) : Json("NaN");
    case 3:
      return value.is_number() ? Json(value.get<double>() * source.usual(-100.0, 100.0)) : Json("");
    case 4:
      return source.chance(0.5) ? "NaN" : "-Infinity";
    case 5:
      return Json::array();
    case 6:
      return source.chance(0.5);
    default:
      return nullptr;
  }
}

// Selects some value and changes it.
void change(test::ByteSource& source, Json& json) {
  Json* at = &json;
  while (at->is_structured() && !at->empty() && !source.chance(0.03)) {
    auto child = at->begin();
    std::advance(child,
                 source.integer(0, static_cast<int>(std::min<std::size_t>(at->size(), 5000)) - 1));
    at = &*child;
  }
  if (at->is_array() && !at->empty() && source.chance(0.5)) {
    at->push_back(at->back());
  } else if (at->is_string() && !at->get_ref<std::string&>().empty() && source.chance(0.5)) {
    auto& text = at->get_ref<std::string&>();
    text[static_cast<std::size_t>(source.integer(0, 65535)) % text.size()] =
        static_cast<char>(source.integer(32, 126));
  } else {
    *at = another_value(source, *at);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::ChangedRecording by_map = test::short_recording(Sensing::Map);
  static const test::ChangedRecording by_lidar = test::short_recording(Sensing::Lidar);
  test::ByteSource source(data, size);
  test::ChangedRecording run = source.chance(0.5) ? by_map : by_lidar;
  while (source.left() && !run.messages.empty()) {
    const auto at = static_cast<std::size_t>(source.integer(0, 255)) % run.messages.size();
    if (source.chance(0.05)) {
      run.messages.erase(run.messages.begin() + static_cast<std::ptrdiff_t>(at));
    } else if (source.chance(0.05)) {
      run.messages.push_back(run.messages[at]);
    } else {
      change(source, run.messages[at].content);
    }
  }
  ReplayCheck check;
  io::RunStream stream;
  ObserverList observers;
  observers.add(check);
  observers.add(stream);
  const auto read = io::read_recording(run.bytes(), "r.mcap", observers);
  if (!read && read.error().message.find('\n') != std::string::npos) std::abort();
  return 0;
}
