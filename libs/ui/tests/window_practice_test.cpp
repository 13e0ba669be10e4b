// SPDX-License-Identifier: Apache-2.0
// Watching, tracing and guided writing, step by step: what is shown, snapped and announced.
#include "characters/characters.h"
#include "hand_under_test.h"
#include "nazori/widgets/page/window_parts.h"
#include "pointing_under_test.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using study::MissReply;

class Practice : public WindowTest {
 protected:
  Practice() { pages_ = {make}; }
  static std::unique_ptr<Page> make(WindowParts& parts) {
    parts_of_practice = &parts;
    auto made = std::make_unique<Characters>(parts);
    characters_of_practice = made.get();
    return made;
  }
  static practice::TabletControl& controller() { return parts_of_practice->tablet(); }
  static practice::CharacterPractice& characters() { return parts_of_practice->practice(); }
  /// How often a stage was gone through to its end, from now on.
  static std::shared_ptr<int> count_finished(practice::PracticeStage& stage) {
    auto count = std::make_shared<int>(0);
    stage.finished.connect([count](const study::WritingResult&) { ++*count; });
    return count;
  }
  std::string said() { return feedback().toStdString(); }
  static inline WindowParts* parts_of_practice = nullptr;
  static inline Characters* characters_of_practice = nullptr;
};

class Watching : public Practice {
 protected:
  void begin(char32_t character) {
    action("reduced_motion")->trigger();
    show(character);
    action("watch")->trigger();
  }
  static std::vector<double> ink() {
    const auto overlay = controller().overlay();
    return {overlay.groove_ink.begin(), overlay.groove_ink.end()};
  }
  std::string position() { return text("watch_label").toStdString(); }
};

TEST_F(Watching, StepsStopAtTheBeginningAndAtTheEndOfEachStroke) {
  begin(U'二');
  const auto finished = count_finished(characters().watch());
  using Ink = std::vector<double>;
  EXPECT_EQ(ink(), (Ink{0, 0}));
  EXPECT_EQ(position(), "1 of 2 · 1×");
  const auto step = [this](const char* name) {
    action(name)->trigger();
    return ink();
  };
  EXPECT_EQ(step("step_on"), (Ink{0, 0})) << "where the first begins";
  EXPECT_EQ(said(), "Stroke 1 of 2: horizontal stroke. It ends with a stop.");
  EXPECT_EQ(step("step_on"), (Ink{1, 0}));
  EXPECT_EQ(*finished, 0);
  EXPECT_EQ(step("step_on"), (Ink{1, 1}));
  EXPECT_EQ(said(), "Stroke 2 of 2: horizontal stroke. It ends with a stop.");
  EXPECT_EQ(position(), "2 of 2 · 1×");
  EXPECT_EQ(*finished, 1);
  EXPECT_EQ(step("step_on"), (Ink{1, 1}));
  EXPECT_EQ(step("step_back"), (Ink{1, 0}));
  EXPECT_EQ(said(), "Stroke 1 of 2: horizontal stroke. It ends with a stop.");
  EXPECT_EQ(step("step_back"), (Ink{0, 0}));
  EXPECT_EQ(step("step_back"), (Ink{0, 0}));
  EXPECT_FALSE(action("play")->isChecked());
}

TEST_F(Watching, SpeedGoesInEvenStepsFromAQuarterToFourTimes) {
  begin(U'二');
  action("faster")->trigger();
  EXPECT_EQ(said(), "Speed: 1.41×.");
  EXPECT_EQ(position(), "1 of 2 · 1.4×");
  action("faster")->trigger();
  EXPECT_EQ(said(), "Speed: 2.00×.");
  for (int i = 0; i < 5; ++i) action("faster")->trigger();
  EXPECT_EQ(said(), "Speed: 4.00×.");
  action("slower")->trigger();
  EXPECT_EQ(said(), "Speed: 2.83×.");
  for (int i = 0; i < 12; ++i) action("slower")->trigger();
  EXPECT_EQ(said(), "Speed: 0.25×.");
}

TEST_F(Watching, AtTheEndItStopsOrBeginsAgain) {
  begin(U'二');
  auto& watch = characters().watch();
  const auto finished = count_finished(watch);
  watch.show_moment(watch.player().duration_s() - 0.05);
  action("play")->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !action("play")->isChecked(); }, 10'000));
  EXPECT_EQ(*finished, 1);
  EXPECT_EQ(said(), "All 2 strokes shown. Space: play again. F6: trace.");
  EXPECT_EQ(ink(), (std::vector<double>{1, 1}));
  action("play")->trigger();
  EXPECT_EQ(ink()[0], 0) << "from the beginning again";
  action("loop")->setChecked(true);
  watch.show_moment(watch.player().duration_s() - 0.05);
  ASSERT_TRUE(QTest::qWaitFor([&] { return *finished == 2; }, 10'000));
  EXPECT_TRUE(action("play")->isChecked());
  EXPECT_LT(ink()[0], 1);
  action("trace")->trigger();
  EXPECT_FALSE(action("play")->isChecked());
}

TEST_F(Watching, ItPlaysByItselfUnlessNothingShallMove) {
  show(U'二');
  action("watch")->trigger();
  EXPECT_TRUE(action("play")->isChecked());
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return feedback().startsWith(QStringLiteral("Stroke 1 of 2")); }, 10'000));
  ASSERT_TRUE(QTest::qWaitFor([&] { return ink().size() == 2 && ink()[0] > 0; }, 10'000));
  EXPECT_LT(ink()[1], 1);
}

class Tracing : public Practice {
 protected:
  void begin(char32_t character) {
    test::move_mouse(*QCoreApplication::instance());
    show(character);
    action("trace")->trigger();
  }
};

TEST_F(Tracing, SwitchesHoldAtOnceAndAreRemembered) {
  begin(U'二');
  EXPECT_EQ(said(), "Hold the left button at number 1 and draw along the groove.");
  const auto& kept = parts_of_practice->preferences();
  action("numbers")->trigger();
  EXPECT_FALSE(controller().numbers_visible());
  EXPECT_FALSE(kept.numbers_visible);
  action("arrows")->trigger();
  EXPECT_FALSE(controller().arrows_visible());
  EXPECT_FALSE(kept.arrows_visible);
  action("snap")->trigger();
  EXPECT_TRUE(controller().snapping());
  EXPECT_TRUE(kept.snapping);
  EXPECT_EQ(said(), "Snapping on: strokes attract the stylus. Pull firmly to leave a stroke.");
  action("strokes")->trigger();
  EXPECT_FALSE(controller().strokes_visible());
  EXPECT_FALSE(kept.strokes_visible);
  EXPECT_EQ(said(), "Snapping works only while strokes are visible. S: show them.");
  EXPECT_FALSE(action("numbers")->isEnabled());
  EXPECT_FALSE(action("arrows")->isEnabled());
  action("snap")->trigger();
  action("strokes")->trigger();
  EXPECT_TRUE(action("numbers")->isEnabled());
  EXPECT_EQ(said(), "Hold the left button at number 1 and draw along the groove.");
  action("next_stroke")->trigger();
  EXPECT_EQ(said(), "Stroke 1 of 2. Start at its number.");
  EXPECT_EQ(text("stroke_label"), QStringLiteral("stroke 1 of 2"));
  action("previous_stroke")->trigger();
  EXPECT_EQ(text("stroke_label"), QStringLiteral("all 2 strokes"));
  action("previous_stroke")->trigger();
  EXPECT_EQ(said(), "Stroke 2 of 2. Start at its number.");
  action("all_strokes")->trigger();
  EXPECT_EQ(controller().current_stroke(), 0);
}

TEST_F(Tracing, AfterTheMissesOfALessonAStrokeIsShownAlone) {
  begin(U'二');
  std::vector<int> missed;
  MissReply reply = MissReply::try_again;
  characters().trace().set_on_mistake([&](int stroke) {
    missed.push_back(stroke);
    return reply;
  });
  controller().stroke_event(practice::TraceEvent::too_early, 2);
  EXPECT_EQ(said(), "Stroke 1 comes before stroke 2.");
  EXPECT_EQ(controller().current_stroke(), 0);
  controller().stroke_event(practice::TraceEvent::began, 1);
  EXPECT_EQ(missed, std::vector{0}) << "that was none";
  reply = MissReply::show;
  controller().stroke_event(practice::TraceEvent::from_the_end, 1);
  EXPECT_EQ(missed, (std::vector{0, 0}));
  EXPECT_EQ(controller().current_stroke(), 1);
  EXPECT_EQ(said(), "Stroke 1 of 2. Start at its number.");
  controller().stroke_event(practice::TraceEvent::finished, 1);
  EXPECT_EQ(controller().current_stroke(), 0) << "all are there again";
  action("next_stroke")->trigger();
  controller().stroke_event(practice::TraceEvent::finished, 1);
  EXPECT_EQ(controller().current_stroke(), 1) << "the learner chose it";
}

TEST_F(Tracing, TheLastStrokeEndsItAndTheEraserTakesItBack) {
  begin(U'一');
  const auto finished = count_finished(characters().trace());
  test::write(controller(), test::model(U'一').front());
  EXPECT_EQ(*finished, 1);
  ASSERT_EQ(controller().ink().next_stroke(), 0);
  controller().eraser_used();
  EXPECT_EQ(controller().ink().next_stroke(), 1);
  test::write(controller(), test::model(U'一').front());
  action("clear_ink")->trigger();
  EXPECT_EQ(controller().ink().next_stroke(), 1);
  EXPECT_EQ(said(), "Hold the left button at number 1 and draw along the groove.");
}

class Guided : public Practice {
 protected:
  void begin(char32_t character) {
    show(character);
    action("guided")->trigger();
  }
  static view::Overlay seen() { return controller().overlay(); }
  practice::GuidedStage& guided() { return characters().guided(); }
  void help(double much) {
    guided().set_help(much);
    action("by_groove")->trigger();
  }
};

TEST_F(Guided, HelpFadesWithEveryTracingWithoutASlip) {
  begin(U'一');
  std::vector<double> lines;
  std::vector<bool> holds;
  QStringList told;
  for (int success = 0; success < 4; ++success) {
    lines.push_back(seen().lines_opacity);
    holds.push_back(controller().snapping_in_effect());
    EXPECT_EQ(seen().numbers_visible, success == 0) << success;
    if (success == 3) break;
    test::write(controller(), test::model(U'一').front());
    EXPECT_EQ(guided().successes(), success + 1);
    told.append(feedback());
  }
  EXPECT_GT(lines[0], lines[1]);
  EXPECT_GT(lines[1], 0);
  EXPECT_EQ(lines[2], 0);
  EXPECT_EQ(lines[3], 0);
  EXPECT_EQ(holds, (std::vector{true, true, true, false}));
  const QString less = QStringLiteral("No mistakes. Write it again, now with less help.");
  EXPECT_EQ(told, (QStringList{less, less,
                               QStringLiteral("No mistakes, and no help used. F8: write from memory.")}));
  EXPECT_EQ(controller().ink().next_stroke(), 1) << "the tablet is empty for the next time";
}

TEST_F(Guided, ASlipCostsTheSuccessUntilTheTabletIsCleared) {
  begin(U'一');
  controller().stroke_event(practice::TraceEvent::from_the_end, 1);
  test::write(controller(), test::model(U'一').front());
  EXPECT_EQ(said(),
            "All strokes written, but not all in the right order or direction. Delete: clear and try again.");
  EXPECT_EQ(guided().successes(), 0);
  action("clear_ink")->trigger();
  EXPECT_EQ(said(), "Follow the groove.");
  test::write(controller(), test::model(U'一').front());
  EXPECT_EQ(guided().successes(), 1);
}

TEST_F(Guided, InALessonHelpIsWhatTheCourseGives) {
  begin(U'一');
  help(1);
  const double whole = seen().lines_opacity;
  help(0.6);
  EXPECT_NEAR(seen().lines_opacity, 0.6 * whole, 1e-12);
  EXPECT_TRUE(seen().numbers_visible);
  EXPECT_TRUE(controller().snapping_in_effect());
  help(0.4);
  EXPECT_FALSE(seen().numbers_visible);
  help(0);
  EXPECT_EQ(seen().lines_opacity, 0);
  EXPECT_FALSE(controller().snapping_in_effect());
  help(0.6);
  const auto finished = count_finished(guided());
  double help_used = -1;
  const base::Connection watching =
      guided().finished.connect([&](const study::WritingResult& result) { help_used = result.help; });
  test::write(controller(), test::model(U'一').front());
  ASSERT_EQ(*finished, 1);
  EXPECT_EQ(help_used, 0.6);
  EXPECT_EQ(said(), "No mistakes.");
  EXPECT_EQ(guided().successes(), 0);
  help(0.6);
  controller().stroke_event(practice::TraceEvent::from_the_end, 1);
  test::write(controller(), test::model(U'一').front());
  EXPECT_EQ(said(), "All strokes written, but not all in the right order or direction.");
  EXPECT_EQ(*finished, 2);
}

TEST_F(Guided, AStrokeThatIsShownStandsOutUntilItIsWritten) {
  begin(U'二');
  guided().set_on_mistake([](int stroke) { return stroke == 0 ? MissReply::show : MissReply::try_again; });
  controller().stroke_event(practice::TraceEvent::too_early, 2);
  EXPECT_EQ(said(), "Stroke 1 is shown. Start at its number.");
  EXPECT_EQ(seen().lines_opacity, 1);
  EXPECT_EQ(controller().current_stroke(), 1);
  controller().stroke_event(practice::TraceEvent::finished, 2);
  EXPECT_EQ(controller().current_stroke(), 1) << "another one";
  controller().stroke_event(practice::TraceEvent::finished, 1);
  EXPECT_EQ(controller().current_stroke(), 0);
  EXPECT_LT(seen().lines_opacity, 1);
}

TEST_F(Guided, LeadingNeedsADeviceWithForceAndIsRemembered) {
  begin(U'一');
  EXPECT_EQ(said(), "Follow the groove.");
  action("by_starts")->trigger();
  EXPECT_EQ(said(), "Start each stroke at its number.");
  action("lead_hand")->trigger();
  EXPECT_EQ(said(),
            "Start each stroke at its number. Only a force-feedback device can lead your hand; here strokes "
            "attract the stylus.");
  window_->close();
  open_window();
  EXPECT_TRUE(action("lead_hand")->isChecked());
}

TEST_F(Guided, ThatTheStylusGivesWayIsSaidOnce) {
  begin(U'一');
  std::vector<haptics::ServoSample> samples(3);
  controller().sampled(samples);
  EXPECT_EQ(said(), "Follow the groove.");
  samples[1].events = static_cast<std::uint16_t>(haptics::ServoEvent::resisted);
  controller().sampled(samples);
  EXPECT_EQ(said(), "The stylus has let go. Move on a little by yourself and it leads again.");
  parts_of_practice->announce(Feedback::hint, QStringLiteral("x"));
  controller().sampled(samples);
  EXPECT_EQ(said(), "x");
  action("clear_ink")->trigger();
  controller().sampled(samples);
  EXPECT_NE(said(), "Follow the groove.") << "again for the next time";
}

TEST_F(Guided, OnABlankTabletTheInkOfTheHandIsSeen) {
  begin(U'一');
  action("by_starts")->trigger();
  std::vector<haptics::ServoSample> samples;
  const auto add = [&](double x_m, bool touching) {
    haptics::ServoSample s;
    s.time_s = 0.01 * static_cast<double>(samples.size());
    s.proxy_m = {x_m, 0.04, 0};
    s.device_m = {x_m, 0.04, -0.005};
    s.touching = touching;
    samples.push_back(s);
  };
  for (int i = 0; i <= 10; ++i) add(0.001 * i, true);
  controller().sampled(samples);
  EXPECT_EQ(seen().writing.size(), 1U) << "while it is written";
  add(0.01, false);
  for (int i = 0; i <= 10; ++i) add(0.02 + 0.001 * i, true);
  add(0.03, false);
  controller().sampled(std::span(samples).subspan(11));
  EXPECT_EQ(seen().writing.size(), 2U);
  controller().eraser_used();
  EXPECT_EQ(seen().writing.size(), 1U);
  action("clear_ink")->trigger();
  EXPECT_TRUE(seen().writing.empty());
  action("by_groove")->trigger();
  controller().sampled(samples);
  EXPECT_TRUE(seen().writing.empty()) << "in a groove the ink is the groove's";
}

}  // namespace
}  // namespace nazori::ui
