// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "fairway/base/error.hpp"
#include "fairway/io/aside_file.hpp"
#include "fairway/io/recording/run_messages.hpp"

namespace fairway::io {

/// A recording in memory: all messages of `RunMessages`, as MCAP.
class Recording final : public MessageSink {
 public:
  std::uint16_t add_channel(const McapChannel& channel) override;
  [[nodiscard]] bool wants(std::uint16_t channel) const override;
  void write(std::uint16_t channel, std::uint64_t time, std::string_view message) override;

  /// The bytes that are ready since the last call.
  [[nodiscard]] std::string take() { return writer_.take(); }
  void finish() { writer_.finish(); }
  [[nodiscard]] const McapWriter& writer() const noexcept { return writer_; }

 private:
  McapWriter writer_;
};

/// Records a run into a file while it happens, for `--log FILE.mcap`. The file is written aside and
/// gets its name when it is whole; see AsideFile.
///
///     auto file = RecordingFile::create(path);        // an error if it cannot be written
///     run_episode(scenario, {.observer = &file->observer()});
///     if (auto closed = file->close(); !closed) ...
class RecordingFile {
 public:
  [[nodiscard]] static Expected<std::unique_ptr<RecordingFile>> create(const std::string& path);

  [[nodiscard]] EpisodeObserver& observer() noexcept { return observer_; }

  /// Writes the rest and the index, and names the file. Without it there is no file.
  [[nodiscard]] Expected<void> close();

 private:
  // Passes all events on, and writes the bytes that are ready to the file.
  class Spill final : public EpisodeObserver {
   public:
    explicit Spill(RecordingFile& file) : file_(file) {}
    void on_start(const Scenario& scenario) override;
    void on_navigators(double time,
                       const Settings& settings,
                       std::span<const NavigatorStart> starts) override;
    void on_goal(double time, std::size_t robot, const Goal& goal) override;
    void on_scan(const ObservedScan& scan) override;
    void on_plan(double time, std::size_t robot, const Plan& plan) override;
    void on_cycle(const NavigationCycle& cycle) override;
    void on_world(const WorldView& world) override;

   private:
    RecordingFile& file_;
  };

  explicit RecordingFile(std::unique_ptr<AsideFile> file);

  std::unique_ptr<AsideFile> file_;
  Recording recording_;
  RunMessages messages_;
  Spill observer_;
};

}  // namespace fairway::io
