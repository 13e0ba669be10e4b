// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/statistics_reader.h"

#include <gtest/gtest.h>

#include "learner_under_test.h"

namespace nazori::practice {
namespace {

TEST(PracticeStatistics, OfManyRequestsForStatisticsTheNewestIsAnswered) {
  base::Inbox inbox;
  StatisticsReader reader(inbox);
  int answers = 0;
  reader.failed.connect([&](const base::Error&) { ++answers; });
  reader.ready.connect([&](const SharedStatistics&) { ++answers; });
  for (int i = 0; i < 10; ++i) reader.request("/nowhere/learner.db", {});
  EXPECT_TRUE(reader.is_busy());
  inbox.run_until([&] { return !reader.is_busy(); });
  EXPECT_EQ(answers, 1);
  reader.request("/nowhere/learner.db", {});  // destroyed before it is answered
}

using StatisticsOfALearner = LearnerTest;

TEST_F(StatisticsOfALearner, AreOfWhatIsSavedAndReportHowFarTheyAre) {
  write(U'一');
  write(U'二');
  StatisticsReader reader(inbox_);
  SharedStatistics read;
  std::vector<double> progress;
  bool is_early = true;
  reader.ready.connect([&](const SharedStatistics& statistics) { read = statistics; });
  reader.progressed.connect([&](double done) {
    progress.push_back(done);
    is_early = is_early && !read;
  });
  reader.request(learner_->file(), learner_->store().now());
  inbox_.run_until([&] { return !reader.is_busy(); });
  ASSERT_TRUE(read);
  EXPECT_EQ(read->today, learner_->store().today());
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_TRUE(is_early) << "how far it is comes before the answer";
}

TEST_F(StatisticsOfALearner, OfADamagedFileFail) {
  StatisticsReader reader(inbox_);
  base::Error error;
  reader.failed.connect([&](const base::Error& reported) { error = reported; });
  reader.request(kanji_db(), {});
  inbox_.run_until([&] { return !reader.is_busy(); });
  EXPECT_EQ(error.code, base::Errc::schema);
}

}  // namespace
}  // namespace nazori::practice
