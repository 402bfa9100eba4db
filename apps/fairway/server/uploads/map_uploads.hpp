// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "fairway/base/error.hpp"
#include "fairway/simulation/scenario.hpp"

namespace fairway::app {

/// Decodes uploaded maps one after another in a thread of its own, so that the network's thread
/// serves other clients meanwhile. Few may wait, which bounds the memory.
class MapUploads {
 public:
  /// Takes over a decoded map with a robot on it, from the thread; false where it cannot.
  using Use = std::function<bool(Scenario scenario)>;

  /// How an upload ended, from the thread.
  enum class Outcome : std::uint8_t { Used, Refused, Busy };
  using Done = std::function<void(Outcome outcome, std::string reason)>;

  explicit MapUploads(Use use);
  ~MapUploads();
  MapUploads(const MapUploads&) = delete;
  MapUploads& operator=(const MapUploads&) = delete;

  /// Queues an upload; false, and nothing happens, where as many as may be are waiting.
  /// @param json  As read_uploaded_map reads it.
  [[nodiscard]] bool add(std::string json, Done done);

 private:
  struct Upload {
    std::string json;
    Done done;
  };

  void run(const std::stop_token& stop);
  void decode(Upload upload) const;

  Use use_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Upload> waiting_;  // guarded by mutex_
  std::jthread thread_;
};

}  // namespace fairway::app
