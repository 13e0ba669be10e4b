// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/correction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nazori/practice/model_fit.h"
#include "nazori/tablet/tablet_line.h"

namespace nazori::practice {
namespace {

using kanji::MistakeKind;
using testing::ElementsAre;
using testing::IsEmpty;

/// Three drawn strokes of which the first two are strokes 2 and 1 of the model.
writing::Grade grade(std::vector<writing::Mistake> mistakes) {
  writing::Grade made;
  made.strokes.resize(3);
  made.strokes[0].matched = 1;
  made.strokes[1].matched = 0;
  made.mistakes = std::move(mistakes);
  return made;
}

writing::Mistake mistake(MistakeKind kind, int stroke, std::optional<int> second = {},
                         std::vector<int> model = {}) {
  writing::Mistake made;
  made.kind = kind;
  made.stroke = stroke;
  made.second = second;
  made.model = std::move(model);
  return made;
}

TEST(Correction, ShowsTheStrokesThatTheMistakesAreAbout) {
  EXPECT_THAT(strokes_to_show(grade({}), 4), IsEmpty());
  EXPECT_THAT(strokes_to_show(grade({mistake(MistakeKind::reversed, 0)}), 4), ElementsAre(1));
  EXPECT_THAT(strokes_to_show(grade({mistake(MistakeKind::missing, 3)}), 4), ElementsAre(3));
  EXPECT_THAT(strokes_to_show(grade({mistake(MistakeKind::order, 0, 1)}), 4), ElementsAre(0, 1))
      << "both, in the right order";
  EXPECT_THAT(strokes_to_show(grade({mistake(MistakeKind::joined, 0, {}, {2, 3})}), 4), ElementsAre(2, 3));
  EXPECT_THAT(strokes_to_show(grade({mistake(MistakeKind::extra, 2)}), 4), ElementsAre(0, 1, 2, 3))
      << "the model has no such stroke";
  EXPECT_THAT(strokes_to_show(grade({mistake(MistakeKind::other, 0)}), 4), ElementsAre(0, 1, 2, 3));
}

TEST(Correction, AdviceIsShownWhereThereIsNoMistake) {
  auto with_advice = grade({});
  with_advice.advice = {mistake(MistakeKind::ending, 1)};
  EXPECT_THAT(strokes_to_show(with_advice, 4), ElementsAre(0));
  with_advice.mistakes = {mistake(MistakeKind::missing, 2)};
  EXPECT_THAT(strokes_to_show(with_advice, 4), ElementsAre(2));
}

tablet::CarvedTablet three_levels() {
  std::vector<kanji::StrokeLine> lines(3);
  for (int i = 0; i < 3; ++i)
    lines[static_cast<std::size_t>(i)].points = {{20, 24.5 + 30 * i}, {89, 24.5 + 30 * i}};
  return *tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 64).value();
}

TEST(Correction, DrawsOneStrokeAfterTheOtherAndStopsAtTheEnd) {
  const auto model = three_levels();
  Correction correction;
  EXPECT_TRUE(correction.is_empty());
  EXPECT_FALSE(correction.is_moving());
  correction.begin(model, {0, 2});
  EXPECT_THAT(correction.parts(), IsEmpty()) << "nothing is drawn at the beginning";
  bool has_seen_first_alone = false;
  double share = 0;
  int steps = 0;
  while (correction.is_moving() && ++steps < 10'000) {
    correction.advance(0.02);
    const auto parts = correction.parts();
    if (parts.empty()) continue;
    EXPECT_EQ(parts.front().stroke, 0);
    EXPECT_GE(parts.front().share, share);
    share = parts.front().share;
    has_seen_first_alone = has_seen_first_alone || parts.size() == 1;
    if (parts.size() == 2) {
      EXPECT_EQ(parts.front().share, 1);
      EXPECT_EQ(parts.back().stroke, 2);
    }
  }
  EXPECT_TRUE(has_seen_first_alone);
  ASSERT_EQ(correction.parts().size(), 2U) << "it stays";
  EXPECT_EQ(correction.parts().back().share, 1);
}

TEST(Correction, WithoutMotionAllOfItIsThereAtOnce) {
  const auto model = three_levels();
  Correction correction;
  correction.begin(model, {1});
  correction.finish();
  EXPECT_FALSE(correction.is_moving());
  ASSERT_EQ(correction.parts().size(), 1U);
  EXPECT_EQ(correction.parts()[0].share, 1);
  correction.clear();
  EXPECT_THAT(correction.parts(), IsEmpty());
}

TEST(Correction, APartOfAStrokeEndsThereAlongItsLine) {
  const auto model = three_levels();
  const auto whole = model_line(model.paths()[0], {}, 1);
  const auto half = model_line(model.paths()[0], {}, 1, 0.5);
  const double from = whole.points.front().at.x;
  const double to = whole.points.back().at.x;
  EXPECT_EQ(half.points.front().at.x, from);
  EXPECT_NEAR(half.points.back().at.x, (from + to) / 2, 1e-9);
}

}  // namespace
}  // namespace nazori::practice
