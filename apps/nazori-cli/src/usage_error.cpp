// SPDX-License-Identifier: Apache-2.0
#include "usage_error.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "command_table.h"
#include "did_you_mean.h"

namespace nazori::cli {
namespace {

using base::Errc;
using base::Error;

std::vector<const CLI::App*> all_verbs(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::vector<const CLI::Option*> all_options(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_group().empty(); });
}

/// "--size N"; "characters" for an argument.
std::string name_with_value(const CLI::Option& option) {
  const OptionEntry entry = option_entry(option);
  if (entry.names.empty()) return entry.argument;
  return entry.names.back() + (entry.value.empty() ? "" : " " + entry.value);
}

/// "nazori-cli study": the command with the commands above it.
std::string full_name(const CLI::App& verb) {
  const CLI::App* const above = verb.get_parent();
  return (above == nullptr ? "" : full_name(*above) + " ") + verb.get_name();
}

std::string see_help(const CLI::App& app) { return "see " + name_of_verb(app) + " --help"; }

/// The kind of an error. Its name may be that of the command.
bool is(const CLI::ParseError& error, CLI::ExitCodes kind) {
  return error.get_exit_code() == static_cast<int>(kind);
}

bool is_number(std::string_view text) {
  double value = 0;
  return CLI::detail::lexical_cast(std::string(text), value);
}

bool looks_like_option(std::string_view text) { return text.size() > 1 && text.front() == '-'; }

/// "study due" for "due" where exactly one subcommand has that name.
std::optional<std::string> verb_inside(const CLI::App& app, const std::string& given) {
  std::vector<std::string> paths;
  for (const CLI::App* verb : all_verbs(app)) {
    const std::vector<std::string> below = verbs_below(*verb);
    if (std::find(below.begin(), below.end(), given) != below.end())
      paths.push_back(verb->get_name() + " " + given);
  }
  return paths.size() == 1 ? std::optional(paths.front()) : std::nullopt;
}

/// An argument that nothing accepts: a misspelt option, or one argument too many.
Error unexpected(const CLI::App& app, const std::string& given) {
  const CLI::App& verb = last_verb(app);
  if (!looks_like_option(given)) {
    return {Errc::bad_argument, fmt::format("'{}' is one argument too many", given), "", see_help(app)};
  }
  if (is_number(given.substr(0, 2)) || given[1] == '.') {
    return {Errc::bad_argument, fmt::format("'{}' belongs to no option", given), "",
            "a value that begins with a minus follows an equals sign: --name=" + given};
  }
  const std::string name = given.substr(0, given.find('='));
  std::vector<std::string> names;
  for (const CLI::Option* option : all_options(verb)) {
    for (const std::string& word : option->get_lnames()) names.push_back("--" + word);
  }
  const auto meant = name.starts_with("--") ? meant_word(name, names) : std::nullopt;
  return {Errc::bad_argument, fmt::format("there is no option '{}'", name), "",
          meant ? "did you mean " + *meant + "?" : see_help(app)};
}

/// The option or argument that the parser's text names at its beginning, or after "Could not convert: ".
const CLI::Option* option_in(const CLI::App& app, std::string_view text) {
  constexpr std::string_view kConversion = "Could not convert: ";
  if (text.starts_with(kConversion)) text.remove_prefix(kConversion.size());
  const CLI::Option* found = nullptr;
  for (const CLI::Option* option : all_options(last_verb(app))) {
    const std::string name = option->get_name();
    const bool named = text.starts_with(name) && text.size() > name.size() &&
                       (text[name.size()] == ':' || text[name.size()] == ' ');
    if (named && (found == nullptr || name.size() > found->get_name().size())) found = option;
  }
  return found;
}

Error missing(const CLI::App& app) {
  for (const CLI::Option* option : all_options(last_verb(app))) {
    if (!option->get_required() || option->count() > 0) continue;
    const OptionEntry entry = option_entry(*option);
    const std::string name =
        entry.names.empty() ? "the argument '" + entry.argument + "'" : name_with_value(*option);
    return {Errc::bad_argument, name + " is missing", "", see_help(app)};
  }
  return {Errc::bad_argument, "an argument is missing", "", see_help(app)};
}

/// "'mabye' is none of on, off (did you mean on?)"
Error no_choice(const CLI::Option& option, const OptionEntry& entry, const CLI::App& app) {
  const auto is_choice = [&entry](const std::string& given) {
    return std::find(entry.choices.begin(), entry.choices.end(), given) != entry.choices.end();
  };
  const std::vector<std::string> results = option.results();
  const auto wrong = std::find_if_not(results.begin(), results.end(), is_choice);
  const std::string given = wrong == results.end() ? "" : *wrong;
  const auto meant = meant_word(given, entry.choices);
  return {Errc::bad_argument, fmt::format("'{}' is none of {}", given, fmt::join(entry.choices, ", ")),
          entry.names.empty() ? entry.argument : entry.names.back(),
          meant ? "did you mean " + *meant + "?" : see_help(app)};
}

Error wrong_count(const CLI::Option& option, const CLI::App& app) {
  const OptionEntry entry = option_entry(option);
  const std::string name = entry.names.empty() ? entry.argument : entry.names.back();
  const int expected = option.get_expected_max();
  const std::size_t given = option.results().size();
  if (given == 0) {
    return {Errc::bad_argument, name_with_value(option) + " has no value", "", see_help(app)};
  }
  if (expected <= 1) {
    return {Errc::bad_argument, fmt::format("is given {} times", given), name, "give it once"};
  }
  std::string values = entry.value;
  const bool in_one_word = option.get_delimiter() != '\0';
  for (int i = 1; i < expected && !in_one_word; ++i) values += " " + entry.value;
  return {Errc::bad_argument, fmt::format("has {} value{}, not {}", given, given == 1 ? "" : "s", expected),
          name, "write " + name + (in_one_word ? "=" : " ") + values};
}

Error wrong_value(const CLI::Option& option, const CLI::App& app) {
  const OptionEntry entry = option_entry(option);
  const std::string name = entry.names.empty() ? entry.argument : entry.names.back();
  if (entry.value.empty() && entry.argument.empty())
    return {Errc::bad_argument, "takes no value", name, "leave out what follows the equals sign"};
  std::string given;
  for (const std::string& result : option.results()) {
    given = result;
    if (!is_number(result))
      return {Errc::bad_argument, fmt::format("'{}' is not a number", given), name, see_help(app)};
  }
  return {Errc::bad_argument, fmt::format("'{}' is not a whole number", given), name, see_help(app)};
}

Error rewritten(const CLI::App& app, const CLI::ParseError& error) {
  const std::string text = error.what();
  const CLI::Option* option = option_in(app, text);
  if (option == nullptr) return {Errc::bad_argument, text, "", see_help(app)};
  if (is(error, CLI::ExitCodes::ArgumentMismatch)) {
    return option->get_expected_max() == 0 || option->get_type_size() == 0 ? wrong_value(*option, app)
                                                                           : wrong_count(*option, app);
  }
  if (is(error, CLI::ExitCodes::ConversionError)) return wrong_value(*option, app);
  const OptionEntry entry = option_entry(*option);
  if (!entry.choices.empty()) return no_choice(*option, entry, app);
  // The checks of this program write "5 is not within 2..8" after the name.
  const std::string what = text.substr(std::min(text.size(), option->get_name().size() + 2));
  return {Errc::bad_argument, what, entry.names.empty() ? entry.argument : entry.names.back(), see_help(app)};
}

}  // namespace

const CLI::App& last_verb(const CLI::App& app) {
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) verb = verb->get_subcommands().front();
  return *verb;
}

std::string name_of_verb(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* verb = &app; !verb->get_subcommands().empty();) {
    verb = verb->get_subcommands().front();
    name += " " + verb->get_name();
  }
  return name;
}

std::vector<std::string> verbs_below(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : all_verbs(app)) names.push_back(verb->get_name());
  return names;
}

Error no_such_verb(const CLI::App& app, const std::string& given) {
  const std::vector<std::string> names = verbs_below(app);
  auto meant = verb_inside(app, given);
  if (!meant) meant = meant_word(given, names);
  return {Errc::bad_argument, fmt::format("unknown command '{}'", given), "",
          meant ? fmt::format("did you mean {}?", *meant)
                : fmt::format("the verbs are {}; see {} --help", fmt::join(names, ", "), full_name(app))};
}

Error usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& verb = last_verb(app);
  const std::vector<std::string> extras = app.remaining(true);
  if (!all_verbs(verb).empty()) {
    const auto given = std::find_if_not(extras.begin(), extras.end(),
                                        [](const std::string& one) { return looks_like_option(one); });
    if (!extras.empty() && (given == extras.end() || given != extras.begin()))
      return unexpected(app, extras.front());
    if (given != extras.end()) return no_such_verb(verb, *given);
    return {Errc::bad_argument, "a command is missing", "",
            fmt::format("the verbs are {}; {}", fmt::join(verbs_below(verb), ", "), see_help(app))};
  }
  if (is(error, CLI::ExitCodes::ExtrasError) || is(error, CLI::ExitCodes::RequiredError)) {
    // A misspelt option is why a required one is missing.
    if (!extras.empty()) return unexpected(app, extras.front());
    return missing(app);
  }
  return rewritten(app, error);
}

std::optional<Error> empty_value(const CLI::App& app) {
  for (const CLI::Option* option : all_options(last_verb(app))) {
    const OptionEntry entry = option_entry(*option);
    if (entry.names.empty() || entry.value.empty()) continue;
    for (const std::string& given : option->results()) {
      if (!given.empty()) continue;
      return Error{Errc::bad_argument, "is empty", entry.names.back(),
                   fmt::format("give {}, or leave the option out", entry.value)};
    }
  }
  return std::nullopt;
}

}  // namespace nazori::cli
