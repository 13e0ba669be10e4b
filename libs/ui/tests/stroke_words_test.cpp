// SPDX-License-Identifier: Apache-2.0
// The sentences about strokes: their names, their endings, and what happens to them on the tablet.
#include "characters/stroke_words.h"

#include <map>

#include "characters/stage_words.h"
#include "characters/stroke_counter.h"
#include "hand_under_test.h"
#include "nazori/practice/tracing_feedback.h"
#include "nazori/widgets/controls/input_watch.h"
#include "nazori/widgets/tablet/window_tablet.h"
#include "nazori/widgets/words/feedback_tone.h"
#include "pointing_under_test.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

class StrokeWordsTest : public testing::Test {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }
};

TEST_F(StrokeWordsTest, EveryStrokeOfUnicodesChartHasItsName) {
  // By the letters of the chart: H level, S upright, P to the left, N to the right, D dot, T rising, Z turn,
  // G hook, W bend, X slanting, B flat.
  const std::map<const char*, std::string> names{{"㇐", "horizontal stroke"},
                                                 {"㇑", "vertical stroke"},
                                                 {"㇒", "sweep to the left"},
                                                 {"㇓", "sweep to the left"},
                                                 {"㇏", "sweep to the right"},
                                                 {"㇝", "sweep to the right"},
                                                 {"㇔", "dot"},
                                                 {"㇀", "rising stroke"},
                                                 {"㇖", "horizontal stroke with a hook"},
                                                 {"㇚", "vertical stroke with a hook"},
                                                 {"㇕", "horizontal stroke that turns down"},
                                                 {"㇆", "horizontal stroke that turns down, with a hook"},
                                                 {"㇗", "vertical stroke that turns right"},
                                                 {"㇄", "vertical stroke that turns right"},
                                                 {"㇟", "vertical stroke that bends right, with a hook"},
                                                 {"㇙", "vertical stroke that rises at the end"},
                                                 {"㇇", "horizontal stroke that turns into a left sweep"},
                                                 {"㇁", "curved stroke with a hook"},
                                                 {"㇂", "slanting stroke with a hook"},
                                                 {"㇃", "flat curve with a hook"},
                                                 {"㇈", "horizontal stroke that bends, with a hook"},
                                                 {"㇠", "horizontal stroke that bends, with a hook"},
                                                 {"㇊", "horizontal stroke that turns down, then rises"},
                                                 {"㇜", "sweep to the left that turns right"},
                                                 {"㇛", "sweep to the left that turns into a dot"},
                                                 {"㇞", "stroke with three turns"},
                                                 {"㇅", "stroke with three turns"},
                                                 {"㇎", "stroke with three turns"},
                                                 {"㇉", "stroke with several turns and a hook"},
                                                 {"㇡", "stroke with several turns and a hook"},
                                                 {"㇋", "stroke with two turns and a sweep to the left"},
                                                 {"㇌", "stroke that turns and curves, with a hook"}};
  for (const auto& [type, name] : names) {
    EXPECT_EQ(StrokeWords::name(type).toStdString(), name) << type;
    EXPECT_EQ(StrokeWords::name(std::string(type) + "b/㇐").toStdString(), name) << type;
  }
  EXPECT_EQ(StrokeWords::name(""), QString());
  EXPECT_EQ(StrokeWords::name("x"), QString());
}

TEST_F(StrokeWordsTest, EveryEndHasItsSentence) {
  using kanji::StrokeEnding;
  EXPECT_EQ(StrokeWords::ending(StrokeEnding::stop), QStringLiteral("It ends with a stop."));
  EXPECT_EQ(StrokeWords::ending(StrokeEnding::hook), QStringLiteral("It ends with a hook."));
  EXPECT_EQ(StrokeWords::ending(StrokeEnding::taper),
            QStringLiteral("It ends with a sweep: lift the pen while it is still moving."));
  EXPECT_EQ(StrokeWords::ending(StrokeEnding::either), QStringLiteral("It may end with a stop or a sweep."));
}

/// Three level strokes on a tablet.
class StageWordsTest : public StrokeWordsTest {
 protected:
  void put_three() {
    std::vector<kanji::StrokeLine> lines(3);
    for (int i = 0; i < 3; ++i) lines[static_cast<std::size_t>(i)].points = line(i, 89);
    controller_.set_tablet(*tablet::CarvedTablet::from_lines(tablet::tablet_lines(lines), 128));
  }
  static test::Points line(int stroke, double to) {
    return {{20, 24.5 + 30 * stroke}, {to, 24.5 + 30 * stroke}};
  }
  void expect(const std::optional<practice::StageFeedback>& said, Feedback kind, const char* text) const {
    ASSERT_TRUE(said);
    EXPECT_EQ(StageWords::sentence(*said).toStdString(), text);
    EXPECT_EQ(to_feedback(said->tone), kind) << text;
  }
  [[nodiscard]] std::optional<practice::StageFeedback> about(practice::TraceEvent event, int stroke) const {
    return practice::tracing_feedback(event, stroke, controller_);
  }
  WindowTablet controller_;
  QObject watched_;
};

TEST_F(StageWordsTest, InvitesByWhatIsToBeSeen) {
  test::move_mouse(watched_);
  expect(practice::tracing_invitation(controller_), Feedback::hint,
         "Press the left button to touch the tablet; the right button turns it.");
  put_three();
  expect(practice::tracing_invitation(controller_), Feedback::hint,
         "Hold the left button at number 1 and draw along the groove.");
  expect(practice::shown_stroke_feedback(controller_), Feedback::hint,
         "Hold the left button at number 1 and draw along the groove.");
  controller_.set_current_stroke(2);
  expect(practice::shown_stroke_feedback(controller_), Feedback::hint, "Stroke 2 of 3. Start at its number.");
  controller_.set_strokes_visible(false);
  expect(practice::shown_stroke_feedback(controller_), Feedback::advice,
         "Stroke 2 is selected, but the strokes are hidden. S: show them.");
  expect(practice::tracing_invitation(controller_), Feedback::hint,
         "Hold the left button in a groove and follow it. S: show the strokes.");
}

TEST_F(StageWordsTest, NamesNoButtonToAPenADeviceOrKeys) {
  const auto expect_no_button = [this] {
    controller_.set_strokes_visible(true);
    expect(practice::tracing_invitation(controller_), Feedback::hint,
           "Start at number 1 and draw along the groove.");
    controller_.set_strokes_visible(false);
    expect(practice::tracing_invitation(controller_), Feedback::hint,
           "Follow a groove. S: show the strokes.");
  };
  test::move_pen(watched_);
  expect(practice::tracing_invitation(controller_), Feedback::hint, "Touch the tablet with the tip.");
  put_three();
  expect_no_button();
  test::move_mouse(watched_);
  InputWatch::of_program().set_has_device(true);
  expect_no_button();
  // The one that follows has seen no pointer, like that of a learner who only uses keys.
  delete &InputWatch::of_program();
  expect_no_button();
  EXPECT_EQ(InputWatch::of_program().sentence({}),
            QStringLiteral("You are writing with the mouse. A pen tablet works better."));
}

TEST_F(StageWordsTest, SaysWhetherStrokesHoldTheStylus) {
  put_three();
  controller_.set_snapping(false);
  expect(practice::snapping_feedback(controller_), Feedback::hint, "Snapping off: the stylus moves freely.");
  controller_.set_snapping(true);
  expect(practice::snapping_feedback(controller_), Feedback::hint,
         "Snapping on: strokes attract the stylus. Pull firmly to leave a stroke.");
  controller_.set_strokes_visible(false);
  expect(practice::snapping_feedback(controller_), Feedback::advice,
         "Snapping works only while strokes are visible. S: show them.");
}

TEST_F(StageWordsTest, ToldInTurnOutOfTurnAndLeftOpen) {
  put_three();
  EXPECT_FALSE(about(practice::TraceEvent::none, 1));
  expect(about(practice::TraceEvent::began, 1), Feedback::hint, "Stroke 1: follow the groove to its end.");
  expect(about(practice::TraceEvent::from_the_end, 1), Feedback::advice,
         "Start stroke 1 at its other end, at the number.");
  expect(about(practice::TraceEvent::left_open, 1), Feedback::advice,
         "Stroke 1 is not finished: the blue bit is missing. Draw on from there.");
  expect(about(practice::TraceEvent::too_early, 2), Feedback::advice, "Stroke 1 comes before stroke 2.");
  expect(about(practice::TraceEvent::finished, 2), Feedback::advice,
         "Stroke 2 is written, but stroke 1 comes first. Write it now.");
  controller_.set_current_stroke(2);
  expect(about(practice::TraceEvent::finished, 2), Feedback::good,
         "Stroke 2 written. Full stop (.): show the next one.");
  controller_.set_current_stroke(0);
  EXPECT_TRUE(practice::is_mistake(practice::TraceEvent::from_the_end, controller_));
  EXPECT_TRUE(practice::is_mistake(practice::TraceEvent::too_early, controller_));
  for (const auto event : {practice::TraceEvent::none, practice::TraceEvent::began,
                           practice::TraceEvent::finished, practice::TraceEvent::left_open})
    EXPECT_FALSE(practice::is_mistake(event, controller_));

  ASSERT_TRUE(controller_.start());
  test::write(controller_, line(0, 60));
  ASSERT_EQ(controller_.ink().left_open(), std::vector{1});
  expect(about(practice::TraceEvent::too_early, 2), Feedback::advice,
         "Stroke 1 is not finished: draw the blue bit first.");
  expect(about(practice::TraceEvent::finished, 2), Feedback::advice,
         "Stroke 2 is written, but stroke 1 is not finished: the blue bit is missing.");
  EXPECT_FALSE(practice::is_mistake(practice::TraceEvent::too_early, controller_)) << "only a bit is missing";
  EXPECT_TRUE(practice::is_mistake(practice::TraceEvent::from_the_end, controller_));
  test::write(controller_, {{60, 24.5}, {89, 24.5}});
  ASSERT_EQ(controller_.ink().next_stroke(), 2);
  expect(about(practice::TraceEvent::finished, 1), Feedback::good, "Stroke 1 written. Next: stroke 2.");
  test::write(controller_, line(1, 89));
  test::write(controller_, line(2, 89));
  expect(about(practice::TraceEvent::finished, 3), Feedback::good,
         "All 3 strokes written. Delete: clear the tablet.");
}

TEST_F(StageWordsTest, TheCounterNamesTheStrokeAndKeepsItsWidth) {
  StrokeCounter counter(controller_);
  counter.refresh();
  EXPECT_EQ(counter.text(), QStringLiteral("no strokes"));
  put_three();
  counter.refresh();
  EXPECT_EQ(counter.text(), QStringLiteral("all 3 strokes"));
  const int width = counter.minimumWidth();
  EXPECT_GE(width, counter.sizeHint().width());
  controller_.set_current_stroke(2);
  counter.refresh();
  EXPECT_EQ(counter.text(), QStringLiteral("stroke 2 of 3"));
  EXPECT_EQ(counter.minimumWidth(), width);
  EXPECT_GT(width, counter.fontMetrics().horizontalAdvance(QStringLiteral("stroke 28 of 28")));
  QFont large = counter.font();
  large.setPointSizeF(large.pointSizeF() * 2);
  counter.setFont(large);
  EXPECT_GT(counter.minimumWidth(),
            counter.fontMetrics().horizontalAdvance(QStringLiteral("stroke 28 of 28")));
}

}  // namespace
}  // namespace nazori::ui
