// SPDX-License-Identifier: Apache-2.0
#include "cli/left_out.hpp"

namespace fairway::app {

std::string left_out(const char* packages) {
  return std::string("which this build left out; to get it: tools/install_packages.sh ") +
         packages + " && cmake --preset release && cmake --build --preset release";
}

void add_left_out_command(CommandLine& tool,
                          const char* name,
                          const char* help,
                          const char* packages) {
  const auto work = [name, packages]() -> Expected<int> {
    return fail(std::string("expected a command of this build, found ") + name + ", " +
                left_out(packages));
  };
  tool.add_command(name, std::string(help) + " (left out of this build)", work).take_anything();
}

}  // namespace fairway::app
