// SPDX-License-Identifier: Apache-2.0
// write_synthetic_run RUN.mcap RUN.html ROBOTS SECONDS MAP_SIDE
#include <cstdio>
#include <cstdlib>
#include <span>

#include "fairway/io/recording/recording.hpp"
#include "fairway/io/web_report/report.hpp"
#include "fairway/io/whole_file.hpp"
#include "synthetic_run.hpp"

int main(int argc, char** argv) {
  const std::span<char*> arguments(argv, static_cast<std::size_t>(argc));
  if (arguments.size() != 6) {
    std::fputs("write_synthetic_run RUN.mcap RUN.html ROBOTS SECONDS MAP_SIDE\n", stderr);
    return 2;
  }
  const fairway::test::SyntheticRun run{.robots = std::atoi(arguments[3]),
                                        .bodies = 2,
                                        .seconds = std::atof(arguments[4]),
                                        .map_side = std::atoi(arguments[5]),
                                        .rectangular = true};
  auto file = fairway::io::RecordingFile::create(arguments[1]);
  if (!file) return 1;
  run.play((*file)->observer());
  fairway::io::Report report;
  run.play(report.observer());
  const bool done = (*file)->close().has_value() &&
                    fairway::io::write_file_atomically(arguments[2], report.page()).has_value();
  return done ? 0 : 1;
}
