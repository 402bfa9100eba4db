// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "cli/output.hpp"
#include "fairway/io/number_text.hpp"

namespace fairway::app {

namespace {

// Whether a first argument is neither an option nor a command. (CLI11 would report a missing
// command instead of the wrong one.)
bool names_no_command(const CLI::App& tool, const std::string& word) {
  if (word.starts_with('-')) return false;
  const auto commands = tool.get_subcommands([](const CLI::App* /*command*/) { return true; });
  return std::none_of(commands.begin(), commands.end(),
                      [&](const CLI::App* command) { return command->check_name(word); });
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : between) + word;
  return text;
}

// What a command adds to the footer of the tool.
std::string own_footer(const CLI::App& command, const std::string& of_tool) {
  std::string footer = command.get_footer();
  if (footer.ends_with(of_tool)) footer.resize(footer.size() - of_tool.size());
  if (footer.ends_with('\n')) footer.pop_back();
  return footer;
}

// What is wrong with the arguments, in the words of the tool.
std::string problem_of(const CLI::ParseError& error, const CLI::App& tool) {
  std::string command = tool.get_name();
  for (const CLI::App* chosen : tool.get_subcommands())
    command += " " + chosen->get_name();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    return fmt::format("expected the arguments that {} --help lists, found {}", command,
                       io::excerpt(joined(tool.remaining(true), " ")));
  }
  const std::string text = error.what();
  constexpr std::string_view kRequired = " is required";
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && text.ends_with(kRequired)) {
    return fmt::format("{}: expected a value, see {} --help; found none",
                       text.substr(0, text.size() - kRequired.size()), command);
  }
  return text;
}

// An empty value is usually that of a variable which was not set. Taken as if the option were not
// there, it would lose a recording, or settings.
std::string problem_of_value(const std::string& text) {
  return text.empty() ? "expected a value, found an empty one" : "";
}

// Of the one command that a process carries out.
std::vector<std::string>& command_line_words() {
  static std::vector<std::string> words;
  return words;
}

}  // namespace

Argument Argument::required() const {
  option_->required();
  return *this;
}

Argument Argument::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

Argument Argument::one_of(const std::vector<std::string>& values) const {
  const auto problem = [values](const std::string& text) {
    if (std::find(values.begin(), values.end(), text) != values.end()) return std::string();
    return "expected " + joined(values, " or ") + ", found " + io::excerpt(text);
  };
  return check(problem, "{" + joined(values, ",") + "}");
}

Argument Argument::between(int low, int high) const {
  const auto problem = [low, high](const std::string& text) {
    const std::optional<int> value = io::parse_integer(text);
    if (value && *value >= low && *value <= high) return std::string();
    return fmt::format("expected an integer from {} to {}, found {}", low, high, io::excerpt(text));
  };
  return check(problem, fmt::format("INT in [{} - {}]", low, high));
}

Argument Argument::not_negative() const {
  const auto problem = [](const std::string& text) {
    const std::optional<int> value = io::parse_integer(text);
    if (value && *value >= 0) return std::string();
    return "expected an integer from 0 on, found " + io::excerpt(text);
  };
  return check(problem, "NONNEGATIVE");
}

Argument Argument::check(const Check& problem, const std::string& in_help) const {
  option_->check(CLI::Validator([problem](std::string& text) { return problem(text); }, in_help));
  return *this;
}

Argument Argument::shows_default() const {
  option_->capture_default_str();
  return *this;
}

Argument Argument::one_at_a_time() const {
  option_->allow_extra_args(false);
  return *this;
}

Argument Options::add(const char* name, std::string& value, const char* help) const {
  return Argument(*command_->add_option(name, value, help)).check(problem_of_value, "");
}

Argument Options::add(const char* name, std::vector<std::string>& values, const char* help) const {
  return Argument(*command_->add_option(name, values, help)).check(problem_of_value, "");
}

Argument Options::add(const char* name, int& value, const char* help) const {
  return Argument(*command_->add_option(name, value, help));
}

Argument Options::add(const char* name, std::uint16_t& value, const char* help) const {
  return Argument(*command_->add_option(name, value, help));
}

Argument Options::add(const char* name, std::optional<int>& value, const char* help) const {
  return Argument(*command_->add_option(name, value, help));
}

Argument Options::add(const char* name, std::optional<double>& value, const char* help) const {
  return Argument(*command_->add_option(name, value, help));
}

void Options::add_flag(const char* name, bool& value, const char* help) const {
  command_->add_flag(name, value, help);
}

void Options::take_anything() const { command_->allow_extras(); }

void Options::footer(const std::string& text) const {
  command_->footer(text + '\n' + command_->get_footer());  // which begins as that of the tool
}

const char* tool_version() noexcept { return FAIRWAY_VERSION; }

const std::vector<std::string>& given_command_line() noexcept { return command_line_words(); }

CommandLine::CommandLine()
    : tool_(std::make_unique<CLI::App>(
          "Safe corridors and model predictive control for wheeled robots.", "fairway")) {
  tool_->set_version_flag("--version", std::string("fairway ") + tool_version());
  tool_->require_subcommand(1);
  tool_->footer(
      "Exit codes: 0 done, 1 the task failed, 2 bad usage or bad input.\n"
      "Documents: docs/command_line.md and docs/README.md in the sources, share/doc/fairway where "
      "they are installed.");
}

CommandLine::~CommandLine() = default;

Options CommandLine::add_command(const char* name, const std::string& help, Work work) {
  CLI::App* command = tool_->add_subcommand(name, help);
  command->callback([this, work = std::move(work)] { chosen_ = work; });
  return Options(*command);
}

std::vector<CommandHelp> CommandLine::help() const {
  std::vector<CommandHelp> commands;
  for (const CLI::App* app :
       tool_->get_subcommands([](const CLI::App* /*command*/) { return true; })) {
    CommandHelp command{.name = app->get_name(),
                        .help = app->get_description(),
                        .footer = own_footer(*app, tool_->get_footer()),
                        .options = {}};
    for (const CLI::Option* option : app->get_options()) {
      OptionHelp one{.name = option->get_name(),
                     .type = option->get_type_name(),
                     .help = option->get_description(),
                     .values = {},
                     .takes_value = option->get_items_expected_max() > 0};
      if (one.name == "--help" || one.name == "-h,--help") continue;
      // "TEXT:{map,lidar}": Argument::one_of has added the values.
      const std::size_t open = one.type.find('{');
      if (open != std::string::npos && one.type.ends_with('}')) {
        std::istringstream list(one.type.substr(open + 1, one.type.size() - open - 2));
        for (std::string value; std::getline(list, value, ',');)
          one.values.push_back(value);
      }
      // Without what a check has added: "INT:INT in [1 - 5]".
      one.type =
          one.values.empty() ? one.type.substr(0, one.type.find(':')) : one.type.substr(open);
      command.options.push_back(std::move(one));
    }
    std::stable_partition(command.options.begin(), command.options.end(),
                          [](const OptionHelp& one) { return !one.name.starts_with('-'); });
    commands.push_back(std::move(command));
  }
  std::sort(commands.begin(), commands.end(),
            [](const CommandHelp& a, const CommandHelp& b) { return a.name < b.name; });
  return commands;
}

int CommandLine::run(int argc, char** argv) {
  command_line_words() = {"fairway"};
  command_line_words().insert(command_line_words().end(), argv + std::min(argc, 1), argv + argc);
  if (argc > 1 && names_no_command(*tool_, argv[1])) {
    print_error(std::string("expected a command, see fairway --help; found ") + argv[1]);
    return kBadInput;
  }
  try {
    tool_->parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return tool_->exit(success);
  } catch (const CLI::ParseError& error) {
    print_error(problem_of(error, *tool_));
    return kBadInput;
  }
  const Expected<int> code = chosen_();
  if (code && *code != kBadInput) print_warnings();
  if (code) return *code;
  print_error(code.error().message);
  return kBadInput;
}

}  // namespace fairway::app
