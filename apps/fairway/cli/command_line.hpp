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

/// Returns the error in the text of a value, as "expected ..., found ..."; empty for a valid text.
using Check = std::function<std::string(const std::string& text)>;

/// One argument or option of a command; each call adds one property.
class Argument {
 public:
  explicit Argument(CLI::Option& option) noexcept : option_(&option) {}

  Argument required() const;
  /// Sets the name of the value in the help.
  Argument type_name(const std::string& name) const;
  Argument one_of(const std::vector<std::string>& values) const;
  Argument between(int low, int high) const;
  Argument not_negative() const;
  /// @param in_help  Shown after the type in the help, as in INT:INT in [1 - 5]; empty: nothing.
  Argument check(const Check& problem, const std::string& in_help = {}) const;
  /// Shows the default value in the help.
  Argument shows_default() const;
  /// Takes one value per occurrence of an option that may be repeated.
  Argument one_at_a_time() const;

 private:
  CLI::Option* option_;
};

/// The arguments and options of one command. Only this file's source includes CLI11: its headers
/// take six seconds to compile, nine to precompile, and then one for each source that loads them.
class Options {
 public:
  explicit Options(CLI::App& command) noexcept : command_(&command) {}

  /// Adds an option if the name begins with dashes, else an argument. Parsing sets `value`, which
  /// must live until then.
  Argument add(const char* name, std::string& value, const char* help) const;
  Argument add(const char* name, std::vector<std::string>& values, const char* help) const;
  Argument add(const char* name, int& value, const char* help) const;
  Argument add(const char* name, std::uint16_t& value, const char* help) const;
  Argument add(const char* name, std::optional<int>& value, const char* help) const;
  Argument add(const char* name, std::optional<double>& value, const char* help) const;
  /// Adds an option without a value.
  void add_flag(const char* name, bool& value, const char* help) const;
  /// Accepts any further arguments and options, for a command that only explains why it cannot run.
  void take_anything() const;
  /// Sets the text below the options in the help.
  void footer(const std::string& text) const;

 private:
  CLI::App* command_;
};

/// Exit codes of the tool, on which scripts rely.
inline constexpr int kDone = 0;      ///< the task is done
inline constexpr int kFailed = 1;    ///< the input is valid, but the task failed
inline constexpr int kBadInput = 2;  ///< bad usage or bad input; the Error says which

/// The work of a command: returns an exit code, or the error behind kBadInput.
using Work = std::function<Expected<int>()>;

[[nodiscard]] const char* tool_version() noexcept;

/// Returns the words of the process's command line, the tool's name first. Results name it in their
/// provenance.
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

/// The tool with its commands; the command line selects one.
class CommandLine {
 public:
  CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;
  ~CommandLine();

  Options add_command(const char* name, const std::string& help, Work work);

  /// All commands as help has them, sorted by name; for manual pages and completion.
  [[nodiscard]] std::vector<CommandHelp> help() const;

  /// Runs the selected command, or prints the help or an error. @return the exit code.
  [[nodiscard]] int run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> tool_;
  Work chosen_;
};

}  // namespace fairway::app
