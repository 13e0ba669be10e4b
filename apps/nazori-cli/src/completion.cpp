// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include "command_table.h"
#include "completion_script.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

int run(Console& console, const CLI::App& app, const std::string& shell) {
  const Command program = command_table(app);
  console.print(shell == "bash"  ? bash_completion(program)
                : shell == "zsh" ? zsh_completion(program)
                                 : fish_completion(program));
  return kDone;
}

}  // namespace

void add_completion(CLI::App& app, Action& chosen) {
  auto shell = std::make_shared<std::string>();
  CLI::App* verb = app.add_subcommand("completion", "Print a script that completes commands in a shell");
  verb->add_option("shell", *shell, "The shell: bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  verb->footer(
      "The shell reads the script when it starts; zsh wants it in a folder of $fpath.\n\nExamples:\n"
      "  nazori-cli completion bash > ~/.local/share/bash-completion/completions/nazori-cli\n"
      "  nazori-cli completion fish > ~/.config/fish/completions/nazori-cli.fish\n"
      "  nazori-cli completion zsh > _nazori-cli");
  verb->callback([shell, &app, &chosen] {
    chosen = [shell, &app](Console& console) { return run(console, app, *shell); };
  });
}

}  // namespace nazori::cli
