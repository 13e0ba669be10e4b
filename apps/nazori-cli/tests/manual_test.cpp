// SPDX-License-Identifier: Apache-2.0
// The manual page: whole, readable by man, and the same wherever it is made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "completion_script.h"
#include "help_pages.h"
#include "manual_page.h"
#include "odd_command_line.h"
#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::UnorderedElementsAreArray;

std::string page() {
  const Outcome run = nazori_cli({"manual"}, {"SOURCE_DATE_EPOCH="});
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  return run.out;
}

/// The lines from `heading` to the next heading.
std::string section(const std::string& text, const std::string& heading) {
  std::istringstream lines(text);
  std::string found;
  bool within = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(".SH ") || line.starts_with(".SS ")) within = line == heading;
    if (within) found += line + "\n";
  }
  return found;
}

/// Every option in bold at the start of an entry, without escapes.
std::vector<std::string> options_in(const std::string& text) {
  std::vector<std::string> options;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string start = "\\fB\\-";
    for (std::size_t at = line.find(start); at != std::string::npos; at = line.find(start, at + 1)) {
      std::string name = line.substr(at + 3, line.find("\\fR", at) - at - 3);
      std::erase(name, '\\');
      options.push_back(name);
    }
  }
  return options;
}

/// The warnings of man about a page, and the rendered page.
Outcome shown_by_man(const std::string& text, const std::string& options) {
  const TemporaryFolder folder;
  write(folder / "page.1", text);
  return shell("LC_ALL=C.UTF-8 man " + options + " -l " + shell_quoted(folder / "page.1"));
}

bool man_is_there() { return shell("command -v man && command -v groff").code == 0; }

TEST(Manual, HasTheSectionsOfAManualPage) {
  std::vector<std::string> headings;
  std::istringstream lines(page());
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(".SH ")) headings.push_back(line.substr(4));
  }
  EXPECT_THAT(headings, testing::ElementsAre("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "VERBS",
                                             "ENVIRONMENT", "FILES", "EXIT STATUS", "EXAMPLES", "SEE ALSO"));
}

TEST(Manual, EveryVerbAndOptionOfHelpHasItsEntryAndNoOther) {
  const std::string text = page();
  for (const HelpPage& help : help_pages()) {
    const std::string heading =
        help.verb.empty() ? ".SH OPTIONS" : ".SS " + roff_escaped("nazori-cli " + help.path());
    const std::string entries = section(text, heading);
    ASSERT_NE(entries, "") << heading;
    std::vector<std::string> options = help.options;
    // Described once, for the program.
    const std::vector<std::string> told_once{"-h", "--help", "-q", "--quiet"};
    if (!help.verb.empty()) {
      std::erase_if(options, [&](const auto& o) {
        return std::find(told_once.begin(), told_once.end(), o) != told_once.end();
      });
    }
    EXPECT_THAT(options_in(entries), UnorderedElementsAreArray(options)) << heading;
    for (const std::string& argument : help.arguments) {
      EXPECT_THAT(entries, HasSubstr("\n\\fI" + roff_escaped(argument) + "\\fR\n")) << heading;
    }
  }
}

TEST(Manual, TellsOnceWhatEveryVerbTakesAndNamesEveryExitCode) {
  const std::string text = page();
  EXPECT_THAT(section(text, ".SH OPTIONS"), HasSubstr("\\-q \", \" \\-\\-quiet"));
  const std::string codes = section(text, ".SH EXIT STATUS");
  for (const char* code : {".B 0", ".B 1", ".B 2", ".B 3", ".BR 130 \", \" 143"})
    EXPECT_THAT(codes, HasSubstr(code));
}

TEST(Manual, NamesTheEnvironmentAndShowsExamples) {
  const std::string environment = section(page(), ".SH ENVIRONMENT");
  for (const char* name : {"NAZORI_DATA", "NAZORI_LEARNERS", "NAZORI_CHARACTERS", "NAZORI_NOW",
                           "XDG_DATA_HOME", "XDG_DATA_DIRS", "XDG_CACHE_HOME", "SOURCE_DATE_EPOCH"}) {
    EXPECT_THAT(environment, HasSubstr(name));
  }
  EXPECT_THAT(section(page(), ".SH EXAMPLES"),
              HasSubstr(roff_escaped("nazori-cli carve 休 --size 128 --output 休.raw --strokes 休.str")));
}

TEST(Manual, BearsTheDateOfItsSourcesOrNone) {
  const Outcome dated = nazori_cli({"manual"}, {"SOURCE_DATE_EPOCH=1767225600"});
  EXPECT_THAT(dated.out, HasSubstr("\n.TH NAZORI\\-CLI 1 \"2026\\-01\\-01\" "));
  EXPECT_THAT(page(), HasSubstr("\n.TH NAZORI\\-CLI 1 \"\" "));
  EXPECT_EQ(page(), page());
  for (const char* bad : {"today", "1767225600.5", "-1", "999999999999999"}) {
    expect_one_line(nazori_cli({"manual"}, {std::string("SOURCE_DATE_EPOCH=") + bad}), 2,
                    {"SOURCE_DATE_EPOCH", bad, "1970"});
  }
}

TEST(Manual, ManReadsItWithoutAWarning) {
  if (!man_is_there()) GTEST_SKIP() << "man is not installed";
  const Outcome run = shown_by_man(page(), "--warnings -E UTF-8 -Tutf8 -Z");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("x T utf8"));
}

TEST(Manual, NothingOfADescriptionIsARequest) {
  const OddCommandLine odd;
  const std::string text = manual_page(command_table(odd.app), "1", "");
  std::istringstream lines(text);
  const std::vector<std::string> requests{".TH", ".SH", ".SS", ".TP", ".PP", ".EX",  ".EE",
                                          ".B",  ".BR", ".I",  ".IR", ".RI", ".\\\""};
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('.')) {
      EXPECT_THAT(requests, testing::Contains(line.substr(0, line.find(' '))));
    }
    EXPECT_THAT(line, Not(testing::StartsWith("'")));
  }
  if (!man_is_there()) GTEST_SKIP() << "man is not installed";
  const Outcome run = shown_by_man(text, "--warnings --no-hyphenation --no-justification");
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(in_one_line(run.out), HasSubstr(kOddDescription + " (required)"));
}

TEST(Manual, HasOfEachCommandItsUseItsEntriesAndItsProse) {
  CLI::App app("Does it", "nazori-cli");
  std::string text;
  CLI::App* make = app.add_subcommand("make", "Make it");
  make->add_option("name", text, "The name")->required();
  make->add_option("other", text, "The other name");
  make->add_option("-s,--size", text, "The size")->type_name("N")->default_str("4");
  make->add_option("--form", text, "The form")->group("Looks")->type_name("F");
  make->footer(
      "First line\nof a paragraph.\n\nAnother one.\n\nExamples:\n  nazori-cli make a\n\n  nazori-cli make b");
  CLI::App* group = app.add_subcommand("group", "Of two");
  group->add_subcommand("inner", "Inside");
  group->footer("Example:\n  nazori-cli group inner");  // one that is added later would inherit it
  const std::string page = manual_page(command_table(app), "1.2", "2026-01-01");
  EXPECT_TRUE(
      page.starts_with(".\\\" Written by: nazori\\-cli manual\n"
                       ".TH NAZORI\\-CLI 1 \"2026\\-01\\-01\" \"Nazori 1.2\" \"User Commands\"\n"))
      << page.substr(0, 200);
  EXPECT_EQ(section(page, ".SS nazori\\-cli make"),
            ".SS nazori\\-cli make\nMake it.\n.PP\n.EX\nnazori\\-cli make [options] name [other]\n.EE\n"
            ".TP\n\\fIname\\fR\nThe name\n.TP\n\\fIother\\fR\nThe other name\n"
            ".TP\n\\fB\\-s\\fR, \\fB\\-\\-size\\fR \\fIN\\fR\nThe size (default: 4)\n"
            ".PP\nLooks:\n.TP\n\\fB\\-\\-form\\fR \\fIF\\fR\nThe form\n"
            ".PP\nFirst line of a paragraph.\n.PP\nAnother one.\n");
  EXPECT_EQ(section(page, ".SS nazori\\-cli group"),
            ".SS nazori\\-cli group\nOf two.\n.PP\n.EX\nnazori\\-cli group [options] VERB\n.EE\n");
  EXPECT_EQ(section(page, ".SH EXAMPLES"),
            ".SH EXAMPLES\n.PP\nMake it:\n.PP\n.EX\nnazori\\-cli make a\nnazori\\-cli make b\n.EE\n")
      << "those of a group are its commands' own";
  EXPECT_TRUE(page.ends_with("\n.SH SEE ALSO\n.BR nazori (1)\n"));
}

TEST(Manual, LinesAreFilledToSeventyEightBytes) {
  const auto lines_of = [](const std::string& description) {
    CLI::App app("Does it", "nazori-cli");
    app.add_subcommand("make", description);
    std::istringstream lines(section(manual_page(command_table(app), "1", ""), ".SS nazori\\-cli make"));
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    return std::vector<std::string>(all.begin() + 1, std::find(all.begin(), all.end(), ".PP"));
  };
  const std::string forty(40, 'a');
  // With the full stop and the space 78 and 79 bytes.
  EXPECT_THAT(lines_of(forty + " " + std::string(36, 'b')),
              testing::ElementsAre(forty + " " + std::string(36, 'b') + "."));
  EXPECT_THAT(lines_of(forty + " " + std::string(37, 'b')),
              testing::ElementsAre(forty, std::string(37, 'b') + "."));
  EXPECT_THAT(lines_of(forty + " b c " + forty + " d"), testing::ElementsAre(forty + " b c", forty + " d."));
  EXPECT_THAT(lines_of(std::string(100, 'w') + " x"), testing::ElementsAre(std::string(100, 'w'), "x."));
}

TEST(Manual, EscapesWhatRoffReads) {
  EXPECT_EQ(roff_escaped(".a"), "\\&.a");
  EXPECT_EQ(roff_escaped("a.b\\c-d'e\"f\ng"), "a.b\\(rsc\\-d\\(aqe\\(dqf g");
  EXPECT_EQ(roff_escaped("`a^b~c"), "\\(gaa\\(hab\\(tic");
}

}  // namespace
}  // namespace nazori::cli::test
