// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "support/runs/temporary_folder.hpp"

namespace fairway::test {

/// The result of a run of the tool.
struct ToolRun {
  int code = -1;  ///< exit code; -1 after a signal
  std::string out;
  std::string err;
};

/// Runs `fairway ARGUMENTS` as a shell would, from `folder`.
inline ToolRun run_tool(const TemporaryFolder& folder, const std::string& arguments) {
  const TemporaryFolder captured;
  const std::string command = "cd '" + folder.path("") + "' && '" FAIRWAY_TOOL "' " + arguments +
                              " > '" + captured.path("out") + "' 2> '" + captured.path("err") + "'";
  const int status = std::system(command.c_str());
  return {.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
          .out = content_of(captured.path("out")),
          .err = content_of(captured.path("err"))};
}

/// Writes room.yaml and room.pgm: a room of 8 m by 4 m in cells of 0.1 m. A wall at x = 4 leaves a
/// gap of 1 m in the middle.
inline void write_room(const TemporaryFolder& folder) {
  std::string pixels;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 80; ++x) {
      const bool border = x == 0 || y == 0 || x == 79 || y == 39;
      const bool wall = (x == 40 || x == 41) && (y < 15 || y >= 25);
      pixels += border || wall ? '\0' : '\xfe';
    }
  }
  folder.write("room.pgm", "P5\n80 40\n255\n" + pixels);
  folder.write("room.yaml",
               "image: room.pgm\nmode: trinary\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
               "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
}

inline std::ptrdiff_t count_lines(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace fairway::test
