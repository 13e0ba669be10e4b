// SPDX-License-Identifier: Apache-2.0
// What the actions, the canvas and the panel of the workshop do to the character, and what is said of it.
#include <QBoxLayout>

#include "nazori/author/check.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/studio/workshop/workshop_words.h"
#include "workshop_page_under_test.h"

namespace nazori::ui {
namespace {

using author::Tool;

using test::sentence;
using PageOfTheWorkshop = test::WorkshopPageTest;

TEST_F(PageOfTheWorkshop, BeginsWithADrawnTabletAndSaysWhatCanBeDone) {
  EXPECT_EQ(said_,
            QStringList{sentence("Draw strokes with mouse or pen. 1 to 8: tools. K: check. S: describe "
                                 "what is there.")});
  EXPECT_EQ(kind_, Feedback::hint);
  EXPECT_EQ(page_->id(), sentence("workshop"));
  EXPECT_EQ(page_->name(), sentence("&Workshop"));
  EXPECT_EQ(page_->purpose(), sentence("Make your own characters and signs"));
  EXPECT_EQ(page_->drawing(), Icon::chisel);
  EXPECT_TRUE(page_->has_files());
  EXPECT_EQ(page_->title(), QString());
  const auto* row = static_cast<QBoxLayout*>(page_->instead_of_tablet()->layout());
  EXPECT_EQ(row->contentsMargins(), QMargins());
  EXPECT_EQ(row->spacing(), 0);
  EXPECT_EQ(row->stretch(0), 1);
  EXPECT_EQ(row->direction(), QBoxLayout::LeftToRight);
  EXPECT_EQ(page_->instead_of_tablet()->focusProxy(), &canvas());
  EXPECT_EQ(canvas().accessibleDescription(), sentence("No name yet: no strokes."));
  parts_.preferences().left_handed = true;
  page_->enter();
  EXPECT_EQ(row->direction(), QBoxLayout::RightToLeft);
  EXPECT_EQ(test::tools_of(*page_),
            sentence("workshop_draw* workshop_place* workshop_edit* workshop_groove* - workshop_undo* "
                     "workshop_redo* workshop_remove - workshop_check* - workshop_panel"));
}

TEST_F(PageOfTheWorkshop, EachToolIsTakenByItsActionAndKept) {
  for (std::size_t i = 0; i < 8; ++i) {
    const int before = saves_;
    EXPECT_EQ(by(actions().tools[i]), sentence("Tool: %1.").arg(tool_name(static_cast<Tool>(i))));
    EXPECT_EQ(bench().settings().tool, static_cast<Tool>(i));
    EXPECT_EQ(saves_, before + 1);
  }
  const int before = saves_;
  actions().straight->trigger();
  EXPECT_TRUE(bench().settings().straight);
  EXPECT_FALSE(bench().settings().mirrored);
  actions().mirrored->trigger();
  actions().straight->trigger();
  EXPECT_FALSE(bench().settings().straight);
  EXPECT_TRUE(bench().settings().mirrored);
  EXPECT_EQ(saves_, before + 3);
}

TEST_F(PageOfTheWorkshop, TheToolGetsWiderAndDeeperByATenth) {
  const int before = saves_;
  EXPECT_EQ(by(actions().wider), sentence("Width: 7.7 of 109."));
  EXPECT_NEAR(bench().settings().width, 7.7, 1e-9);
  EXPECT_EQ(by(actions().thinner), sentence("Width: 7.0 of 109."));
  EXPECT_EQ(by(actions().thinner), sentence("Width: 6.4 of 109."));
  EXPECT_EQ(by(actions().shallower), sentence("Depth: 91%."));
  EXPECT_NEAR(bench().settings().depth, 1 / 1.1, 1e-9);
  EXPECT_EQ(by(actions().deeper), sentence("Depth: 100%."));
  EXPECT_EQ(by(actions().deeper), sentence("Depth: 100%.")) << "not deeper than the tablet";
  EXPECT_EQ(saves_, before + 6);
  EXPECT_EQ(kind_, Feedback::hint);
}

TEST_F(PageOfTheWorkshop, WithTheToolForEditingTheChosenStrokeGetsWiderAndDeeperInstead) {
  choose(Tool::place);
  actions().shallower->trigger();
  place({{20, 40}, {80, 40}});
  const double half = stroke(0).points[0].half_width, depth = stroke(0).points[0].depth;
  const int before = saves_;
  actions().wider->trigger();
  EXPECT_EQ(stroke(0).points[0].half_width, half) << "another tool";
  choose(Tool::edit);
  EXPECT_EQ(by(actions().wider), edit_words(author::EditKind::set_width, author::EditWay::made));
  EXPECT_NEAR(stroke(0).points[0].half_width, 1.1 * half, 1e-9);
  actions().thinner->trigger();
  EXPECT_NEAR(stroke(0).points[0].half_width, half, 1e-9);
  EXPECT_EQ(by(actions().shallower), edit_words(author::EditKind::set_depth, author::EditWay::made));
  EXPECT_NEAR(stroke(0).points[0].depth, depth / 1.1, 1e-6);
  actions().deeper->trigger();
  EXPECT_NEAR(stroke(0).points[0].depth, depth, 1e-6);
  EXPECT_NEAR(bench().settings().width, 7.7, 1e-9);
  EXPECT_EQ(saves_, before + 2) << "of the tool's width and of the tool";
}

TEST_F(PageOfTheWorkshop, StampsAndEndingsFollowEachOtherInARing) {
  for (const char* stamp : {"Ring", "Bar", "Cross", "Square", "Triangle", "Dot"})
    EXPECT_EQ(by(actions().next_stamp), sentence("Stamp: %1.").arg(sentence(stamp)));
  EXPECT_EQ(bench().settings().stamp, author::StampShape::dot);
  for (const char* ending : {"hook", "sweep", "stop", "hook"})
    EXPECT_EQ(by(actions().ending), sentence("Ending of placed strokes: %1.").arg(sentence(ending)));
  EXPECT_EQ(bench().settings().ending, kanji::StrokeEnding::hook);
  EXPECT_EQ(saves_, 10);
  place({{20, 40}, {80, 40}});
  EXPECT_EQ(stroke(0).ending, kanji::StrokeEnding::hook);
  by(actions().ending);
  EXPECT_EQ(said_.back(), sentence("Ending: sweep."));
  EXPECT_EQ(stroke(0).ending, kanji::StrokeEnding::taper);
  EXPECT_EQ(bench().settings().ending, kanji::StrokeEnding::hook);
}

TEST_F(PageOfTheWorkshop, WithoutAStrokeThatIsChosenTheLearnerHearsHowToChooseOne) {
  const QString choose_first = sentence("Choose a stroke first. N: next stroke. Full stop: next point.");
  auto& a = actions();
  for (auto* action : {a.earlier, a.later, a.reverse, a.insert, a.split, a.join, a.remove, a.place_number})
    EXPECT_EQ(by(action), choose_first) << action->objectName().toStdString();
  for (auto* action : {a.next_stroke, a.previous_stroke, a.next_point, a.previous_point, a.number, a.curve})
    EXPECT_EQ(by(action), sentence("There are no strokes yet.")) << action->objectName().toStdString();
  EXPECT_EQ(by(a.finish), sentence("Place at least two points first: the start and the end."));
  EXPECT_EQ(by(a.remove_part), sentence("Choose a part in the list first."));
  EXPECT_EQ(kind_, Feedback::hint);
  place({{20, 40}, {80, 40}});
  for (auto* action : {a.earlier, a.later, a.split, a.join})
    EXPECT_EQ(by(action), sentence("This is not possible here.")) << action->objectName().toStdString();
}

TEST_F(PageOfTheWorkshop, TheReliefByHandIsClearedOnlyWhereThereIsOne) {
  auto& a = actions();
  EXPECT_FALSE(a.clear_relief->isEnabled());
  choose(Tool::stamp);
  click({50, 50});
  EXPECT_TRUE(a.clear_relief->isEnabled());
  EXPECT_EQ(canvas().accessibleDescription(),
            sentence("No name yet: no strokes. The relief was changed by hand."));
  EXPECT_EQ(by(a.clear_relief), edit_words(author::EditKind::clear_relief, author::EditWay::made));
  EXPECT_FALSE(a.clear_relief->isEnabled());
}

TEST_F(PageOfTheWorkshop, AFindingThatIsChosenShowsItsPlace) {
  place({{20, 30}, {80, 30}});
  place({{20, 70}, {80, 70}});
  using author::FindingKind;
  const auto chosen = [this](author::Finding finding) {
    emit panel().finding_chosen(finding);
    EXPECT_EQ(said_.back(), finding_words(finding));
    EXPECT_EQ(kind_, Feedback::advice);
    return bench().selection();
  };
  EXPECT_EQ(chosen({.kind = FindingKind::point_off_line, .stroke = 0, .point = 1}),
            (author::Selection{0, 1}));
  for (const auto kind :
       {FindingKind::number_far, FindingKind::numbers_overlap, FindingKind::number_hides_start})
    EXPECT_EQ(chosen({.kind = kind, .stroke = 1}), (author::Selection{1, {}, true}));
  said_.clear();
  emit panel().finding_chosen({.kind = FindingKind::no_name});
  EXPECT_TRUE(said_.isEmpty());
  EXPECT_EQ(bench().selection(), (author::Selection{1, {}, true}));
}

TEST_F(PageOfTheWorkshop, ACheckSaysAllThatItFindsAndEndsWithTheNextChange) {
  const auto found = [this] {
    QStringList all;
    for (const auto& finding : author::check(bench().character(), {})) all.append(finding_words(finding));
    return all.join(QLatin1Char(' '));
  };
  EXPECT_EQ(by(actions().check), found());
  EXPECT_EQ(kind_, Feedback::advice);
  EXPECT_TRUE(said_.back().contains(sentence("There are no strokes.")));
  EXPECT_TRUE(actions().check->isChecked());
  EXPECT_EQ(by(actions().check), QString());
  EXPECT_FALSE(actions().check->isChecked());
  actions().check->trigger();
  name("x");
  EXPECT_FALSE(actions().check->isChecked());
}

TEST_F(PageOfTheWorkshop, TellsWhatIsThere) {
  EXPECT_EQ(
      by(actions().describe),
      sentence("No name yet: no strokes. Tool: %1. Cursor: 55 from the left and 55 from the top, of 109.")
          .arg(tool_name(Tool::draw)));
  place({{20, 30}, {80, 30}});
  name("山");
  const QString all = character_words(bench().character()) + QLatin1Char(' ') +
                      selection_words(bench().character(), {0, {}}) +
                      sentence(" Tool: %1. Cursor: 80 from the left and 30 from the top, of 109. Not saved.")
                          .arg(tool_name(Tool::place));
  EXPECT_EQ(by(actions().describe), all);
}

TEST_F(PageOfTheWorkshop, LooksNearerAndHidesStrokesAndPanel) {
  auto& a = actions();
  page_->instead_of_tablet()->resize(900, 600);
  a.zoom_in->trigger();
  EXPECT_NEAR(canvas().zoomed(), 1.5, 1e-9);
  a.zoom_in->trigger();
  EXPECT_NEAR(canvas().zoomed(), 2.25, 1e-9);
  a.zoom_out->trigger();
  EXPECT_NEAR(canvas().zoomed(), 1.5, 1e-9);
  a.zoom_whole->trigger();
  EXPECT_EQ(canvas().zoomed(), 1);
  const int before = saves_;
  a.strokes->trigger();
  a.panel->trigger();
  EXPECT_EQ(saves_, before + 2);
  EXPECT_TRUE(panel().isHidden());
  for (auto* action : {a.details, a.add_part}) {
    action->trigger();
    EXPECT_FALSE(panel().isHidden()) << "it is needed";
    EXPECT_TRUE(a.panel->isChecked());
    action->trigger();
    EXPECT_TRUE(a.panel->isChecked()) << "it stays";
    a.panel->trigger();
  }
  place({{20, 30}, {80, 30}});
  a.curve->trigger();
  EXPECT_TRUE(a.panel->isChecked());
}

TEST_F(PageOfTheWorkshop, KeepsItsToolsForTheNextTime) {
  auto& a = actions();
  for (auto* action :
       {a.tools[4], a.straight, a.mirrored, a.wider, a.shallower, a.next_stamp, a.ending, a.strokes, a.panel})
    action->trigger();
  const auto held = bench().settings();
  keep_settings(*page_);
  open_page();
  EXPECT_EQ(bench().settings(), held);
  EXPECT_EQ(held.tool, Tool::raise);
  EXPECT_TRUE(actions().tools[4]->isChecked());
  EXPECT_TRUE(actions().straight->isChecked());
  EXPECT_TRUE(actions().mirrored->isChecked());
  EXPECT_FALSE(actions().strokes->isChecked());
  EXPECT_FALSE(actions().panel->isChecked());
  EXPECT_TRUE(panel().isHidden());
}

TEST_F(PageOfTheWorkshop, WhatIsMadeBecomesTheTabletThatIsFelt) {
  std::optional<practice::OwnTablet> shown;
  parts_.workshop().loaded.connect([&shown](const practice::OwnTablet& own) { shown = own; });
  actions().carve->trigger();
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->name, "Own character");
  EXPECT_EQ(shown->map_size, bench().editor().map().size());
  EXPECT_FALSE(shown->has_strokes);
  place({{20, 30}, {80, 30}});
  name("山");
  actions().carve->trigger();
  EXPECT_EQ(shown->name, "山");
  EXPECT_TRUE(shown->has_strokes);
}

}  // namespace
}  // namespace nazori::ui
