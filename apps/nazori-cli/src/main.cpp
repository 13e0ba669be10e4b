// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <string>

#include "console.h"
#include "help_text.h"
#include "stop.h"
#include "usage_error.h"
#include "verbs.h"

namespace {

using nazori::cli::Action;
using nazori::cli::Console;

/// Settings of every command: one heading in the list, and --quiet.
void finish_table(CLI::App& app, bool& quiet) {
  for (CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    verb->group("Commands");
    finish_table(*verb, quiet);
    if (nazori::cli::verbs_below(*verb).empty()) {
      verb->add_flag("-q,--quiet", quiet, "Print no answer and no progress: the exit code tells");
    }
  }
}

void add_verbs(CLI::App& app, Action& chosen) {
  nazori::cli::add_info(app, chosen);
  nazori::cli::add_search(app, chosen);
  nazori::cli::add_carve(app, chosen);
  nazori::cli::add_render(app, chosen);
  nazori::cli::add_model(app, chosen);
  nazori::cli::add_plot(app, chosen);
  nazori::cli::add_demo(app, chosen);
  nazori::cli::add_feel(app, chosen);
  nazori::cli::add_paint(app, chosen);
  nazori::cli::add_record(app, chosen);
  nazori::cli::add_devices(app, chosen);
  nazori::cli::add_database(app, chosen);
  nazori::cli::add_grade(app, chosen);
  nazori::cli::add_recognise(app, chosen);
  nazori::cli::add_practise(app, chosen);
  nazori::cli::add_speak(app, chosen);
  nazori::cli::add_study(app, chosen);
  nazori::cli::add_worksheet(app, chosen);
  nazori::cli::add_grade_sheet(app, chosen);
  nazori::cli::add_author(app, chosen);
  nazori::cli::add_completion(app, chosen);
  nazori::cli::add_manual(app, chosen);
  nazori::cli::add_help(app, chosen);
}

bool answers_in_json(const CLI::App& verb) {
  const CLI::Option* const json = verb.get_option_no_throw("--json");
  return json != nullptr && json->count() > 0;
}

int read_and_run(CLI::App& app, const Action& chosen, const bool& quiet, Console& console, int argc,
                 char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    console.print(app.help());
    return nazori::cli::kDone;
  } catch (const CLI::CallForVersion& version) {
    console.print(std::string(version.what()) + "\n");
    return nazori::cli::kDone;
  } catch (const CLI::ParseError& error) {
    console.set_name(nazori::cli::name_of_verb(app));
    return console.refuse(nazori::cli::usage_error(app, error));
  }
  console.set_name(nazori::cli::name_of_verb(app));
  if (const auto empty = nazori::cli::empty_value(app)) return console.refuse(*empty);
  console.set_quiet(quiet);
  console.set_json(answers_in_json(nazori::cli::last_verb(app)));
  return chosen(console);
}

}  // namespace

// Only an invalid table of options throws here, which any test would reveal.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  nazori::cli::watch_for_stop();
  // A closed pipe appears as a failed write instead, which Console ignores.
  (void)std::signal(SIGPIPE, SIG_IGN);

  CLI::App app("Nazori: carved kanji you can see, feel and trace", "nazori-cli");
  app.set_version_flag("--version", "nazori-cli " NAZORI_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<nazori::cli::HelpText>());
  app.footer(
      "Help for one command: nazori-cli help carve\n"
      "Exit code: 0 done, 1 the answer is no or not found, 2 bad usage or bad input,\n"
      "3 another program has the learner open.");

  Action chosen;
  bool quiet = false;
  add_verbs(app, chosen);
  finish_table(app, quiet);

  Console console;
  const int code = console.finish(read_and_run(app, chosen, quiet, console, argc, argv));
  if (nazori::cli::stop_requested()) nazori::cli::end_by_stop_signal();
  return code;
}
