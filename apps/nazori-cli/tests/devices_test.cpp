// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"
#include "standins/inverse_standin.h"
#include "test_paths.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

// Hides the devices of the machine that runs the tests: no library, no service.
const std::vector<std::string> kBare{"NAZORI_LIBHD=/nowhere/libHD.so", "NAZORI_LIBDHD=/nowhere/libdhd.so",
                                     "NAZORI_INVERSE_PORT=1", "NAZORI_PANTOGRAPH_PORT=/nowhere/ttyACM0"};

std::vector<std::string> with(const std::string& more) {
  std::vector<std::string> all = kBare;
  all.push_back(more);
  return all;
}

TEST(Devices, EveryBackEndIsListedWithItsDevicesOrTheReason) {
  const Outcome run = nazori_cli({"devices"}, kBare);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("/nowhere/libHD.so"));
  EXPECT_THAT(run.out, HasSubstr("/nowhere/libdhd.so"));
  EXPECT_THAT(run.out, HasSubstr("haply-inverse-service"));
  EXPECT_THAT(run.out, HasSubstr("simulated:falcon"));
  EXPECT_EQ(run.err, "");
}

TEST(Devices, TheListIsJsonToo) {
  const Outcome run = nazori_cli({"devices", "--json"}, kBare);
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json.size(), 7U);
  EXPECT_TRUE(json[0]["devices"].empty());
  EXPECT_THAT(json[0]["problem"]["remedy"].get<std::string>(), HasSubstr("docs/devices.md"));
  EXPECT_TRUE(json[5]["problem"].is_null());
  EXPECT_EQ(json[5]["devices"][0]["id"], "pointer");
}

/// What `--test` must report for any device with force.
void expect_trial(const Json& json) {
  EXPECT_GT(json["ticks"].get<int>(), 0);
  EXPECT_GT(json["rate_hz"].get<double>(), 0);
  EXPECT_GT(json["max_force_n"].get<double>(), 0);
  ASSERT_EQ(json["lateness"].size(), 8U);
  EXPECT_TRUE(json["lateness"][7]["up_to_s"].is_null());
  // For each period between two ticks the lateness is reported.
  int periods = 0;
  for (const Json& bin : json["lateness"]) periods += bin["ticks"].get<int>();
  EXPECT_EQ(periods, json["ticks"].get<int>() - 1);
  EXPECT_TRUE(json["rest_noise_m"].is_null() || json["rest_noise_m"] == 0) << "the stand-in's hand is still";
  EXPECT_GT(json["round_trip_delay_s"].get<double>(), 0);
  EXPECT_TRUE(json["trouble"].is_null() || json["trouble"].is_string());
  EXPECT_TRUE(json["machine"]["kernel_preempts"].is_boolean());
  EXPECT_TRUE(json["machine"]["advice"].is_array());
}

TEST(Devices, AStandInForATouchIsFoundAndTestedEndToEnd) {
  const std::vector<std::string> touch =
      with(std::string("NAZORI_LIBHD=") + test_paths::kStandins + "/libHD.so");
  EXPECT_THAT(nazori_cli({"devices"}, touch).out, HasSubstr("Stand-in Touch (serial 0042)"));
  const Outcome run = nazori_cli({"devices", "--test", "0.5", "--json"}, touch);
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["id"], "openhaptics");  // the best one, unasked
  expect_trial(json);
}

TEST(Devices, AStandInForAnOmegaIsFoundAndTestedEndToEnd) {
  const std::vector<std::string> omega =
      with(std::string("NAZORI_LIBDHD=") + test_paths::kStandins + "/libdhd.so");
  EXPECT_THAT(nazori_cli({"devices"}, omega).out, HasSubstr("omega.3"));
  const Outcome run = nazori_cli({"devices", "--test", "0.5", "--json"}, omega);
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["id"], "forcedimension:0");
  expect_trial(json);
}

TEST(Devices, AStandInForAnInverseServiceIsFoundAndTestedEndToEnd) {
  const devices::standin::InverseService service;
  const std::vector<std::string> inverse = with("NAZORI_INVERSE_PORT=" + std::to_string(service.port()));
  // When the machine pauses for a second the service looks dead, so try again.
  Outcome run;
  for (int i = 0; i < 10; ++i) {
    run = nazori_cli({"devices", "--test", "0.5", "--json", "--device", "inverse3"}, inverse);
    if (run.code == 0) break;
  }
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["id"], "inverse3:049D");
  EXPECT_LE(json["max_force_n"].get<double>(), 2.0);
  expect_trial(json);
  EXPECT_EQ(service.malformed, 0);
}

TEST(Devices, ASimulationCanBeTestedByName) {
  const Outcome run = nazori_cli({"devices", "--test", "0.3", "--device", "simulated:touch"}, kBare);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("lateness"));
  EXPECT_THAT(run.out, HasSubstr("machine"));
}

TEST(Devices, TheListOfThePointerAndTheSimulationsIsAsTheManualShowsIt) {
  const auto bytes = bytes_of(std::string(test_paths::kDocs) + "/command-line.md");
  const std::string manual(bytes.begin(), bytes.end());
  const std::size_t begin = manual.find("\nMouse, pen or finger\n") + 1;
  const std::string shown = manual.substr(begin, manual.find("```", begin) - begin);
  EXPECT_THAT(shown, testing::EndsWith("  simulated:inverse3      Inverse3 (simulated)\n"));
  const std::string list = nazori_cli({"devices"}, kBare).out;
  EXPECT_TRUE(list.ends_with(shown)) << list;
  EXPECT_THAT(list, HasSubstr("OpenHaptics (PHANTOM, Touch)\n  nothing found: OpenHaptics: "));
}

TEST(Devices, ATrialForPeopleHasItsLimitsRatesAndLatenessesInOrder) {
  const Outcome run = nazori_cli({"devices", "--test", "0.3", "--device", "simulated:touch"}, kBare);
  ASSERT_EQ(run.code, 0) << run.err;
  // The Touch: 3.3 N at the peak, 0.88 N all the time, 1 kHz.
  EXPECT_THAT(run.out, testing::StartsWith("simulated:touch  Touch / PHANTOM Omni (simulated)\n"
                                           "limits      3.30 N peak, 0.88 N continuous, "));
  EXPECT_THAT(run.out,
              testing::ContainsRegex("\nrate        [0-9]+ Hz of 1000 Hz, [0-9]+ ticks in 0\\.[0-9] s\n"
                                     "lateness     +[0-9]+  up to 0\\.[0-9][0-9] ms\n"
                                     "             +[0-9]+  up to 0\\.[0-9][0-9] ms\n"));
  EXPECT_THAT(run.out, testing::ContainsRegex("\n             +[0-9]+  more, up to [0-9.]+ ms\n"));
  EXPECT_THAT(run.out, HasSubstr("\nmachine     "));
  EXPECT_THAT(run.out, testing::Not(HasSubstr("problem")));
}

TEST(Devices, ADeviceThatIsNotThereIsOneLineAndTheAnswerNo) {
  expect_one_line(nazori_cli({"devices", "--test", "1", "--device", "gramophone"}, kBare), 1,
                  {"gramophone", "simulated:touch"});
  expect_one_line(nazori_cli({"devices", "--test", "1", "--device", "openhaptics"}, kBare), 1,
                  {"/nowhere/libHD.so", "docs/devices.md"});
}

TEST(Devices, TheManualShowsTheHelpAsItIsPrinted) {
  const auto bytes = bytes_of(std::string(test_paths::kDocs) + "/command-line.md");
  EXPECT_THAT(std::string(bytes.begin(), bytes.end()), HasSubstr(nazori_cli({"devices", "--help"}).out));
}

TEST(Devices, WrongUseIsRefused) {
  expect_one_line(nazori_cli({"devices", "--device", "pointer"}, kBare), 2, {"--device", "--test"});
  expect_one_line(nazori_cli({"devices", "--test", "-1"}, kBare), 2, {"--test"});
  expect_one_line(nazori_cli({"devices", "--test", "nan"}, kBare), 2, {"--test"});
}

}  // namespace
}  // namespace nazori::cli::test
