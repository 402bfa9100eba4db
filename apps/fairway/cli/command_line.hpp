// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fairway/base/error.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fairway::app {

/// What is wrong with the text of a value, as "expected ..., found ..."; empty where nothing is.
using Check = std::function<std::string(const std::string& text)>;

/// One argument or option of a command; each call tells one more thing about it.
class Argument {
 public:
  explicit Argument(CLI::Option& option) noexcept : option_(&option) {}

  Argument required() const;
  /// What help calls its value.
  Argument type_name(const std::string& name) const;
  Argument one_of(const std::vector<std::string>& values) const;
  Argument between(int low, int high) const;
  Argument not_negative() const;
  /// @param in_help  What help says beside the type, as in INT:INT in [1 - 5]; empty: nothing.
  Argument check(const Check& problem, const std::string& in_help = {}) const;
  /// Help tells the value that it has without being given.
  Argument shows_default() const;
  /// Takes one value each time it is given, where it may be given several times.
  Argument one_at_a_time() const;

 private:
  CLI::Option* option_;
};

/// The arguments and options of one command. CLI11 is behind this file alone: its headers take six
/// seconds to compile, nine to precompile, and then one for each source that loads them.
class Options {
 public:
  explicit Options(CLI::App& command) noexcept : command_(&command) {}

  /// An option where the name begins with dashes, else an argument; parsing sets `value`, which
  /// must live until then.
  Argument add(const char* name, std::string& value, const char* help) const;
  Argument add(const char* name, std::vector<std::string>& values, const char* help) const;
  Argument add(const char* name, int& value, const char* help) const;
  Argument add(const char* name, std::uint16_t& value, const char* help) const;
  Argument add(const char* name, std::optional<int>& value, const char* help) const;
  Argument add(const char* name, std::optional<double>& value, const char* help) const;
  /// An option without a value.
  void add_flag(const char* name, bool& value, const char* help) const;
  /// Takes any further arguments and options, for a command that only tells why it cannot work.
  void take_anything() const;
  /// What help says below the options.
  void footer(const std::string& text) const;

 private:
  CLI::App* command_;
};

/// Exit codes of the tool: what scripts rely on.
inline constexpr int kDone = 0;      ///< the task was carried out
inline constexpr int kFailed = 1;    ///< the task is sound but has no answer
inline constexpr int kBadInput = 2;  ///< bad usage or bad input; an Error tells which

/// The work of a command: gives an exit code, or the error behind kBadInput.
using Work = std::function<Expected<int>()>;

[[nodiscard]] const char* tool_version() noexcept;

/// The words of the command line that this process was started with, the tool's name first; for
/// results that say how they were made.
[[nodiscard]] const std::vector<std::string>& given_command_line() noexcept;

/// What help says about an argument or option of a command.
struct OptionHelp {
  std::string name;  ///< "--json" or, for an argument, "MAP"
  std::string type;  ///< of its value: "FILE"
  std::string help;
  std::vector<std::string> values{};  ///< if only these are allowed
  bool takes_value = true;
};

/// What help says about a command.
struct CommandHelp {
  std::string name;
  std::string help;
  std::string footer;
  std::vector<OptionHelp> options;  ///< arguments first
};

/// The tool with its commands, one of which is chosen on the command line.
class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine();

  Options add_command(const char* name, const std::string& help, Work work);

  /// All commands as help has them, sorted by name; for manual pages and completion.
  [[nodiscard]] std::vector<CommandHelp> help() const;

  /// Runs the command that was chosen, or prints help or what is wrong. @return the exit code.
  [[nodiscard]] int run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> tool_;
  Work chosen_;
};

}  // namespace fairway::app
