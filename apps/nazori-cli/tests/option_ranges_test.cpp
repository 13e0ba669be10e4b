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

}  // namespace
}  // namespace nazori::cli::test
