// SPDX-License-Identifier: Apache-2.0
// The sentence of everything that a stage of practice reports.
#include <gtest/gtest.h>

#include "characters/stage_words.h"
#include "nazori/widgets/words/error_text.h"
#include "pointing_under_test.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using Event = practice::StageEvent;

class StageSentences : public testing::Test {
 protected:
  void SetUp() override {
    install_language(QStringLiteral("en"));
    QObject watched;
    test::move_mouse(watched);
    feedback_.stroke = 2;
    feedback_.other = 3;
    feedback_.count = 4;
    feedback_.value = 0.5;
    feedback_.type = "㇐";
    feedback_.ending = kanji::StrokeEnding::hook;
    feedback_.written = U'大';
    feedback_.asked = U'日';
  }
  std::string said(Event event) {
    feedback_.event = event;
    return StageWords::sentence(feedback_).toStdString();
  }
  std::string said_of_strokes(Event event) {
    feedback_.event = event;
    return StageWords::of_strokes(feedback_, {}).toStdString();
  }
  practice::StageFeedback feedback_;
};

TEST_F(StageSentences, OfWatchingAndTracingNameTheStrokes) {
  const std::pair<Event, const char*> all[] = {
      {Event::watch_paused, "Space: play. Left and Right: step stroke by stroke."},
      {Event::stroke_watched, "Stroke 2 of 4: horizontal stroke. It ends with a hook."},
      {Event::all_watched, "All 4 strokes shown. Space: play again. F6: trace."},
      {Event::speed_changed, "Speed: 0.50×."},
      {Event::touch_tablet, "Press the left button to touch the tablet; the right button turns it."},
      {Event::follow_groove, "Hold the left button in a groove and follow it. S: show the strokes."},
      {Event::draw_from_one, "Hold the left button at number 1 and draw along the groove."},
      {Event::stroke_began, "Stroke 2: follow the groove to its end."},
      {Event::stroke_written_alone, "Stroke 2 written. Full stop (.): show the next one."},
      {Event::stroke_written, "Stroke 2 written. Next: stroke 3."},
      {Event::stroke_written_but_open,
       "Stroke 2 is written, but stroke 3 is not finished: the blue bit is missing."},
      {Event::stroke_written_early, "Stroke 2 is written, but stroke 3 comes first. Write it now."},
      {Event::all_written, "All 4 strokes written. Delete: clear the tablet."},
      {Event::left_open, "Stroke 2 is not finished: the blue bit is missing. Draw on from there."},
      {Event::open_stroke_first, "Stroke 2 is not finished: draw the blue bit first."},
      {Event::too_early, "Stroke 2 comes before stroke 3."},
      {Event::from_the_end, "Start stroke 2 at its other end, at the number."},
      {Event::stroke_shown_alone, "Stroke 2 is shown. Start at its number."},
      {Event::gives_way, "The stylus has let go. Move on a little by yourself and it leads again."},
      {Event::stroke_chosen, "Stroke 2 of 4. Start at its number."},
      {Event::stroke_chosen_hidden, "Stroke 2 is selected, but the strokes are hidden. S: show them."},
      {Event::snapping_off, "Snapping off: the stylus moves freely."},
      {Event::snapping_on, "Snapping on: strokes attract the stylus. Pull firmly to leave a stroke."},
      {Event::snapping_needs_strokes, "Snapping works only while strokes are visible. S: show them."},
      {Event::guided_with_mistakes,
       "All strokes written, but not all in the right order or direction. Delete: clear and try again."},
      {Event::lesson_with_mistakes, "All strokes written, but not all in the right order or direction."},
      {Event::guided_without_mistake, "No mistakes."},
      {Event::guided_less_help, "No mistakes. Write it again, now with less help."},
      {Event::guided_without_help, "No mistakes, and no help used. F8: write from memory."}};
  for (const auto& [event, sentence] : all) EXPECT_EQ(said(event), sentence);
  EXPECT_EQ(StageWords::watched_in_session(4),
            QStringLiteral("All 4 strokes shown. Space: play again. Enter: trace."));
  feedback_.type.clear();
  EXPECT_EQ(said(Event::stroke_watched), "Stroke 2 of 4. It ends with a hook.");
  EXPECT_EQ(said(Event::judged), "") << "there is no stage that wrote it";
}

TEST_F(StageSentences, OfGuidedWritingSayHowTheHandIsLedAndWhatWentWell) {
  const std::string well = " Written without mistakes so far: 4.";
  EXPECT_EQ(said(Event::follow_hidden), "Follow the groove." + well);
  EXPECT_EQ(said(Event::write_from_starts), "Start each stroke at its number." + well);
  feedback_.leading = practice::Leading::leading;
  EXPECT_EQ(said(Event::follow_hidden),
            "Let the stylus lead your hand. If you hold back, it gives way." + well);
  feedback_.leading = practice::Leading::missing;
  EXPECT_EQ(said(Event::write_from_starts),
            "Start each stroke at its number. Only a force-feedback device can lead your hand; here strokes "
            "attract the stylus." +
                well);
  feedback_.leading = practice::Leading::none;
  feedback_.count = 1;
  EXPECT_EQ(said(Event::follow_hidden), "Follow the groove. Written without mistakes so far: 1.");
  feedback_.count = 0;
  EXPECT_EQ(said(Event::follow_hidden), "Follow the groove.");
}

TEST_F(StageSentences, OfWritingFromMemorySayWhatIsThereAndWhatIsMissing) {
  const std::pair<Event, const char*> all[] = {
      {Event::nothing_written, "Nothing written yet. H: show the first stroke."},
      {Event::tablet_full, "The tablet is full. Delete: clear it."},
      {Event::strokes_unjudged, "4 strokes written. Enter: finish."},
      {Event::not_of_character, "That stroke isn't part of this character. Ctrl+Z: undo."},
      {Event::stroke_hinted, "Stroke 2 is shown in blue. Write over it and go on."},
      {Event::stroke_right, "Stroke 2 is correct. 4 to go."},
      {Event::stroke_right_other_missing, "Stroke 2 is right. Stroke 3 is still missing."},
      {Event::judging_failed, ""},
      {Event::stroke_undone, "Undone. 4 strokes written."},
      {Event::all_strokes_there, "All strokes written. Enter: finish."},
      {Event::hint_given, "Stroke 2 is shown in blue. H again: show all remaining strokes."},
      {Event::all_hints_given, "All remaining strokes are shown in blue."},
      {Event::answer_shown, "This is how it is written. Delete: clear and try again."},
      {Event::other_character, "That is 大; 日 was asked."},
      {Event::judges_each, "Each stroke is checked as you finish it."},
      {Event::judges_at_end, "Your writing is checked at the end: press Enter."},
      {Event::own, ""}};
  for (const auto& [event, sentence] : all) EXPECT_EQ(said_of_strokes(event), sentence);
  feedback_.count = 0;
  EXPECT_EQ(said_of_strokes(Event::stroke_right), "Stroke 2 is correct. Enter: finish.");
  feedback_.asked = 0;
  EXPECT_EQ(said_of_strokes(Event::other_character), "That is 大, another character.");
  feedback_.error = base::Error{base::Errc::io, "it is broken", "", ""};
  EXPECT_EQ(said_of_strokes(Event::judging_failed),
            "Your writing could not be checked: " + reason(*feedback_.error).toStdString() +
                ". It is still there.");
  feedback_.more = practice::MistakeHelp::hint;
  EXPECT_EQ(said_of_strokes(Event::not_of_character),
            "That stroke isn't part of this character. Ctrl+Z: undo. H: show where the stroke goes.");
  feedback_.mistake = writing::Mistake{};
  feedback_.more = practice::MistakeHelp::none;
  const auto why = writing::explain(*feedback_.mistake, writing::Grade(), writing::Language::english);
  for (const Event event : {Event::mistake, Event::stroke_advice}) EXPECT_EQ(said_of_strokes(event), why);
}

}  // namespace
}  // namespace nazori::ui
