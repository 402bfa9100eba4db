// SPDX-License-Identifier: Apache-2.0
// Reads any text as a scenario file: a valid scenario reads back from its own archive, and some
// cycles of it can be driven.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fairway/io/recording/exact/scenario_archive.hpp"
#include "fairway/io/scenario/scenario_file.hpp"
#include "fairway/simulation/episode.hpp"
#include "support/runs/temporary_folder.hpp"

namespace {

constexpr int kCycles = 3;

void write_map(const fairway::test::TemporaryFolder& folder) {
  std::string pixels;
  for (int i = 0; i < 60 * 40; ++i)
    pixels += i % 60 == 30 && i / 60 > 10 ? '\0' : '\xfe';
  folder.write("m.pgm", "P5\n60 40\n255\n" + pixels);
  folder.write("m.yaml",
               "image: m.pgm\nresolution: 0.1\norigin: [-1, -1, 0]\nnegate: 0\n"
               "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  folder.write("t.txt", "0 1 0.5 0 0.5 0 0 0\n10 1 1.5 0 0.5 0 0 0\n");
}

void drive(const fairway::Scenario& scenario) {
  if (scenario.robots.size() > 4 || scenario.bodies.size() > 20) return;
  int cycles = 0;
  static_cast<void>(fairway::run_episode(
      scenario, {.clock = {}, .on_cycle = [&](double) { return ++cycles < kCycles; }, .play = {}}));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fairway::test::TemporaryFolder folder;
  static const bool written = (write_map(folder), true);
  static_cast<void>(written);
  const std::string file = folder.write("s.yaml", std::string(data, data + size));
  const auto scenario = fairway::io::read_scenario(file);
  if (!scenario) {
    if (scenario.error().message.find('\n') != std::string::npos) std::abort();
    return 0;
  }
  const auto files = fairway::io::scenario_files(*scenario);
  static const fairway::test::TemporaryFolder archive;
  for (const auto& [name, content] : files)
    archive.write(name, content);
  const auto again = fairway::io::read_scenario(archive.path("scenario.yaml"));
  if (!again || fairway::io::scenario_files(*again).front().content != files.front().content)
    std::abort();
  drive(*scenario);
  return 0;
}
