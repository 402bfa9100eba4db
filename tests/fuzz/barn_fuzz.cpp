// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as BARN's and DynaBARN's list of worlds: a valid list makes a scenario.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "experiments/barn/barn_file.hpp"
#include "support/runs/temporary_folder.hpp"

namespace {

void check(const fairway::Expected<std::vector<fairway::BarnWorld>>& worlds) {
  if (!worlds) {
    if (worlds.error().message.find('\n') != std::string::npos) std::abort();
    return;
  }
  for (const fairway::BarnWorld& world : *worlds) {
    const fairway::Scenario scenario = fairway::barn_scenario(world, {}, 0);
    if (scenario.robots.size() != 1 || !is_finite(scenario.robots.front().start)) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fairway::test::TemporaryFolder folder;
  folder.write("m.yaml",
               "image: m.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\n"
               "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  folder.write("m.pgm", "P5\n3 2\n255\n\xfe\xfe\xfe\xfe\xfe\xfe");
  const std::string file = folder.write("barn.json", std::string(data, data + size));
  check(fairway::io::read_barn(folder.path(""), {}));
  check(fairway::io::read_dynabarn(file, {}));
  return 0;
}
