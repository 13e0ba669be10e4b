// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "program.h"

namespace nazori::cli::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

class Record : public testing::Test {
 protected:
  Record() {
    const Outcome run = nazori_cli({"demo", "一", "--size", "100", "--output", folder_ / "a.png", "--record",
                                    folder_ / "a.nzr", "--json"});
    EXPECT_EQ(run.code, 0) << run.err;
    demo_ = Json::parse(run.out).at(0);
  }
  Json info(const std::string& name) {
    const Outcome run = nazori_cli({"record", "info", folder_ / name, "--json"});
    EXPECT_EQ(run.code, 0) << run.err;
    return Json::parse(run.out);
  }
  TemporaryFolder folder_;
  Json demo_;
};

TEST_F(Record, HoldsWhatTheDemoSaw) {
  const Json got = info("a.nzr");
  EXPECT_EQ(got["state"], "complete");
  EXPECT_EQ(got["character"], "一");
  EXPECT_THAT(got["device"].get<std::string>(), HasSubstr("Touch"));
  EXPECT_EQ(got["rate_hz"], 1000);
  EXPECT_EQ(got["lost"], 0);
  EXPECT_EQ(got["damaged"], 0);
  EXPECT_EQ(got["gaps"], 0);
  const Json& samples = demo_.at("samples");
  for (const char* name : {"ticks", "duration_s", "peak_force_n", "mean_force_n", "dissipated_j", "events"})
    EXPECT_EQ(got[name], samples.at(name)) << name;
  EXPECT_GT(got["peak_force_n"], 0.1);
}

TEST_F(Record, ExportsARowForEachTick) {
  const Outcome run = nazori_cli({"record", "export", folder_ / "a.nzr", "--output", folder_ / "a.csv"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto bytes = bytes_of(folder_ / "a.csv");
  EXPECT_EQ(static_cast<std::uint64_t>(std::count(bytes.begin(), bytes.end(), '\n')),
            demo_["samples"]["ticks"].get<std::uint64_t>() + 1);
}

TEST_F(Record, ARecordingCanBeFeltAgain) {
  ASSERT_EQ(nazori_cli({"record", "export", folder_ / "a.nzr", "--output", folder_ / "a.csv"}).code, 0);
  const Outcome run =
      nazori_cli({"feel", "一", "--input", folder_ / "a.csv", "--output", folder_ / "b.csv", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(bytes_of(folder_ / "a.csv"), bytes_of(folder_ / "b.csv"));
}

TEST_F(Record, StraightToCsvIsTheSameAsExported) {
  ASSERT_EQ(nazori_cli({"record", "export", folder_ / "a.nzr", "--output", folder_ / "a.csv"}).code, 0);
  ASSERT_EQ(nazori_cli(
                {"demo", "一", "--size", "100", "--output", folder_ / "a.png", "--record", folder_ / "b.csv"})
                .code,
            0);
  EXPECT_EQ(bytes_of(folder_ / "a.csv"), bytes_of(folder_ / "b.csv"));
  EXPECT_THAT(folder_.names(), testing::Not(testing::Contains("b.csv.nzr")));
}

TEST_F(Record, TellsThatAFileBreaksOff) {
  const std::string part = folder_ / "part.nzr";
  std::filesystem::copy_file(folder_ / "a.nzr", part);
  std::filesystem::resize_file(part, 512 + 1000 * 152 + 17);
  const Json got = info("part.nzr");
  EXPECT_EQ(got["state"], "incomplete");
  EXPECT_EQ(got["ticks"], 1000);
  EXPECT_EQ(got["trailing_bytes"], 17);
  EXPECT_THAT(nazori_cli({"record", "info", part}).out, HasSubstr("incomplete"));
  EXPECT_THAT(nazori_cli({"record", "export", part, "--output", folder_ / "part.csv"}).out,
              HasSubstr("1000 ticks, the recording is incomplete"));
}

TEST_F(Record, TellsPeopleWhereAndOnWhatItWasMadeAndHowTheClockKept) {
  EXPECT_EQ(info("a.nzr")["late_ticks"], 0);
  const Outcome run = nazori_cli({"record", "info", folder_ / "a.nzr"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.out.starts_with(folder_ / "a.nzr" + "  complete\nstart    20")) << run.out;
  EXPECT_THAT(run.out, HasSubstr("\ndevice   Touch / PHANTOM Omni (simulated), 1000 Hz\n"
                                 "tablet   一, 100.0 mm wide, 10.0 mm deep\n"));
  EXPECT_THAT(run.out, HasSubstr("\nclock    0 ticks late, at most 0.000 ms\n"
                                 "lost     0 while recording, 0 damaged\n"));
  const auto ticks = demo_["samples"]["ticks"].get<int>();
  EXPECT_THAT(run.out, HasSubstr("\nticks    " + std::to_string(ticks) + " in "));
  EXPECT_THAT(run.out, HasSubstr(" s at 1000 Hz, "));
  const Outcome table = nazori_cli({"record", "export", folder_ / "a.nzr", "--output", folder_ / "a.csv"});
  EXPECT_EQ(table.out, folder_ / "a.csv" + "  " + std::to_string(ticks) + " ticks\n");
}

TEST_F(Record, ADamagedTickIsLeftOutAndCountedAndTheNextIsLate) {
  auto bytes = bytes_of(folder_ / "a.nzr");
  ASSERT_GT(bytes.size(), 512U + 600 * 152);
  bytes[512 + 500 * 152 + 40] ^= 0x55;  // in the 501st tick
  write(folder_ / "bad.nzr", {bytes.begin(), bytes.end()});
  const int ticks = demo_["samples"]["ticks"].get<int>() - 1;
  const Json got = info("bad.nzr");
  EXPECT_EQ(got["damaged"], 1);
  EXPECT_EQ(got["gaps"], 1);
  EXPECT_EQ(got["late_ticks"], 1);
  EXPECT_EQ(got["ticks"], ticks);
  const std::string text = nazori_cli({"record", "info", folder_ / "bad.nzr"}).out;
  EXPECT_THAT(text, HasSubstr("\nclock    1 tick late, at most "));
  EXPECT_THAT(text, HasSubstr("\nlost     0 while recording, 1 damaged\n"));
  EXPECT_EQ(nazori_cli({"record", "export", folder_ / "bad.nzr", "--output", folder_ / "b.csv"}).out,
            folder_ / "b.csv" + "  " + std::to_string(ticks) + " ticks, 1 damaged ticks skipped\n");
}

TEST_F(Record, ABallAtTheTipIsTold) {
  ASSERT_EQ(nazori_cli({"demo", "一", "--tip-radius-mm", "1.5", "--size", "64", "--output", folder_ / "b.png",
                        "--record", folder_ / "b.nzr"})
                .code,
            0);
  EXPECT_THAT(nazori_cli({"record", "info", folder_ / "b.nzr"}).out,
              HasSubstr("10.0 mm deep, felt by a ball of 1.5 mm\n"));
}

TEST_F(Record, EveryMistakeIsOneLine) {
  write(folder_ / "no.nzr", "not a recording");
  expect_one_line(nazori_cli({"record", "info", folder_ / "no.nzr"}), 2, {"no.nzr", "not a recording"});
  expect_one_line(nazori_cli({"record", "info", folder_ / "none.nzr"}), 2, {"none.nzr"});
  expect_one_line(nazori_cli({"record", "export", folder_ / "a.nzr", "--output", folder_ / "a.txt"}), 2,
                  {".csv"});
  expect_one_line(nazori_cli({"record"}), 2, {"info, export"});
  expect_one_line(nazori_cli({"demo", "一", "--output", folder_ / "a.png", "--record", folder_ / "a.wav"}), 2,
                  {".nzr or .csv"});
}

}  // namespace
}  // namespace nazori::cli::test
