// SPDX-License-Identifier: Apache-2.0
// What stands beside the tablet in the making: tool, strokes, details and parts, and what each sends.
#include "nazori/studio/workshop/workshop_panel.h"

#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSpinBox>
#include <QTest>

#include "in_english.h"
#include "nazori/studio/workshop/groove_curve.h"
#include "nazori/studio/workshop/parts_editor.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QString said(const char* text) { return QString::fromUtf8(text); }

class PanelOfTheWorkshop : public testing::Test {
 protected:
  PanelOfTheWorkshop() {
    test::speak_english();
    window_.resize(400, 900);
    panel_.resize(400, 900);
  }
  template <class T>
  T& find(const char* name) {
    return *panel_.findChild<T*>(QString::fromLatin1(name));
  }
  void activate() {
    window_.show();
    window_.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  }
  static author::CharacterEditor three_strokes() {
    author::OwnCharacter character;
    for (int i = 0; i < 3; ++i) {
      author::OwnStroke stroke;
      stroke.points = {
          {{10, 20.0 + 20 * i}, 3, 1}, {{50, 20.0 + 20 * i}, 2, 0.5}, {{90, 20.0 + 20 * i}, 3, 1}};
      character.strokes.push_back(stroke);
    }
    character.strokes[1].ending = kanji::StrokeEnding::hook;
    character.facts.name = "our sign";
    character.facts.readings = {"さん", "みつ"};
    character.facts.meanings = {"three", "third"};
    character.facts.radical = 1;
    character.facts.parts = {{"a", {0}}, {"b", {1, 2}}};
    character.facts.rights = {"CC0-1.0", "Aiko", "a picture"};
    return *author::CharacterEditor::create(character, 64);
  }
  /// Three strokes; the second is chosen, with its second point.
  void show_three() {
    author::Workbench bench(three_strokes());
    bench.select({1, 1, false});
    panel_.show_character(bench);
  }
  static QStringList rows(const QListWidget& list) {
    QStringList all;
    for (int i = 0; i < list.count(); ++i) all.append(list.item(i)->text());
    return all;
  }
  QWidget window_;
  WorkshopActions actions_{&window_};
  WorkshopPanel& panel_ = *new WorkshopPanel(actions_, &window_);
};

TEST_F(PanelOfTheWorkshop, TellsItsToolsByNameAndInTheirOrder) {
  EXPECT_EQ(panel_.objectName(), said("workshop_panel"));
  EXPECT_EQ(panel_.accessibleName(), said("Strokes and details"));
  EXPECT_EQ(panel_.frameShape(), QFrame::NoFrame);
  EXPECT_EQ(panel_.focusPolicy(), Qt::NoFocus);
  EXPECT_EQ(panel_.sizeHint(), QSize(19 * QFontInfo(panel_.font()).pixelSize(), 400));
  const auto& ending = find<QComboBox>("workshop_ending_box");
  QStringList names;
  for (int i = 0; i < ending.count(); ++i) {
    names.append(ending.itemText(i));
    EXPECT_EQ(ending.itemData(i).toInt(), i);
  }
  EXPECT_EQ(names, (QStringList{said("stop"), said("hook"), said("sweep")}));
  const auto& stamp = find<QComboBox>("workshop_stamp_box");
  names.clear();
  for (int i = 0; i < stamp.count(); ++i) names.append(stamp.itemText(i));
  EXPECT_EQ(names, (QStringList{said("Dot"), said("Ring"), said("Bar"), said("Cross"), said("Square"),
                                said("Triangle")}));
  QStringList headings;
  for (const auto* label : panel_.findChildren<QLabel*>())
    if (label->property("role").toString() == said("heading")) headings.append(label->text());
  EXPECT_EQ(headings,
            (QStringList{said("Tool"), said("Strokes"), said("Details"), said("Parts"), said("Check")}));
  EXPECT_EQ(find<QListWidget>("workshop_findings").minimumHeight(), 7 * QFontInfo(panel_.font()).pixelSize());
  EXPECT_EQ(find<QListWidget>("workshop_strokes_list").selectionMode(), QAbstractItemView::ExtendedSelection);
  EXPECT_EQ(find<QListWidget>("workshop_strokes_list").dragDropMode(), QAbstractItemView::InternalMove);
  for (const char* name : {"workshop_name", "workshop_readings", "workshop_meanings", "workshop_radical",
                           "workshop_author", "workshop_licence"})
    EXPECT_EQ(find<QLineEdit>(name).maxLength(), 200) << name;
  EXPECT_EQ(find<QLineEdit>("workshop_radical").placeholderText(), said("1 to 214, or a form"));
  EXPECT_EQ(find<QLineEdit>("workshop_licence").placeholderText(), said("CC-BY-4.0"));
}

TEST_F(PanelOfTheWorkshop, ShowsTheToolAndSendsWhatIsChosenOfIt) {
  author::BenchSettings settings;
  settings.tool = author::Tool::place;
  settings.width = 12.5;
  settings.depth = 0.35;
  settings.ending = kanji::StrokeEnding::taper;
  settings.stamp = author::StampShape::cross;
  std::vector<std::array<double, 4>> sent;
  QObject::connect(&panel_, &WorkshopPanel::tool_changed, &panel_,
                   [&](double width, double depth, int ending, int stamp) {
                     sent.push_back({width, depth, static_cast<double>(ending), static_cast<double>(stamp)});
                   });
  panel_.show_settings(settings);
  EXPECT_TRUE(sent.empty()) << "nobody chose";
  EXPECT_EQ(find<QDoubleSpinBox>("workshop_width").value(), 12.5);
  EXPECT_EQ(find<QSpinBox>("workshop_depth").value(), 35);
  auto& ending = find<QComboBox>("workshop_ending_box");
  auto& stamp = find<QComboBox>("workshop_stamp_box");
  EXPECT_EQ(ending.currentText(), said("sweep"));
  EXPECT_EQ(stamp.currentText(), said("Cross"));
  EXPECT_FALSE(ending.isHidden());
  EXPECT_TRUE(stamp.isHidden());
  find<QDoubleSpinBox>("workshop_width").setValue(3.5);
  find<QSpinBox>("workshop_depth").setValue(50);
  ending.setCurrentIndex(1);
  emit ending.activated(1);
  stamp.setCurrentIndex(0);
  emit stamp.activated(0);
  const double dot = static_cast<int>(author::StampShape::dot);
  const double cross = static_cast<int>(author::StampShape::cross);
  EXPECT_EQ(sent,
            (std::vector<std::array<double, 4>>{
                {3.5, 0.35, 2, cross}, {3.5, 0.5, 2, cross}, {3.5, 0.5, 1, cross}, {3.5, 0.5, 1, dot}}));
  settings.tool = author::Tool::stamp;
  panel_.show_settings(settings);
  EXPECT_TRUE(ending.isHidden());
  EXPECT_FALSE(stamp.isHidden());
  settings.tool = author::Tool::draw;
  panel_.show_settings(settings);
  EXPECT_TRUE(ending.isHidden());
  EXPECT_TRUE(stamp.isHidden());
}

TEST_F(PanelOfTheWorkshop, ShowsACharacterWithItsStrokesAndItsDetails) {
  author::Workbench shown(three_strokes());
  shown.select({1, 1, false});
  std::vector<std::size_t> chosen;
  QObject::connect(&panel_, &WorkshopPanel::stroke_chosen, &panel_,
                   [&](std::size_t stroke) { chosen.push_back(stroke); });
  panel_.show_character(shown);
  auto& strokes = find<QListWidget>("workshop_strokes_list");
  EXPECT_EQ(rows(strokes), (QStringList{said("1  stop"), said("2  hook"), said("3  stop")}));
  EXPECT_EQ(strokes.currentRow(), 1);
  EXPECT_TRUE(find<QLabel>("workshop_selection").text().startsWith(said("Stroke 2 of 3, hook, 3 points. ")));
  EXPECT_EQ(find<QLineEdit>("workshop_name").text(), said("our sign"));
  EXPECT_EQ(find<QLineEdit>("workshop_readings").text(), said("さん, みつ"));
  EXPECT_EQ(find<QLineEdit>("workshop_meanings").text(), said("three, third"));
  EXPECT_EQ(find<QLineEdit>("workshop_radical").text(), said("1 一"));
  EXPECT_EQ(find<QLineEdit>("workshop_author").text(), said("Aiko"));
  EXPECT_EQ(find<QLineEdit>("workshop_licence").text(), said("CC0-1.0"));
  EXPECT_EQ(find<QLabel>("workshop_source").text(), said("Source: a picture"));
  EXPECT_FALSE(find<QLabel>("workshop_source").isHidden());
  EXPECT_FALSE(find<QLineEdit>("workshop_author").isReadOnly());
  EXPECT_EQ(find<GrooveCurve>("workshop_width_curve").value(), 2);
  EXPECT_EQ(find<GrooveCurve>("workshop_depth_curve").value(), 0.5);
  EXPECT_TRUE(chosen.empty()) << "nobody chose";
  strokes.setCurrentRow(2);
  strokes.setCurrentRow(-1);
  strokes.setCurrentRow(0);
  EXPECT_EQ(chosen, (std::vector<std::size_t>{2, 0}));
  // The first stroke is chosen, then none.
  shown.select({0, {}, false});
  panel_.show_character(shown);
  EXPECT_EQ(strokes.currentRow(), 0);
  EXPECT_EQ(strokes.selectedItems().size(), 1);
  shown.select({});
  panel_.show_character(shown);
  EXPECT_TRUE(strokes.selectedItems().isEmpty());
  EXPECT_EQ(find<QLabel>("workshop_selection").text(), said("our sign: 3 strokes."));
  EXPECT_EQ(find<GrooveCurve>("workshop_width_curve").value_words(), said("No stroke is chosen."));
}

TEST_F(PanelOfTheWorkshop, FewerStrokesLeaveNoneOfThoseBefore) {
  show_three();
  author::OwnCharacter one;
  one.strokes.resize(1);
  one.strokes[0].points = {{{10, 20}, 3, 1}, {{90, 20}, 3, 1}};
  one.strokes[0].ending = kanji::StrokeEnding::taper;
  one.facts.rights = author::kanjivg_rights();
  panel_.show_character(author::Workbench(*author::CharacterEditor::create(one, 64)));
  EXPECT_EQ(rows(find<QListWidget>("workshop_strokes_list")), QStringList{said("1  sweep")});
  EXPECT_TRUE(rows(find<QListWidget>("workshop_parts")).isEmpty());
  EXPECT_TRUE(find<QLineEdit>("workshop_author").isReadOnly()) << "it keeps its authors";
  EXPECT_TRUE(find<QLineEdit>("workshop_licence").isReadOnly());
  EXPECT_EQ(find<QLabel>("workshop_source").text(), said("Source: KanjiVG"));
  panel_.show_character(author::Workbench(*author::CharacterEditor::create({}, 64)));
  EXPECT_EQ(find<QListWidget>("workshop_strokes_list").count(), 0);
  EXPECT_TRUE(find<QLabel>("workshop_source").isHidden());
  EXPECT_FALSE(find<QLineEdit>("workshop_author").isReadOnly());
}

TEST_F(PanelOfTheWorkshop, ADraggedStrokeIsSentWithWhereItWasAndWhereItCame) {
  show_three();
  auto& strokes = find<QListWidget>("workshop_strokes_list");
  std::vector<std::pair<std::size_t, std::size_t>> dragged;
  QObject::connect(&panel_, &WorkshopPanel::stroke_dragged, &panel_,
                   [&](std::size_t from, std::size_t to) { dragged.emplace_back(from, to); });
  auto* model = strokes.model();
  // Before row 3 of three: behind the last one.
  EXPECT_TRUE(model->moveRow({}, 0, {}, 3));
  EXPECT_TRUE(model->moveRow({}, 2, {}, 0));
  EXPECT_TRUE(model->moveRow({}, 0, {}, 2));
  EXPECT_EQ(dragged, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 2}, {2, 0}, {0, 1}}));
}

TEST_F(PanelOfTheWorkshop, DetailsAreSentAsTheyWereTypedWithoutSpacesAround) {
  show_three();
  std::vector<author::Facts> sent;
  QStringList refused;
  QObject::connect(&panel_, &WorkshopPanel::facts_typed, &panel_,
                   [&](const author::Facts& facts) { sent.push_back(facts); });
  QObject::connect(&panel_, &WorkshopPanel::text_refused, &panel_,
                   [&](const QString& sentence) { refused.append(sentence); });
  const auto type = [&](const char* field, const char* text) {
    find<QLineEdit>(field).setText(said(text));
    emit find<QLineEdit>(field).editingFinished();
  };
  type("workshop_name", "our sign");
  EXPECT_TRUE(sent.empty()) << "as it was";
  type("workshop_name", "  new   name ");
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent.back().name, "new name");
  EXPECT_EQ(sent.back().rights.author, "Aiko");
  type("workshop_readings", "さん、, みつ ,みっつ");
  EXPECT_EQ(sent.back().readings, (std::vector<std::string>{"さん", "みつ", "みっつ"}));
  type("workshop_meanings", " one thing , ");
  EXPECT_EQ(sent.back().meanings, std::vector<std::string>{"one thing"});
  type("workshop_author", " Ken ");
  EXPECT_EQ(sent.back().rights.author, "Ken");
  type("workshop_licence", " CC-BY-4.0 ");
  EXPECT_EQ(sent.back().rights.licence, "CC-BY-4.0");
  type("workshop_radical", "9");
  EXPECT_EQ(sent.back().radical, 9);
  EXPECT_EQ(find<QLineEdit>("workshop_radical").text(), said("9 人"));
  EXPECT_TRUE(refused.isEmpty());
  type("workshop_radical", "亻");
  EXPECT_EQ(refused, QStringList{said("“亻” is not a radical. Type its number, 1 to 214, or its form.")});
  EXPECT_EQ(find<QLineEdit>("workshop_radical").text(), said("1 一")) << "as the character has it";
  panel_.set_radicals([](const QString&) { return std::optional<int>(9); });
  type("workshop_radical", "亻");
  EXPECT_EQ(refused.size(), 1);
  EXPECT_EQ(sent.back().radical, 9);
}

TEST_F(PanelOfTheWorkshop, WhatIsBeingTypedIsNotReplaced) {
  activate();
  auto& name = find<QLineEdit>("workshop_name");
  panel_.focus_name();
  EXPECT_TRUE(name.hasFocus());
  name.setText(said("half typed"));
  show_three();
  EXPECT_EQ(name.text(), said("half typed"));
  EXPECT_EQ(find<QLineEdit>("workshop_meanings").text(), said("three, third"));
  EXPECT_EQ(find<QLineEdit>("workshop_meanings").cursorPosition(), 0);
  panel_.focus_name();
  EXPECT_EQ(name.selectedText(), said("half typed"));
  panel_.focus_curve();
  EXPECT_TRUE(find<GrooveCurve>("workshop_width_curve").hasFocus());
  show_three();
  EXPECT_EQ(name.text(), said("our sign"));
}

TEST_F(PanelOfTheWorkshop, AFindingThatIsClickedIsSent) {
  const std::vector<author::Finding> findings{{.kind = author::FindingKind::no_name},
                                              {.kind = author::FindingKind::too_shallow, .stroke = 2}};
  panel_.show_findings(findings, true);
  std::vector<author::Finding> chosen;
  QObject::connect(&panel_, &WorkshopPanel::finding_chosen, &panel_,
                   [&](const author::Finding& finding) { chosen.push_back(finding); });
  auto& list = find<QListWidget>("workshop_findings");
  EXPECT_TRUE(list.wordWrap());
  emit list.itemClicked(list.item(1));
  emit list.itemActivated(list.item(0));
  EXPECT_EQ(chosen, (std::vector<author::Finding>{findings[1], findings[0]}));
}

TEST_F(PanelOfTheWorkshop, CurvesSendWhatIsMovedInThem) {
  show_three();
  std::vector<std::tuple<std::size_t, double, bool>> widths, depths;
  std::vector<std::size_t> points;
  QStringList said_there;
  QObject::connect(
      &panel_, &WorkshopPanel::half_width_moved, &panel_,
      [&](std::size_t point, double value, bool goes_on) { widths.emplace_back(point, value, goes_on); });
  QObject::connect(
      &panel_, &WorkshopPanel::depth_moved, &panel_,
      [&](std::size_t point, double value, bool goes_on) { depths.emplace_back(point, value, goes_on); });
  QObject::connect(&panel_, &WorkshopPanel::point_chosen, &panel_,
                   [&](std::size_t point) { points.push_back(point); });
  QObject::connect(&panel_, &WorkshopPanel::curve_said, &panel_,
                   [&](const QString& sentence) { said_there.append(sentence); });
  auto& width = find<GrooveCurve>("workshop_width_curve");
  auto& depth = find<GrooveCurve>("workshop_depth_curve");
  emit width.value_moved(1, 2.5, true);
  emit depth.value_moved(2, 0.5, false);
  emit width.point_chosen(2);
  emit depth.point_chosen(1);
  emit width.said(said("w"));
  emit depth.said(said("d"));
  EXPECT_EQ(widths, (std::vector<std::tuple<std::size_t, double, bool>>{{1, 2.5, true}}));
  EXPECT_EQ(depths, (std::vector<std::tuple<std::size_t, double, bool>>{{2, 0.5, false}}));
  EXPECT_EQ(points, (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(said_there, (QStringList{said("w"), said("d")}));
}

/// The editor of parts, whose parts are kept as it sends them.
class EditorOfParts : public testing::Test {
 protected:
  EditorOfParts() {
    test::speak_english();
    window_.resize(300, 400);
    QObject::connect(&editor_, &PartsEditor::parts_typed, &editor_,
                     [this](const std::vector<author::OwnPart>& parts) {
                       ++sent_;
                       parts_ = parts;
                       if (keeps_) editor_.show_parts(parts_, 5);
                     });
    QObject::connect(&editor_, &PartsEditor::refused, &editor_,
                     [this](const QString& sentence) { refused_.append(sentence); });
    editor_.show_parts(parts_, 5);
  }
  QStringList rows() const {
    QStringList all;
    for (int i = 0; i < list_.count(); ++i) all.append(list_.item(i)->text());
    return all;
  }
  void type(QLineEdit& field, const char* text) {
    field.setText(said(text));
    emit field.editingFinished();
  }
  QWidget window_;
  WorkshopActions actions_{&window_};
  PartsEditor& editor_ = *new PartsEditor(actions_, &window_);
  QListWidget& list_ = *editor_.findChild<QListWidget*>();
  QLineEdit& name_ = *editor_.findChild<QLineEdit*>(QStringLiteral("workshop_part_name"));
  QLineEdit& strokes_ = *editor_.findChild<QLineEdit*>(QStringLiteral("workshop_part_strokes"));
  std::vector<author::OwnPart> parts_{{"a", {0, 1}}, {"b", {2}}};
  int sent_ = 0;
  bool keeps_ = true;
  QStringList refused_;
};

TEST_F(EditorOfParts, HasItsFieldsAndTheirHints) {
  EXPECT_EQ(editor_.objectName(), said("parts_editor"));
  EXPECT_EQ(list_.accessibleName(), said("Parts"));
  EXPECT_EQ(name_.accessibleName(), said("Name of the part"));
  EXPECT_EQ(strokes_.accessibleName(), said("Strokes of the part"));
  EXPECT_EQ(name_.placeholderText(), said("亻"));
  EXPECT_EQ(strokes_.placeholderText(), said("1, 2 or 1-3"));
  EXPECT_EQ(name_.maxLength(), 200);
  EXPECT_EQ(list_.height(), 6 * QFontInfo(editor_.font()).pixelSize());
  EXPECT_EQ(editor_.layout()->contentsMargins(), QMargins());
  EXPECT_FALSE(name_.isEnabled()) << "no part is chosen";
  EXPECT_FALSE(strokes_.isEnabled());
}

TEST_F(EditorOfParts, ShowsThePartThatIsChosen) {
  EXPECT_EQ(rows(), (QStringList{said("a: strokes 1, 2"), said("b: strokes 3")}));
  list_.setCurrentRow(0);
  EXPECT_TRUE(name_.isEnabled());
  EXPECT_EQ(name_.text(), said("a"));
  EXPECT_EQ(strokes_.text(), said("1, 2"));
  list_.setCurrentRow(1);
  EXPECT_EQ(name_.text(), said("b"));
  // The list becomes shorter: the last one is chosen, then none.
  editor_.show_parts({{"a", {0, 1, 2}}}, 5);
  EXPECT_EQ(rows(), QStringList{said("a: strokes 1-3")});
  EXPECT_EQ(list_.currentRow(), 0);
  EXPECT_EQ(name_.text(), said("a"));
  editor_.show_parts({}, 5);
  EXPECT_TRUE(rows().isEmpty());
  EXPECT_FALSE(name_.isEnabled());
  EXPECT_EQ(name_.text(), QString());
  EXPECT_EQ(sent_, 0);
}

TEST_F(EditorOfParts, SendsWhatWasTypedIntoTheChosenPart) {
  type(name_, "x");
  EXPECT_EQ(sent_, 0) << "none is chosen";
  list_.setCurrentRow(1);
  type(name_, "  new  name ");
  EXPECT_EQ(parts_, (std::vector<author::OwnPart>{{"a", {0, 1}}, {"new name", {2}}}));
  type(strokes_, "5,3,4");
  EXPECT_EQ(parts_[1].strokes, (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(strokes_.text(), said("3-5"));
  EXPECT_EQ(sent_, 2);
  type(strokes_, "3 4 5");
  EXPECT_EQ(sent_, 2) << "the same strokes";
  EXPECT_EQ(strokes_.text(), said("3-5"));
  type(strokes_, "6");
  EXPECT_EQ(refused_, QStringList{said("“6” does not name strokes. Type numbers from 1 to 5: 1, 2 or 1-3.")});
  EXPECT_EQ(strokes_.text(), said("3-5"));
  EXPECT_EQ(sent_, 2);
  editor_.show_parts(parts_, 0);
  type(strokes_, "6");
  EXPECT_EQ(refused_.back(), said("There are no strokes yet."));
}

TEST_F(EditorOfParts, AddsAPartOfTheGivenStrokesOrOfThoseThatAreInNone) {
  window_.show();
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_));
  editor_.add({1, 4});
  EXPECT_EQ(parts_.back(), (author::OwnPart{"", {1, 4}}));
  EXPECT_EQ(list_.currentRow(), 2);
  EXPECT_TRUE(name_.hasFocus());
  editor_.add({});
  EXPECT_EQ(parts_.back(), (author::OwnPart{"", {3}})) << "1, 2, 3 and 5 are in parts";
  EXPECT_EQ(list_.currentRow(), 3);
  list_.setFocus();
  list_.setCurrentRow(0);
  keeps_ = false;
  editor_.add({0});
  EXPECT_EQ(list_.currentRow(), 0) << "the page refused it";
  EXPECT_TRUE(list_.hasFocus());
}

TEST_F(EditorOfParts, RemovesTheChosenOne) {
  EXPECT_FALSE(editor_.remove());
  EXPECT_EQ(sent_, 0);
  list_.setCurrentRow(0);
  EXPECT_TRUE(editor_.remove());
  EXPECT_EQ(parts_, (std::vector<author::OwnPart>{{"b", {2}}}));
  EXPECT_EQ(name_.text(), said("b")) << "the next one is chosen";
}

}  // namespace
}  // namespace nazori::ui
