// SPDX-License-Identifier: Apache-2.0
#include "author.h"

#include "verbs.h"

namespace nazori::cli {

void add_author(CLI::App& app, Action& chosen) {
  CLI::App* verb =
      app.add_subcommand("author", "Check, convert, trace and keep characters that you make yourself");
  verb->require_subcommand(1);
  verb->footer(
      "Examples:\n  nazori-cli author convert 永 --output 永.nazori\n  nazori-cli author check 永.nazori\n"
      "  nazori-cli author trace brush.jpg --character 永 --output 永.nazori\n"
      "  nazori-cli author keep sign.nazori");
  add_author_check(*verb, chosen);
  add_author_convert(*verb, chosen);
  add_author_trace(*verb, chosen);
  add_author_keep(*verb, chosen);
}

}  // namespace nazori::cli
