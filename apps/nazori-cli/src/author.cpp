// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "author_verbs.h"
#include "verbs.h"

namespace nazori::cli {

void add_author(CLI::App& app, Action& chosen) {
  CLI::App* verb = app.add_subcommand("author", "Make characters of one's own");
  verb->require_subcommand(1);
  verb->footer("Example:\n  nazori-cli author trace brush.jpg --character 永 --output 永.svg");
  add_author_trace(*verb, chosen);
}

}  // namespace nazori::cli
