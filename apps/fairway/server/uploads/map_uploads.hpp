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

/// Decodes uploaded maps one after another in its own thread. The network's thread meanwhile serves
/// other clients. Few uploads may wait, which bounds the memory.
class MapUploads {
 public:
  /// Receives a decoded map with a robot on it, in the decoding thread; returns false if it cannot
  /// be used.
  using Use = std::function<bool(Scenario scenario)>;

  /// Receives how an upload ended, in the decoding thread.
  enum class Outcome : std::uint8_t { Used, Refused, Busy };
  using Done = std::function<void(Outcome outcome, std::string reason)>;

  explicit MapUploads(Use use);
  ~MapUploads();
  MapUploads(const MapUploads&) = delete;
  MapUploads& operator=(const MapUploads&) = delete;

  /// Queues an upload. Returns false, and does nothing, if too many are waiting.
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
