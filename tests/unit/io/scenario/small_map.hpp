// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/runs/temporary_folder.hpp"

namespace fairway::test {

// Writes a free map of 10 m by 5 m.
inline void write_map(const TemporaryFolder& folder) {
  folder.write("m.pgm", "P5 10 5 255\n" + std::string(50, '\xff'));
  folder.write("m.yaml",
               "image: m.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
               "free_thresh: 0.196\n");
}

}  // namespace fairway::test
