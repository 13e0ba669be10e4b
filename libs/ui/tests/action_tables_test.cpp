// SPDX-License-Identifier: Apache-2.0
// Names, keys and menus of the actions, against a table: users know the keys by heart, and settings use the
// names.
#include <gtest/gtest.h>

#include <QActionGroup>
#include <QWidget>

#include "characters/character_actions.h"
#include "device/device_actions.h"
#include "learners/learner_actions.h"
#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "progress/progress_actions.h"
#include "start/check_page.h"
#include "start/start_page.h"
#include "study/home.h"
#include "study/session_actions.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

/// Of every group its title, then each action's name and keys; "-" is a separator, "*" one that is checked.
QStringList table_of(const ActionSet& set) {
  QStringList all;
  for (const auto& group : set.groups()) {
    all.append(QLatin1Char('[') + without_mnemonic(group.title) + QLatin1Char(']'));
    for (const auto* action : group.actions) {
      if (action == nullptr) {
        all.append(QStringLiteral("-"));
        continue;
      }
      QStringList keys;
      for (const auto& key : action->shortcuts()) keys.append(key.toString(QKeySequence::PortableText));
      all.append((action->isCheckable() ? QStringLiteral("*") : QString()) + action->objectName() +
                 QLatin1Char(' ') + keys.join(QLatin1Char(' ')));
    }
  }
  return all;
}

QStringList lines(const char* text) { return QString::fromUtf8(text).trimmed().split(QLatin1Char('\n')); }

/// Every action says what it does, in words of its own.
void expect_words(const ActionSet& set) {
  for (const auto& group : set.groups()) {
    QStringList texts;
    for (const auto* action : group.actions) {
      if (action == nullptr) continue;
      EXPECT_FALSE(action->iconText().isEmpty());
      EXPECT_FALSE(action->statusTip().isEmpty()) << action->objectName().toStdString();
      EXPECT_TRUE(action->toolTip().startsWith(action->statusTip()));
      texts.append(action->text());
    }
    EXPECT_EQ(texts.removeDuplicates(), 0);
  }
}

QStringList with_icons(ActionSet& set) {
  set.draw_icons();
  QStringList names;
  for (const auto& group : set.groups())
    for (const auto* action : group.actions)
      if (action != nullptr && !action->icon().isNull()) names.append(action->objectName());
  return names;
}

class ActionTables : public testing::Test {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }
  QWidget window_;
};

TEST_F(ActionTables, OfCharacters) {
  CharacterActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Character]
find Ctrl+F
*find_by_parts Ctrl+J
*find_by_radical Ctrl+K
*draw_to_find Ctrl+D
-
tell_apart Ctrl+Shift+D
make_model Ctrl+Shift+F
-
next_character Ctrl+PgDown PgDown
previous_character Ctrl+PgUp PgUp
-
back Alt+Left
forward Alt+Right
[Strokes]
next_stroke .
previous_stroke ,
all_strokes 0
-
*strokes S
*numbers N
*arrows A
*snap F
writing_cross C
-
clear_ink Del
[Practice]
*watch F5
*trace F6
*guided F7
*memory F8
*dictation F9
-
*play Space
step_back Left
step_on Right
slower [
faster ]
*loop L
-
*by_groove Ctrl+Alt+G
*by_starts Ctrl+Alt+P
*lead_hand Ctrl+Alt+D
[Writing]
undo_stroke Ctrl+Z Backspace
done Return Enter
hint H
give_up G
-
show_right D
*compare_over O
*compare_beside B
-
*judge_each J
*groove_hidden Ctrl+Alt+H
*groove_shown Ctrl+Alt+S
*groove_appears Ctrl+Alt+A
-
more_lenient Ctrl+[
more_strict Ctrl+]
*lenient Ctrl+Alt+L
*normal Ctrl+Alt+N
*strict Ctrl+Alt+T
[Pen by keys]
*key_pen M
-
pen_down P
pen_start T
pen_where I
[Speech]
speak V
*speaks_itself Shift+V
-
*voice_automatic Alt+Shift+B
*voice_open_jtalk Alt+Shift+J
*voice_dispatcher Alt+Shift+D
*voice_espeak Alt+Shift+E
-
voice_file Alt+Shift+V)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfCharactersThoseThatExcludeEachOtherDo) {
  const CharacterActions a(&window_);
  for (const auto& group :
       {a.stages, QList{a.by_groove, a.by_starts}, QList{a.groove_hidden, a.groove_shown, a.groove_appears},
        QList{a.lenient, a.normal, a.strict}})
    for (auto* chosen : group) {
      chosen->setChecked(true);
      for (const auto* other : group) EXPECT_EQ(other->isChecked(), other == chosen);
    }
  EXPECT_EQ(a.compare_over->actionGroup(), nullptr);
}

TEST_F(ActionTables, WhatStandsInAToolbarHasAPicture) {
  CharacterActions characters(&window_);
  EXPECT_EQ(
      with_icons(characters),
      lines("draw_to_find\nnext_stroke\nprevious_stroke\nstrokes\nnumbers\narrows\nsnap\nwriting_"
            "cross\nclear_ink\nwatch\n"
            "trace\nguided\nmemory\ndictation\nplay\nstep_back\nstep_on\nslower\nfaster\nloop\nby_groove\nby_"
            "starts\n"
            "lead_hand\nundo_stroke\ndone\nhint\ngive_up\nshow_right\ncompare_over\ncompare_beside\nspeak"));
  SessionActions session(&window_);
  EXPECT_EQ(with_icons(session), lines("study_start\nstudy_go_on\nstudy_undo"));
  HomeActions home(&window_);
  EXPECT_EQ(with_icons(home), lines("home_study\nhome_brush\nhome_undo"));
  ProgressActions progress(&window_);
  EXPECT_EQ(with_icons(progress), lines("progress_numbers\nprogress_copy"));
}

TEST_F(ActionTables, OfASession) {
  const SessionActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Study]
study_start Ctrl+Return
study_go_on Shift+Return
-
rate_again 1
rate_hard 2
rate_good 3
rate_easy 4
-
study_undo Ctrl+Shift+Z
-
study_this Ctrl+Shift+S
know_this Ctrl+Shift+Y
add_to_list Ctrl+Shift+A
study_tags Ctrl+Shift+T
-
study_postpone Ctrl+Shift+P
study_pause Ctrl+Shift+U
study_reset Ctrl+Shift+N
-
study_end Ctrl+Shift+E
study_choices Ctrl+Shift+G
study_settings Ctrl+,)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfHome) {
  const HomeActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Study]
home_study Ctrl+Return
home_reviews R
home_more F
home_ahead A
home_practise P
home_brush B
home_leeches_lesson Ctrl+Shift+Return
home_choose C
-
*home_all_ink I
home_week W
home_month M
-
home_undo Ctrl+Shift+Z
-
home_choices Ctrl+Shift+G
home_study_settings Ctrl+,)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfTheFirstStart) {
  const StartActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Study]
start_go_on Ctrl+Return
start_skip_all Esc)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfTheTest) {
  const CheckActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Test]
check_done Return Enter
check_unknown I
-
check_undo Ctrl+Z Backspace
check_clear Del
-
check_end Ctrl+Shift+E)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfProgress) {
  const ProgressActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Progress]
progress_calendar 1
progress_characters 2
progress_hard_strokes 3
progress_forecast 4
progress_retention 5
progress_activity 6
progress_motion 7
-
*progress_more M
progress_practise P
-
progress_numbers N
progress_copy Ctrl+C
-
progress_longer L
progress_shorter K)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfDevices) {
  const DeviceActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Device]
choose_device D
look_again F5
-
stronger Ctrl+PgUp
weaker Ctrl+PgDown
-
larger_tip ]
smaller_tip [
-
calibrate C
fit Shift+C)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfTheBrush) {
  const BrushActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Brush]
brush_ink I
brush_water W
brush_wipe X
-
brush_thicker ]
brush_thinner [
brush_hair H
brush_ink_colour C
-
*brush_guess G
*brush_left_hand L
*brush_strengthen Shift+F
*brush_shown B
[Sheet]
brush_undo Ctrl+Z Backspace
brush_redo Ctrl+Y Ctrl+Shift+Z
-
brush_dry D
brush_new Ctrl+N
brush_paper P
-
brush_describe S
*brush_advice J
-
brush_png Ctrl+E
brush_carve Ctrl+Shift+C
-
*brush_tools F3
[Model]
*brush_model_none 1
*brush_model_beneath 2
*brush_model_beside 3
-
brush_ruling R
brush_font F
-
brush_model_text T
brush_next_model .
brush_previous_model ,
-
brush_watch V
[By key]
*brush_by_key M
-
brush_press U
brush_start N
brush_where K
-
brush_harder +
brush_softer -
[Study]
brush_review Ctrl+Return
brush_go_on Return Enter
-
brush_again 7
brush_hard 8
brush_good 9
brush_easy 0
-
brush_undo_rating Shift+Backspace
-
brush_skip Ctrl+Shift+P
brush_end Ctrl+Shift+E)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfTheWorkshop) {
  const WorkshopActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Tool]
*workshop_draw 1
*workshop_place 2
*workshop_edit 3
*workshop_groove 4
*workshop_raise 5
*workshop_smooth 6
*workshop_erase 7
*workshop_stamp 8
-
*workshop_straight L
*workshop_mirrored M
workshop_next_stamp T
-
workshop_wider ]
workshop_thinner [
workshop_deeper PgDown
workshop_shallower PgUp
[Stroke]
workshop_undo Ctrl+Z
workshop_redo Ctrl+Y Ctrl+Shift+Z
workshop_step_back Backspace
workshop_finish Return Enter
-
workshop_next_stroke N
workshop_previous_stroke P
workshop_next_point .
workshop_previous_point ,
-
workshop_earlier Ctrl+Up
workshop_later Ctrl+Down
workshop_reverse R
workshop_ending E
-
workshop_insert I
workshop_split X
workshop_join J
workshop_remove Del
-
workshop_curve W
workshop_number U
workshop_place_number Shift+U
[Character]
workshop_new Ctrl+N
workshop_copy C
workshop_picture Ctrl+I
workshop_font F
workshop_plot Y
-
workshop_clear_relief Ctrl+Del
-
workshop_details D
workshop_add_part G
workshop_remove_part Shift+G
*workshop_check K
workshop_describe S
-
workshop_carve Ctrl+Shift+C
workshop_export Ctrl+E
-
workshop_keep A
*workshop_instead Shift+A
workshop_remove_kept Ctrl+Shift+Del
[Look]
workshop_zoom_in + =
workshop_zoom_out -
workshop_zoom_whole 0
-
*workshop_strokes B
*workshop_panel F3)"));
  expect_words(actions);
}

TEST_F(ActionTables, OfLearners) {
  const LearnerActions actions(&window_);
  EXPECT_EQ(table_of(actions), lines(R"(
[Learner]
learners Ctrl+Shift+W
-
back_up Ctrl+Shift+B
restore Ctrl+Shift+O
-
export_json Ctrl+Shift+X
export_csv Ctrl+Shift+V
export_anki Ctrl+Shift+K
import_json Ctrl+Shift+I)"));
  expect_words(actions);
}

}  // namespace
}  // namespace nazori::ui
