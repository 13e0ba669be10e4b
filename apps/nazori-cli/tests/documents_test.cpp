// SPDX-License-Identifier: Apache-2.0
// docs/command-line.md has the help of the commands, and examples with what they print.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "help_pages.h"
#include "program.h"
#include "test_paths.h"

namespace nazori::cli::test {
namespace {

using testing::UnorderedElementsAreArray;

using Words = std::vector<std::string>;

std::string document() {
  const auto bytes = bytes_of(std::string(test_paths::kDocs) + "/command-line.md");
  return {bytes.begin(), bytes.end()};
}

Words joined(std::initializer_list<Words> parts) {
  Words all;
  for (const Words& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

struct Entries {
  Words options;
  Words arguments;
};

/// The commands that the document describes in sentences and tables.
const std::map<std::string, Entries>& described_in_words() {
  static const Words asked{"-h", "--help"}, answers{"-h", "--help", "-q", "--quiet"};
  static const Words learner = joined({answers, {"--profile", "--learners", "--now", "--json"}});
  static const Words writer = joined({learner, {"--wait"}});
  static const Words both = joined({writer, {"--database"}});
  static const std::map<std::string, Entries> all{
      {"author", {asked, {}}},
      {"grade", {joined({answers, {"--strictness", "--live", "--explain", "--database"}}), {}}},
      {"recognise", {joined({answers, {"--top", "--unfinished", "--among", "--database"}}), {}}},
      {"speak",
       {joined(
            {answers, {"-o", "--output", "--voice", "--voice-file", "--recordings", "--voices", "--json"}}),
        {"kana..."}}},
      {"study", {asked, {}}},
      {"study due", {joined({learner, {"--database"}}), {}}},
      {"study next", {joined({learner, {"--database"}}), {}}},
      {"study review",
       {joined({both,
                {"--rating", "--stage", "--rejected", "--score", "--fault", "--hints", "--misses", "--shown",
                 "--help-level", "--seconds"}}),
        {"character"}}},
      {"study undo", {joined({writer, {"-n", "--count"}}), {}}},
      {"study know", {joined({both, {"--text"}}), {"characters..."}}},
      {"study postpone", {joined({both, {"--days"}}), {"characters..."}}},
      {"study pause", {both, {"characters..."}}},
      {"study resume", {both, {"characters..."}}},
      {"study reset", {both, {"characters..."}}},
      {"study leech", {both, {"characters..."}}},
      {"study settings", {joined({writer, {"--weights"}}), {"changes..."}}},
      {"study stats", {learner, {}}},
      {"study workload", {learner, {}}},
      {"study lists", {joined({both, {"--import", "--as", "--remove"}}), {"list"}}},
      {"study tag", {joined({both, {"--with"}}), {"characters..."}}},
      {"study profiles", {joined({writer, {"--rename", "--remove"}}), {}}},
      {"study export",
       {joined({learner, {"-o", "--output", "--list", "--deck", "--words", "--database"}}), {}}},
      {"study import", {writer, {"file"}}},
      {"study backup", {joined({learner, {"-o", "--output"}}), {}}},
      {"study restore", {joined({writer, {"--list"}}), {"file"}}},
      {"study rebuild", {writer, {}}},
      {"study replay", {joined({learner, {"--check"}}), {"file"}}}};
  return all;
}

TEST(Documents, HaveTheHelpOfEachCommandAsItIsPrinted) {
  const std::string text = document();
  for (const HelpPage& page : help_pages()) {
    if (described_in_words().contains(page.path())) continue;
    Words line = page.verb;
    line.emplace_back("--help");
    const std::string help = nazori_cli(line).out;
    EXPECT_NE(text.find("\n```\n" + help + "```\n"), std::string::npos)
        << "docs/command-line.md shows another help of '" << page.path() << "' than this:\n"
        << help;
  }
}

TEST(Documents, KnowTheOptionsOfTheOtherCommands) {
  std::size_t known = 0;
  for (const HelpPage& page : help_pages()) {
    const auto found = described_in_words().find(page.path());
    if (found == described_in_words().end()) continue;
    ++known;
    EXPECT_THAT(page.options, UnorderedElementsAreArray(found->second.options)) << page.path();
    EXPECT_THAT(page.arguments, UnorderedElementsAreArray(found->second.arguments)) << page.path();
  }
  EXPECT_EQ(known, described_in_words().size());
}

/// What the document shows after the line of a command, up to the next one or to the end of the block.
std::string shown_after(const std::string& text, const std::string& command) {
  const std::string line = "\n$ " + command + "\n";
  const std::size_t at = text.find(line);
  if (at == std::string::npos) return "no such example: " + command;
  const std::size_t begin = at + line.size();
  const std::size_t end = std::min(text.find("\n```", begin), text.find("\n$ ", begin));
  std::string shown = text.substr(begin, end - begin);
  while (shown.ends_with('\n')) shown.pop_back();
  return shown + "\n";
}

TEST(Documents, HaveExamplesWithWhatIsPrinted) {
  const std::string text = document();
  const std::vector<std::pair<std::string, Words>> examples{
      {"nazori-cli info 休", {"info", "休"}},
      {"nazori-cli search rest --limit 4", {"search", "rest", "--limit", "4"}},
      {"nazori-cli search きゅうじつ", {"search", "きゅうじつ"}},
      {"nazori-cli search --radical 亻 --grade 1", {"search", "--radical", "亻", "--grade", "1"}},
      {"nazori-cli plot 'y = tan(x); y = 1' --window=-2,2,-4,4 --points",
       {"plot", "y = tan(x); y = 1", "--window=-2,2,-4,4", "--points"}}};
  for (const auto& [command, arguments] : examples) {
    const Outcome run = nazori_cli(arguments);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.out, shown_after(text, command));
  }
  EXPECT_EQ(nazori_cli({"plot", "y = 2 +", "--output", "a.png"}).err,
            shown_after(text, "nazori-cli plot 'y = 2 +' --output a.png"));
}

TEST(Documents, HaveExamplesOfFilesWithWhatIsPrinted) {
  const std::string text = document();
  const TemporaryFolder folder;
  const auto here = [&](const Words& arguments) {
    const Outcome run = nazori_cli(arguments, {}, folder.path());
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out;
  };
  EXPECT_EQ(here({"carve", "休", "--size", "128", "--output", "休.raw", "--strokes", "休.str"}),
            shown_after(text, "nazori-cli carve 休 --size 128 --output 休.raw --strokes 休.str"));
  EXPECT_EQ(here({"render", "休", "木", "--output", "{}.png", "--tilt", "30"}),
            shown_after(text, "nazori-cli render 休 木 --output '{}.png' --tilt 30"));
  const Outcome practised = shell(
      "printf '%s\\n' '{\"stage\": \"memory\"}' '{\"strokes\": [[[14, 54], [95, 54]]]}' | \"$NAZORI\" "
      "practise 一");
  EXPECT_EQ(practised.out, shown_after(text,
                                       "printf '%s\\n' '{\"stage\": \"memory\"}' '{\"strokes\": [[[14, 54], "
                                       "[95, 54]]]}' | nazori-cli practise 一"));
}

}  // namespace
}  // namespace nazori::cli::test
