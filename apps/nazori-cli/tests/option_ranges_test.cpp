// SPDX-License-Identifier: Apache-2.0
// The ranges and default values of all options that take numbers, as docs/command-line.md and docs/study.md
// have them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;

using Words = std::vector<std::string>;

struct Range {
  Words verb;
  std::string option;
  std::string lowest, below;
  std::string highest, above;
};

const std::vector<Range>& ranges() {
  static const std::vector<Range> all{{{"info"}, "--words", "0", "-1", "100000", "100001"},
                                      {{"search"}, "--grade", "1", "0", "10", "11"},
                                      {{"search"}, "--strokes", "1", "0", "100", "101"},
                                      {{"search"}, "--jlpt", "1", "0", "4", "5"},
                                      {{"search"}, "--frequency", "1", "0", "100000", "100001"},
                                      {{"search"}, "--limit", "1", "0", "100000", "100001"},
                                      {{"carve"}, "--size", "2", "1", "8192", "8193"},
                                      {{"carve"}, "--width", "0.5", "0.49", "40", "40.1"},
                                      {{"carve"}, "--depth", "0.01", "0.009", "1", "1.01"},
                                      {{"render"}, "--stroke", "0", "-1", "1024", "1025"},
                                      {{"render"}, "--map-size", "2", "1", "8192", "8193"},
                                      {{"render"}, "--tilt", "0", "-0.1", "85", "85.1"},
                                      {{"render"}, "--azimuth", "-360", "-360.1", "360", "360.1"},
                                      {{"render"}, "--zoom", "0.2", "0.19", "20", "20.1"},
                                      {{"plot"}, "--size", "32", "31", "4096", "4097"},
                                      {{"plot"}, "--half-width", "0.001", "0.0009", "0.2", "0.21"},
                                      {{"feel"}, "--stroke", "0", "-1", "1024", "1025"},
                                      {{"feel"}, "--rate", "20", "19.9", "20000", "20001"},
                                      {{"feel"}, "--stiffness", "0", "-0.1", "1", "1.1"},
                                      {{"feel"}, "--damping", "0", "-0.1", "1", "1.1"},
                                      {{"feel"}, "--friction", "0,0", "0,-0.1", "10,10", "10.1,0"},
                                      {{"feel"}, "--roughness", "0", "-0.1", "1", "1.1"},
                                      {{"feel"}, "--map-size", "2", "1", "8192", "8193"},
                                      {{"devices"}, "--test", "0.1", "0.09", "3600", "3601"},
                                      {{"recognise"}, "--top", "1", "0", "1000", "1001"},
                                      {{"study", "review"}, "--score", "0", "-1", "100", "101"},
                                      {{"study", "review"}, "--hints", "0", "-1", "1000", "1001"},
                                      {{"study", "review"}, "--misses", "0", "-1", "1000", "1001"},
                                      {{"study", "review"}, "--shown", "0", "-1", "1000", "1001"},
                                      {{"study", "review"}, "--help-level", "0", "-0.1", "1", "1.1"},
                                      {{"study", "review"}, "--seconds", "0", "-1", "86400", "86401"},
                                      {{"study", "review"}, "--wait", "0", "-1", "86400", "86401"},
                                      {{"study", "undo"}, "--count", "1", "0", "100000", "100001"},
                                      {{"study", "postpone"}, "--days", "1", "0", "3650", "3651"},
                                      {{"study", "export"}, "--words", "0", "-1", "20", "21"}};
  return all;
}

/// What the program says about a value. An option that does not exist stops it before it does anything.
std::string said(const Range& range, const std::string& value) {
  Words line = range.verb;
  line.push_back(range.option + "=" + value);
  line.emplace_back("--no-such-option");
  const Outcome run = nazori_cli(line);
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.out, "");
  return run.err;
}

TEST(OptionRanges, EachNumberIsTakenUpToBothBoundsAndRefusedBeyondThem) {
  for (const Range& range : ranges()) {
    for (const std::string& fine : {range.lowest, range.highest})
      EXPECT_THAT(said(range, fine), HasSubstr("there is no option '--no-such-option'"))
          << range.verb.back() << " " << range.option << " " << fine;
    for (const std::string& wrong : {range.below, range.above})
      EXPECT_THAT(said(range, wrong), HasSubstr(range.option + ": ")) << range.verb.back() << " " << wrong;
  }
}

/// What the help of a verb says about an option, in one line.
std::string help_of(const Words& verb, const std::string& option) {
  static std::map<Words, std::string> pages;
  std::string& page = pages[verb];
  if (page.empty()) {
    Words line = verb;
    line.emplace_back("--help");
    page = nazori_cli(line).out;
  }
  std::string text;
  std::size_t begin = page.find("  " + option + " ");
  if (begin == std::string::npos) begin = page.find(", " + option + " ");
  if (begin == std::string::npos) return "";
  for (std::size_t at = begin; at < page.size();) {
    const std::size_t end = std::min(page.find('\n', at), page.size());
    const std::string row = page.substr(at, end - at);
    // The text goes on in the second column; another option begins in the first.
    if (at != begin && row.rfind("        ", 0) != 0) break;
    const std::size_t from = row.find_first_not_of(' ');
    text += (text.empty() ? "" : " ") + row.substr(from == std::string::npos ? 0 : from);
    at = end + 1;
  }
  return text;
}

TEST(OptionRanges, TheHelpTellsThem) {
  for (const Range& range : ranges()) {
    if (range.option == "--friction") continue;  // each of two numbers
    EXPECT_THAT(help_of(range.verb, range.option), HasSubstr("(" + range.lowest + ".." + range.highest))
        << range.verb.back() << " " << range.option;
  }
}

TEST(OptionRanges, TheHelpTellsWhatHoldsWithoutTheOption) {
  struct Default {
    Words verb;
    std::string option;
    std::string value;
  };
  const std::vector<Default> defaults{{{"carve"}, "--size", "128"},
                                      {{"carve"}, "--bits", "16"},
                                      {{"carve"}, "--depth", "1"},
                                      {{"carve"}, "--cross-section", "rounded"},
                                      {{"render"}, "--stroke", "0"},
                                      {{"render"}, "--size", "800x800"},
                                      {{"render"}, "--style", "wood"},
                                      {{"render"}, "--theme", "light"},
                                      {{"render"}, "--tilt", "0"},
                                      {{"render"}, "--azimuth", "0"},
                                      {{"render"}, "--zoom", "1"},
                                      {{"plot"}, "--window", "-10,10,-10,10"},
                                      {{"plot"}, "--size", "512"},
                                      {{"plot"}, "--half-width", "0.0125"},
                                      {{"plot"}, "--axes", "on"},
                                      {{"plot"}, "--language", "en"},
                                      {{"plot"}, "--speech", "verbose"},
                                      {{"demo"}, "--output", "{}-demo.png"},
                                      {{"demo"}, "--device", "touch"},
                                      {{"feel"}, "--mode", "contact"},
                                      {{"feel"}, "--stroke", "0"},
                                      {{"feel"}, "--device", "touch"},
                                      {{"feel"}, "--stiffness", "0.8"},
                                      {{"feel"}, "--damping", "0"},
                                      {{"feel"}, "--friction", "0,0"},
                                      {{"feel"}, "--texture", "none"},
                                      {{"feel"}, "--roughness", "0.5"},
                                      {{"grade"}, "--strictness", "normal"},
                                      {{"recognise"}, "--top", "10"},
                                      {{"recognise"}, "--among", "all"},
                                      {{"study", "review"}, "--score", "85"},
                                      {{"study", "review"}, "--stage", "memory"},
                                      {{"study", "review"}, "--profile", "learner"},
                                      {{"study", "review"}, "--wait", "0"},
                                      {{"study", "undo"}, "--count", "1"},
                                      {{"study", "postpone"}, "--days", "1"},
                                      {{"study", "export"}, "--words", "4"},
                                      {{"study", "export"}, "--deck", "Nazori"}};
  for (const Default& one : defaults)
    EXPECT_THAT(help_of(one.verb, one.option), HasSubstr("default: " + one.value + ")"))
        << one.verb.back() << " " << one.option;
}

TEST(OptionRanges, TheHelpOfMachinesPaperAndSheetsTellsThemWithWhatHoldsWithoutTheOption) {
  struct Note {
    Words verb;
    std::string option;
    std::string note;  ///< in parentheses at the end of what the help says
  };
  const Words model{"model"}, plot{"plot"}, paint{"paint"}, worksheet{"worksheet"};
  const Words check{"author", "check"}, convert{"author", "convert"}, trace{"author", "trace"};
  const std::vector<Note> notes{{model, "--columns", "1..50"},
                                {model, "--size-mm", "10..500; default: 100"},
                                {model, "--margin-mm", "0..100; default: 6"},
                                {model, "--gap-mm", "0..100; default: 0"},
                                {model, "--thickness-mm", "0.4..100"},
                                {model, "--depth-mm", "0.1..99; default: 3"},
                                {model, "--line-height-mm", "0.2..10; default: "},
                                {model, "--line-width-mm", "0.4..10; default: "},
                                {model, "--map-size", "2..8192"},
                                {model, "--cutter-mm", "0.2..20; default: 3"},
                                {model, "--step-over-mm", "0.02..5; default: 0.2"},
                                {model, "--pass-depth-mm", "0.05..50; default: 1.5"},
                                {model, "--safe-mm", "1..100; default: 5"},
                                {model, "--feed", "10..20000; default: 800"},
                                {model, "--plunge", "10..20000; default: 250"},
                                {model, "--spindle-rpm", "0..60000; default: 12000"},
                                {model, "--layers", "1..64; default: "},
                                {model, "--paper", "default: a4"},
                                {model, "--columns-braille", "12..100; default: 40"},
                                {model, "--lines-braille", "12..100; default: 25"},
                                {model, "--braille", "default: uncontracted"},
                                {plot, "--model-size-mm", "40..400; default: 120"},
                                {plot, "--columns-braille", "12..100; default: 40"},
                                {paint, "--paper", "default: hanshi"},
                                {paint, "--brush", "default: mixed"},
                                {paint, "--number", "1..6; default: 6"},
                                {paint, "--ink", "default: sumi"},
                                {paint, "--load", "0..1; default: 1"},
                                {paint, "--strength", "0..4; default: 1"},
                                {paint, "--lean", "0..60; default: 0"},
                                {paint, "--size-mm", "10..102; default: 85"},
                                {paint, "--cells", "default: 1024"},
                                {paint, "--after", "0..600; default: 5"},
                                {worksheet, "--grade", "1..6"},
                                {worksheet, "--layout", "default: practice"},
                                {worksheet, "--paper", "default: a4"},
                                {worksheet, "--cell-mm", "8..60; default: 15"},
                                {worksheet, "--guide", "default: 十"},
                                {worksheet, "--rows", "0..40; default: 2"},
                                {worksheet, "--copies", "0..40; default: 4"},
                                {worksheet, "--per-sheet", "default: 4"},
                                {worksheet, "--language", "default: en"},
                                {{"demo"}, "--tip-radius-mm", "0..3; default: 0"},
                                {check, "--grid", "2..8192"},
                                {check, "--tip-mm", "0.1..10; default: "},
                                {convert, "--grid", "2..8192"},
                                {convert, "--size", "2..8192"},
                                {trace, "--size", "2..8192; default: 512"}};
  for (const Note& one : notes)
    EXPECT_THAT(help_of(one.verb, one.option),
                HasSubstr("(" + one.note + (one.note.ends_with(' ') ? "" : ")")))
        << one.verb.back() << " " << one.option;
}

}  // namespace
}  // namespace nazori::cli::test
