// SPDX-License-Identifier: Apache-2.0
// The choices beside the paper and beside a worksheet: what they offer, show and send.
#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <set>

#include "in_english.h"
#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_words.h"
#include "nazori/studio/brush/tools_panel.h"
#include "nazori/studio/print/worksheet_options.h"
#include "nazori/widgets/controls/list_choice.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QString said(const char* text) { return QString::fromUtf8(text); }

class ToolsOfTheBrush : public testing::Test {
 protected:
  ToolsOfTheBrush() {
    test::speak_english();
    window_.resize(400, 900);
    panel_.resize(400, 900);
  }
  template <class T = QLabel>
  T& find(const char* name) {
    return *panel_.findChild<T*>(QString::fromLatin1(name));
  }
  QStringList entries(const char* name) {
    QStringList all;
    for (int i = 0; i < find<QComboBox>(name).count(); ++i) all.append(find<QComboBox>(name).itemText(i));
    return all;
  }
  /// Chooses an entry as a hand does.
  void choose(const char* name, int row) {
    auto& box = find<QComboBox>(name);
    box.setCurrentIndex(row);
    emit box.activated(row);
  }
  QWidget window_;
  BrushActions actions_{&window_};
  BrushToolsPanel& panel_ = *new BrushToolsPanel(actions_, &window_);
};

TEST_F(ToolsOfTheBrush, OffersEachChoiceByItsName) {
  EXPECT_EQ(panel_.objectName(), said("brush_tools_panel"));
  EXPECT_EQ(panel_.accessibleName(), said("Brush, paper and model"));
  EXPECT_EQ(panel_.frameShape(), QFrame::NoFrame);
  EXPECT_EQ(panel_.focusPolicy(), Qt::NoFocus);
  EXPECT_EQ(panel_.sizeHint(), QSize(19 * QFontInfo(panel_.font()).pixelSize(), 400));
  EXPECT_EQ(entries("brush_ink_box"),
            (QStringList{said("Sumi, black"), said("Sumi, bluish"), said("Sumi, brownish"), said("Vermilion"),
                         said("Water only")}));
  EXPECT_EQ(entries("brush_size_box"),
            (QStringList{said("Large"), said("Medium"), said("Small"), said("Fine")}));
  EXPECT_EQ(entries("brush_hair_box"),
            (QStringList{said("Goat (soft)"), said("Mixed"), said("Weasel (stiff)")}));
  EXPECT_EQ(entries("brush_paper_box"),
            (QStringList{said("Hanshi (practice paper)"), said("Gasenshi (bleeds fast)"),
                         said("Gasenshi (bleeds slowly)"), said("Board (hardly bleeds)"),
                         said("Water paper (fades as it dries)")}));
  EXPECT_EQ(entries("brush_ruling_box"),
            (QStringList{said("No ruling"), said("1 characters"), said("2 characters"), said("4 characters"),
                         said("6 characters")}));
  EXPECT_EQ(entries("brush_model_box"), (QStringList{said("None"), said("Beneath"), said("Beside")}));
  EXPECT_EQ(entries("brush_font_box"), QStringList{said("Printed lines")});
  for (const char* name : {"brush_ink_box", "brush_size_box", "brush_hair_box", "brush_paper_box",
                           "brush_ruling_box", "brush_model_box", "brush_font_box"})
    EXPECT_EQ(find<QComboBox>(name).minimumContentsLength(), 9) << name;
  EXPECT_EQ(find<QLineEdit>("brush_text").placeholderText(), said("Current character"));
  EXPECT_EQ(find<QLineEdit>("brush_text").maxLength(), 200);
  QStringList headings;
  for (const auto* label : panel_.findChildren<QLabel*>())
    if (label->property("role").toString() == said("heading")) headings.append(label->text());
  EXPECT_EQ(headings,
            (QStringList{said("Advice (not a mark)"), said("Brush"), said("Paper"), said("Model")}));
}

TEST_F(ToolsOfTheBrush, SendsWhatIsChosen) {
  QSignalSpy ink(&panel_, &BrushToolsPanel::ink_chosen), paper(&panel_, &BrushToolsPanel::paper_chosen),
      ruling(&panel_, &BrushToolsPanel::ruling_chosen), font(&panel_, &BrushToolsPanel::font_chosen),
      typed(&panel_, &BrushToolsPanel::text_typed), entered(&panel_, &BrushToolsPanel::text_entered);
  std::vector<calligraphy::BrushSize> sizes;
  std::vector<brush::Hair> hairs;
  std::vector<ModelPlace> places;
  QObject::connect(&panel_, &BrushToolsPanel::size_chosen, &panel_, [&](auto one) { sizes.push_back(one); });
  QObject::connect(&panel_, &BrushToolsPanel::hair_chosen, &panel_, [&](auto one) { hairs.push_back(one); });
  QObject::connect(&panel_, &BrushToolsPanel::place_chosen, &panel_,
                   [&](auto one) { places.push_back(one); });
  choose("brush_ink_box", 2);
  choose("brush_paper_box", 4);
  choose("brush_ruling_box", 3);
  choose("brush_size_box", 3);
  choose("brush_hair_box", 2);
  choose("brush_model_box", 2);
  panel_.show_fonts({{"Aoyagi", "fonts-aoyagi"}, {"Kouzan", "fonts-kouzan"}}, said("Install more."));
  EXPECT_EQ(entries("brush_font_box"), (QStringList{said("Printed lines"), said("Aoyagi"), said("Kouzan")}));
  EXPECT_EQ(find("brush_font_hint").text(), said("Install more."));
  EXPECT_FALSE(find("brush_font_hint").isHidden());
  EXPECT_EQ(font.count(), 0);
  choose("brush_font_box", 2);
  emit find<QLineEdit>("brush_text").textEdited(said("休日"));
  emit find<QLineEdit>("brush_text").returnPressed();
  EXPECT_EQ(ink.value(0).value(0).toString(), said("sumi-brown"));
  EXPECT_EQ(paper.value(0).value(0).toString(), said("water"));
  EXPECT_EQ(ruling.value(0).value(0).toInt(), 4);
  EXPECT_EQ(font.value(0).value(0).toString(), said("Kouzan"));
  EXPECT_EQ(typed.value(0).value(0).toString(), said("休日"));
  EXPECT_EQ(entered.count(), 1);
  EXPECT_EQ(sizes, std::vector{calligraphy::BrushSize::fine});
  EXPECT_EQ(hairs, std::vector{brush::Hair::weasel});
  EXPECT_EQ(places, std::vector{ModelPlace::beside});
  panel_.show_fonts({}, {});
  EXPECT_TRUE(find("brush_font_hint").isHidden());
  EXPECT_EQ(entries("brush_font_box"), QStringList{said("Printed lines")});
}

TEST_F(ToolsOfTheBrush, ShowsTheBrushAndTheSheetAsTheyAre) {
  calligraphy::SheetState state;
  state.strokes = 3;
  state.is_wet = true;
  state.paper = "board";
  state.ink = "vermilion";
  state.brush = {calligraphy::BrushSize::small, brush::Hair::goat};
  state.fullness = 0.5;
  state.strength = 0.25;
  panel_.show_state(state);
  EXPECT_EQ(find("brush_words").text(), said("Brush: 50% full, ink 25%."));
  EXPECT_EQ(find("paper_words").text(), said("3 strokes, wet."));
  EXPECT_EQ(find<QWidget>("ink_gauge").accessibleDescription(), said("Brush: 50% full, ink 25%."));
  EXPECT_EQ(find<QWidget>("ink_gauge").accessibleName(), said("Ink in the brush"));
  EXPECT_EQ(find<QWidget>("ink_gauge").sizePolicy(), QSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed));
  EXPECT_EQ(find<QComboBox>("brush_paper_box").currentText(), said("Board (hardly bleeds)"));
  EXPECT_EQ(find<QComboBox>("brush_ink_box").currentText(), said("Vermilion"));
  EXPECT_EQ(find<QComboBox>("brush_size_box").currentText(), said("Small"));
  EXPECT_EQ(find<QComboBox>("brush_hair_box").currentText(), said("Goat (soft)"));
  panel_.show_ruling(2);
  EXPECT_EQ(find<QComboBox>("brush_ruling_box").currentText(), said("2 characters"));
  panel_.show_place(ModelPlace::beneath);
  EXPECT_EQ(find<QComboBox>("brush_model_box").currentText(), said("Beneath"));
  panel_.show_fonts({{"Aoyagi", "fonts-aoyagi"}}, {});
  panel_.show_font(said("Aoyagi"));
  EXPECT_EQ(find<QComboBox>("brush_font_box").currentText(), said("Aoyagi"));
  panel_.show_font({});
  EXPECT_EQ(find<QComboBox>("brush_font_box").currentText(), said("Printed lines"));
  panel_.show_text(said("休"));
  EXPECT_EQ(find<QLineEdit>("brush_text").text(), said("休"));
  panel_.show_model_words(said("Model: 休"));
  EXPECT_EQ(find("model_words").text(), said("Model: 休"));
  EXPECT_FALSE(find("model_words").isHidden());
  panel_.show_model_words({});
  EXPECT_TRUE(find("model_words").isHidden());
}

TEST_F(ToolsOfTheBrush, AdviceStandsAtTheTopOrNotAtAll) {
  auto& words = find("brush_advice_words");
  const QLabel* heading = nullptr;
  for (const auto* label : panel_.findChildren<QLabel*>())
    if (label->text() == said("Advice (not a mark)")) heading = label;
  ASSERT_NE(heading, nullptr);
  EXPECT_TRUE(words.isHidden());
  EXPECT_TRUE(heading->isHidden());
  panel_.show_advice({said("One."), said("Two.")});
  EXPECT_EQ(words.text(), said("One.\nTwo."));
  EXPECT_FALSE(words.isHidden());
  EXPECT_FALSE(heading->isHidden());
  panel_.show_advice({});
  EXPECT_TRUE(words.isHidden());
  EXPECT_TRUE(heading->isHidden());
}

TEST_F(ToolsOfTheBrush, SwitchesAreTheActionsAndWhatIsNotFreeCannotBeChosen) {
  for (auto* action : {actions_.guess_pressure, actions_.left_hand, actions_.show_brush}) {
    auto* box = panel_.findChild<QCheckBox*>(said("box_") + action->objectName());
    ASSERT_NE(box, nullptr);
    EXPECT_EQ(box->text(), action->iconText());
    EXPECT_EQ(box->toolTip(), action->toolTip());
    const bool before = action->isChecked();
    EXPECT_EQ(box->isChecked(), before);
    box->click();
    EXPECT_EQ(action->isChecked(), !before);
    action->setChecked(before);
    EXPECT_EQ(box->isChecked(), before);
  }
  panel_.set_model_free(false);
  EXPECT_FALSE(find<QComboBox>("brush_ruling_box").isEnabled());
  EXPECT_FALSE(find<QLineEdit>("brush_text").isEnabled());
  EXPECT_TRUE(find<QComboBox>("brush_paper_box").isEnabled());
  panel_.set_model_free(true);
  EXPECT_TRUE(find<QComboBox>("brush_ruling_box").isEnabled());
  EXPECT_TRUE(find<QLineEdit>("brush_text").isEnabled());
  window_.show();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  panel_.show_text(said("休日"));
  panel_.focus_text();
  EXPECT_TRUE(find<QLineEdit>("brush_text").hasFocus());
  EXPECT_EQ(find<QLineEdit>("brush_text").selectedText(), said("休日"));
}

class OptionsOfAWorksheet : public testing::Test {
 protected:
  OptionsOfAWorksheet() {
    test::speak_english();
    EXPECT_TRUE(store_.save_list({"few", {U'休'}}));
    options_ = std::make_unique<WorksheetOptions>(store_, U'休', nullptr);
  }
  template <class T>
  T& find(const char* name) {
    return *options_->findChild<T*>(QString::fromLatin1(name));
  }
  QStringList entries(const char* name) {
    QStringList all;
    for (int i = 0; i < find<QComboBox>(name).count(); ++i) all.append(find<QComboBox>(name).itemText(i));
    return all;
  }
  /// The options that are shown, without the part of their names that all have.
  std::set<std::string> shown() {
    std::set<std::string> names;
    for (const auto* widget : options_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      if (widget->objectName().startsWith(said("worksheet_")) && !widget->isHidden())
        names.insert(widget->objectName().mid(10).toStdString());
    return names;
  }
  QTemporaryDir folder_;
  study::LearnerStore store_ = *study::LearnerStore::open(
      std::filesystem::path(folder_.path().toStdString()) / "learner" / "learner.db", study::Access::write,
      [] { return *study::parse_time("2026-03-02T10:00Z"); });
  std::unique_ptr<WorksheetOptions> options_;
};

TEST_F(OptionsOfAWorksheet, OfferWhatASheetCanBe) {
  EXPECT_EQ(entries("worksheet_source"),
            (QStringList{said("The character shown: 休"), said("A list"), said("Today's reviews"),
                         said("Difficult characters"), said("From a text")}));
  EXPECT_EQ(entries("worksheet_layout"),
            (QStringList{said("Practice sheet"), said("Quiz"), said("Flash cards"), said("Manuscript paper"),
                         said("Brush sheet")}));
  EXPECT_EQ(entries("worksheet_paper"),
            (QStringList{said("A4"), said("B5"), said("Letter"), said("Hanshi")}));
  EXPECT_EQ(entries("worksheet_guide"),
            (QStringList{said("None"), said("Cross 十"), said("Four fields 田"), said("Eight parts 米")}));
  EXPECT_EQ(entries("worksheet_per_sheet"), (QStringList{said("1"), said("2"), said("4"), said("6")}));
  EXPECT_EQ(entries("worksheet_language"), (QStringList{said("English"), said("Japanese")}));
  EXPECT_EQ(find<QSpinBox>("worksheet_cell").minimum(), 8);
  EXPECT_EQ(find<QSpinBox>("worksheet_cell").maximum(), 60);
  EXPECT_EQ(find<QSpinBox>("worksheet_cell").suffix(), said(" mm"));
  for (const char* name : {"worksheet_rows", "worksheet_copies"}) {
    EXPECT_EQ(find<QSpinBox>(name).minimum(), 0);
    EXPECT_EQ(find<QSpinBox>(name).maximum(), 40);
    EXPECT_EQ(find<QSpinBox>(name).suffix(), QString());
  }
  EXPECT_EQ(find<QLineEdit>("worksheet_title").maxLength(), 60);
  EXPECT_TRUE(find<QPlainTextEdit>("worksheet_text").tabChangesFocus());
  EXPECT_EQ(find<QPlainTextEdit>("worksheet_text").placeholderText(), said("Paste a text here"));
  EXPECT_EQ(find<QPlainTextEdit>("worksheet_text").height(), 6 * QFontInfo(options_->font()).pixelSize());
  EXPECT_EQ(find<QComboBox>("worksheet_layout").minimumContentsLength(), 12);
  EXPECT_GE(find<ListChoice>("worksheet_list").findData(said("list:few")), 1);
  EXPECT_EQ(options_->layout()->contentsMargins(), QMargins(0, 0, 8, 0));
  EXPECT_EQ(options_->layout()->spacing(), 8);
  const WorksheetOptions without(store_, 0, nullptr);
  EXPECT_EQ(without.findChild<QComboBox*>(said("worksheet_source"))->count(), 4);
}

TEST_F(OptionsOfAWorksheet, EachChoiceIsShownAndReadBack) {
  practice::WorksheetChoice first;
  first.source = practice::WorksheetSource::list;
  first.shown = U'休';
  first.list = "list:few";
  first.text = "a text";
  first.sheet.layout = print::Layout::quiz;
  first.sheet.paper = print::Paper::letter;
  first.sheet.guide = print::Guide::field;
  first.sheet.language = print::Language::japanese;
  first.sheet.cell_mm = 21;
  first.sheet.rows = 7;
  first.sheet.copies = 3;
  first.sheet.per_sheet = 6;
  first.sheet.title = "Title";
  // Each switch alone.
  using Flag = bool print::SheetSettings::*;
  const Flag flags[] = {
      &print::SheetSettings::whole_page, &print::SheetSettings::vertical, &print::SheetSettings::steps,
      &print::SheetSettings::numbers,    &print::SheetSettings::arrows,   &print::SheetSettings::facts,
      &print::SheetSettings::answers,    &print::SheetSettings::booklet,  &print::SheetSettings::name_line};
  QSignalSpy changed(options_.get(), &WorksheetOptions::changed);
  for (const Flag on : flags) {
    for (const Flag flag : flags) first.sheet.*flag = flag == on;
    options_->set_choice(first);
    EXPECT_EQ(options_->choice(), first);
  }
  EXPECT_EQ(changed.count(), 0) << "nobody changed anything";
  practice::WorksheetChoice second = first;
  second.source = practice::WorksheetSource::text;
  second.list = "grade-2";
  second.text = "another";
  second.sheet.layout = print::Layout::brush;
  second.sheet.paper = print::Paper::hanshi;
  second.sheet.guide = print::Guide::none;
  second.sheet.language = print::Language::english;
  second.sheet.cell_mm = 8;
  second.sheet.rows = 1;
  second.sheet.copies = 0;
  second.sheet.per_sheet = 2;
  second.sheet.title = "";
  options_->set_choice(second);
  EXPECT_EQ(options_->choice(), second);
  second.sheet.cell_mm = 14.6;
  options_->set_choice(second);
  EXPECT_EQ(options_->choice().sheet.cell_mm, 15) << "whole millimetres";
  find<QLineEdit>("worksheet_title").setText(said("  T "));
  EXPECT_EQ(options_->choice().sheet.title, "T");
}

TEST_F(OptionsOfAWorksheet, OnlyPagesWithCellsAreFolded) {
  practice::WorksheetChoice choice;
  choice.sheet.booklet = true;
  for (const auto& [layout, folds] :
       {std::pair(print::Layout::practice, true), std::pair(print::Layout::quiz, true),
        std::pair(print::Layout::cards, false), std::pair(print::Layout::manuscript, false),
        std::pair(print::Layout::brush, false)}) {
    choice.sheet.layout = layout;
    options_->set_choice(choice);
    EXPECT_EQ(options_->choice().sheet.booklet, folds);
  }
}

TEST_F(OptionsOfAWorksheet, WithoutAShownCharacterTheListTakesItsPlace) {
  const auto without = std::make_unique<WorksheetOptions>(store_, 0, nullptr);
  practice::WorksheetChoice choice;
  choice.source = practice::WorksheetSource::shown;
  without->set_choice(choice);
  EXPECT_EQ(without->choice().source, practice::WorksheetSource::list);
  options_->set_choice(choice);
  EXPECT_EQ(options_->choice().source, practice::WorksheetSource::shown);
  EXPECT_EQ(options_->choice().shown, U'休');
}

TEST_F(OptionsOfAWorksheet, OnlyThoseThatHaveAnEffectAreShown) {
  practice::WorksheetChoice choice;
  const auto with = [&](print::Layout layout, practice::WorksheetSource source) {
    choice.sheet.layout = layout;
    choice.source = source;
    options_->set_choice(choice);
    return shown();
  };
  using Names = std::set<std::string>;
  using Source = practice::WorksheetSource;
  EXPECT_EQ(with(print::Layout::practice, Source::shown),
            (Names{"source", "layout", "paper", "cell", "guide", "whole_page", "rows", "copies", "steps",
                   "numbers", "arrows", "facts", "vertical", "booklet", "name_line", "title", "language"}));
  EXPECT_EQ(with(print::Layout::quiz, Source::list),
            (Names{"source", "list", "layout", "paper", "cell", "guide", "answers", "vertical", "booklet",
                   "name_line", "title", "language"}));
  EXPECT_EQ(with(print::Layout::cards, Source::text),
            (Names{"source", "text", "layout", "paper", "numbers", "language"}));
  EXPECT_EQ(with(print::Layout::manuscript, Source::list), (Names{"text", "layout", "paper", "language"}));
  EXPECT_EQ(with(print::Layout::brush, Source::due),
            (Names{"source", "layout", "paper", "guide", "per_sheet", "rows", "copies", "numbers", "arrows",
                   "name_line", "language"}));
  choice.sheet.whole_page = true;
  const Names whole = with(print::Layout::practice, Source::shown);
  EXPECT_FALSE(whole.contains("rows")) << "the page is full of them";
  EXPECT_TRUE(with(print::Layout::brush, Source::shown).contains("rows"));
}

TEST_F(OptionsOfAWorksheet, RowsAndCopiesAreSheetsWhereABrushWrites) {
  practice::WorksheetChoice choice;
  const auto names = [&](print::Layout layout) {
    choice.sheet.layout = layout;
    options_->set_choice(choice);
    const auto* form = qobject_cast<QFormLayout*>(options_->layout());
    QStringList all;
    for (const char* field : {"worksheet_rows", "worksheet_copies"}) {
      all.append(qobject_cast<QLabel*>(form->labelForField(&find<QSpinBox>(field)))->text());
      all.append(find<QSpinBox>(field).accessibleName());
    }
    return all;
  };
  EXPECT_EQ(names(print::Layout::brush),
            (QStringList{said("Sheets o&f the same characters"), said("Sheets of the same characters"),
                         said("Sheets to &trace, fading"), said("Sheets to trace, fading")}));
  EXPECT_EQ(names(print::Layout::practice),
            (QStringList{said("&Rows per character"), said("Rows per character"),
                         said("Cells to &trace, fading"), said("Cells to trace, fading")}));
}

TEST_F(OptionsOfAWorksheet, EachOneTellsThatItChanged) {
  options_->set_choice({});
  QSignalSpy changed(options_.get(), &WorksheetOptions::changed);
  int expected = 0;
  for (auto* box : options_->findChildren<QComboBox*>()) {
    const int row = box->currentIndex() == 0 ? 1 : 0;
    box->setCurrentIndex(row);
    EXPECT_GE(changed.count(), ++expected) << box->objectName().toStdString();
    expected = static_cast<int>(changed.count());
  }
  for (auto* check : options_->findChildren<QCheckBox*>()) {
    check->toggle();
    EXPECT_EQ(changed.count(), ++expected) << check->objectName().toStdString();
  }
  for (auto* spin : options_->findChildren<QSpinBox*>()) {
    spin->setValue(spin->value() + 1);
    EXPECT_EQ(changed.count(), ++expected) << spin->objectName().toStdString();
  }
  find<QLineEdit>("worksheet_title").setText(said("T"));
  EXPECT_EQ(changed.count(), ++expected);
  find<QPlainTextEdit>("worksheet_text").setPlainText(said("T"));
  EXPECT_EQ(changed.count(), ++expected);
}

}  // namespace
}  // namespace nazori::ui
