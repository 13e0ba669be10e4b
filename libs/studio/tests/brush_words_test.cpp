// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/brush_words.h"

#include <gtest/gtest.h>

#include "in_english.h"
#include "nazori/studio/brush/advice_words.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using calligraphy::Advice;
using calligraphy::AdviceKind;
using calligraphy::Edit;
using calligraphy::StrokePart;

QString said(const char* text) { return QString::fromUtf8(text); }

class WordsOfTheBrush : public testing::Test {
 protected:
  WordsOfTheBrush() { test::speak_english(); }
};

TEST_F(WordsOfTheBrush, EachThingThatCanBeChosenHasItsName) {
  for (const auto& [id, name] :
       {std::pair("hanshi", "Hanshi (practice paper)"), std::pair("gasenshi", "Gasenshi (bleeds fast)"),
        std::pair("gasenshi-slow", "Gasenshi (bleeds slowly)"), std::pair("board", "Board (hardly bleeds)"),
        std::pair("water", "Water paper (fades as it dries)"), std::pair("other", "other")})
    EXPECT_EQ(paper_name(id), said(name));
  for (const auto& [id, name] :
       {std::pair("sumi", "Sumi, black"), std::pair("sumi-blue", "Sumi, bluish"),
        std::pair("sumi-brown", "Sumi, brownish"), std::pair("vermilion", "Vermilion"),
        std::pair("water", "Water only"), std::pair("other", "other")})
    EXPECT_EQ(ink_name(id), said(name));
  EXPECT_EQ(hair_name(brush::Hair::goat), said("Goat (soft)"));
  EXPECT_EQ(hair_name(brush::Hair::mixed), said("Mixed"));
  EXPECT_EQ(hair_name(brush::Hair::weasel), said("Weasel (stiff)"));
  using Size = calligraphy::BrushSize;
  for (const auto& [size, name] : {std::pair(Size::large, "Large"), std::pair(Size::medium, "Medium"),
                                   std::pair(Size::small, "Small"), std::pair(Size::fine, "Fine")})
    EXPECT_EQ(brush_size_name(size), said(name));
  EXPECT_EQ(ruling_name(0), said("No ruling"));
  EXPECT_EQ(ruling_name(4), said("4 characters"));
  EXPECT_EQ(font_name(""), said("Printed lines"));
  EXPECT_EQ(font_name("Aoyagi"), said("Aoyagi"));
}

TEST_F(WordsOfTheBrush, WhatIsInItIsToldInPercentOrThatItIsEmpty) {
  calligraphy::SheetState state;
  const auto words = [&](double fullness, double strength) {
    state.fullness = fullness;
    state.strength = strength;
    return brush_words(state);
  };
  EXPECT_EQ(words(0, 1), said("The brush is empty."));
  EXPECT_EQ(words(0.0049, 1), said("The brush is empty."));
  EXPECT_EQ(words(0.006, 1), said("Brush: 1% full, ink 100%."));
  EXPECT_EQ(words(0.804, 0), said("Brush: 80% full, water only."));
  EXPECT_EQ(words(0.804, 0.0049), said("Brush: 80% full, water only."));
  EXPECT_EQ(words(0.804, 0.006), said("Brush: 80% full, ink 1%."));
  EXPECT_EQ(words(0.806, 0.396), said("Brush: 81% full, ink 40%."));
}

TEST_F(WordsOfTheBrush, WhatIsOnThePaperIsWetOrDry) {
  calligraphy::SheetState state;
  EXPECT_EQ(paper_words(state), said("Nothing is written yet."));
  state.is_wet = true;
  EXPECT_EQ(paper_words(state), said("0 strokes, wet."));
  state.strokes = 3;
  EXPECT_EQ(paper_words(state), said("3 strokes, wet."));
  state.is_wet = false;
  EXPECT_EQ(paper_words(state), said("3 strokes, dry."));
}

TEST_F(WordsOfTheBrush, WhatIsUndoneAndRedoneIsSaid) {
  const std::tuple<Edit, const char*, const char*> all[] = {
      {Edit::none, "There is nothing to undo.", "There is nothing to redo."},
      {Edit::stroke, "Stroke 5 undone.", "Stroke 4 redone."},
      {Edit::drying, "Drying undone: the sheet is wet again.", "The sheet is dry again."},
      {Edit::new_sheet, "The sheet before is back: 4 strokes.", "The next sheet is back: 4 strokes."}};
  for (const auto& [edit, undone, redone] : all) {
    EXPECT_EQ(undo_words(edit, 4), said(undone));
    EXPECT_EQ(redo_words(edit, 4), said(redone));
  }
}

TEST_F(WordsOfTheBrush, AReviewHasItsModelWhereTheSheetHasIt) {
  EXPECT_EQ(brush_model_of(ModelPlace::none), practice::BrushModel::none);
  EXPECT_EQ(brush_model_of(ModelPlace::beneath), practice::BrushModel::beneath);
  EXPECT_EQ(brush_model_of(ModelPlace::beside), practice::BrushModel::beside);
}

TEST_F(WordsOfTheBrush, PackagesOfFontsAreNamedOnceEachWhereTheyAreMissing) {
  const auto all = author::brush_fonts();
  EXPECT_EQ(font_packages_words(all), QString());
  QStringList packages;
  for (const auto& font : all) {
    const QString package =
        QString::fromUtf8(font.package.data(), static_cast<qsizetype>(font.package.size()));
    if (!packages.contains(package)) packages.append(package);
  }
  ASSERT_GT(packages.size(), 1);
  EXPECT_EQ(font_packages_words({}),
            said("For more fonts, install %1 and start Nazori again.").arg(packages.join(said(", "))));
  EXPECT_EQ(font_packages_words(all.subspan(1)),
            said("For more fonts, install %1 and start Nazori again.").arg(packages.front()));
}

/// Advice about one thing.
Advice about(AdviceKind kind, int stroke = -1, double amount = 0, StrokePart part = StrokePart::middle,
             int second = -1) {
  Advice made;
  made.kind = kind;
  made.stroke = stroke;
  made.second = second;
  made.part = part;
  made.amount = amount;
  return made;
}

calligraphy::CharacterAdvice comparable(std::vector<Advice> advice) {
  calligraphy::CharacterAdvice made;
  made.character = U'休';
  made.written = 6;
  made.is_comparable = true;
  made.grade.emplace();
  made.advice = std::move(advice);
  return made;
}

TEST_F(WordsOfTheBrush, EachKindOfAdviceAboutAStrokeHasItsSentence) {
  const std::pair<Advice, const char*> all[] = {
      {about(AdviceKind::start_turned, 1, -0.5236),
       "Stroke 2: the start is turned by 30°. Begin in the direction of the arrow."},
      {about(AdviceKind::hidden_tip, 0),
       "Stroke 1: the start moves back first (hidden tip). Here the tip may stay visible."},
      {about(AdviceKind::no_stop, 2), "Stroke 3: there is no stop. Stop and press at the end, then lift."},
      {about(AdviceKind::no_hook, 2),
       "Stroke 3: the hook is missing or blunt. Stop, then flick the brush off."},
      {about(AdviceKind::no_sweep, 2),
       "Stroke 3: the end stays broad. Lift the brush slowly while it is still moving."},
      {about(AdviceKind::thin, 4), "Stroke 5: too thin. Press more, or take a thicker brush."},
      {about(AdviceKind::thick, 4), "Stroke 5: too thick. Press less, or take a thinner brush."},
      {about(AdviceKind::hasty, 4, 0, StrokePart::beginning),
       "Stroke 5: hurried at the beginning. Keep an even speed."},
      {about(AdviceKind::hasty, 4, 0, StrokePart::middle),
       "Stroke 5: hurried in the middle. Keep an even speed."},
      {about(AdviceKind::hasty, 4, 0, StrokePart::end),
       "Stroke 5: hurried towards the end. Keep an even speed."},
      {about(AdviceKind::halting, 4, 0, StrokePart::beginning),
       "Stroke 5: hesitant at the beginning. Keep an even speed."},
      {about(AdviceKind::halting, 4, 0, StrokePart::middle),
       "Stroke 5: hesitant in the middle. Keep an even speed."},
      {about(AdviceKind::halting, 4, 0, StrokePart::end),
       "Stroke 5: hesitant towards the end. Keep an even speed."}};
  for (const auto& [advice, sentence] : all)
    EXPECT_EQ(advice_words(comparable({advice})), QStringList{said(sentence)});
}

TEST_F(WordsOfTheBrush, EachKindOfAdviceAboutTheWholeHasItsSentence) {
  const std::pair<Advice, const char*> all[] = {
      {about(AdviceKind::flat_width),
       "All strokes are equally thick. Press at starts and stops, and lift in hooks and sweeps."},
      {about(AdviceKind::uncovered, -1, 0.556), "The ink covers only 56% of the model."},
      {about(AdviceKind::outside, -1, 0.556), "56% of the ink is outside the model."},
      {about(AdviceKind::too_far_left), "The character is too far to the left."},
      {about(AdviceKind::too_far_right), "The character is too far to the right."},
      {about(AdviceKind::too_high), "The character is too high."},
      {about(AdviceKind::too_low), "The character is too low."},
      {about(AdviceKind::too_large), "The character is larger than the model."},
      {about(AdviceKind::too_small), "The character is smaller than the model."},
      {about(AdviceKind::wide_gap, 1, 0, StrokePart::middle, 4),
       "The gap between strokes 2 and 5 is too wide."},
      {about(AdviceKind::narrow_gap, 1, 0, StrokePart::middle, 4),
       "The gap between strokes 2 and 5 is too narrow."}};
  for (const auto& [advice, sentence] : all)
    EXPECT_EQ(advice_words(comparable({advice})), QStringList{said(sentence)});
}

TEST_F(WordsOfTheBrush, TheSameAdviceOnSeveralStrokesIsOneSentenceWithTheLargestAmount) {
  const auto advice =
      comparable({about(AdviceKind::start_turned, 0, 0.1), about(AdviceKind::thin, 1),
                  about(AdviceKind::start_turned, 2, -0.5236), about(AdviceKind::too_low),
                  about(AdviceKind::hasty, 2, 0, StrokePart::end), about(AdviceKind::start_turned, 3, 0.2),
                  about(AdviceKind::hasty, 4, 0, StrokePart::beginning), about(AdviceKind::thin, 4),
                  about(AdviceKind::too_low)});
  EXPECT_EQ(
      advice_words(advice),
      (QStringList{
          said("Strokes 1, 3 and 4: the start is turned by 30°. Begin in the direction of the arrow."),
          said("Strokes 2 and 5: too thin. Press more, or take a thicker brush."),
          said("The character is too low."), said("Stroke 3: hurried towards the end. Keep an even speed."),
          said("Stroke 5: hurried at the beginning. Keep an even speed."),
          said("The character is too low.")}));
}

TEST_F(WordsOfTheBrush, WhatIsGoodIsSaidLast) {
  auto advice = comparable({about(AdviceKind::too_low)});
  advice.good = {0, 4};
  EXPECT_EQ(advice_words(advice),
            (QStringList{said("The character is too low."), said("Strokes 1 and 5: very good.")}));
  advice.advice.clear();
  advice.is_good = true;
  EXPECT_EQ(advice_words(advice), QStringList{said("Well written: there is nothing to correct.")});
}

TEST_F(WordsOfTheBrush, WhatCannotBeComparedIsSaidAndAnEmptySquareIsNot) {
  auto advice = comparable({about(AdviceKind::too_low)});
  const QStringList cannot{said("Too few strokes match the model, so they cannot be compared.")};
  advice.is_comparable = false;
  EXPECT_EQ(advice_words(advice), cannot);
  advice.is_comparable = true;
  advice.grade.reset();
  EXPECT_EQ(advice_words(advice), cannot);
  advice.written = 0;
  EXPECT_TRUE(advice_words(advice).isEmpty());
}

TEST_F(WordsOfTheBrush, OfSeveralCharactersEachBeginsWithItself) {
  std::vector<calligraphy::CharacterAdvice> sheet{
      comparable({about(AdviceKind::too_low)}), {}, comparable({about(AdviceKind::too_high)})};
  sheet[2].character = U'木';
  EXPECT_EQ(advice_words(sheet), (QStringList{said("休:"), said("The character is too low."), said("木:"),
                                              said("The character is too high.")}));
  sheet[2].written = 0;
  EXPECT_EQ(advice_words(sheet), QStringList{said("The character is too low.")}) << "alone it needs no name";
  EXPECT_TRUE(advice_words(std::span<const calligraphy::CharacterAdvice>()).isEmpty());
}

}  // namespace
}  // namespace nazori::ui
