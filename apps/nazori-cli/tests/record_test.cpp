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
