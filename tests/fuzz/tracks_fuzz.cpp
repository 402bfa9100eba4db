// SPDX-License-Identifier: Apache-2.0
// Reads any text as the tracks of people: every person has a position at every time.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "fairway/io/scenario/tracks_file.hpp"
#include "support/runs/temporary_folder.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fairway::test::TemporaryFolder folder;
  const std::string file = folder.write("t.txt", std::string(data, data + size));
  const auto bodies = fairway::io::read_tracks(file);
  if (!bodies) {
    if (bodies.error().message.find('\n') != std::string::npos) std::abort();
    return 0;
  }
  for (const fairway::MovingBody& body : *bodies) {
    for (const double time : {-1.0, 0.0, 0.1, 1e3}) {
      const fairway::MovingObstacle there = body.at(time);
      if (!there.position.allFinite() || !there.velocity.allFinite()) std::abort();
    }
  }
  return 0;
}
