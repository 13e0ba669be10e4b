// SPDX-License-Identifier: Apache-2.0
// What is said about a file that was made, and about the samples of a servo.
#include <gtest/gtest.h>

#include "solid_model.h"
#include "statistics_text.h"
#include "touch_options.h"

namespace nazori::cli {
namespace {

using practice::TouchFile;
using practice::TouchKind;

TouchFile made(TouchKind kind) {
  TouchFile file;
  file.kind = kind;
  file.width_mm = 112.34;
  file.height_mm = 98.76;
  return file;
}

TEST(MadeText, APlateOfAMillIsToldWithItsPassesItsDepthItsWayAndItsTime) {
  TouchFile file = made(TouchKind::mill);
  file.path.passes = 3;
  file.path.deepest_mm = 2.996;
  file.path.cut_length_mm = 4560;
  file.path.minutes = 7.1;
  EXPECT_EQ(touch_text(file, "休", "a.nc"),
            "休  a.nc  112.3 x 98.76 mm, 3 passes down to 3.00 mm, 4.6 m in about 8 min\n");
}

TEST(MadeText, PagesAreToldWhereThereAreSeveral) {
  TouchFile file = made(TouchKind::embosser);
  EXPECT_EQ(touch_text(file, "休", "a.brf"), "休  a.brf  112.3 x 98.76 mm\n");
  file.pages = 2;
  EXPECT_EQ(touch_text(file, "休", "a.brf"), "休  a.brf  112.3 x 98.76 mm, 2 pages\n");
}

TEST(MadeText, WhatDoesNotSuitAFingerStandsInALineOfItsOwn) {
  TouchFile file = made(TouchKind::swell_paper);
  file.without_number = {2, 5};
  file.closest_mm = 3.2;
  EXPECT_EQ(touch_text(file, "休", "a.pdf"),
            "休  a.pdf  112.3 x 98.76 mm\n"
            "no room for the numbers of strokes 2, 5: a larger --size-mm has more\n"
            "lines run 3.2 mm apart: fingers tell lines apart from 6.4 mm, so take 2.00 times the size\n");
  file.closest_mm = 0;
  EXPECT_EQ(close_lines_text(file), "") << "none run side by side";
  file.closest_mm = 6.4;
  EXPECT_EQ(close_lines_text(file), "") << "far enough";
  file.closest_mm = 6.3;
  EXPECT_EQ(close_lines_text(file),
            "lines run 6.3 mm apart: fingers tell lines apart from 6.4 mm, so take 1.02 times the size\n");
  file.closest_mm = 0.9;
  EXPECT_EQ(close_lines_text(file),
            "lines run 0.9 mm apart: fingers tell lines apart from 6.4 mm, so take 7.11 times the size\n");
  EXPECT_EQ(without_number_text({7}), "no room for the numbers of strokes 7: a larger --size-mm has more\n");
  EXPECT_EQ(without_number_text({}), "");
}

TEST(MadeText, TheAnswerNamesTheKindAndOnlyAMillMills) {
  for (const auto& [kind, name] :
       {std::pair(TouchKind::mill, "mill"), std::pair(TouchKind::laser, "laser"),
        std::pair(TouchKind::swell_paper, "swell-paper"), std::pair(TouchKind::embosser, "embosser")}) {
    TouchFile file = made(kind);
    file.pages = 4;
    file.without_number = {3};
    file.closest_mm = 5.5;
    file.path.passes = 2;
    file.path.deepest_mm = 1.5;
    file.path.cut_length_mm = 300;
    file.path.minutes = 6;
    const auto answer = answer_of(file, "休", "a.x");
    EXPECT_EQ(answer.subject, "休");
    EXPECT_EQ(answer.file, "a.x");
    EXPECT_EQ(answer.kind, name);
    EXPECT_EQ(answer.width_mm, 112.34);
    EXPECT_EQ(answer.height_mm, 98.76);
    EXPECT_EQ(answer.pages, 4);
    EXPECT_EQ(answer.without_number, std::vector<int>{3});
    EXPECT_EQ(answer.closest_mm, 5.5);
    ASSERT_EQ(answer.milling.has_value(), kind == TouchKind::mill);
    if (!answer.milling) continue;
    EXPECT_EQ(answer.milling->passes, 2);
    EXPECT_EQ(answer.milling->deepest_mm, 1.5);
    EXPECT_EQ(answer.milling->cut_length_mm, 300);
    EXPECT_EQ(answer.milling->minutes, 6);
  }
}

TEST(MadeText, ASolidIsToldInMillimetresWithItsTriangles) {
  exchange::SolidModel solid;
  solid.subject = "休";
  solid.file = "a.stl";
  solid.width_mm = 112;
  solid.height_mm = 96.5;
  solid.thickness_mm = 6.25;
  solid.triangles = 12345;
  solid.error_mm = 0.0196;
  EXPECT_EQ(model_text(solid), "休  a.stl  112 x 96.5 x 6.25 mm, 12345 triangles within 0.020 mm\n");
  solid.without_number = {1, 2};
  EXPECT_EQ(model_text(solid),
            "休  a.stl  112 x 96.5 x 6.25 mm, 12345 triangles within 0.020 mm\n"
            "no room for the numbers of strokes 1, 2: a larger --size-mm has more\n");
}

TEST(MadeText, PaperAndBrailleAreTakenByTheirNames) {
  PaperOptions paper;
  for (const auto& [name, kind] : {std::pair("a4", print::Paper::a4), std::pair("b5", print::Paper::b5),
                                   std::pair("letter", print::Paper::letter)}) {
    paper.swell = name;
    EXPECT_EQ(paper.paper(), kind);
  }
  TouchOptions options;
  EXPECT_EQ(options.english(), model::EnglishBraille::uncontracted);
  options.braille = "contracted";
  EXPECT_EQ(options.english(), model::EnglishBraille::contracted);
}

/// Four samples, a tenth of a second apart. In the second and the third the stylus is in contact: pressed in
/// by 2 mm against 0.5 N, then let out by 1 mm against 0.25 N.
TEST(SamplesInText, AreSummedUpInNewtonsMillimetresAndMillijoules) {
  recording::SampleStatistics samples;
  EXPECT_EQ(statistics_text(samples, 1000),
            "ticks    0 in 0.000 s at 1000 Hz, 0 % in contact\n"
            "force    mean 0.000 N, in contact 0.000 N, peak 0.000 N\n"
            "depth    at most 0.000 mm behind the surface\n"
            "energy   put in 0.000 mJ, got back 0.000 mJ, dissipated 0.000 mJ\n"
            "events   none\n");
  const double heights_m[] = {0, 0, -0.002, -0.001};
  const double forces_n[] = {0, 0.5, 0.25, 0};
  for (int i = 0; i < 4; ++i) {
    haptics::ServoSample sample;
    sample.tick = static_cast<std::uint64_t>(i);
    sample.time_s = 2 + 0.1 * i;
    sample.device_m = {0, 0, heights_m[i]};
    sample.proxy_m = {0, 0, 0};
    sample.force_n = {0, 0, forces_n[i]};
    sample.touching = i == 1 || i == 2;
    samples.add(sample);
  }
  const std::string text = statistics_text(samples, 10);
  EXPECT_EQ(text.find("ticks    4 in 0.300 s at 10 Hz, 50 % in contact\n"), 0U) << text;
  EXPECT_NE(text.find("\nforce    mean 0.188 N, in contact 0.375 N, peak 0.500 N\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\ndepth    at most 2.000 mm behind the surface\n"), std::string::npos) << text;
  // The hand pushes 2 mm against 0.5 N, which is 1 mJ, and gets 1 mm of 0.25 N back.
  EXPECT_NE(text.find("\nenergy   put in 1.000 mJ, got back 0.250 mJ, dissipated 0.750 mJ\n"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace nazori::cli
