// SPDX-License-Identifier: Apache-2.0
// Completion as the shells do it: each script is run, and what it offers is compared with --help.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "completion_script.h"
#include "help_pages.h"
#include "odd_command_line.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::IsSupersetOf;
using testing::UnorderedElementsAre;
using testing::UnorderedElementsAreArray;

using Words = std::vector<std::string>;

bool is_there(const std::string& shell_name) { return shell("command -v " + shell_name).code == 0; }

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The answers of a script that ends each of them with a line "=====".
std::vector<Words> answers_in(const std::string& text) {
  std::vector<Words> answers(1);
  for (const std::string& line : lines_of(text)) {
    if (line == "=====") {
      answers.emplace_back();
    } else if (!line.empty()) {
      answers.back().push_back(line);
    }
  }
  answers.pop_back();
  return answers;
}

/// A folder with a completion script, in which lines are completed.
class Completion {
 public:
  explicit Completion(const std::string& script) { write(folder_ / "script", script); }

  /// The completions of bash for each line; its last word is the one being typed.
  std::vector<Words> in_bash(const std::vector<Words>& lines) {
    std::string driver =
        "source ./script\n"
        "offer() {\n  COMP_WORDS=(nazori-cli \"$@\") COMP_CWORD=$#\n  _nazori_cli\n"
        "  printf '%s\\n' \"${COMPREPLY[@]}\" =====\n}\n";
    for (const Words& line : lines) {
      driver += "offer";
      for (const std::string& word : line) driver += " " + shell_quoted(word);
      driver += "\n";
    }
    return run("bash", driver, lines.size());
  }

  /// The same in fish, each completion with its description after a tab.
  std::vector<Words> in_fish(const std::vector<std::string>& lines) {
    std::string driver = "source ./script\n";
    for (const std::string& line : lines) driver += "complete -C 'nazori-cli " + line + "'; echo '====='\n";
    return run("fish", driver, lines.size());
  }

  /// The arguments of _arguments and _describe of zsh for each command, as zsh reads them.
  std::vector<Words> in_zsh(const std::vector<Words>& verbs) {
    std::string driver =
        "compdef() { }\n_arguments() { print -rl -- \"$@\"; state=verb }\n_describe() { print -rl -- $verbs "
        "}\n"
        "source ./script\n";
    for (const Words& verb : verbs) {
      driver += "_nazori-cli";
      for (const std::string& word : verb) driver += "-" + word;
      driver += "; echo '====='\n";
    }
    return run("zsh", driver, verbs.size());
  }

  void add_files(const Words& names) {
    for (const std::string& name : names) write(folder_ / name, "");
  }
  [[nodiscard]] Words files() const { return folder_.names(); }

 private:
  std::vector<Words> run(const std::string& shell_name, const std::string& driver, std::size_t count) {
    write(folder_ / "driver", driver);
    const Outcome done =
        shell("cd " + shell_quoted(folder_.path().string()) + " && HOME=$PWD " + shell_name + " ./driver");
    EXPECT_EQ(done.code, 0);
    EXPECT_EQ(done.err, "");
    std::vector<Words> answers = answers_in(done.out);
    EXPECT_EQ(answers.size(), count);
    answers.resize(count);
    return answers;
  }

  TemporaryFolder folder_;
};

std::string script_of(const std::string& shell_name) {
  const Outcome run = nazori_cli({"completion", shell_name});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  return run.out;
}

Words plus(Words words, const std::string& word) {
  words.push_back(word);
  return words;
}

TEST(Completion, HelpLeadsToEveryVerb) {
  Words paths;
  for (const HelpPage& page : help_pages()) paths.push_back(page.path());
  EXPECT_THAT(paths, IsSupersetOf({"", "info", "recognise", "grade", "completion", "manual", "study",
                                   "study due", "study replay", "database build", "record export"}));
}

TEST(Completion, AnUnknownShellIsRefused) {
  expect_one_line(nazori_cli({"completion", "csh"}), 2, {"csh", "bash", "did you mean zsh"});
  expect_one_line(nazori_cli({"completion"}), 2, {"shell"});
}

TEST(BashCompletion, OffersEveryVerbAndOptionOfHelpAndNoOther) {
  std::vector<Words> lines;
  for (const HelpPage& page : help_pages()) {
    lines.push_back(plus(page.verb, "-"));
    if (!page.verbs.empty()) lines.push_back(plus(page.verb, ""));
  }
  const std::vector<Words> offers = Completion(script_of("bash")).in_bash(lines);
  std::size_t at = 0;
  for (const HelpPage& page : help_pages()) {
    EXPECT_THAT(offers[at++], UnorderedElementsAreArray(page.options)) << page.path();
    if (!page.verbs.empty()) {
      EXPECT_THAT(offers[at++], UnorderedElementsAreArray(page.verbs)) << page.path();
    }
  }
}

TEST(BashCompletion, OffersWhatBeginsWithWhatWasTyped) {
  const auto offers =
      Completion(script_of("bash")).in_bash({{"stu"}, {"study", "un"}, {"carve", "--cross"}, {"x"}});
  EXPECT_THAT(offers, ElementsAre(ElementsAre("study"), ElementsAre("undo"), ElementsAre("--cross-section"),
                                  IsEmpty()));
}

TEST(BashCompletion, OffersTheWordsOfFixedChoices) {
  const auto offers = Completion(script_of("bash"))
                          .in_bash({{"feel", "--mode", "le"},
                                    {"feel", "--mode", "=", "le"},
                                    {"feel", "--mode", "="},
                                    {"feel", "--mode=le"},
                                    {"completion", ""},
                                    {"completion", "bash", ""}});
  EXPECT_THAT(offers[0], ElementsAre("lesson", "lead"));
  EXPECT_THAT(offers[1], ElementsAre("lesson", "lead"));
  EXPECT_THAT(offers[2], ElementsAre("contact", "snap", "lesson", "lead"));
  EXPECT_THAT(offers[3], ElementsAre("--mode=lesson", "--mode=lead"));
  EXPECT_THAT(offers[4], ElementsAre("bash", "zsh", "fish"));
  EXPECT_THAT(offers[5], IsEmpty());
}

TEST(BashCompletion, OffersFilesOnlyWhereOneIsTaken) {
  Completion completion(script_of("bash"));
  completion.add_files({"a file.nzr"});
  const auto offers = completion.in_bash({{"record", "info", "a"},
                                          {"record", "info", "x", "a"},
                                          {"carve", "-o", "a"},
                                          {"carve", "休", "--output", "=", "a"},
                                          {"carve", "--output=a"},
                                          {"carve", "a"},
                                          {"carve", "--size", "a"},
                                          {"study", "due", "--learners", "a"},
                                          {"study", "restore", "--", "a"}});
  EXPECT_THAT(offers[0], ElementsAre("a file.nzr"));
  EXPECT_THAT(offers[1], IsEmpty());
  EXPECT_THAT(offers[2], ElementsAre("a file.nzr"));
  EXPECT_THAT(offers[3], ElementsAre("a file.nzr"));
  EXPECT_THAT(offers[4], ElementsAre("--output=a file.nzr"));
  EXPECT_THAT(offers[5], IsEmpty());
  EXPECT_THAT(offers[6], IsEmpty());
  EXPECT_THAT(offers[7], IsEmpty());  // a folder is accepted
  EXPECT_THAT(offers[8], ElementsAre("a file.nzr"));
}

TEST(BashCompletion, ValuesOfOptionsAreNeitherVerbsNorArguments) {
  const auto offers = Completion(script_of("bash"))
                          .in_bash({{"study", "profiles", "--rename", "due", "--"},
                                    {"study", "profiles", "--rename", "a", "b", "--rem"},
                                    {"search", "study", "--gr"},
                                    {"carve", "--", "--"}});
  EXPECT_THAT(offers[0], IsEmpty());  // the second of two names
  EXPECT_THAT(offers[1], ElementsAre("--remove"));
  EXPECT_THAT(offers[2], ElementsAre("--grade"));
  EXPECT_THAT(offers[3], IsEmpty());
}

TEST(BashCompletion, NothingOfADescriptionOrAWordIsExpanded) {
  const OddCommandLine odd;
  Completion completion(bash_completion(command_table(odd.app)));
  const auto offers = completion.in_bash({{""}, {"carve", "--shape", ""}, {"carve", "--level", ""}});
  EXPECT_THAT(offers[0], ElementsAre("carve", "study"));
  EXPECT_THAT(offers[1], ElementsAre("round", "it's", "$(touch pwned)"));
  EXPECT_THAT(offers[2], ElementsAre("high", "low"));
  EXPECT_THAT(completion.files(), ElementsAre("driver", "script"));
}

TEST(FishCompletion, OffersEveryVerbAndOptionOfHelpAndNoOther) {
  if (!is_there("fish")) GTEST_SKIP() << "fish is not installed";
  std::vector<std::string> lines;
  for (const HelpPage& page : help_pages()) {
    lines.push_back(page.path() + " -");
    lines.push_back(page.path() + " ");
  }
  const std::vector<Words> offers = Completion(script_of("fish")).in_fish(lines);
  std::size_t at = 0;
  for (const HelpPage& page : help_pages()) {
    Words options;
    for (const std::string& offer : offers[at++]) options.push_back(offer.substr(0, offer.find('\t')));
    EXPECT_THAT(options, UnorderedElementsAreArray(page.options)) << page.path();
    Words verbs;
    for (const std::string& offer : offers[at++]) verbs.push_back(offer.substr(0, offer.find('\t')));
    if (!page.verbs.empty()) {
      EXPECT_THAT(verbs, UnorderedElementsAreArray(page.verbs)) << page.path();
    }
  }
}

TEST(FishCompletion, OffersChoicesAndFilesWhereTheyAreTaken) {
  if (!is_there("fish")) GTEST_SKIP() << "fish is not installed";
  Completion completion(script_of("fish"));
  completion.add_files({"a.nzr"});
  const auto offers = completion.in_fish({"completion ", "record info a", "carve -o a", "carve a",
                                          "carve --size a", "grade --explain ", "study un"});
  EXPECT_THAT(offers[0], UnorderedElementsAre("bash", "zsh", "fish"));
  EXPECT_THAT(offers[1], ElementsAre("a.nzr"));
  EXPECT_THAT(offers[2], ElementsAre("a.nzr"));
  EXPECT_THAT(offers[3], IsEmpty());
  EXPECT_THAT(offers[4], IsEmpty());
  EXPECT_EQ(offers[5].size(), 2U);
  EXPECT_THAT(offers[6], ElementsAre(testing::StartsWith("undo\tUndo the last ")));
}

TEST(FishCompletion, NothingOfADescriptionOrAWordIsExpanded) {
  if (!is_there("fish")) GTEST_SKIP() << "fish is not installed";
  const OddCommandLine odd;
  Completion completion(fish_completion(command_table(odd.app)));
  const auto offers = completion.in_fish({"ca", "carve --out", "carve --shape "});
  EXPECT_THAT(offers[0], ElementsAre("carve\t" + kOddDescription));
  EXPECT_THAT(offers[1], ElementsAre("--output\t" + kOddDescription));
  EXPECT_THAT(offers[2], UnorderedElementsAre("round\tA shape", "it's\tA shape", "$(touch pwned)\tA shape"));
  const Words files = completion.files();
  EXPECT_EQ(std::count(files.begin(), files.end(), "pwned"), 0);
}

/// "--output" of "(-o --output)--output=[The file]:FILE:_files".
std::string name_in(std::string spec) {
  if (spec.starts_with('*')) spec.erase(0, 1);
  if (spec.starts_with('(')) spec.erase(0, spec.find(')') + 1);
  return spec.substr(0, spec.find_first_of("=+["));
}

TEST(ZshCompletion, OffersEveryVerbAndOptionOfHelpAndNoOther) {
  if (!is_there("zsh")) GTEST_SKIP() << "zsh is not installed";
  std::vector<Words> verbs;
  for (const HelpPage& page : help_pages()) verbs.push_back(page.verb);
  const std::vector<Words> specs = Completion(script_of("zsh")).in_zsh(verbs);
  for (std::size_t i = 0; i < verbs.size(); ++i) {
    const HelpPage& page = help_pages()[i];
    Words options;
    Words offered_verbs;
    for (const std::string& spec : specs[i]) {
      const std::string name = name_in(spec);
      // The flags of _arguments itself come without a description.
      if (name.starts_with('-') && spec.find('[') != std::string::npos) options.push_back(name);
      if (!spec.starts_with('-') && spec.find('[') == std::string::npos && !spec.starts_with(':') &&
          !spec.starts_with('*')) {
        offered_verbs.push_back(spec.substr(0, spec.find(':')));
      }
    }
    EXPECT_THAT(options, UnorderedElementsAreArray(page.options)) << page.path();
    EXPECT_THAT(offered_verbs, UnorderedElementsAreArray(page.verbs)) << page.path();
  }
}

TEST(ZshCompletion, SaysWhatIsTakenAndQuotesDescriptions) {
  if (!is_there("zsh")) GTEST_SKIP() << "zsh is not installed";
  const OddCommandLine odd;
  Completion completion(zsh_completion(command_table(odd.app)));
  const auto specs = completion.in_zsh({{"carve"}, {"study", "check"}});
  EXPECT_THAT(specs[0],
              IsSupersetOf({"--folder=[A folder]:FOLDER:_files -/", "--level=[A level]:INT:(high low)",
                            R"(--shape=[A shape]:TEXT:(round it\'s \$\(touch\ pwned\)))",
                            "--window=[A window]:A,B,C,D: ", "--rename=[Two names]:NAME: :NAME: ",
                            R"(*--fault=[A fault]:KIND\:STROKE: )", "(-q --quiet)--quiet[A flag]",
                            "*:characters: "}));
  EXPECT_THAT(specs[0],
              Contains("(-o --output)-o+[" + with_backslashes(kOddDescription, "[]") + "]:FILE:_files"));
  EXPECT_THAT(specs[1], Contains("::file:_files"));
  EXPECT_THAT(completion.files(), ElementsAre("driver", "script"));
}

TEST(Completion, EveryScriptIsWhole) {
  for (const std::string name : {"bash", "zsh", "fish"}) {
    const std::string script = script_of(name);
    EXPECT_EQ(script, script_of(name));
    if (!is_there(name)) continue;
    const TemporaryFolder folder;
    write(folder / "script", script);
    const Outcome run = shell(name + " -n " + shell_quoted(folder / "script"));
    EXPECT_EQ(run.code, 0) << name;
    EXPECT_EQ(run.err, "") << name;
  }
}

}  // namespace
}  // namespace nazori::cli::test
