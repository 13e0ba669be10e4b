// SPDX-License-Identifier: Apache-2.0
#include <QLineEdit>
#include <QListWidget>
#include <QSettings>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "characters/character_actions.h"
#include "characters/characters.h"
#include "characters/compare_view.h"
#include "hand_under_test.h"
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

WindowParts* the_parts = nullptr;

std::unique_ptr<Page> make_characters(WindowParts& parts) {
  the_parts = &parts;
  return std::make_unique<Characters>(parts);
}

using test::Points;

class Stages : public WindowTest {
 protected:
  Stages() { pages_ = {make_characters}; }

  static std::vector<Points> model(char32_t character) { return test::model(character); }
  static void write(const Points& line) { test::write(the_parts->tablet(), line); }

  bool says(const char* words) {
    return QTest::qWaitFor([&] { return feedback().contains(QString::fromUtf8(words)); }, 10000);
  }
  std::vector<view::Verdict> seen_verdicts() {
    std::vector<view::Verdict> out;
    for (const auto& stroke : the_parts->tablet().overlay().writing) out.push_back(stroke.verdict);
    return out;
  }
};

TEST_F(Stages, WritingRightFromMemoryIsToldStrokeByStrokeAndAccepted) {
  show(U'十');
  press(Qt::Key_F8);
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Write from memory – Nazori"));
  EXPECT_FALSE(find("glyph")->isVisible());
  EXPECT_TRUE(feedback().contains(QStringLiteral("2 strokes"))) << feedback().toStdString();
  const auto strokes = model(U'十');
  write(strokes[0]);
  EXPECT_TRUE(says("Stroke 1 is correct. 1 to go.")) << feedback().toStdString();
  EXPECT_EQ(seen_verdicts(), (std::vector{view::Verdict::right}));
  write(strokes[1]);
  EXPECT_TRUE(says("of 5 stars")) << feedback().toStdString();
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("十 – Nazori"));
  EXPECT_TRUE(find("glyph")->isVisible());
}

TEST_F(Stages, AWrongStrokeIsMarkedExplainedAndKeptUntilItIsTakenBack) {
  show(U'十');
  press(Qt::Key_F8);
  write({{90, 100}, {60, 60}, {95, 40}, {20, 20}});
  ASSERT_TRUE(QTest::qWaitFor([&] { return seen_verdicts() == std::vector{view::Verdict::wrong}; }, 10000))
      << feedback().toStdString();
  EXPECT_FALSE(feedback().contains(QStringLiteral("Write the character")));
  write(model(U'十')[0]);
  EXPECT_TRUE(QTest::qWaitFor([&] { return seen_verdicts().size() == 2; }, 5000));
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(seen_verdicts().size(), 1U);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(seen_verdicts().empty());
  EXPECT_TRUE(feedback().contains(QStringLiteral("0 strokes")));
}

TEST_F(Stages, StrokesInTheWrongOrderAreNamedAtTheEnd) {
  show(U'十');
  press(Qt::Key_F8);
  action("judge_each")->trigger();
  const auto strokes = model(U'十');
  write(strokes[1]);
  EXPECT_TRUE(says("1 stroke written")) << feedback().toStdString();
  EXPECT_EQ(seen_verdicts(), (std::vector{view::Verdict::none})) << "not judged before the end";
  write(strokes[0]);
  EXPECT_TRUE(says("2 strokes written")) << feedback().toStdString();
  press(Qt::Key_Return);
  EXPECT_TRUE(says("before")) << feedback().toStdString();
  const auto verdicts = seen_verdicts();
  EXPECT_NE(std::find(verdicts.begin(), verdicts.end(), view::Verdict::wrong), verdicts.end());
}

TEST_F(Stages, JudgedOnlyAtTheEndIsJudgedWhenTheLearnerSaysSo) {
  show(U'十');
  press(Qt::Key_F8);
  action("judge_each")->trigger();
  for (const auto& stroke : model(U'十')) write(stroke);
  EXPECT_TRUE(says("2 strokes written")) << feedback().toStdString();
  QTest::qWait(300);
  EXPECT_EQ(seen_verdicts(), (std::vector{view::Verdict::none, view::Verdict::none}))
      << "all is right, but nobody asked yet";
  press(Qt::Key_Return);
  EXPECT_TRUE(says("stars")) << feedback().toStdString();
}

TEST_F(Stages, AHintShowsOneStrokeASecondAllAndGivingUpEverything) {
  show(U'休');
  press(Qt::Key_F8);
  press(Qt::Key_H);
  EXPECT_EQ(seen_verdicts(), (std::vector{view::Verdict::shown}));
  press(Qt::Key_H);
  EXPECT_EQ(seen_verdicts().size(), 6U);
  EXPECT_FALSE(find("glyph")->isVisible());
  press(Qt::Key_Delete);
  EXPECT_TRUE(seen_verdicts().empty());
  press(Qt::Key_G);
  EXPECT_EQ(seen_verdicts().size(), 6U);
  EXPECT_TRUE(find("glyph")->isVisible());
}

TEST_F(Stages, TheGrooveIsHiddenShownOrComesWithEachRightStroke) {
  show(U'十');
  press(Qt::Key_F8);
  const auto carved = [] {
    const auto& map = the_parts->tablet().tablet()->height_map();
    return *std::min_element(map.samples().begin(), map.samples().end()) < 0.5F;
  };
  EXPECT_FALSE(carved());
  action("groove_shown")->trigger();
  EXPECT_TRUE(carved());
  EXPECT_TRUE(find("glyph")->isVisible()) << "what is carved is no secret";
  action("groove_appears")->trigger();
  EXPECT_FALSE(carved());
  write(model(U'十')[0]);
  EXPECT_TRUE(QTest::qWaitFor(carved, 20000)) << feedback().toStdString();
}

TEST_F(Stages, ComparingShowsTheModelOverTheWritingAndBothBesideEachOther) {
  show(U'十');
  press(Qt::Key_F8);
  EXPECT_FALSE(action("compare_over")->isEnabled());
  write(model(U'十')[0]);
  ASSERT_TRUE(says("is correct"));
  press(Qt::Key_O);
  EXPECT_EQ(seen_verdicts(), (std::vector{view::Verdict::right, view::Verdict::shown, view::Verdict::shown}));
  press(Qt::Key_B);
  auto* compare = find<CompareView>("compare_view");
  EXPECT_TRUE(compare->isVisible());
  const int all = compare->points_shown();
  EXPECT_GT(all, 20);
  compare->show_moment(compare->duration_s() * 0.01);
  EXPECT_LT(compare->points_shown(), all / 2);
  compare->show_moment(compare->duration_s());
  EXPECT_EQ(compare->points_shown(), all);
}

TEST_F(Stages, AnotherCharacterIsNotGivenAwayByTheComparisonOfTheLast) {
  show(U'十');
  press(Qt::Key_F8);
  write(model(U'十')[0]);
  ASSERT_TRUE(says("is correct"));
  press(Qt::Key_O);
  press(Qt::Key_B);
  show(U'休');
  EXPECT_FALSE(find("compare_view")->isVisible());
  press(Qt::Key_F8);
  EXPECT_FALSE(action("compare_beside")->isChecked());
  EXPECT_FALSE(find("compare_view")->isVisible());
  EXPECT_TRUE(seen_verdicts().empty());
}

TEST_F(Stages, TheWritingIsReplayedOnTheTabletAtItsOwnSpeed) {
  show(U'十');
  press(Qt::Key_F8);
  EXPECT_FALSE(action("play")->isEnabled()) << "there is nothing to replay";
  write(model(U'十')[0]);
  ASSERT_TRUE(says("is correct"));
  const auto points = [] {
    std::size_t count = 0;
    for (const auto& stroke : the_parts->tablet().overlay().writing) count += stroke.points.size();
    return count;
  };
  const auto all = points();
  const auto* compare = find<CompareView>("compare_view");
  EXPECT_FALSE(compare->isVisible()) << "not needed for it";
  press(Qt::Key_Space);
  EXPECT_TRUE(action("play")->isChecked());
  EXPECT_LT(points(), all / 2);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !action("play")->isChecked(); }, 30000));
  EXPECT_EQ(points(), all) << "all of it is there again";
}

TEST_F(Stages, StrictnessIsASliderThatKeysMoveToo) {
  press(Qt::Key_F6);
  EXPECT_FALSE(find("strictness")->isVisible());
  press(Qt::Key_F8);
  auto* slider = find<QSlider>("strictness");
  ASSERT_TRUE(slider->isVisible());
  EXPECT_TRUE(action("normal")->isChecked());
  press(Qt::Key_BracketRight, Qt::ControlModifier);
  EXPECT_EQ(slider->value(), slider->maximum() / 2 + 1);
  EXPECT_FALSE(action("normal")->isChecked());
  EXPECT_EQ(feedback(), QStringLiteral("Strictness: fairly strict."));
  action("strict")->trigger();
  EXPECT_EQ(slider->value(), slider->maximum());
  EXPECT_EQ(slider->accessibleDescription(), QStringLiteral("strict"));
  slider->setFocus(Qt::TabFocusReason);
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_TRUE(action("lenient")->isChecked());
}

TEST_F(Stages, EnterInTheSearchBoxChoosesAndIsNoVerdict) {
  press(Qt::Key_F8);
  auto* search = find<QLineEdit>("search");
  search->setFocus();
  QTest::keyClicks(search, QStringLiteral("mizu"));
  ASSERT_TRUE(QTest::qWaitFor([this] { return text("list_count").contains(QStringLiteral("found")); }, 5000));
  press(Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([this] { return window_->windowTitle().contains(u'水'); }))
      << window_->windowTitle().toStdString();
  EXPECT_TRUE(action("trace")->isChecked()) << "who looks a character up sees it";
}

TEST_F(Stages, PageDownOnTheSliderMovesItAndKeepsTheCharacter) {
  show(U'十');
  press(Qt::Key_F8);
  auto* slider = find<QSlider>("strictness");
  slider->setFocus(Qt::TabFocusReason);
  const int before = slider->value();
  press(Qt::Key_PageUp);
  EXPECT_EQ(slider->value(), before + slider->pageStep());
}

TEST_F(Stages, TheReportTellsThePartsOfTheScoreAndHowThePenMoved) {
  show(U'十');
  press(Qt::Key_F8);
  const auto strokes = model(U'十');
  write(strokes[0]);
  ASSERT_TRUE(says("Stroke 1 is correct"));
  EXPECT_FALSE(find("writing_report")->isVisible()) << "not while it is written";
  write(strokes[1]);
  ASSERT_TRUE(says("of 5 stars")) << feedback().toStdString();
  EXPECT_TRUE(find("writing_report")->isVisible());
  EXPECT_TRUE(text("report_verdict").startsWith(QStringLiteral("Correct. Form: ")));
  EXPECT_TRUE(text("report_parts").contains(QStringLiteral("Order: 15/15")))
      << text("report_parts").toStdString();
  EXPECT_TRUE(text("report_pen").startsWith(QStringLiteral("Written in ")))
      << text("report_pen").toStdString();
  press(Qt::Key_Delete);
  EXPECT_FALSE(find("writing_report")->isVisible());
}

TEST_F(Stages, WatchingNamesTheStrokesAndStepsThroughThem) {
  action("reduced_motion")->trigger();
  press(Qt::Key_F5);
  EXPECT_FALSE(action("play")->isChecked()) << "nothing moves unasked";
  EXPECT_TRUE(feedback().contains(QStringLiteral("Space: play")));
  press(Qt::Key_Right);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Stroke 1 of 6: sweep to the left.")))
      << feedback().toStdString();
  press(Qt::Key_Right);
  press(Qt::Key_Right);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Stroke 2 of 6: vertical stroke. It ends with a stop")))
      << feedback().toStdString();
  const auto overlay = the_parts->tablet().overlay();
  ASSERT_EQ(overlay.groove_ink.size(), 6U);
  EXPECT_EQ(overlay.groove_ink[1], 1);
  EXPECT_EQ(overlay.groove_ink[2], 0);
  press(Qt::Key_Left);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Stroke 1 of 6"))) << feedback().toStdString();
  press(Qt::Key_Space);
  EXPECT_TRUE(action("play")->isChecked());
  press(Qt::Key_Space);
  EXPECT_FALSE(action("play")->isChecked());
}

TEST_F(Stages, GuidedShowsOnlyTheGrooveOrOnlyTheStartsAndHoldsTheStylus) {
  press(Qt::Key_F7);
  EXPECT_TRUE(the_parts->tablet().snapping_in_effect());
  EXPECT_LT(the_parts->tablet().overlay().lines_opacity, 0.5);
  action("by_starts")->trigger();
  const auto& map = the_parts->tablet().tablet()->height_map();
  EXPECT_GT(*std::min_element(map.samples().begin(), map.samples().end()), 0.99F);
  EXPECT_TRUE(the_parts->tablet().overlay().numbers_visible);
  press(Qt::Key_F6);
  EXPECT_FALSE(the_parts->tablet().snapping_in_effect()) << "the learner's own switch counts again";
}

TEST_F(Stages, KeysOfOneStageDoNothingInAnother) {
  press(Qt::Key_F8);
  press(Qt::Key_N);
  EXPECT_TRUE(the_parts->tablet().numbers_visible());
  press(Qt::Key_F6);
  press(Qt::Key_H);
  EXPECT_FALSE(feedback().contains(QStringLiteral("blue")));
  press(Qt::Key_N);
  EXPECT_FALSE(the_parts->tablet().numbers_visible());
}

TEST_F(Stages, SpaceOnAButtonPressesTheButton) {
  press(Qt::Key_F5);
  action("play")->setChecked(false);
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  auto* loop = find<QToolButton>("tool_loop");
  ASSERT_TRUE(QTest::qWaitFor([&] { return loop->isVisible(); }, 5000));
  loop->setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(loop->hasFocus());
  QTest::keyClick(loop, Qt::Key_Space);
  EXPECT_TRUE(action("loop")->isChecked());
}

TEST_F(Stages, TheKeyboardStaysOnTheButtonThatChangesTheStage) {
  auto* memory = find<QToolButton>("tool_memory");
  memory->setFocus(Qt::TabFocusReason);
  QTest::keyClick(memory, Qt::Key_Space);
  EXPECT_TRUE(action("memory")->isChecked());
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        const auto* at = window_->focusWidget();
        return at != nullptr && at->objectName() == QStringLiteral("tool_memory") && at->isVisible();
      },
      5000));
}

TEST_F(Stages, TheStageAndItsSettingsSurviveARestart) {
  press(Qt::Key_F8);
  action("groove_shown")->trigger();
  action("lenient")->trigger();
  press(Qt::Key_BracketRight, Qt::ControlModifier);
  window_->close();
  open_window();
  EXPECT_TRUE(action("memory")->isChecked());
  EXPECT_TRUE(action("groove_shown")->isChecked());
  EXPECT_FALSE(action("lenient")->isChecked());
  EXPECT_EQ(find<QSlider>("strictness")->value(), 1);
}

class DrawingToFind : public Stages {
 protected:
  void draw(const Points& line) {
    auto* pad = find("drawing_pad");
    const double side = std::min(pad->width(), pad->height());
    const auto at = [side](geometry::GlyphPoint p) {
      return QPoint(int(p.x / 109 * side), int(p.y / 109 * side));
    };
    QTest::mousePress(pad, Qt::LeftButton, {}, at(line.front()));
    const double length = geometry::arc_length<geometry::GlyphFrame>(line);
    for (double s = 2; s <= length; s += 2) {
      QMouseEvent move(QEvent::MouseMove, at(geometry::point_at<geometry::GlyphFrame>(line, s)),
                       QCursor::pos(), Qt::NoButton, Qt::LeftButton, {});
      QCoreApplication::sendEvent(pad, &move);
    }
    QTest::mouseRelease(pad, Qt::LeftButton, {}, at(line.back()));
  }
  QListWidget* candidates() { return find<QListWidget>("candidates"); }
};

TEST_F(DrawingToFind, ListsTheLikeliestWhileDrawingAndEnterTakesTheFirst) {
  press(Qt::Key_D, Qt::ControlModifier);
  ASSERT_TRUE(find("draw_panel")->isVisible());
  EXPECT_FALSE(find("library_panel")->isVisible());
  for (const auto& stroke : model(U'村')) draw(stroke);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return candidates()->count() > 0 && candidates()->item(0)->text() == QStringLiteral("村"); },
      60000));
  QSignalSpy shown(window_.get(), &MainWindow::character_shown);
  QTest::keyClick(find("drawing_pad"), Qt::Key_Return);
  ASSERT_TRUE(shown.wait(20000));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("村 – Nazori"));
  EXPECT_FALSE(find("draw_panel")->isVisible());
  EXPECT_TRUE(find("library_panel")->isVisible());
}

TEST_F(DrawingToFind, WhatIsDrawnWholeComesBeforeWhatGoesOnWithMoreStrokes) {
  press(Qt::Key_D, Qt::ControlModifier);
  // 休 is also how 体 begins.
  for (const auto& stroke : model(U'休')) draw(stroke);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return candidates()->count() > 1 && candidates()->item(0)->text() == QStringLiteral("休"); },
      60000));
}

TEST_F(DrawingToFind, ArrowsChooseUndoAndDeleteTakeBackAndEscapeCloses) {
  press(Qt::Key_D, Qt::ControlModifier);
  auto* pad = find("drawing_pad");
  for (const auto& stroke : model(U'木')) draw(stroke);
  ASSERT_TRUE(QTest::qWaitFor([&] { return candidates()->count() > 3; }, 60000));
  QTest::keyClick(pad, Qt::Key_Right);
  EXPECT_EQ(candidates()->currentRow(), 1);
  QTest::keyClick(pad, Qt::Key_Left);
  EXPECT_EQ(candidates()->currentRow(), 0);
  QTest::keyClick(pad, Qt::Key_Delete);
  EXPECT_TRUE(QTest::qWaitFor([&] { return candidates()->count() == 0; }, 5000));
  QTest::keyClick(pad, Qt::Key_Escape);
  EXPECT_FALSE(find("draw_panel")->isVisible());
  EXPECT_FALSE(action("draw_to_find")->isChecked());
}

}  // namespace
}  // namespace nazori::ui
