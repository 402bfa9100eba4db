// SPDX-License-Identifier: Apache-2.0
#include "fairway/io/recording/recording.hpp"

#include <utility>

namespace fairway::io {

std::uint16_t Recording::add_channel(const McapChannel& channel) {
  return writer_.add_channel(channel);
}

bool Recording::wants(std::uint16_t /*channel*/) const { return true; }

void Recording::write(std::uint16_t channel, std::uint64_t time, std::string_view message) {
  writer_.write(channel, time, message);
}

RecordingFile::RecordingFile(std::unique_ptr<AsideFile> file)
    : file_(std::move(file)),
      messages_(recording_),
      observer_(*this) {}

Expected<std::unique_ptr<RecordingFile>> RecordingFile::create(const std::string& path) {
  auto file = AsideFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return std::unique_ptr<RecordingFile>(new RecordingFile(*std::move(file)));
}

Expected<void> RecordingFile::close() {
  recording_.finish();
  file_->write(recording_.take());
  return file_->commit();
}

void RecordingFile::Spill::on_start(const Scenario& scenario) {
  file_.messages_.on_start(scenario);
}

void RecordingFile::Spill::on_navigators(double time,
                                         const Settings& settings,
                                         std::span<const NavigatorStart> starts) {
  file_.messages_.on_navigators(time, settings, starts);
}

void RecordingFile::Spill::on_goal(double time, std::size_t robot, const Goal& goal) {
  file_.messages_.on_goal(time, robot, goal);
}

void RecordingFile::Spill::on_scan(const ObservedScan& scan) { file_.messages_.on_scan(scan); }

void RecordingFile::Spill::on_plan(double time, std::size_t robot, const Plan& plan) {
  file_.messages_.on_plan(time, robot, plan);
}

void RecordingFile::Spill::on_cycle(const NavigationCycle& cycle) {
  file_.messages_.on_cycle(cycle);
}

void RecordingFile::Spill::on_world(const WorldView& world) {
  file_.messages_.on_world(world);
  file_.file_->write(file_.recording_.take());
}

}  // namespace fairway::io
