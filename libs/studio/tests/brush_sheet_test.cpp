// SPDX-License-Identifier: Apache-2.0
// What becomes of a sheet of paper: undone, compared, written by a teacher, kept as a file and carved.
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QLabel>

#include "brush_page_under_test.h"
#include "nazori/practice/tablet_workshop.h"

namespace nazori::ui {
namespace {

using test::sentence;

class SheetOfThePage : public test::BrushPageTest {
 protected:
  [[nodiscard]] bool has_advice() const {
    const bool is_shown = actions().advice->isChecked();
    EXPECT_EQ(find<QLabel>("brush_advice_words").isHidden(), !is_shown);
    EXPECT_TRUE(is_shown || paper().marks().empty());
    return is_shown;
  }
  /// Whether there is ink at a place of the sheet.
  [[nodiscard]] bool is_inked(geometry::PaperPoint at) const {
    const auto cell = [](double m) { return static_cast<int>((0.5 + m / 0.1024) * kCells); };
    return qGray(paper().picture().pixel(cell(at.x), cell(-at.y))) < 120;
  }
  [[nodiscard]] QByteArray bytes(const char* name) const {
    QFile one(file(name));
    EXPECT_TRUE(one.open(QIODevice::ReadOnly)) << name;
    return one.readAll();
  }
  QString by_writing(const char* name) {
    said_.clear();
    page_->write(file(name));
    settle();
    return all_said();
  }
};

TEST_F(SheetOfThePage, AStrokeIsUndoneAndRedoneAndSaysSo) {
  write();
  EXPECT_TRUE(actions().undo->isEnabled());
  EXPECT_FALSE(actions().redo->isEnabled());
  EXPECT_TRUE(actions().dry->isEnabled());
  EXPECT_EQ(by(actions().undo), sentence("Stroke 1 undone."));
  EXPECT_EQ(state().strokes, 0);
  EXPECT_FALSE(actions().undo->isEnabled());
  EXPECT_TRUE(actions().redo->isEnabled());
  EXPECT_EQ(by(actions().redo), sentence("Stroke 1 redone."));
  EXPECT_EQ(kind_, Feedback::hint);
  emit paper().eraser_used();
  settle();
  EXPECT_EQ(state().strokes, 0) << "the other end of the pen undoes";
  EXPECT_EQ(said_.back(), sentence("Stroke 1 undone."));
}

TEST_F(SheetOfThePage, AnotherInkWaitsUntilTheSheetIsDry) {
  const QString wet = sentence("The sheet is still wet with other inks. D: dry it now.");
  QString said;
  for (int i = 0; i < 4 && said != wet; ++i) {
    write({-0.03, 0.03 - 0.015 * i}, {0.03, 0.03 - 0.015 * i});
    said = by(actions().next_ink);
  }
  ASSERT_EQ(said, wet);
  EXPECT_EQ(kind_, Feedback::advice);
  by(actions().dry);
  const QString ink = QString::fromStdString(state().ink);
  EXPECT_TRUE(by(actions().next_ink).startsWith(sentence("Ink: ")));
  EXPECT_NE(QString::fromStdString(state().ink), ink);
}

TEST_F(SheetOfThePage, AdviceIsShownSaidAndTakenAway) {
  take_model("一", 1);
  EXPECT_EQ(by(actions().advice), sentence("Write a character first. Then J gives advice."));
  EXPECT_FALSE(has_advice());
  // The square is 85 mm of the 102 mm of the sheet.
  write({-0.03, 0.048}, {0.03, 0.048});
  EXPECT_EQ(by(actions().advice), sentence("There are no strokes in the squares of the model."));
  EXPECT_EQ(kind_, Feedback::hint);
  EXPECT_FALSE(has_advice());
  by(actions().undo);
  write({-0.03, 0.03}, {0.03, 0.03});
  const QString advice = by(actions().advice);
  EXPECT_TRUE(advice.startsWith(sentence("Advice: "))) << advice.toStdString();
  EXPECT_TRUE(advice.contains(sentence("The character is too high."))) << advice.toStdString();
  EXPECT_EQ(kind_, Feedback::advice);
  EXPECT_TRUE(has_advice());
  EXPECT_FALSE(paper().marks().empty());
  EXPECT_EQ(find<QLabel>("brush_advice_words").text().replace(QLatin1Char('\n'), QLatin1Char(' ')),
            advice.mid(8));
  EXPECT_EQ(by(actions().advice), sentence("The corrections are gone."));
  EXPECT_FALSE(has_advice());
}

TEST_F(SheetOfThePage, InkBesideTheModelCountsOnlyWhereItWasWrittenOver) {
  take_model("一", 1);
  write({-0.03, 0.02}, {0.03, 0.02});
  const QString outside = sentence("% of the ink is outside the model.");
  EXPECT_TRUE(by(actions().advice).contains(outside)) << all_said().toStdString();
  for (auto* place : {actions().model_beside, actions().model_none}) {
    place->trigger();
    EXPECT_FALSE(by(actions().advice).contains(outside)) << all_said().toStdString();
  }
}

TEST_F(SheetOfThePage, WhateverChangesTheSheetOrItsModelTakesAdviceAway) {
  take_model("一", 1);
  write({-0.03, 0.03}, {0.03, 0.03});
  const auto gone_after = [this](const char* what, const std::function<void()>& act) {
    by(actions().advice);
    EXPECT_TRUE(has_advice()) << what;
    act();
    settle();
    EXPECT_FALSE(has_advice()) << what;
  };
  gone_after("a stroke", [this] { write({-0.03, -0.03}, {0.03, -0.03}); });
  gone_after("undo", [this] { actions().undo->trigger(); });
  gone_after("redo", [this] { actions().redo->trigger(); });
  gone_after("a place", [this] { actions().model_beside->trigger(); });
  gone_after("a text", [this] { emit panel().text_typed(sentence("一一")); });
  gone_after("a ruling", [this] { emit panel().ruling_chosen(1); });
  gone_after("a font", [this] { emit panel().font_chosen({}); });
  gone_after("a new sheet", [this] { actions().new_sheet->trigger(); });
}

TEST_F(SheetOfThePage, AdviceThatIsNoLongerWantedIsNotShown) {
  take_model("一", 1);
  write({-0.03, 0.03}, {0.03, 0.03});
  actions().advice->trigger();
  emit panel().text_typed(sentence("一一"));
  said_.clear();
  settle();
  EXPECT_EQ(all_said(), QString());
  EXPECT_FALSE(has_advice());
}

TEST_F(SheetOfThePage, AdviceWaitsForTheFont) {
  wait_until([this] { return !page_->awaits_models(); });
  take_model("一", 1);
  write({-0.03, 0.03}, {0.03, 0.03});
  emit panel().font_chosen(sentence("KouzanBrushFont"));
  ASSERT_TRUE(page_->awaits_models());
  said_.clear();
  actions().advice->trigger();
  EXPECT_FALSE(page_->writing()->is_waiting()) << "not yet";
  wait_until([this] { return all_said().contains(sentence("Advice: ")); });
  EXPECT_FALSE(page_->awaits_models());
  EXPECT_TRUE(has_advice());
}

TEST_F(SheetOfThePage, ATeacherWritesTheModelOnANewSheet) {
  take_model("一", 1);
  write({-0.03, -0.045}, {0.03, -0.045});
  actions().watch->trigger();
  wait_until([this] { return all_said().contains(sentence("Watch: 1 strokes. V: stop.")); });
  wait_until(
      [this] { return said_.back() == sentence("That is how it is written. Ctrl+N: a new sheet for you."); });
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_FALSE(all_said().contains(sentence("New sheet"))) << "the learner did not ask for it";
  wait_until([this] { return !state().is_writing; });
  EXPECT_EQ(state().strokes, 1);
  const auto& line = paper().model()[0].points;
  EXPECT_TRUE(is_inked(line[line.size() / 2]));
  EXPECT_FALSE(is_inked({0, -0.045})) << "the stroke before is on the old sheet";
}

TEST_F(SheetOfThePage, ATeacherStopsForTheKeyForThePenAndForANewSheet) {
  take_model("☃", 0);
  EXPECT_EQ(by(actions().watch), sentence("There is no model to be written. T: type a text."));
  take_model("十", 2);
  const auto watch = [this] {
    said_.clear();
    actions().watch->trigger();
    wait_until([this] { return all_said().contains(sentence("Watch: 2 strokes. V: stop.")); });
    wait_until([this] { return state().is_writing; });
  };
  watch();
  said_.clear();
  actions().watch->trigger();
  EXPECT_EQ(all_said(), sentence("Stopped."));
  wait_until([this] { return !state().is_writing; });
  const std::function<void()> others[] = {
      [this] {
        emit paper().pen_moved({.time_s = time_s_ += 1, .at = {0.04, 0.04}, .down = false});
      },
      [this] { actions().dip_in_water->trigger(); }, [this] { actions().new_sheet->trigger(); },
      [this] { emit panel().text_typed(sentence("十十")); }, [this] { page_->leave(); }};
  for (const auto& other : others) {
    watch();
    other();
    wait_until([this] { return !state().is_writing; });
    said_.clear();
    actions().watch->trigger();
    EXPECT_EQ(all_said(), QString()) << "it had stopped, so it begins again";
    actions().watch->trigger();
    EXPECT_EQ(all_said(), sentence("Stopped."));
    settle();
  }
}

TEST_F(SheetOfThePage, IsSavedByTheEndingOfItsFile) {
  EXPECT_TRUE(by_writing("none.svg").startsWith(sentence("Could not save none.svg: ")));
  EXPECT_EQ(kind_, Feedback::wrong);
  write();
  by(actions().dry);
  EXPECT_FALSE(state().is_saved);
  for (const char* name : {"one.png", "one.SVG", "one.pdf"}) {
    EXPECT_EQ(by_writing(name), sentence("Saved %1.").arg(sentence(name)));
    EXPECT_EQ(kind_, Feedback::good);
    EXPECT_EQ(page_->title(), QString()) << "a picture of it";
  }
  EXPECT_EQ(QImage(file("one.png")).size(), QSize(kCells, kCells));
  EXPECT_EQ(bytes("one.SVG").count("<path "), 1);
  EXPECT_TRUE(bytes("one.pdf").startsWith("%PDF-"));
  EXPECT_TRUE(bytes("one.pdf").contains("one"));
  EXPECT_FALSE(state().is_saved);
  int titles = 0;
  QObject::connect(page_.get(), &Page::title_changed, &window_, [&titles] { ++titles; });
  EXPECT_EQ(by_writing("one.nzs"), sentence("Saved one.nzs."));
  EXPECT_TRUE(state().is_saved);
  EXPECT_EQ(page_->title(), sentence("one.nzs"));
  EXPECT_EQ(titles, 1);
  by(actions().new_sheet);
  EXPECT_EQ(page_->title(), QString());
  EXPECT_EQ(titles, 2);
  for (const char* name : {"no/a.nzs", "no/a.png", "no/a.pdf"})
    EXPECT_TRUE(by_writing(name).startsWith(sentence("Could not save a.")));
}

TEST_F(SheetOfThePage, OpensAgainWithItsPaperAndInk) {
  emit panel().paper_chosen(sentence("board"));
  emit panel().ink_chosen(sentence("vermilion"));
  settle();
  write();
  by(actions().dry);
  by_writing("one.nzs");
  emit panel().paper_chosen(sentence("hanshi"));
  emit panel().ink_chosen(sentence("sumi"));
  settle();
  EXPECT_TRUE(page_->opens({sentence("a/b.nzs")}));
  EXPECT_TRUE(page_->opens({sentence("B.NZS")}));
  EXPECT_FALSE(page_->opens({sentence("a.nzs"), sentence("b.nzs")}));
  EXPECT_FALSE(page_->opens({sentence("a.png")}));
  EXPECT_FALSE(page_->opens({}));
  int wanted = 0, titles = 0;
  QObject::connect(page_.get(), &Page::wants_to_be_entered, &window_, [&wanted] { ++wanted; });
  QObject::connect(page_.get(), &Page::title_changed, &window_, [&titles] { ++titles; });
  said_.clear();
  page_->open_files({file("one.nzs")});
  settle();
  EXPECT_EQ(all_said(), sentence("Opened one.nzs."));
  EXPECT_EQ(kind_, Feedback::good);
  EXPECT_EQ(wanted, 0);
  EXPECT_EQ(titles, 1);
  EXPECT_EQ(page_->title(), sentence("one.nzs"));
  EXPECT_EQ(by(actions().new_sheet),
            sentence("New sheet: Board (hardly bleeds). Ctrl+Z brings the old one back."));
  page_->leave();
  said_.clear();
  page_->open_files({file("missing.nzs")});
  settle();
  EXPECT_EQ(wanted, 1);
  EXPECT_TRUE(all_said().startsWith(sentence("Could not open missing.nzs: "))) << all_said().toStdString();
  EXPECT_TRUE(all_said().endsWith(sentence(". The sheet was not changed.")));
  EXPECT_EQ(kind_, Feedback::wrong);
}

TEST_F(SheetOfThePage, IsOpenedAndSavedByDialogsThatKnowTheFolder) {
  take_model("一", 1);
  write();
  by(actions().dry);
  int saved = saves_, focused = focused_;
  choose_file({}, [](QFileDialog& dialog) {
    EXPECT_EQ(dialog.windowTitle(), sentence("Save as"));
    EXPECT_EQ(dialog.nameFilters(), QStringList{sentence("Sheet of paper (*.nzs)")});
    EXPECT_EQ(QFileInfo(dialog.selectedFiles().value(0)).fileName(), sentence("一.nzs"));
  });
  page_->ask_and_save();
  EXPECT_EQ(saves_, saved);
  EXPECT_EQ(focused_, focused + 1);
  said_.clear();
  choose_file(file("sheet"));
  page_->ask_and_save();
  settle();
  EXPECT_EQ(all_said(), sentence("Saved sheet.nzs."));
  EXPECT_EQ(saves_, saved + 1);
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
  choose_file(file("drawn"), [](QFileDialog& dialog) {
    EXPECT_EQ(dialog.nameFilters(), (QStringList{sentence("Picture (*.png)"), sentence("Strokes (*.svg)"),
                                                 sentence("Page at real size (*.pdf)")}));
    EXPECT_EQ(QFileInfo(dialog.selectedFiles().value(0)).fileName(), sentence("sheet.png"))
        << "the name of the sheet";
    dialog.selectNameFilter(sentence("Strokes (*.svg)"));
  });
  EXPECT_EQ(by(actions().save_png), sentence("Saved drawn.svg."));
  said_.clear();
  choose_file({}, [](QFileDialog& dialog) {
    EXPECT_EQ(dialog.windowTitle(), sentence("Open a sheet"));
    EXPECT_EQ(dialog.nameFilters(), QStringList{sentence("Sheet of paper (*.nzs)")});
  });
  page_->ask_and_open();
  settle();
  EXPECT_EQ(all_said(), QString());
  parts_.preferences().folder.clear();
  choose_file(file("sheet.nzs"));
  page_->ask_and_open();
  settle();
  EXPECT_EQ(all_said(), sentence("Opened sheet.nzs."));
  EXPECT_EQ(parts_.preferences().folder, folder_.path());
}

TEST_F(SheetOfThePage, IsAskedAboutBeforeTheWindowCloses) {
  EXPECT_TRUE(page_->may_close(true)) << "it is empty";
  write();
  answer("unsaved_sheet_box", "Go back");
  EXPECT_FALSE(page_->may_close(true));
  answer("unsaved_sheet_box", "Do not save");
  EXPECT_TRUE(page_->may_close(true));
  by(actions().dry);
  by_writing("one.nzs");
  EXPECT_TRUE(page_->may_close(true)) << "it is saved";
}

TEST_F(SheetOfThePage, TheWindowClosesWhenTheSheetIsSavedUnlessItOpensAgain) {
  const auto save_as = [this](const QString& path, bool quits) {
    write();
    window_.show();
    answer("unsaved_sheet_box", "Save…");
    choose_file(path);
    EXPECT_FALSE(page_->may_close(quits));
    settle();
    return window_.isVisible();
  };
  EXPECT_TRUE(save_as(file("one.nzs"), false));
  EXPECT_TRUE(save_as({}, true)) << "no file was chosen";
  by_writing("two.nzs");
  EXPECT_TRUE(window_.isVisible()) << "saved later";
  EXPECT_TRUE(save_as(file("no/three.nzs"), true)) << "it failed";
  by_writing("four.nzs");
  EXPECT_TRUE(window_.isVisible());
  EXPECT_FALSE(save_as(file("five.nzs"), true));
}

TEST_F(SheetOfThePage, IsCarvedAsATabletOfItsOwn) {
  std::optional<practice::OwnTablet> shown;
  parts_.workshop().loaded.connect([&shown](const practice::OwnTablet& own) { shown = own; });
  write();
  by(actions().carve);
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->name, "Brush sheet");
  EXPECT_FALSE(shown->has_strokes);
  EXPECT_EQ(shown->map_size, shown->tablet->height_map().size());
}

}  // namespace
}  // namespace nazori::ui
