// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "completion_script.h"

namespace nazori::cli {
namespace {

/// "_nazori-cli-study-due"
std::string function_of(const Command& command) {
  std::string name = "_nazori-cli" + (command.path.empty() ? "" : "-" + command.path);
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

/// ":FILE:_files", once for each value, as _arguments reads what follows an option.
std::string values_of(const OptionEntry& entry) {
  std::string action = " ";
  switch (entry.takes) {
    case Takes::nothing:
      return "";
    case Takes::text:
      break;
    case Takes::file:
      action = "_files";
      break;
    case Takes::folder:
      action = "_files -/";
      break;
    case Takes::choice: {
      std::string words;
      for (const std::string& word : entry.choices) {
        words += (words.empty() ? "" : " ") + with_backslashes(word, " ()'\"$`:;&|<>*?[]{}~#!=");
      }
      action = "(" + words + ")";
    }
  }
  const std::string name = entry.argument.empty() ? entry.value : entry.argument;
  std::string values;
  for (int i = 0; i < entry.values; ++i)
    values += ":" + with_backslashes(in_one_line(name), ":") + ":" + action;
  return values;
}

/// The lines of _arguments for an option, one for each of its names.
std::string option_lines(const OptionEntry& option) {
  std::string names;
  for (const std::string& name : option.names) names += (names.empty() ? "" : " ") + name;
  std::string lines;
  for (const std::string& name : option.names) {
    std::string spec = option.several ? "*" : option.names.size() > 1 ? "(" + names + ")" : "";
    spec += name;
    // "+" and "=": the value is in the same word or in the next one.
    if (option.takes != Takes::nothing) spec += name.starts_with("--") ? "=" : "+";
    spec += "[" + with_backslashes(in_one_line(option.description), "[]") + "]" + values_of(option);
    lines += "    " + shell_quoted(spec) + "\n";
  }
  return lines;
}

std::string argument_line(const OptionEntry& argument) {
  const std::string before = argument.several ? "*" : argument.required ? "" : ":";
  return "    " + shell_quoted(before + values_of(argument)) + "\n";
}

std::string with_verbs(const Command& command, const std::string& arguments) {
  std::string verbs;
  std::string branches;
  for (const Command& verb : command.verbs) {
    verbs += "        " +
             shell_quoted(with_backslashes(verb.name, ":") + ":" +
                          with_backslashes(in_one_line(verb.description), "")) +
             "\n";
    branches += fmt::format("        {}) {} && ret=0 ;;\n", shell_quoted(verb.name), function_of(verb));
  }
  return fmt::format(
      "{}() {{\n"
      "  local curcontext=$curcontext context state state_descr line ret=1\n"
      "  local -a arguments verbs\n"
      "  typeset -A opt_args\n"
      "  arguments=(\n{}    ': :->verb'\n    '*:: :->rest'\n  )\n"
      "  _arguments -C -s -S $arguments && ret=0\n"
      "  case $state in\n"
      "    verb)\n"
      "      verbs=(\n{}      )\n"
      "      _describe -t verbs verb verbs && ret=0\n"
      "      ;;\n"
      "    rest)\n"
      "      case $words[1] in\n{}      esac\n"
      "      ;;\n"
      "  esac\n"
      "  return ret\n"
      "}}\n\n",
      function_of(command), arguments, verbs, branches);
}

std::string function_text(const Command& command) {
  std::string arguments;
  for (const OptionEntry& option : command.options) arguments += option_lines(option);
  if (!command.verbs.empty()) return with_verbs(command, arguments);
  for (const OptionEntry& argument : command.arguments) arguments += argument_line(argument);
  return fmt::format(
      "{}() {{\n  local -a arguments\n  arguments=(\n{}  )\n  _arguments -s -S $arguments\n}}\n\n",
      function_of(command), arguments);
}

}  // namespace

std::string zsh_completion(const Command& program) {
  std::string text =
      "#compdef nazori-cli\n# zsh completion of nazori-cli, written by: nazori-cli completion zsh\n\n";
  for (const Command* command : all_commands(program)) text += function_text(*command);
  // Loaded by zsh from a folder of $fpath it is the body of a function; read by "source" it must name itself.
  return text +
         "if [[ $funcstack[1] == _nazori-cli ]]; then\n  _nazori-cli \"$@\"\nelse\n"
         "  compdef _nazori-cli nazori-cli\nfi\n";
}

}  // namespace nazori::cli
