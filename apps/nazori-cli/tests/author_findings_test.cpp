// SPDX-License-Identifier: Apache-2.0
// The sentences of author check.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsSupersetOf;

/// A character as KanjiVG's files have it. @param paths  the strokes. @param numbers  the places of their
/// numbers.
std::string svg(const std::vector<std::string>& paths, const std::vector<std::string>& numbers) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"109\" height=\"109\" viewBox=\"0 0 109 109\">\n"
      "<g id=\"kvg:StrokePaths_04e8c\" style=\"fill:none;stroke:#000000\">\n"
      "<g id=\"kvg:04e8c\" kvg:element=\"二\">\n";
  for (std::size_t i = 0; i < paths.size(); ++i)
    text +=
        "<path id=\"kvg:04e8c-s" + std::to_string(i + 1) + "\" kvg:type=\"㇐\" d=\"" + paths[i] + "\"/>\n";
  text += "</g>\n</g>\n<g id=\"kvg:StrokeNumbers_04e8c\" style=\"font-size:8;fill:#808080\">\n";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text += "<text transform=\"matrix(1 0 0 1 " + numbers[i] + ")\">" + std::to_string(i + 1) + "</text>\n";
  return text + "</g>\n</svg>\n";
}

class AuthorFindings : public testing::Test {
 protected:
  std::vector<std::string> messages(const std::string& text, const std::vector<std::string>& options = {}) {
    write(folder_ / "a.svg", text);
    std::vector<std::string> arguments{"author", "check", folder_ / "a.svg", "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome run = nazori_cli(arguments);
    EXPECT_EQ(run.err, "");
    answer_ = nlohmann::json::parse(run.out).at(0);
    std::vector<std::string> all;
    for (const auto& finding : answer_.at("findings")) all.push_back(finding.at("message"));
    return all;
  }
  std::vector<std::string> changed(const std::string& from, const std::string& to) {
    std::string text = svg({"M20,30L90,30", "M10,80L100,80"}, {"13 28", "3 78"});
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return messages(text.replace(at, from.size(), to));
  }
  TemporaryFolder folder_;
  nlohmann::json answer_;
};

TEST_F(AuthorFindings, OfTheFormOfAnSvgQuoteWhatIsThere) {
  EXPECT_THAT(changed("0 0 109 109", "0 0 108 109"), Contains("viewBox is '0 0 108 109', not '0 0 109 109'"));
  EXPECT_THAT(changed("width=\"109\"", "width=\"110\""), Contains("width or height is '110', not 109"));
  EXPECT_THAT(changed("StrokeNumbers_04e8c", "StrokeNumbers_04e8d"),
              Contains("the group 'kvg:StrokeNumbers_04e8d' is not named after the character"));
  EXPECT_THAT(changed(" style=\"font-size:8;fill:#808080\"", ""),
              Contains("the group 'kvg:StrokeNumbers_04e8c' has no style"));
  EXPECT_THAT(changed("kvg:04e8c-s2", "kvg:04e8c-s3"),
              Contains("the path 'kvg:04e8c-s3' is not named after its stroke, 2"));
  EXPECT_THAT(changed(">2</text>", ">3</text>"), Contains("the number '3' is not in order"));
  EXPECT_THAT(changed("</text>\n</g>", "</text>\n<text>3</text></g>"),
              Contains("there are 3 numbers, not one for each stroke"));
  EXPECT_THAT(changed("<g id=\"kvg:04e8c\" kvg:element=\"二\">",
                      "<g id=\"kvg:04e8c\" kvg:element=\"二\"><g id=\"kvg:04e8c-g7\"/>"),
              Contains("the group 'kvg:04e8c-g7' is not named after its number"));
}

TEST_F(AuthorFindings, OfStrokesAndNumbersCountFromOne) {
  // The second stroke turns back, the third is a dot, the fourth leaves the picture, the fifth lies on the
  // first.
  const auto found = messages(svg(
      {"M20,30L90,30", "M10,80L60,80L20,80.5L100,81", "M50,50L50.3,50", "M60,60L60,120", "M20,30.2L90,30.2"},
      {"20 8", "3 78", "45 48", "55 58", "55 59"}));
  EXPECT_THAT(found, IsSupersetOf({"the number of stroke 1 is 22.0 units from its start",
                                   "the numbers of strokes 4 and 5 cover one another",
                                   "stroke 3 is only 0.30 units long", "stroke 5 lies on stroke 1",
                                   "point 5 of stroke 4 is outside the picture",
                                   "stroke 2 turns back at point 5", "the dictionary counts 2 strokes"}))
      << testing::PrintToString(found);
  for (const auto& finding : answer_.at("findings")) {
    if (finding.at("kind") == "doubled") {
      EXPECT_EQ(finding.at("stroke"), 1);
      EXPECT_EQ(finding.at("second"), 5);
      EXPECT_TRUE(finding.at("point").is_null());
    }
    if (finding.at("kind") == "outside") {
      EXPECT_EQ(finding.at("stroke"), 4);
      EXPECT_EQ(finding.at("point"), 5);
      EXPECT_NEAR(finding.at("at")[0].get<double>(), 60, 1e-6);
      EXPECT_GT(finding.at("at")[1].get<double>(), 109);
    }
  }
  EXPECT_EQ(answer_.at("strokes"), 5);
  EXPECT_EQ(answer_.at("name"), "二");
  EXPECT_EQ(answer_.at("version"), 1);
}

TEST_F(AuthorFindings, OfWallsAreInMillimetresOfATabletOfTenCentimetres) {
  // A millimetre is 1.09 units: 7 units wide are 6.4 mm.
  const auto found =
      messages(svg({"M20,30L90,30", "M20,40.27L90,40.27"}, {"13 28", "13 45"}), {"--tip-mm", "8"});
  EXPECT_THAT(found, IsSupersetOf({"stroke 1 is only 6.4 mm wide, narrower than the tip",
                                   "stroke 2 is only 6.4 mm wide, narrower than the tip"}))
      << testing::PrintToString(found);
  const auto wall = std::find_if(answer_["findings"].begin(), answer_["findings"].end(),
                                 [](const auto& one) { return one["kind"] == "thin_wall"; });
  ASSERT_NE(wall, answer_["findings"].end());
  const double mm = std::round((*wall)["amount"].get<double>() / 1.09 * 10) / 10;
  EXPECT_EQ((*wall)["message"], "the wall between strokes 1 and 2 is " + std::to_string(mm).substr(0, 3) +
                                    " mm, thinner than the tip");
}

TEST_F(AuthorFindings, ForPeopleAreCountedAndHaveTheirSeverity) {
  write(folder_ / "two.svg", svg({"M20,30L90,30", "M10,80L100,80"}, {"13 28", "3 78"}));
  write(folder_ / "one.svg", svg({"M20,30L90,30"}, {"13 28"}));
  const Outcome run = nazori_cli({"author", "check", folder_ / "two.svg", folder_ / "one.svg"});
  EXPECT_EQ(run.code, 0) << "notes do not count";
  EXPECT_EQ(run.out, (folder_ / "two.svg") + "  2 strokes: no findings\n" + (folder_ / "one.svg") +
                         "  1 stroke: 1 finding\n  note    the dictionary counts 2 strokes\n");
}

}  // namespace
}  // namespace nazori::cli::test
