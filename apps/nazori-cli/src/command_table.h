// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the name that CLI11 has
class App;
class Option;
}  // namespace CLI

namespace nazori::cli {

/// The kind of a value on the command line.
enum class Takes {
  nothing,  ///< no value: a flag
  text,     ///< anything: a number, a name, a character
  file,     ///< the name of a file
  folder,   ///< the name of a folder
  choice    ///< one of a few words
};

/// One option, or one argument without dashes, as it was added to the command line.
struct OptionEntry {
  std::vector<std::string> names;    ///< with their dashes, short ones first; empty for an argument
  std::string argument;              ///< name of an argument: "characters"; empty for an option
  Takes takes = Takes::nothing;      ///< what its value is
  std::string value;                 ///< placeholder for the value in help: "FILE"; empty for a flag
  std::vector<std::string> choices;  ///< the words, for Takes::choice
  int values = 0;                    ///< how many words follow each use; 0 for a flag
  bool several = false;              ///< takes any number of values, or may be repeated
  bool required = false;
  std::string description;
  std::string notes;  ///< range, default, "required": "2..8192; default: 128"; may be empty
  std::string group;  ///< heading in help: "Options", "Brush"
};

/// A command with its options, arguments and subcommands; the program itself is the outermost one.
struct Command {
  std::string path;  ///< "study due"; empty for the program
  std::string name;  ///< "due"; "nazori-cli" for the program
  std::string description;
  std::string footer;                  ///< explanation and examples under its help
  std::vector<OptionEntry> arguments;  ///< in order
  std::vector<OptionEntry> options;    ///< in order, --help too
  std::vector<Command> verbs;          ///< in order
};

/// One option or argument of the command line as plain data.
[[nodiscard]] OptionEntry option_entry(const CLI::Option& option);

/// "-o, --output"; "characters..." for an argument that takes several.
[[nodiscard]] std::string joined_names(const OptionEntry& entry);

/// The description, followed by the notes in brackets.
[[nodiscard]] std::string description_with_notes(const OptionEntry& entry);

/// The whole command line as plain data. Entries with an empty group are hidden and left out.
[[nodiscard]] Command command_table(const CLI::App& app);

/// The command and all its subcommands, outermost first. The pointers live as long as `command`.
[[nodiscard]] std::vector<const Command*> all_commands(const Command& command);

}  // namespace nazori::cli
