// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/output.hpp"
#include "commands/commands.hpp"
#include "commands/reference/command_reference.hpp"

namespace fairway::app {

namespace {

Expected<int> printed(const std::string& text) {
  if (const auto done = print(text); !done) return tl::unexpected(done.error());
  return kDone;
}

}  // namespace

void add_reference_commands(CommandLine& tool) {
  const auto shell = std::make_shared<std::string>();
  const Options completion = tool.add_command(
      "completion", "Print a script that completes commands and options in a shell",
      [&tool, shell] {
        return printed(*shell == "bash" ? bash_completion(tool.help())
                                        : zsh_completion(tool.help()));
      });
  completion.add("SHELL", *shell, "bash or zsh").required().one_of({"bash", "zsh"});
  completion.footer("For this shell: source <(fairway completion bash)");
  const Options manual = tool.add_command("manual", "Print the manual page, in the format of man",
                                          [&tool] { return printed(manual_page(tool.help())); });
  manual.footer("To read it: fairway manual | man -l -");
}

}  // namespace fairway::app
