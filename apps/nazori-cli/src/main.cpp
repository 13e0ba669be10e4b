// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <csignal>
#include <memory>
#include <string>
#include <vector>

#include "console.h"
#include "help_text.h"
#include "verbs.h"

namespace {

/// The innermost verb that has been read, the program itself where there is none.
const CLI::App& last_verb(const CLI::App& app) {
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) verb = verb->get_subcommands().front();
  return *verb;
}

/// "nazori-cli carve": the verb whose arguments are being read.
std::string name_of(const CLI::App& app) {
  std::string name = "nazori-cli";
  for (const CLI::App* verb = &app; !verb->get_subcommands().empty();) {
    verb = verb->get_subcommands().front();
    name += " " + verb->get_name();
  }
  return name;
}

/// "info, search, carve" where one of several verbs should follow the last one, else nothing.
std::string verbs_to_choose_from(const CLI::App& app) {
  std::string names;
  for (const CLI::App* verb : last_verb(app).get_subcommands([](const CLI::App*) { return true; })) {
    names += (names.empty() ? "" : ", ") + verb->get_name();
  }
  return names;
}

int read_and_run(CLI::App& app, const nazori::cli::Action& chosen, nazori::cli::Console& console, int argc,
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
    const std::string name = name_of(app);
    console.set_name(name);
    std::string what = error.what();
    if (const std::string verbs = verbs_to_choose_from(app); !verbs.empty()) {
      const std::vector<std::string> given = last_verb(app).remaining();
      what = (given.empty() ? std::string("a verb is missing") : "there is no verb '" + given.front() + "'") +
             ": " + verbs;
    }
    return console.refuse({nazori::base::Errc::bad_argument, what, "", "see " + name + " --help"});
  }
  console.set_name(name_of(app));
  return chosen(console);
}

}  // namespace

// Only a wrong table of options throws here, and any test would show that.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
  // A closed pipe shows as a failed write instead, which Console passes over in silence.
  (void)std::signal(SIGPIPE, SIG_IGN);
  nazori::cli::stop_on_signals();

  CLI::App app("Nazori: carved kanji you can see, feel and trace", "nazori-cli");
  app.set_version_flag("--version", "nazori-cli " NAZORI_VERSION);
  app.require_subcommand(1);
  app.formatter(std::make_shared<nazori::cli::HelpText>());
  app.footer(
      "Every verb documents itself: nazori-cli carve --help\n"
      "Exit code: 0 done, 1 the answer is no or not found, 2 bad usage or bad input.");

  nazori::cli::Action chosen;
  nazori::cli::add_info(app, chosen);
  nazori::cli::add_search(app, chosen);
  nazori::cli::add_carve(app, chosen);
  nazori::cli::add_render(app, chosen);
  nazori::cli::add_plot(app, chosen);
  nazori::cli::add_demo(app, chosen);
  nazori::cli::add_feel(app, chosen);
  nazori::cli::add_record(app, chosen);
  nazori::cli::add_devices(app, chosen);
  nazori::cli::add_database(app, chosen);
  nazori::cli::add_grade(app, chosen);
  nazori::cli::add_recognise(app, chosen);
  nazori::cli::add_study(app, chosen);
  nazori::cli::add_completion(app, chosen);
  nazori::cli::add_manual(app, chosen);

  nazori::cli::Console console;
  const int code = read_and_run(app, chosen, console, argc, argv);
  return console.finish(code);
}
