// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "completion_script.h"

namespace nazori::cli {
namespace {

// The code that parses the line; it follows the table, which lists for each command what can come next.
constexpr std::string_view kReader = R"(
_nazori_cli() {
  local current=${COMP_WORDS[COMP_CWORD]} verb='' option='' prefix='' word takes values i
  local pending=0 arguments=0 only_arguments=0
  local -a verbs options choices
  COMPREPLY=()
  _nazori_cli_verb ''

  # The words before the cursor: which verb, how many arguments, whether an option still waits for values.
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $word == '=' && -n $option && ${COMP_WORDS[i - 1]} == "$option" ]]; then
      continue
    elif ((pending > 0)); then
      pending=$((pending - 1))
    elif ((only_arguments)); then
      arguments=$((arguments + 1))
    elif [[ $word == -- ]]; then
      only_arguments=1
    elif [[ $word == -?* ]]; then
      _nazori_cli_takes "$verb" "$word"
      option=$word
      pending=$values
    else
      for takes in "${verbs[@]}"; do
        if [[ $takes == "$word" ]]; then
          verb=${verb:+$verb }$word
          _nazori_cli_verb "$verb"
          continue 2
        fi
      done
      arguments=$((arguments + 1))
    fi
  done

  # bash splits --option=value at the equals sign, unless COMP_WORDBREAKS was changed.
  if ((pending > 0)) && [[ $current == '=' ]]; then
    current=''
  elif ((pending == 0 && !only_arguments)) && [[ $current == --*=* ]]; then
    option=${current%%=*}
    prefix=$option=
    current=${current#*=}
    pending=1
  fi

  if ((pending > 0)); then
    _nazori_cli_takes "$verb" "$option"
  elif ((!only_arguments)) && [[ $current == -* ]]; then
    takes=choice
    choices=("${options[@]}")
  elif ((${#verbs[@]} > 0)); then
    takes=choice
    choices=("${verbs[@]}")
  else
    _nazori_cli_takes "$verb" $((arguments + 1))
  fi

  case $takes in
    choice)
      for word in "${choices[@]}"; do
        if [[ $word == "$current"* ]]; then COMPREPLY+=("$prefix$word"); fi
      done
      ;;
    file | folder)
      while IFS= read -r word; do COMPREPLY+=("$prefix$word"); done < <(
        if [[ $takes == file ]]; then compgen -f -- "$current"; else compgen -d -- "$current"; fi
      )
      # Says how names are quoted; fails where no line is being completed, as in a test.
      compopt -o filenames 2> /dev/null
      ;;
  esac
  return 0
}

complete -F _nazori_cli nazori-cli
)";

std::string list_of(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : " ") + shell_quoted(word);
  return list;
}

std::string_view completion_word(Takes takes) {
  switch (takes) {
    case Takes::nothing:
      return "nothing";
    case Takes::text:
      return "text";
    case Takes::file:
      return "file";
    case Takes::folder:
      return "folder";
    case Takes::choice:
      return "choice";
  }
  return "";
}

std::string branch(const std::string& patterns, const OptionEntry& entry) {
  const std::string choices =
      entry.takes == Takes::choice ? fmt::format(" choices=({})", list_of(entry.choices)) : "";
  return fmt::format("    {}) takes={} values={}{} ;;\n", patterns, completion_word(entry.takes),
                     entry.values, choices);
}

std::string verbs_and_options(const Command& command) {
  std::vector<std::string> verbs;
  for (const Command& verb : command.verbs) verbs.push_back(verb.name);
  std::vector<std::string> options;
  for (const OptionEntry& option : command.options) {
    options.insert(options.end(), option.names.begin(), option.names.end());
  }
  return fmt::format("    {})\n      verbs=({})\n      options=({})\n      ;;\n", shell_quoted(command.path),
                     list_of(verbs), list_of(options));
}

std::string values_of(const Command& command) {
  std::string branches;
  for (const OptionEntry& option : command.options) {
    if (option.takes == Takes::nothing) continue;
    std::string patterns;
    for (const std::string& name : option.names) {
      patterns += (patterns.empty() ? "" : " | ") + shell_quoted(command.path + " " + name);
    }
    branches += branch(patterns, option);
  }
  int number = 0;
  for (const OptionEntry& argument : command.arguments) {
    ++number;
    // If several values are allowed, this branch covers the rest of the line: bash uses the first match.
    branches += branch(argument.several ? shell_quoted(command.path + " ") + "[1-9]*"
                                        : shell_quoted(command.path + " " + std::to_string(number)),
                       argument);
  }
  return branches;
}

}  // namespace

std::string bash_completion(const Command& program) {
  std::string verbs;
  std::string values;
  for (const Command* command : all_commands(program)) {
    verbs += verbs_and_options(*command);
    values += values_of(*command);
  }
  return "# bash completion of nazori-cli, written by: nazori-cli completion bash\n\n"
         "# What may follow the verb $1, in verbs and options.\n"
         "_nazori_cli_verb() {\n  case $1 in\n" +
         verbs +
         "  esac\n}\n\n"
         "# What the option or the argument (its number from 1) $2 of the verb $1 takes: takes, values, "
         "choices.\n"
         "_nazori_cli_takes() {\n  takes=nothing values=0 choices=()\n  case \"$1 $2\" in\n" +
         values + "  esac\n}\n" + std::string(kReader);
}

}  // namespace nazori::cli
