// SPDX-License-Identifier: Apache-2.0
// The actions of the pages for the brush and of the workshop: each has its name, its words and keys of its
// own.
#include <gtest/gtest.h>

#include <QActionGroup>
#include <QWidget>

#include "in_english.h"
#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

class ActionsOfTheStudio : public testing::Test {
 protected:
  ActionsOfTheStudio() { test::speak_english(); }
  static QString names(const QList<QAction*>& actions) {
    QStringList all;
    for (const auto* action : actions)
      all.append(action == nullptr ? QStringLiteral("-") : action->objectName());
    return all.join(QLatin1Char(' '));
  }
  /// Those with some property, in the order of the menus.
  static QString those(const ActionSet& set, const std::function<bool(const QAction&)>& met) {
    QStringList all;
    for (const auto& group : set.groups())
      for (const auto* action : group.actions)
        if (action != nullptr && met(*action)) all.append(action->objectName());
    return all.join(QLatin1Char(' '));
  }
  static void expect_words_and_keys(const ActionSet& set, const char* start) {
    QStringList keys, names;
    for (const auto& group : set.groups()) {
      EXPECT_EQ(group.title.count(QLatin1Char('&')), 1) << group.title.toStdString();
      for (const auto* action : group.actions) {
        if (action == nullptr) continue;
        const std::string name = action->objectName().toStdString();
        EXPECT_TRUE(action->objectName().startsWith(QLatin1String(start))) << name;
        EXPECT_EQ(action->text().count(QLatin1Char('&')), 1) << name << ": a letter for the menu";
        EXPECT_FALSE(action->statusTip().contains(QLatin1Char('&'))) << name << ": a sentence";
        EXPECT_FALSE(action->shortcuts().isEmpty()) << name;
        for (const auto& key : action->shortcuts()) {
          EXPECT_FALSE(key.isEmpty()) << name;
          keys.append(key.toString(QKeySequence::PortableText));
        }
        names.append(action->objectName());
      }
    }
    EXPECT_EQ(keys.removeDuplicates(), 0);
    EXPECT_EQ(names.removeDuplicates(), 0);
  }
  static bool checkable(const QAction& action) { return action.isCheckable(); }
  static bool drawn(const QAction& action) { return !action.icon().isNull(); }
  QWidget window_;
};

TEST_F(ActionsOfTheStudio, HaveNamesWordsAndKeysOfTheirOwn) {
  expect_words_and_keys(BrushActions(&window_), "brush_");
  expect_words_and_keys(WorkshopActions(&window_), "workshop_");
}

TEST_F(ActionsOfTheStudio, OfTheBrushAreInTheMenusOfWhatTheyChange) {
  BrushActions actions(&window_);
  const auto& groups = actions.groups();
  ASSERT_EQ(groups.size(), 5);
  EXPECT_EQ(names(groups[0].actions),
            QStringLiteral("brush_ink brush_water brush_wipe - brush_thicker brush_thinner brush_hair "
                           "brush_ink_colour - brush_guess brush_left_hand brush_strengthen brush_shown"));
  EXPECT_EQ(names(groups[1].actions),
            QStringLiteral("brush_undo brush_redo - brush_dry brush_new brush_paper - brush_describe "
                           "brush_advice - brush_png brush_carve - brush_tools"));
  EXPECT_EQ(
      names(groups[2].actions),
      QStringLiteral("brush_model_none brush_model_beneath brush_model_beside - brush_ruling brush_font "
                     "- brush_model_text brush_next_model brush_previous_model - brush_watch"));
  EXPECT_EQ(names(groups[3].actions), QStringLiteral("brush_by_key - brush_press brush_start brush_where - "
                                                     "brush_harder brush_softer"));
  EXPECT_EQ(names(groups[4].actions),
            QStringLiteral("brush_review brush_go_on - brush_again brush_hard brush_good brush_easy - "
                           "brush_undo_rating - brush_skip brush_end"));
  EXPECT_EQ(those(actions, checkable), QStringLiteral("brush_guess brush_left_hand brush_strengthen "
                                                      "brush_shown brush_advice brush_tools brush_model_none "
                                                      "brush_model_beneath brush_model_beside brush_by_key"));
  actions.draw_icons();
  EXPECT_EQ(
      those(actions, drawn),
      QStringLiteral("brush_ink brush_water brush_wipe brush_undo brush_redo brush_dry brush_new "
                     "brush_advice brush_tools brush_watch brush_review brush_go_on brush_undo_rating"));
  for (auto* one : {actions.model_none, actions.model_beneath, actions.model_beside}) {
    one->trigger();
    EXPECT_EQ(actions.model_none->isChecked() + actions.model_beneath->isChecked() +
                  actions.model_beside->isChecked(),
              1);
  }
}

TEST_F(ActionsOfTheStudio, OfTheBrushFollowTheSession) {
  BrushActions actions(&window_);
  const auto enabled = [&actions] {
    return those(actions, [](const QAction& one) { return one.isEnabled(); });
  };
  const QString ratings = QStringLiteral("brush_again brush_hard brush_good brush_easy");
  EXPECT_FALSE(enabled().contains(ratings));
  EXPECT_TRUE(
      enabled().contains(QStringLiteral("brush_ruling brush_font brush_model_text brush_next_model "
                                        "brush_previous_model brush_watch brush_by_key")));
  EXPECT_TRUE(enabled().endsWith(QStringLiteral("brush_review brush_undo_rating")));
  actions.show_session(true, false);
  EXPECT_TRUE(enabled().contains(QStringLiteral("brush_model_beside brush_font brush_by_key")));
  EXPECT_TRUE(
      enabled().endsWith(QStringLiteral("brush_review brush_go_on brush_undo_rating brush_skip brush_end")));
  actions.show_session(true, true);
  EXPECT_TRUE(enabled().contains(QStringLiteral("brush_go_on ") + ratings));
}

TEST_F(ActionsOfTheStudio, OfTheWorkshopAreInTheMenusOfWhatTheyChange) {
  WorkshopActions actions(&window_);
  const auto& groups = actions.groups();
  ASSERT_EQ(groups.size(), 4);
  EXPECT_EQ(
      names(groups[0].actions),
      QStringLiteral("workshop_draw workshop_place workshop_edit workshop_groove workshop_raise "
                     "workshop_smooth workshop_erase workshop_stamp - workshop_straight workshop_mirrored "
                     "workshop_next_stamp - workshop_wider workshop_thinner workshop_deeper "
                     "workshop_shallower"));
  EXPECT_EQ(names(groups[1].actions),
            QStringLiteral("workshop_undo workshop_redo workshop_step_back workshop_finish - "
                           "workshop_next_stroke workshop_previous_stroke workshop_next_point "
                           "workshop_previous_point - workshop_earlier workshop_later workshop_reverse "
                           "workshop_ending - workshop_insert workshop_split workshop_join workshop_remove - "
                           "workshop_curve workshop_number workshop_place_number"));
  EXPECT_EQ(
      names(groups[2].actions),
      QStringLiteral("workshop_new workshop_copy workshop_picture workshop_font workshop_plot - "
                     "workshop_clear_relief - workshop_details workshop_add_part workshop_remove_part "
                     "workshop_check workshop_describe - workshop_carve workshop_export - workshop_keep "
                     "workshop_instead workshop_remove_kept"));
  EXPECT_EQ(names(groups[3].actions),
            QStringLiteral("workshop_zoom_in workshop_zoom_out workshop_zoom_whole - "
                           "workshop_strokes workshop_panel"));
  EXPECT_EQ(
      those(actions, checkable),
      QStringLiteral("workshop_draw workshop_place workshop_edit workshop_groove workshop_raise "
                     "workshop_smooth workshop_erase workshop_stamp workshop_straight workshop_mirrored "
                     "workshop_check workshop_instead workshop_strokes workshop_panel"));
  actions.draw_icons();
  EXPECT_EQ(those(actions, drawn),
            QStringLiteral("workshop_draw workshop_place workshop_edit workshop_groove workshop_erase "
                           "workshop_undo workshop_redo workshop_remove workshop_new workshop_copy "
                           "workshop_check workshop_panel"));
  for (auto* tool : actions.tools) {
    tool->trigger();
    EXPECT_EQ(std::count_if(actions.tools.begin(), actions.tools.end(),
                            [](const QAction* one) { return one->isChecked(); }),
              1);
  }
}

}  // namespace
}  // namespace nazori::ui
