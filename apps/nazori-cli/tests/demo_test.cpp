// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

Outcome demo(std::vector<std::string> arguments, const std::string& picture) {
  arguments.insert(arguments.begin(), "demo");
  arguments.insert(arguments.end(), {"--size", "200", "--output", picture});
  return nazori_cli(arguments);
}

Json strokes_of(const Outcome& run) {
  EXPECT_EQ(run.code, 0) << run.err;
  return Json::parse(run.out).at(0).at("strokes");
}

TEST(Demo, TheGrooveHoldsTheTipNearerToTheLineThanTheHandAims) {
  const TemporaryFolder folder;
  const Json strokes = strokes_of(demo({"休", "--json"}, folder / "a.png"));
  ASSERT_EQ(strokes.size(), 6U);
  int held = 0;
  for (const Json& stroke : strokes) {
    EXPECT_GT(stroke["contact_share"], 0.85) << stroke;
    EXPECT_GT(stroke["traced_share"], 0.9) << stroke;
    EXPECT_GT(stroke["mean_depth_m"], 0.004) << stroke;
    EXPECT_LE(stroke["mean_depth_m"], 0.010) << stroke;
    EXPECT_GT(stroke["mean_force_n"], 0.05) << stroke;
    // The limits of the device: 3.3 N at the peak.
    EXPECT_LE(stroke["peak_force_n"], 3.3) << stroke;
    EXPECT_EQ(stroke["snapped_share"], 0) << stroke;
    // A hand that deviates at a crossing may slip into the other groove; it notices that and comes back.
    EXPECT_LE(stroke["slips"], 1) << stroke;
    if (stroke["slips"] > 0) continue;
    ++held;
    // Half the width of a groove of 休 is 3.2 mm: within it all the time, except where another groove
    // crosses.
    EXPECT_LT(stroke["tip_max_m"], 0.0050) << stroke;
    EXPECT_LT(stroke["tip_rms_m"], 0.8 * stroke["aim_rms_m"].get<double>()) << stroke;
  }
  EXPECT_GE(held, 4);
}

TEST(Demo, SnappingKeepsTheTipOnTheStroke) {
  const TemporaryFolder folder;
  for (const Json& stroke : strokes_of(demo({"休", "--snap", "--json"}, folder / "a.png"))) {
    EXPECT_GT(stroke["snapped_share"], 0.95) << stroke;
    EXPECT_LT(stroke["tip_max_m"], 0.0002) << stroke;
    EXPECT_LE(stroke["peak_force_n"], 3.3) << stroke;
  }
}

TEST(Demo, EveryDeviceHoldsTheHandWithinItsOwnForce) {
  const TemporaryFolder folder;
  for (const auto& [name, newtons] : std::vector<std::pair<std::string, double>>{
           {"touch", 3.3}, {"touch-x", 7.9}, {"falcon", 8}, {"omega3", 12}, {"inverse3", 2}}) {
    const Json strokes = strokes_of(demo({"一", "--device", name, "--json"}, folder / "a.png"));
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_LE(strokes[0]["peak_force_n"], newtons) << name;
    EXPECT_LT(strokes[0]["tip_rms_m"], strokes[0]["aim_rms_m"]) << name;
    EXPECT_EQ(strokes[0]["slips"], 0) << name;
  }
}

TEST(Demo, LengthsAreThoseOfTheCharacter) {
  const TemporaryFolder folder;
  const Json strokes = strokes_of(demo({"一", "--json"}, folder / "a.png"));
  ASSERT_EQ(strokes.size(), 1U);
  // KanjiVG 4e00: from (11, 54.25) to (97.63, 52.66), hardly bent, on 109 units to 100 mm.
  EXPECT_NEAR(strokes[0]["length_m"], 0.0797, 0.002);
}

TEST(Demo, IsTheSameEveryTime) {
  const TemporaryFolder folder;
  const Outcome first = demo({"休", "--json"}, folder / "a.png");
  const auto picture = bytes_of(folder / "a.png");
  EXPECT_EQ(first.out, demo({"休", "--json"}, folder / "a.png").out);
  EXPECT_EQ(picture, bytes_of(folder / "a.png"));
}

TEST(Demo, ForPeopleHasALineForEachStrokeAndNamesThePicture) {
  const TemporaryFolder folder;
  const Outcome run = demo({"休", "木"}, folder / "{}.png");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* part : {"休", "6 strokes", "木", "4 strokes", "1 kHz", "休.png", "木.png"}) {
    EXPECT_THAT(run.out, HasSubstr(part));
  }
  EXPECT_THAT(folder.names(), testing::UnorderedElementsAre("休.png", "木.png"));
}

TEST(Demo, ForPeopleHasTheNumbersOfTheJson) {
  const TemporaryFolder folder;
  const Json json = Json::parse(demo({"一", "--json"}, folder / "a.png").out).at(0);
  const Json& stroke = json["strokes"][0];
  const auto number = [](const Json& value, double factor, int digits) {
    char text[32] = {};
    (void)std::snprintf(text, sizeof text, "%.*f", digits, value.get<double>() * factor);
    return std::string(text);
  };
  const Outcome run = demo({"一", "--record", folder / "a.nzr"}, folder / "a.png");
  EXPECT_TRUE(run.out.starts_with(
      "一  1 stroke, traced by a simulated hand through the servo at 1 kHz, snapping off\n"
      "device: Touch / PHANTOM Omni (simulated)\n"))
      << run.out;
  for (const std::string& part :
       {"     1   " + number(stroke["length_m"], 1e3, 1) + " mm   " + number(stroke["aim_rms_m"], 1e3, 2) +
            "  " + number(stroke["aim_max_m"], 1e3, 2) + " mm     " + number(stroke["tip_rms_m"], 1e3, 2) +
            "  " + number(stroke["tip_max_m"], 1e3, 2) + " mm     " + number(stroke["mean_force_n"], 1, 2) +
            "  " + number(stroke["peak_force_n"], 1, 2) + " N ",
        "\nall strokes: tip error " + number(json["tracking_rms_m"], 1e3, 2) + " mm rms, " +
            number(json["tracking_max_m"], 1e3, 2) + " mm at most; force " +
            number(json["samples"]["mean_force_n"], 1, 2) + " N mean, " +
            number(json["samples"]["peak_force_n"], 1, 2) + " N peak\n",
        " " + number(stroke["contact_share"], 100, 0) + " %   " + number(stroke["mean_depth_m"], 1e3, 1) +
            " mm ",
        "\npicture " + (folder / "a.png") + "\nrecording " + (folder / "a.nzr") + "\n"})
    EXPECT_THAT(run.out, HasSubstr(part));
  const double work_mj = json["work_on_hand_j"].get<double>() * 1e3;
  EXPECT_THAT(run.out,
              HasSubstr(work_mj > 0 ? "energy: the motors did " + number(json["work_on_hand_j"], 1e3, 3) +
                                          " mJ of work on the hand\n"
                                    : "energy: the tablet dissipated " +
                                          number(json["work_on_hand_j"], -1e3, 3) + " mJ from the hand\n"));
  const Outcome snapped = demo({"一", "--snap"}, folder / "a.png");
  EXPECT_THAT(snapped.out, HasSubstr("snapping on\n"));
  EXPECT_THAT(snapped.out, HasSubstr("energy: the tablet dissipated "));
}

TEST(Demo, WithoutAnOutputThePictureLiesInTheCurrentFolder) {
  const TemporaryFolder folder;
  const Outcome run = nazori_cli({"demo", "一", "--size", "100"}, {}, folder.path());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(folder.names(), ElementsAre("一-demo.png"));
  EXPECT_THAT(run.out, HasSubstr("一-demo.png"));
}

TEST(Demo, OnTheClockThreadPeopleReadTheTimingToo) {
  const TemporaryFolder folder;
  const Outcome run = demo({"一", "--real-time"}, folder / "a.png");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, testing::ContainsRegex(
                           "\nclock thread, [^:]+: [0-9]+ ticks, [0-9]+ late, [0-9]+ missed; a tick "
                           "took [0-9.]+ us, 99.9 % at most [0-9.]+ us, all at most [0-9.]+ us; "
                           "99.9 % at most [0-9]+\\.[0-9][0-9][0-9] ms late, all at most "
                           "[0-9]+\\.[0-9][0-9][0-9] ms\n"));
}

TEST(Demo, OnTheClockThreadItHoldsAsWellAndTellsTheTime) {
  const TemporaryFolder folder;
  const Outcome run = demo({"一", "--real-time", "--json"}, folder / "a.png");
  EXPECT_EQ(run.code, 0) << run.err;
  const Json answer = Json::parse(run.out).at(0);
  EXPECT_GT(answer["timing"]["ticks"], 1000);
  EXPECT_GT(answer["strokes"][0]["traced_share"], 0.9);
}

TEST(Demo, AnyMistakeIsOneLineAndLeavesNoPicture) {
  const TemporaryFolder folder;
  expect_one_line(demo({"☃"}, folder / "a.png"), 1, {"☃"});
  expect_one_line(demo({"休", "--device", "spoon"}, folder / "a.png"), 2, {"--device", "touch"});
  expect_one_line(demo({"休"}, folder / "none/a.png"), 2, {"the folder"});
  expect_one_line(demo({"休木"}, folder / "a.png"), 2, {"{}"});
  expect_one_line(demo({"休"}, folder / "a.jpg"), 2, {"a.jpg"});
  expect_one_line(nazori_cli({"demo", "休", "--size", "1", "-o", folder / "a.png"}), 2, {"--size"});
  EXPECT_THAT(folder.names(), ElementsAre());
}

}  // namespace
}  // namespace nazori::cli::test
