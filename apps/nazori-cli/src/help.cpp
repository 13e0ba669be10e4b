// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "usage_error.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

int run(Console& console, const CLI::App& app, const std::vector<std::string>& verbs) {
  const CLI::App* verb = &app;
  std::string name = app.get_name();
  for (const std::string& given : verbs) {
    const std::vector<std::string> below = verbs_below(*verb);
    if (below.empty()) {
      return console.refuse({base::Errc::bad_argument, "'" + verb->get_name() + "' has no verbs of its own",
                             "", "see " + name + " --help"});
    }
    if (std::find(below.begin(), below.end(), given) == below.end())
      return console.refuse(no_such_verb(*verb, given));
    verb = verb->get_subcommand(given);
    name += " " + given;
  }
  // App::help() would show the help of the parsed command, which is this one.
  console.print(verb->get_formatter()->make_help(verb, name, CLI::AppFormatMode::Normal));
  return kDone;
}

}  // namespace

void add_help(CLI::App& app, Action& chosen) {
  auto verbs = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = app.add_subcommand("help", "Show the help of the program or of a verb");
  verb->add_option("verb", *verbs, "The verb: carve, or study due");
  verb->footer(
      "It is what --help shows after the verb.\n\nExamples:\n  nazori-cli help carve\n"
      "  nazori-cli help study due");
  verb->callback([verbs, &app, &chosen] {
    chosen = [verbs, &app](Console& console) { return run(console, app, *verbs); };
  });
}

}  // namespace nazori::cli
