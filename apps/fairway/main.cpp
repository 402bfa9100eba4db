// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <exception>
#include <new>

#include "cli/output.hpp"
#include "commands/commands.hpp"

namespace {

using namespace fairway::app;

int run(int argc, char** argv) {
  CommandLine tool;
  add_plan_command(tool);
  add_simulate_command(tool);
  add_solve_command(tool);
  add_replay_command(tool);
  add_reproduce_command(tool);
  add_serve_command(tool);
  add_settings_command(tool);
  add_order_command(tool);
  add_barn_command(tool);
  add_dynabarn_command(tool);
  add_bodies_command(tool);
  add_parking_command(tool);
  add_people_command(tool);
  add_compare_command(tool);
  add_statuses_command(tool);
  add_reference_commands(tool);
  add_merge_command(tool);
  return tool.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that closes the pipe early must not end the process with a signal, as in `fairway
  // settings | head`.
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
