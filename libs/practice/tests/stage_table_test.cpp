// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/stage_table.h"

#include <set>

#include "stage_under_test.h"

namespace nazori::practice {
namespace {

class StageTableTest : public StageTest {
 protected:
  CharacterLibrary library_{inbox_, test::database()};
  WritingJudge judge_{inbox_, test::database()};
  StageParts parts_{inbox_, clock_, tablet_, library_, judge_, {}};
};

TEST_F(StageTableTest, EveryRowMakesAStageOfItsName) {
  std::set<std::string_view> names;
  for (const auto& kind : stage_kinds()) {
    const auto stage = kind.make(parts_);
    EXPECT_EQ(stage->id(), kind.id);
    EXPECT_TRUE(names.insert(kind.id).second) << kind.id;
    EXPECT_EQ(stage_kind(kind.id), &kind);
  }
  EXPECT_EQ(stage_kind("none"), nullptr);
}

TEST_F(StageTableTest, EveryStageOfALessonHasARowUnderTheNameThatIsSaved) {
  for (const auto lesson : study::kStages) {
    const auto* const kind = stage_kind(study::name_of(lesson));
    ASSERT_NE(kind, nullptr) << study::name_of(lesson);
    EXPECT_EQ(kind->lesson, lesson);
  }
}

TEST_F(StageTableTest, EveryStageBeginsWithACharacterAndReportsSomething) {
  library_.request_sheet(U'休');
  std::shared_ptr<const CharacterSheet> sheet;
  const base::Connection ready = library_.sheet_ready.connect([&](const auto& made) { sheet = made; });
  inbox_.run_until([&] { return sheet != nullptr; });
  const StageSubject subject{sheet, character(U'休').tablet};
  for (const auto& kind : stage_kinds()) {
    const auto stage = kind.make(parts_);
    listen(*stage);
    EXPECT_TRUE(stage->can_practise(subject)) << kind.id;
    stage->enter(subject);
    inbox_.run_until([&] { return !stage->is_busy(); });
    for (const auto& command : stage->commands()) command.run();
    inbox_.run_until([&] { return !stage->is_busy(); });
    EXPECT_FALSE(std::exchange(reports_, {}).empty()) << kind.id;
    stage->leave();
  }
}

TEST_F(StageTableTest, NamesAllStagesForAMessage) {
  const std::string names = stage_names();
  EXPECT_EQ(names.find("watch, trace, guided, memory"), 0U) << names;
  EXPECT_NE(names.find(" or " + std::string(stage_kinds().back().id)), std::string::npos) << names;
}

}  // namespace
}  // namespace nazori::practice
