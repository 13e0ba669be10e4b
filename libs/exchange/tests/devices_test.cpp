// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/devices.h"

#include <gtest/gtest.h>

#include "nazori/exchange/databases.h"

namespace nazori::exchange {
namespace {

using json::to_line;

TEST(DeviceDocument, ListsWhatEachBackEndFound) {
  const devices::BackEndFindings findings[] = {
      {"Arms", {{"arm:1", "Arm 1", true, false}}, std::nullopt},
      {"Balls",
       {},
       devices::DeviceProblem{haptics::DeviceTrouble::device_absent,
                              {base::Errc::device, "is absent", "/dev/ball", "plug it in"}}}};
  EXPECT_EQ(
      to_line(to_json(findings)),
      R"([{"back_end":"Arms","devices":[{"id":"arm:1","name":"Arm 1","has_force":true,"automatic":false}],)"
      R"("problem":null},{"back_end":"Balls","devices":[],)"
      R"("problem":{"what":"is absent","where":"/dev/ball","remedy":"plug it in"}}])");
}

TEST(DeviceDocument, OfATrialHasNullForWhatWasNotMeasured) {
  TriedDevice tried;
  tried.id = "arm:1";
  tried.description = {"Arm 1", 1000, true, {}};
  tried.trial.rate_hz = 998;
  tried.trial.ticks = 5;
  tried.trial.lateness = {1, 2};
  Value json = to_json(tried);
  EXPECT_EQ(json["id"], "arm:1");
  EXPECT_EQ(json["nominal_rate_hz"], 1000);
  EXPECT_EQ(json["rate_hz"], 998);
  EXPECT_EQ(json["lateness"].size(), devices::TrialResult::kEdges_s.size() + 1);
  EXPECT_EQ(to_line(json["lateness"][1]), R"({"up_to_s":0.0001,"ticks":2})");
  EXPECT_TRUE(json["lateness"].back()["up_to_s"].is_null());
  for (const char* member : {"rest_noise_m", "round_trip_delay_s", "trouble"})
    EXPECT_TRUE(json[member].is_null());
  tried.trial.rest_noise_m = 2e-6;
  tried.status.delay_s = 0.001;
  tried.status.message = "is too slow";
  tried.machine.advice = {"Do this."};
  json = to_json(tried);
  EXPECT_EQ(json["rest_noise_m"], 2e-6);
  EXPECT_EQ(json["round_trip_delay_s"], 0.001);
  EXPECT_EQ(json["trouble"], "is too slow");
  EXPECT_EQ(json["machine"]["advice"][0], "Do this.");
}

TEST(DatabaseDocument, SaysWhetherItWasBuiltAndWhatItHolds) {
  const std::pair<std::string_view, std::int64_t> counts[] = {{"characters", 7}, {"words", 9}};
  EXPECT_EQ(to_line(database_path("k.db")), R"({"path":"k.db"})");
  EXPECT_EQ(to_line(to_json("k.db", std::nullopt)), R"({"path":"k.db","built":false})");
  EXPECT_EQ(
      to_line(to_json("k.db", BuiltDatabase{100, 1.5, counts, {"edict:24"}})),
      R"({"path":"k.db","built":true,"bytes":100,"took_s":1.5,"characters":7,"words":9,"left_out":["edict:24"]})");
  const kanji::Source sources[] = {
      {.name = "KanjiVG", .version = "1", .sha256 = "ab", .licence = "CC BY-SA 3.0"}};
  EXPECT_EQ(to_line(checked_database("k.db", 100, counts, sources)),
            R"({"path":"k.db","bytes":100,"characters":7,"words":9,)"
            R"("sources":[{"name":"KanjiVG","version":"1","sha256":"ab","licence":"CC BY-SA 3.0"}]})");
}

}  // namespace
}  // namespace nazori::exchange
