// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// A plate without any groove: 128 x 128 samples of plateau.
std::string plate() { return std::string(std::size_t{128} * 128, '\xFF'); }

/// A hand that comes down on a plate within half a second, rests at `depth_m` for `rest_s` and lifts.
std::string pressing(double depth_m, double rest_s, double y_m = -0.02) {
  std::ostringstream text;
  text.precision(12);
  text << "t,x,y,z\n";
  const int rest = static_cast<int>(rest_s * 1000);
  for (int i = 0; i <= 1000 + rest; ++i) {
    const double down = i < 500 ? i / 500.0 : i < 500 + rest ? 1.0 : (1000 + rest - i) / 500.0;
    text << i * 0.001 << ",0.01," << y_m << ',' << 0.005 - (0.005 + depth_m) * down << '\n';
  }
  return text.str();
}

struct Row {
  std::vector<std::string> fields;
  [[nodiscard]] double number(std::size_t i) const { return std::stod(fields.at(i)); }
};
enum Column : std::size_t {
  kT,
  kX,
  kY,
  kZ,
  kProxyX,
  kProxyY,
  kProxyZ,
  kFx,
  kFy,
  kFz,
  kContact,
  kStroke,
  kEvent
};

std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "t,x,y,z,proxy_x,proxy_y,proxy_z,fx,fy,fz,contact,stroke,event");
  while (std::getline(lines, line)) {
    Row row;
    std::istringstream fields(line + ",");
    for (std::string field; std::getline(fields, field, ',');) row.fields.push_back(field);
    EXPECT_EQ(row.fields.size(), 13U) << line;
    rows.push_back(row);
  }
  return rows;
}

std::string text_of(const std::string& path) {
  const auto bytes = bytes_of(path);
  return {bytes.begin(), bytes.end()};
}

class Feel : public testing::Test {
 protected:
  Feel() {
    write(folder_ / "plate.raw", plate());
    write(folder_ / "hand.csv", pressing(0.001, 1.0));
  }
  Outcome feel_plate(std::vector<std::string> more) {
    more.insert(more.begin(), {"feel", "--height-map", folder_ / "plate.raw", "--input", folder_ / "hand.csv",
                               "--output", folder_ / "out.csv"});
    return nazori_cli(more);
  }
  TemporaryFolder folder_;
};

// The plate pushes back with stiffness times depth: 0.8 of the Touch's 500 N/m, 1 mm: 0.4 N.
TEST_F(Feel, APlateAnswersWithStiffnessTimesDepth) {
  const Outcome run = feel_plate({});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto rows = rows_of(text_of(folder_ / "out.csv"));
  ASSERT_EQ(rows.size(), 2001U);
  const Row& resting = rows[1400];
  EXPECT_DOUBLE_EQ(resting.number(kT), 1.4);
  EXPECT_DOUBLE_EQ(resting.number(kX), 0.01);
  EXPECT_DOUBLE_EQ(resting.number(kProxyZ), 0);
  EXPECT_NEAR(resting.number(kFz), 0.4, 1e-6);
  EXPECT_EQ(resting.fields[kContact], "1");
  EXPECT_EQ(rows[0].fields[kContact], "0");
  EXPECT_EQ(rows[0].number(kFz), 0);
  EXPECT_EQ(rows.back().fields[kContact], "0");
  int touched = 0, left = 0;
  for (const Row& row : rows) {
    touched += row.fields[kEvent] == "touch" ? 1 : 0;
    left += row.fields[kEvent] == "untouch" ? 1 : 0;
  }
  EXPECT_EQ(touched, 1);
  EXPECT_EQ(left, 1);
  EXPECT_THAT(run.out, HasSubstr("touch 1"));
}

TEST_F(Feel, TheSummaryIsThatOfTheRows) {
  const Outcome run = feel_plate({"--json", "--stiffness", "0.4"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json got = Json::parse(run.out);
  EXPECT_EQ(got["ticks"], 2001);
  EXPECT_EQ(got["rate_hz"], 1000);
  EXPECT_NEAR(got["duration_s"], 2.0, 1e-9);
  EXPECT_NEAR(got["peak_force_n"], 0.2, 1e-6);
  EXPECT_NEAR(got["max_penetration_m"], 0.001, 1e-9);
  EXPECT_EQ(got["events"]["touch"], 1);
  EXPECT_EQ(got["events"]["fault"], 0);
  EXPECT_GT(got["real_time_factor"], 0);
  // A spring keeps no energy, except that of one tick of delay at most: k d times the way of a tick (12 um).
  EXPECT_LT(std::abs(got["dissipated_j"].get<double>()), 0.2 * 1.2e-5 * 2);
}

TEST_F(Feel, ForPeopleHasTheNumbersOfTheJson) {
  const Outcome run = feel_plate({});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json got = Json::parse(feel_plate({"--json"}).out);
  const auto number = [](const Json& value, double factor, int digits) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.*f", digits, value.get<double>() * factor);
    return std::string(text.data());
  };
  EXPECT_TRUE(run.out.starts_with(
      folder_ / "plate.raw" +
      "  mode contact, device Touch / PHANTOM Omni (simulated)\nticks    2001 in 2.000 s at 1000 Hz, "))
      << run.out;
  EXPECT_THAT(run.out, HasSubstr("\nforce    mean " + number(got["mean_force_n"], 1, 3) + " N, in contact "));
  EXPECT_THAT(run.out,
              HasSubstr(" N, peak 0.400 N\ndepth    at most 1.000 mm behind the surface\nenergy   put in "));
  EXPECT_THAT(run.out,
              HasSubstr(" mJ, dissipated " + number(got["dissipated_j"], 1e3, 3) + " mJ\nevents   "));
  EXPECT_THAT(run.out,
              testing::ContainsRegex("\nreplayed in [0-9.]+ s, [0-9]+ times as fast as real time\n"));
  EXPECT_TRUE(run.out.ends_with("\n" + (folder_ / "out.csv") + "\n"));
  const Outcome ball = feel_plate({"--tip-radius-mm", "2"});
  EXPECT_THAT(ball.out, HasSubstr("(simulated), ball of 2 mm\n"));
}

TEST_F(Feel, AStrokeThatIsNotThereIsNamedWithTheirNumber) {
  const auto feel = [this](const std::string& character, const std::string& stroke) {
    return nazori_cli({"feel", character, "--map-size", "32", "--mode", "snap", "--stroke", stroke, "--input",
                       folder_ / "hand.csv", "--output", folder_ / "out.csv"});
  };
  EXPECT_EQ(feel("二", "2").code, 0);
  expect_one_line(feel("二", "3"), 2, {"--stroke 3: 二 has 2 strokes", "give a smaller number"});
  expect_one_line(feel("一", "2"), 2, {"--stroke 2: 一 has 1 stroke ("});
  EXPECT_EQ(feel_plate({"--friction", "0.2,0.2"}).code, 0) << "as much is not above";
  expect_one_line(feel_plate({"--friction", "0.2,0.21"}), 2, {"dynamic friction is above static friction"});
}

TEST_F(Feel, GivesTheSameBytesForTheSameInput) {
  ASSERT_EQ(feel_plate({"--friction", "0.4,0.3"}).code, 0);
  const auto first = bytes_of(folder_ / "out.csv");
  ASSERT_EQ(feel_plate({"--friction", "0.4,0.3"}).code, 0);
  EXPECT_EQ(first, bytes_of(folder_ / "out.csv"));
}

TEST_F(Feel, AnotherRateFillsInStraightLines) {
  ASSERT_EQ(feel_plate({"--rate", "4000"}).code, 0);
  const auto rows = rows_of(text_of(folder_ / "out.csv"));
  ASSERT_EQ(rows.size(), 8001U);
  EXPECT_DOUBLE_EQ(rows[1].number(kT), 0.00025);
  EXPECT_NEAR(rows[1].number(kZ), 0.005 - 0.25 * 0.006 / 500, 1e-12);
  EXPECT_NEAR(rows[6000].number(kFz), 0.4, 1e-6);
}

TEST_F(Feel, PipesWorkBothWays) {
  const Outcome run = shell("\"$NAZORI\" feel --height-map " + (folder_ / "plate.raw") +
                            " --input - --output - < " + (folder_ / "hand.csv"));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(rows_of(run.out).size(), 2001U);
}

TEST_F(Feel, ItsOutputCanBeItsInput) {
  ASSERT_EQ(feel_plate({}).code, 0);
  const std::string first = text_of(folder_ / "out.csv");
  write(folder_ / "hand.csv", first);
  ASSERT_EQ(feel_plate({}).code, 0);
  EXPECT_EQ(text_of(folder_ / "out.csv"), first);
}

TEST_F(Feel, SnappingCatchesTheHandAboveAStroke) {
  // 4 mm beside the middle of the stroke, within the 10 mm at which a Touch snaps.
  write(folder_ / "hand.csv", pressing(0.005, 0.2, 0.004));
  const Outcome run = nazori_cli({"feel", "一", "--input", folder_ / "hand.csv", "--output",
                                  folder_ / "out.csv", "--mode", "snap", "--device", "touch", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json got = Json::parse(run.out);
  EXPECT_THAT(got["device"].get<std::string>(), HasSubstr("Touch"));
  EXPECT_GE(got["events"]["capture"], 1);
  EXPECT_GT(got["stroke_share"], 0.1);
  EXPECT_EQ(got["mode"], "snap");
}

TEST_F(Feel, EveryMistakeIsOneLineAndLeavesNothing) {
  const std::string hand = folder_ / "hand.csv", out = folder_ / "out.csv", map = folder_ / "plate.raw";
  write(folder_ / "nan.csv", "t,x,y,z\n0,0,0,0\n0.001,0,nan,0\n");
  write(folder_ / "back.csv", "t,x,y,z\n0,0,0,0\n0.001,0,0,0\n0.0005,0,0,0\n");
  write(folder_ / "empty.csv", "");
  write(folder_ / "columns.csv", "t,x,y\n0,0,0\n");
  const auto feel = [&](const std::string& input) {
    return nazori_cli({"feel", "--height-map", map, "--input", folder_ / input, "--output", out});
  };
  expect_one_line(feel("nan.csv"), 2, {"nan.csv:3", "y is not a finite number"});
  expect_one_line(feel("back.csv"), 2, {"back.csv:4", "time goes back"});
  expect_one_line(feel("empty.csv"), 2, {"empty.csv:1", "empty"});
  expect_one_line(feel("columns.csv"), 2, {"columns.csv:1", "column z"});
  expect_one_line(feel("none.csv"), 2, {"none.csv"});
  expect_one_line(nazori_cli({"feel", "--input", hand, "--output", out}), 2, {"no character or file given"});
  expect_one_line(nazori_cli({"feel", "休木", "--input", hand, "--output", out}), 2, {"one character"});
  expect_one_line(nazori_cli({"feel", "休", "--height-map", map, "--input", hand, "--output", out}), 2,
                  {"not both"});
  expect_one_line(feel_plate({"--mode", "lesson"}), 2, {"no strokes", "--strokes"});
  expect_one_line(feel_plate({"--friction", "0.1,0.2"}), 2, {"--friction"});
  expect_one_line(feel_plate({"--stiffness", "2"}), 2, {"--stiffness"});
  expect_one_line(feel_plate({"--rate", "1"}), 2, {"--rate"});
  expect_one_line(nazori_cli({"feel", "--height-map", map, "--input", hand, "--output", folder_ / "out.txt"}),
                  2, {".csv"});
  expect_one_line(nazori_cli({"feel", "--height-map", map, "--input", hand, "--output", "-", "--json"}), 2,
                  {"--json"});
  EXPECT_THAT(folder_.names(),
              ElementsAre("back.csv", "columns.csv", "empty.csv", "hand.csv", "nan.csv", "plate.raw"));
}

}  // namespace
}  // namespace nazori::cli::test
