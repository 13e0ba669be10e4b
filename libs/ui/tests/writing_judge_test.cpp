// SPDX-License-Identifier: Apache-2.0
#include "writing_judge.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "nazori/kanji/kanji_database.h"

namespace {

using nazori::ui::JudgeRequest;
using nazori::ui::WritingJudge;
namespace writing = nazori::writing;

std::filesystem::path database() {
  return std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db";
}

JudgeRequest request(char32_t asked, char32_t written) {
  JudgeRequest made;
  made.character = asked;
  for (const auto& line : nazori::kanji::KanjiDatabase::open(database())->find(written)->lines()) {
    auto& stroke = made.ink.strokes.emplace_back();
    for (const auto& p : line.points) stroke.points.push_back({p.x, p.y});
  }
  return made;
}

TEST(WritingJudge, AcceptsTheModelAndRefusesItsLookalike) {
  WritingJudge judge(database());
  QSignalSpy judged(&judge, &WritingJudge::judged);
  judge.judge(request(U'土', U'土'));
  ASSERT_TRUE(judged.wait(20000));
  EXPECT_TRUE(judged.at(0).at(1).value<writing::Grade>().accepted);
  judge.judge(request(U'土', U'士'));
  ASSERT_TRUE(judged.wait(20000));
  EXPECT_FALSE(judged.at(1).at(1).value<writing::Grade>().accepted);
}

TEST(WritingJudge, OfSeveralRequestsOnlyTheNewestIsAnswered) {
  WritingJudge judge(database());
  QSignalSpy judged(&judge, &WritingJudge::judged);
  std::uint64_t last = 0;
  for (int i = 0; i < 20; ++i) last = judge.judge(request(U'木', U'木'));
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged.count() > 0; }, 20000));
  EXPECT_EQ(judged.at(0).at(0).toULongLong(), last);
  // An answer to an earlier request would come before that to a later one.
  const std::uint64_t next = judge.judge(request(U'木', U'木'));
  ASSERT_TRUE(QTest::qWaitFor([&] { return judged.count() > 1; }, 20000));
  EXPECT_EQ(judged.at(1).at(0).toULongLong(), next);
}

TEST(WritingJudge, ACharacterThatIsNotThereFailsAndAnswersNothing) {
  WritingJudge judge(database());
  QSignalSpy failed(&judge, &WritingJudge::failed);
  judge.judge(request(U'☃', U'木'));
  EXPECT_TRUE(failed.wait(20000));
}

}  // namespace
