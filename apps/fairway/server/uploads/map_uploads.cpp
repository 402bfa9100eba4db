// SPDX-License-Identifier: Apache-2.0
#include "server/uploads/map_uploads.hpp"

#include <exception>
#include <utility>

#include "server/live_maps.hpp"
#include "server/uploads/uploaded_map.hpp"

namespace fairway::app {

namespace {

constexpr std::size_t kMostWaiting = 2;  // uploads of up to 24 MB each

}  // namespace

MapUploads::MapUploads(Use use)
    : use_(std::move(use)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

MapUploads::~MapUploads() {
  thread_.request_stop();
  thread_.join();
}

bool MapUploads::add(std::string json, Done done) {
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() >= kMostWaiting) return false;
    waiting_.push_back({.json = std::move(json), .done = std::move(done)});
  }
  wake_.notify_one();
  return true;
}

void MapUploads::run(const std::stop_token& stop) {
  while (true) {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, stop, [this] { return !waiting_.empty(); })) return;
    if (stop.stop_requested()) return;
    Upload upload = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    decode(std::move(upload));
  }
}

void MapUploads::decode(Upload upload) const {
  try {
    Expected<UploadedMap> map = read_uploaded_map(std::exchange(upload.json, {}));
    if (!map) return upload.done(Outcome::Refused, map.error().message);
    const bool used = use_(scenario_on(map->name, map->map));
    upload.done(used ? Outcome::Used : Outcome::Busy, "");
  } catch (const std::exception& error) {  // out of memory
    upload.done(Outcome::Refused, std::string("expected a map, found: ") + error.what());
  }
}

}  // namespace fairway::app
