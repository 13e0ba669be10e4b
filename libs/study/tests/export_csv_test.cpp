// SPDX-License-Identifier: Apache-2.0
// Each column of the table, and how far an export is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "learner_fixture.h"
#include "nazori/study/exchange.h"
#include "nazori/study/store_filling.h"

namespace nazori::study {
namespace {

using test::MovedClock;
using test::must;
using test::some_ink;
using testing::ElementsAre;

constexpr char32_t kTree = U'木';

LearnerStore in_memory(const MovedClock& clock) { return must(LearnerStore::in_memory(clock.clock())); }

TEST(ExportCsv, EachColumnHoldsWhatItsHeadSays) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  Writing writing;
  writing.stage = Stage::guided;
  writing.rating = Rating::again;
  writing.proposed = Rating::hard;
  writing.result = {false,
                    7,
                    {{kanji::MistakeKind::split, 0}, {kanji::MistakeKind::other, 9}},
                    3,
                    4,
                    5,
                    0.125,
                    std::chrono::milliseconds(678)};
  (void)must(store.add_writing(kTree, 4, writing, some_ink()));
  (void)must(store.undo());
  (void)must(store.add_writing(U',', 2, Writing()));
  const PenMotion motion = *motion_of(some_ink());
  const std::string head =
      "entry,at,day,character,stage,rating,proposed,accepted,score,faults,hints,misses,shown_strokes,help,"
      "duration_ms,strokes,interval_days,speed,smoothness,undone\r\n";
  std::array<char, 64> measured{};
  std::snprintf(measured.data(), measured.size(), "%.3f,%.4f", motion.speed, motion.smoothness);
  const std::string day = to_text(store.today());
  EXPECT_EQ(must(export_csv(store)),
            head + "1,2026-01-01T09:00:00.000Z," + day +
                ",\"木\",guided,again,hard,0,7,split:1 other:10,3,4,5,0.125,678,4,," + measured.data() +
                ",1\r\n3,2026-01-01T09:00:00.000Z," + day +
                ",\",\",memory,good,good,1,100,,0,0,0,0,0,2,,,,0\r\n");
}

TEST(ExportProgress, IsTheShareOfTheWork) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  LearnerStore store = in_memory(clock);
  ASSERT_TRUE(store.fill(test::long_history(512)));
  std::vector<double> reported;
  const auto keep = [&](double done, std::string_view step) {
    EXPECT_EQ(step, "export");
    reported.push_back(done);
    return true;
  };
  const TextSink nowhere = [](std::string_view) -> base::Result<void> { return {}; };
  ASSERT_TRUE(export_json(store, nowhere, keep));
  EXPECT_THAT(reported, ElementsAre(0.5, 1));
  reported.clear();
  // One pass over the log for undone entries, another for the table.
  ASSERT_TRUE(export_csv(store, nowhere, keep));
  ASSERT_EQ(reported.size(), 4U);
  EXPECT_NEAR(reported[1], 2 * reported[0], 1e-12);
  EXPECT_NEAR(reported[2], (reported[1] + 1) / 2, 1e-12);
  EXPECT_EQ(reported[3], 1);
}

}  // namespace
}  // namespace nazori::study
