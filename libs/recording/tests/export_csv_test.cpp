// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "../../base/tests/failing_calls.h"
#include "files_under_test.h"
#include "nazori/recording/sample_csv.h"
#include "nazori/recording/session_recorder.h"
#include "some_samples.h"

namespace nazori::recording {
namespace {

using base::test::FailingCalls;
namespace fs = std::filesystem;

class ExportCsv : public testing::Test {
 protected:
  /// A recording of 10,000 ticks, of which one record is damaged.
  ExportCsv() : samples_(test::some_samples(10'000)) {
    const auto header = encode_header(Session{});
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    for (const auto& sample : samples_) encode_record(sample, bytes);
    encode_end(samples_.size(), 3, false, bytes);
    bytes[kHeaderBytes + 7 * kRecordBytes] ^= 1;
    test::write(recording_, {bytes.begin(), bytes.end()});
    samples_.erase(samples_.begin() + 7);
  }

  test::TemporaryFolder folder_;
  fs::path recording_ = folder_ / "a.nzr", csv_ = folder_ / "a.csv";
  std::vector<haptics::ServoSample> samples_;
};

TEST_F(ExportCsv, WritesEverySoundSampleInItsOrder) {
  std::vector<double> reported;
  const auto ended = export_csv(recording_, csv_, [&](double done, std::string_view step) {
    EXPECT_EQ(step, "exporting");
    reported.push_back(done);
    return true;
  });
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->samples, 9999U);
  EXPECT_EQ(ended->damaged, 1U);
  EXPECT_EQ(ended->lost, 3U);
  EXPECT_TRUE(ended->finished);
  std::string expected(kSampleCsvHeader);
  for (const auto& sample : samples_) append_csv_row(expected, sample);
  EXPECT_EQ(test::text_of(csv_), expected);
  ASSERT_FALSE(reported.empty());
  EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  EXPECT_GT(reported.front(), 0);
  EXPECT_EQ(reported.back(), 1);
  EXPECT_TRUE(export_csv(recording_, csv_, {})) << "with nobody to tell";
}

TEST_F(ExportCsv, ThatIsStoppedLeavesTheOldFile) {
  test::write(csv_, "old");
  const auto stopped = export_csv(recording_, csv_, [](double, std::string_view) { return false; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error(), (base::Error{base::Errc::cancelled, "stopped", csv_.string(), ""}));
  EXPECT_EQ(test::text_of(csv_), "old");
}

TEST_F(ExportCsv, ThatFailsLeavesTheOldFileAndSaysWhy) {
  test::write(csv_, "old");
  for (const char* call : {"write", "fsync", "rename"}) {
    const FailingCalls calls({{call, ENOSPC}});
    EXPECT_EQ(export_csv(recording_, csv_, {}).error().code, base::Errc::io) << call;
  }
  {
    const FailingCalls calls({{"read", EIO}});
    EXPECT_EQ(export_csv(recording_, csv_, {}).error().where, recording_.string());
  }
  EXPECT_EQ(test::text_of(csv_), "old");
  EXPECT_EQ(export_csv(folder_ / "none", csv_, {}).error().code, base::Errc::not_found);
  EXPECT_EQ(export_csv(csv_, csv_, {}).error().code, base::Errc::schema);
  EXPECT_EQ(export_csv(recording_, folder_ / "none" / "a.csv", {}).error().code, base::Errc::io);
}

}  // namespace
}  // namespace nazori::recording
