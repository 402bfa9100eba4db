// SPDX-License-Identifier: Apache-2.0
#include "commands/reference/command_reference.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>
#include <fmt/format.h>

namespace fairway::app {

namespace {

// Escapes text for troff: a dash needs a backslash, and so does a dot or quote at the start of a
// line.
std::string troff(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '-' || c == '\\') result += '\\';
    result += c;
    if (c == '\n') result += "\\&";
  }
  return result;
}

std::string names_of(const std::vector<CommandHelp>& commands) {
  std::string names;
  for (const CommandHelp& command : commands)
    names += (names.empty() ? "" : " ") + command.name;
  return names;
}

// "--corridor" for each option of a command.
std::string options_of(const CommandHelp& command) {
  std::string names = "--help";
  for (const OptionHelp& option : command.options) {
    if (option.name.starts_with('-')) names += " " + option.name;
  }
  return names;
}

std::string in_single_quotes(std::string_view text) {
  std::string quoted;
  for (const char c : text)
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted;
}

// Brackets and colons end a description in zsh's _arguments.
std::string zsh_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':') result += '\\';
    result += c;
  }
  return in_single_quotes(result);
}

}  // namespace

std::string bash_completion(const std::vector<CommandHelp>& commands) {
  std::string text =
      "# Completion of fairway for bash; made by `fairway completion bash`.\n"
      "_fairway() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} options=\n"
      "  COMPREPLY=()\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n";
  text += fmt::format("    COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\"))\n",
                      names_of(commands));
  text +=
      "    return\n"
      "  fi\n"
      "  case ${COMP_WORDS[1]},$before in\n";
  for (const CommandHelp& command : commands) {
    for (const OptionHelp& option : command.options) {
      if (option.values.empty()) continue;
      text += fmt::format("    {},{}) COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n",
                          command.name, option.name, fmt::join(option.values, " "));
    }
  }
  text += "  esac\n  case ${COMP_WORDS[1]} in\n";
  for (const CommandHelp& command : commands)
    text += fmt::format("    {}) options='{}' ;;\n", command.name, options_of(command));
  text +=
      "  esac\n"
      "  case $word in\n"
      "    -*) COMPREPLY=($(compgen -W \"$options\" -- \"$word\")) ;;\n"
      "    *) COMPREPLY=($(compgen -f -- \"$word\")) ;;\n"
      "  esac\n"
      "}\n"
      "complete -o filenames -F _fairway fairway\n";
  return text;
}

std::string zsh_completion(const std::vector<CommandHelp>& commands) {
  std::string text =
      "#compdef fairway\n"
      "# Completion of fairway for zsh; made by `fairway completion zsh`.\n"
      "local -a commands\n"
      "commands=(\n";
  for (const CommandHelp& command : commands)
    text += fmt::format("  '{}:{}'\n", command.name, zsh_text(command.help));
  text +=
      ")\n"
      "if (( CURRENT == 2 )); then\n"
      "  _describe command commands\n"
      "  return\n"
      "fi\n"
      "case $words[2] in\n";
  for (const CommandHelp& command : commands) {
    text += fmt::format("  {})\n    _arguments '*:file:_files' '--help[Print this command]'",
                        command.name);
    for (const OptionHelp& option : command.options) {
      if (!option.name.starts_with('-')) continue;
      text += fmt::format(" \\\n      '*{}[{}]", option.name, zsh_text(option.help));
      if (!option.values.empty()) {
        text += fmt::format(":value:({})", fmt::join(option.values, " "));
      } else if (option.takes_value) {
        text += ":value:_files";
      }
      text += "'";
    }
    text += " ;;\n";
  }
  return text + "esac\n";
}

std::string manual_page(const std::vector<CommandHelp>& commands) {
  std::string text = fmt::format(
      ".TH FAIRWAY 1 \"\" \"Fairway {}\" \"User Commands\"\n"
      ".SH NAME\n"
      "fairway \\- safe corridors and model predictive control for wheeled robots\n"
      ".SH SYNOPSIS\n"
      ".B fairway\n"
      ".I COMMAND\n"
      "[\\fIARGUMENTS\\fR] [\\fIOPTIONS\\fR]\n"
      ".SH COMMANDS\n",
      tool_version());
  for (const CommandHelp& command : commands) {
    text += fmt::format(".SS \"fairway {}", command.name);
    for (const OptionHelp& option : command.options) {
      if (!option.name.starts_with('-')) text += " " + troff(option.name);
    }
    text += fmt::format("\"\n{}.\n", troff(command.help));
    for (const OptionHelp& option : command.options) {
      text += ".TP\n\\fB" + troff(option.name) + "\\fR";
      if (option.name.starts_with('-') && option.takes_value)
        text += " \\fI" + troff(option.type) + "\\fR";
      text += fmt::format("\n\\&{}\n", troff(option.help));
    }
    if (!command.footer.empty()) text += fmt::format(".PP\n\\&{}\n", troff(command.footer));
  }
  return text +
         ".SH EXIT STATUS\n"
         "0: done. 1: the task itself failed. 2: bad usage or bad input, explained in one line on "
         "standard error.\n"
         ".SH SEE ALSO\n"
         "The documents below share/doc/fairway, beginning with README.md.\n";
}

}  // namespace fairway::app
