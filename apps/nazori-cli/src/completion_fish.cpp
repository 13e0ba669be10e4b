// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "completion_script.h"

namespace nazori::cli {
namespace {

/// `text` as one word of fish: in single quotes, unless it is plain.
std::string fish_quoted(std::string_view text) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  };
  if (!text.empty() && text.front() != '-' && std::all_of(text.begin(), text.end(), plain)) {
    return std::string(text);
  }
  return "'" + with_backslashes(text, "'") + "'";
}

/// The name of a command in the script: " study due", the program "".
std::string place_of(const Command& command) { return command.path.empty() ? "" : " " + command.path; }

std::string line_for(const Command& command, const std::string& rest) {
  return fmt::format("complete -c nazori-cli -n {} {}\n",
                     fish_quoted("__nazori_cli_at " + fish_quoted(place_of(command))), rest);
}

/// The option of `complete` for the value: -r requires one, -x requires one that is not a file.
std::string value_of(const OptionEntry& entry) {
  switch (entry.takes) {
    case Takes::nothing:
      return "";
    case Takes::text:
      return " -x";
    case Takes::file:
      return " -r -F";
    case Takes::folder:
      return " -x -a '(__fish_complete_directories (commandline -ct))'";
    case Takes::choice:
      break;
  }
  std::string words;
  for (const std::string& word : entry.choices) words += (words.empty() ? "" : " ") + fish_quoted(word);
  return " -x -a " + fish_quoted(words);
}

std::string option_line(const Command& command, const OptionEntry& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += name.starts_with("--") ? "-l " + name.substr(2) + " " : "-s " + name.substr(1) + " ";
  }
  names.pop_back();
  return line_for(command, names + value_of(option) + " -d " + fish_quoted(in_one_line(option.description)));
}

std::string argument_line(const Command& command, const OptionEntry& argument) {
  switch (argument.takes) {
    case Takes::nothing:
    case Takes::text:
      return "";
    case Takes::file:
      return line_for(command, "-F");
    case Takes::folder:
    case Takes::choice:
      break;
  }
  // An argument needs no option before it: "-x" would add nothing to the line for the whole program.
  return line_for(command, "-f" + value_of(argument).substr(std::string_view(" -x").size()));
}

}  // namespace

std::string fish_completion(const Command& program) {
  std::string places;
  std::string lines;
  for (const Command* command : all_commands(program)) {
    if (!command->path.empty()) places += " " + fish_quoted(place_of(*command));
    for (const Command& verb : command->verbs) {
      lines += line_for(*command, "-a " + fish_quoted(fish_quoted(verb.name)) + " -d " +
                                      fish_quoted(in_one_line(verb.description)));
    }
    for (const OptionEntry& option : command->options) lines += option_line(*command, option);
    for (const OptionEntry& argument : command->arguments) lines += argument_line(*command, argument);
  }
  return "# fish completion of nazori-cli, written by: nazori-cli completion fish\n\n"
         "function __nazori_cli_at --description 'Whether this is the verb before the cursor'\n"
         "    set -l words (commandline -opc)\n"
         "    set -e words[1]\n"
         "    set -l verb ''\n"
         "    for word in $words\n"
         "        test \"$word\" = --; and break\n"
         "        contains -- \"$verb $word\"" +
         places +
         "; and set verb \"$verb $word\"\n"
         "    end\n"
         "    test \"$verb\" = \"$argv[1]\"\n"
         "end\n\n"
         "complete -c nazori-cli -f\n" +
         lines;
}

}  // namespace nazori::cli
