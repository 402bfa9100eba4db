// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "command.hpp"
#include "output.hpp"
#include "replay_command.hpp"
#ifdef FAIRWAY_HAS_REPRODUCTION
#include "reproduce_command.hpp"
#endif
#ifdef FAIRWAY_HAS_SERVER
#include "serve_command.hpp"
#endif

namespace {

using namespace fairway::app;

int run(int argc, char** argv) {
  CLI::App tool("Safe corridors and model predictive control for wheeled robots.", "fairway");
  tool.set_version_flag("--version", "fairway " FAIRWAY_VERSION);
  tool.require_subcommand(1);
  tool.footer("Exit codes: 0 done, 1 the task failed, 2 bad usage or bad input.");
  Command chosen;
  add_plan_command(tool, chosen);
  add_simulate_command(tool, chosen);
  add_solve_command(tool, chosen);
  add_replay_command(tool, chosen);
#ifdef FAIRWAY_HAS_REPRODUCTION
  add_reproduce_command(tool, chosen);
#endif
#ifdef FAIRWAY_HAS_SERVER
  add_serve_command(tool, chosen);
#endif
  add_settings_command(tool, chosen);
  add_barn_command(tool, chosen);
  add_dynabarn_command(tool, chosen);
  if (argc > 1 && names_no_command(tool, argv[1])) {
    print_error(std::string("expected a command, see fairway --help; found ") + argv[1]);
    return kBadInput;
  }
  try {
    tool.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return tool.exit(success);
  } catch (const CLI::ParseError& error) {
    print_error(error.what());
    return kBadInput;
  }
  const fairway::Expected<int> code = chosen();
  if (code) return *code;
  print_error(code.error().message);
  return kBadInput;
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that goes away early, as in `fairway settings | head`, is no reason to die.
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    print_error("expected a task that fits into memory, found one that does not");
  } catch (const std::exception& error) {
    print_error(error.what());
  } catch (...) {
    print_error("failed for an unknown reason");
  }
  return kBadInput;
}
