// SPDX-License-Identifier: Apache-2.0
// What is said about a character in the making, its numbers, its grooves along their lines, and plots.
#include <QDialog>
#include <QLineEdit>
#include <QListWidget>
#include <set>

#include "nazori/author/character_file.h"
#include "nazori/author/stroke_edits.h"
#include "nazori/studio/workshop/groove_curve.h"
#include "nazori/studio/workshop/part_words.h"
#include "workshop_window.h"

namespace nazori::ui {
namespace {

class WorkshopDetails : public WorkshopWindow {
 protected:
  void draw_three() {
    for (const double y : {30.0, 50.0, 70.0}) drag({20, y}, {90, y});
    ASSERT_EQ(character().strokes.size(), 3U);
  }
  void type(const char* field, const QString& text) {
    auto* line = find<QLineEdit>(field);
    line->setFocus();
    line->selectAll();
    // QTest has keys for Latin letters only.
    line->insert(text);
    QTest::keyClick(line, Qt::Key_Return);
  }
  QString shown(const char* field) { return find<QLineEdit>(field)->text(); }
  QStringList part_rows() {
    QStringList rows;
    const auto* list = find<QListWidget>("workshop_parts");
    for (int i = 0; i < list->count(); ++i) rows.append(list->item(i)->text());
    return rows;
  }
  const std::vector<author::OwnPart>& parts() { return character().facts.parts; }
  std::optional<int> radical() { return character().facts.radical; }
  GrooveCurve* curve(const char* name) { return find<GrooveCurve>(name); }
  /// Where the point is drawn just before the button is released.
  QPointF drag_curve(GrooveCurve* on, std::size_t point, double by_px, int moves = 5) {
    const QPointF from = on->place_of(point);
    const auto mouse = [on](QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held) {
      QMouseEvent event(type, at, on->mapToGlobal(at), button, held, {});
      QCoreApplication::sendEvent(on, &event);
    };
    mouse(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    for (int i = 1; i <= moves; ++i)
      mouse(QEvent::MouseMove, from + QPointF(0, by_px * i / moves), Qt::NoButton, Qt::LeftButton);
    const QPointF held_at = on->place_of(point);
    mouse(QEvent::MouseButtonRelease, from + QPointF(0, by_px), Qt::LeftButton, Qt::NoButton);
    return held_at;
  }
  /// Works with the dialog for a plot, once it is open.
  void in_plot_dialog(const std::function<void(QDialog&)>& work) {
    QTimer::singleShot(0, window_.get(), [work] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      ASSERT_EQ(dialog->objectName(), QStringLiteral("plot_dialog"));
      work(*dialog);
    });
    press(Qt::Key_Y);
  }
};

TEST_F(WorkshopDetails, APartIsMadeOfTheStrokesThatAreChosenAndGetsAName) {
  draw_three();
  auto* strokes = find<QListWidget>("workshop_strokes_list");
  strokes->setCurrentRow(0);
  strokes->item(1)->setSelected(true);
  press(Qt::Key_G);
  ASSERT_EQ(parts().size(), 1U);
  EXPECT_EQ(parts()[0].strokes, (std::vector<int>{0, 1}));
  EXPECT_EQ(part_rows(), QStringList{QStringLiteral("No name yet: strokes 1, 2")});
  EXPECT_TRUE(find("workshop_part_name")->hasFocus());
  type("workshop_part_name", QStringLiteral("亻"));
  EXPECT_EQ(parts()[0].name, "亻");
  EXPECT_EQ(part_rows(), QStringList{QStringLiteral("亻: strokes 1, 2")});
  EXPECT_EQ(feedback(), QStringLiteral("Details changed."));
  canvas()->setFocus();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(parts()[0].name, "") << "the name is one change";
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(parts().empty()) << "the part is one change";
  EXPECT_TRUE(part_rows().isEmpty());
  EXPECT_FALSE(find("workshop_part_name")->isEnabled());
}

TEST_F(WorkshopDetails, WithoutAChosenStrokeAPartGetsTheStrokesOfNoPart) {
  draw_three();
  find<QListWidget>("workshop_strokes_list")->setCurrentRow(1, QItemSelectionModel::ClearAndSelect);
  press(Qt::Key_G);
  canvas()->setFocus();
  press(Qt::Key_3);
  click({5, 105});
  ASSERT_FALSE(workshop->bench().selection().stroke);
  press(Qt::Key_G);
  ASSERT_EQ(parts().size(), 2U);
  EXPECT_EQ(parts()[1].strokes, (std::vector<int>{0, 2}));
}

TEST_F(WorkshopDetails, TheStrokesOfAPartAreTypedAndErrorsChangeNothing) {
  draw_three();
  press(Qt::Key_G);
  type("workshop_part_strokes", QStringLiteral("3, 1-2"));
  EXPECT_EQ(parts()[0].strokes, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(shown("workshop_part_strokes"), QStringLiteral("1-3"));
  type("workshop_part_strokes", QStringLiteral("１、３"));
  EXPECT_EQ(parts()[0].strokes, (std::vector<int>{0, 2})) << "as a Japanese keyboard writes it";
  for (const auto* wrong : {"4", "0", "x", "2-1"}) {
    type("workshop_part_strokes", QString::fromLatin1(wrong));
    EXPECT_EQ(feedback(), QStringLiteral("“%1” does not name strokes. Type numbers from 1 to 3: 1, 2 or 1-3.")
                              .arg(QString::fromLatin1(wrong)));
    EXPECT_EQ(shown("workshop_part_strokes"), QStringLiteral("1, 3"));
    EXPECT_EQ(parts()[0].strokes, (std::vector<int>{0, 2}));
  }
  type("workshop_part_strokes", QString());
  EXPECT_TRUE(parts()[0].strokes.empty());
  EXPECT_EQ(part_rows(), QStringList{QStringLiteral("No name yet: no strokes")});
}

TEST_F(WorkshopDetails, APartThatIsChosenIsChangedOrRemoved) {
  draw_three();
  auto* strokes = find<QListWidget>("workshop_strokes_list");
  auto* list = find<QListWidget>("workshop_parts");
  for (int i = 0; i < 2; ++i) {
    strokes->setFocus();
    strokes->setCurrentRow(i, QItemSelectionModel::ClearAndSelect);
    press(Qt::Key_G);
    type("workshop_part_name", QString(QLatin1Char(static_cast<char>('a' + i))));
  }
  EXPECT_EQ(part_rows(), (QStringList{QStringLiteral("a: stroke 1"), QStringLiteral("b: stroke 2")}));
  list->setCurrentRow(0);
  EXPECT_EQ(shown("workshop_part_name"), QStringLiteral("a"));
  EXPECT_EQ(shown("workshop_part_strokes"), QStringLiteral("1"));
  list->setFocus();
  press(Qt::Key_G, Qt::ShiftModifier);
  EXPECT_EQ(part_rows(), QStringList{QStringLiteral("b: stroke 2")});
  EXPECT_EQ(shown("workshop_part_name"), QStringLiteral("b")) << "the next one is chosen";
  press(Qt::Key_G, Qt::ShiftModifier);
  press(Qt::Key_G, Qt::ShiftModifier);
  EXPECT_TRUE(parts().empty());
  EXPECT_EQ(feedback(), QStringLiteral("Choose a part in the list first."));
}

TEST_F(WorkshopDetails, APartFollowsItsStrokesWhenTheirOrderChanges) {
  draw_three();
  find<QListWidget>("workshop_strokes_list")->setCurrentRow(0, QItemSelectionModel::ClearAndSelect);
  press(Qt::Key_G);
  canvas()->setFocus();
  press(Qt::Key_Down, Qt::ControlModifier);
  EXPECT_EQ(part_rows(), QStringList{QStringLiteral("No name yet: stroke 2")});
}

TEST_F(WorkshopDetails, ARadicalIsTypedAsANumberOrAsItsForm) {
  type("workshop_radical", QStringLiteral("9"));
  EXPECT_EQ(radical(), 9);
  EXPECT_EQ(shown("workshop_radical"), QStringLiteral("9 人"));
  type("workshop_radical", QStringLiteral("水"));
  EXPECT_EQ(radical(), 85);
  EXPECT_EQ(shown("workshop_radical"), QStringLiteral("85 水"));
  for (const auto* wrong : {"0", "215", "-3", "x", "休", "9 水", "1.5", "2000"}) {
    type("workshop_radical", QString::fromUtf8(wrong));
    EXPECT_EQ(feedback(), QStringLiteral("“%1” is not a radical. Type its number, 1 to 214, or its form.")
                              .arg(QString::fromUtf8(wrong)));
    EXPECT_EQ(radical(), 85);
    EXPECT_EQ(shown("workshop_radical"), QStringLiteral("85 水"));
  }
  for (const auto& [form, number] :
       {std::pair("亻", 9), {"氵", 85}, {"艹", 140}, {"9 亻", 9}, {"⺅", 9}, {"⼈", 9}}) {
    type("workshop_radical", QString());
    type("workshop_radical", QString::fromUtf8(form));
    EXPECT_EQ(radical(), number) << form;
  }
  type("workshop_radical", QStringLiteral("85 亻"));
  EXPECT_EQ(radical(), 9) << "the two differ";
  type("workshop_radical", QStringLiteral("９"));
  EXPECT_EQ(radical(), 9) << "in full width";
  type("workshop_radical", QString());
  EXPECT_EQ(radical(), std::nullopt);
  canvas()->setFocus();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(radical(), 9);
  EXPECT_EQ(shown("workshop_radical"), QStringLiteral("9 人"));
}

TEST_F(WorkshopDetails, EveryRadicalHasItsOwnFormAndIsReadBack) {
  // Well-known numbers of the classical table.
  for (const auto& [number, form] : {std::pair{1, "一"},
                                     {9, "人"},
                                     {30, "口"},
                                     {75, "木"},
                                     {85, "水"},
                                     {140, "艸"},
                                     {149, "言"},
                                     {167, "金"},
                                     {214, "龠"}})
    EXPECT_EQ(radical_form(number), QString::fromUtf8(form)) << number;
  std::set<QString> forms;
  for (int number = 1; number <= 214; ++number) {
    forms.insert(radical_form(number));
    std::optional<int> read;
    EXPECT_TRUE(read_radical(radical_words(number), read));
    EXPECT_EQ(read, number);
    EXPECT_TRUE(read_radical(radical_form(number), read));
    EXPECT_EQ(read, number);
  }
  EXPECT_EQ(forms.size(), 214U);
}

TEST_F(WorkshopDetails, PartsAndRadicalAreSavedWithTheDocument) {
  draw_three();
  press(Qt::Key_G);
  type("workshop_part_name", QStringLiteral("三"));
  type("workshop_radical", QStringLiteral("1"));
  const QString path = folder_.filePath(QStringLiteral("parts.nazori"));
  write(path);
  const auto read = author::load_character(path.toStdString());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->facts.radical, 1);
  ASSERT_EQ(read->facts.parts.size(), 1U);
  EXPECT_EQ(read->facts.parts[0].name, "三");
}

TEST_F(WorkshopDetails, ANumberIsDraggedMovedByKeysAndPutBack) {
  draw_three();
  press(Qt::Key_3);
  const auto at = author::number_places(character().strokes)[1];
  const auto grip = at + geometry::GlyphPoint{2, -3};
  drag(grip, grip + geometry::GlyphPoint{0, 12});
  EXPECT_EQ(feedback(), QStringLiteral("Number moved."));
  ASSERT_TRUE(character().strokes[1].number_position);
  EXPECT_NEAR(character().strokes[1].number_position->y, at.y + 12, 0.01);
  press(Qt::Key_Right);
  EXPECT_NEAR(character().strokes[1].number_position->x, at.x + 1, 0.01);
  press(Qt::Key_U, Qt::ShiftModifier);
  EXPECT_FALSE(character().strokes[1].number_position);
  EXPECT_EQ(feedback(), QStringLiteral("The program places the number."));
}

TEST_F(WorkshopDetails, WhatACheckFindsAboutANumberChoosesTheNumber) {
  draw_three();
  press(Qt::Key_U);
  canvas()->setFocus();
  for (int i = 0; i < 30; ++i) press(Qt::Key_Right);
  press(Qt::Key_K);
  auto* findings = find<QListWidget>("workshop_findings");
  int far = -1;
  for (int i = 0; i < findings->count(); ++i)
    if (findings->item(i)->text().contains(QStringLiteral("its number is far from its start"))) far = i;
  ASSERT_GE(far, 0) << feedback().toStdString();
  press(Qt::Key_P);
  emit findings->itemClicked(findings->item(far));
  EXPECT_EQ(workshop->bench().selection(), (author::Selection{2, std::nullopt, true}));
}

TEST_F(WorkshopDetails, AKeyChoosesANumberWithTheToolThatMovesIt) {
  press(Qt::Key_U);
  EXPECT_EQ(feedback(), QStringLiteral("There are no strokes yet."));
  draw_three();
  curve("workshop_width_curve")->setFocus();
  press(Qt::Key_U);
  EXPECT_EQ(workshop->bench().settings().tool, author::Tool::edit);
  EXPECT_TRUE(feedback().contains(QStringLiteral("Its number: "))) << feedback().toStdString();
  EXPECT_TRUE(feedback().contains(QStringLiteral("placed by the program"))) << feedback().toStdString();
  press(Qt::Key_Down);
  EXPECT_TRUE(character().strokes[2].number_position);
  press(Qt::Key_S);
  EXPECT_TRUE(feedback().contains(QStringLiteral("placed by hand"))) << feedback().toStdString();
}

TEST_F(WorkshopDetails, TheWidthAlongAStrokeIsDraggedAsOneChange) {
  draw_three();
  find<QListWidget>("workshop_strokes_list")->setCurrentRow(0, QItemSelectionModel::ClearAndSelect);
  const auto before = character().strokes[0].points;
  const auto other = character().strokes[1].points;
  auto* width = curve("workshop_width_curve");
  const std::size_t last = before.size() - 1;
  drag_curve(width, last, -10);
  const auto& after = character().strokes[0].points;
  EXPECT_GT(after[last].half_width, before[last].half_width + 0.2);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(character().strokes[1].points, other);
  EXPECT_EQ(workshop->bench().selection(), (author::Selection{0, last}));
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Point %1 of %1: width ").arg(last + 1)))
      << feedback().toStdString();
  canvas()->setFocus();
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(character().strokes[0].points, before);
  EXPECT_EQ(character().strokes.size(), 3U);
}

TEST_F(WorkshopDetails, ADragDownwardsDeepensTheGrooveAndUpwardsNarrowsNothing) {
  draw_three();
  find<QListWidget>("workshop_strokes_list")->setCurrentRow(0, QItemSelectionModel::ClearAndSelect);
  auto* depth = curve("workshop_depth_curve");
  const auto before = character().strokes[0].points;
  drag_curve(depth, 0, -20);
  const auto shallow = character().strokes[0].points[0];
  EXPECT_LT(shallow.depth, before[0].depth - 0.05);
  EXPECT_EQ(shallow.half_width, before[0].half_width);
  drag_curve(depth, 0, 10);
  EXPECT_GT(character().strokes[0].points[0].depth, shallow.depth + 0.02);
  drag_curve(depth, 0, 1000);
  EXPECT_EQ(character().strokes[0].points[0].depth, 1) << "no deeper than the tablet";
}

TEST_F(WorkshopDetails, ADraggedPointOfACurveStaysUnderThePointer) {
  draw_three();
  find<QListWidget>("workshop_strokes_list")->setCurrentRow(0);
  auto* width = curve("workshop_width_curve");
  const QPointF from = width->place_of(0);
  // Out of the picture: a scale that followed the value would bring the point back.
  const double by = -from.y();
  EXPECT_NEAR(drag_curve(width, 0, by).y(), from.y() + by, 0.5);
  EXPECT_GT(width->place_of(0).y(), 0) << "the scale fits again";
}

TEST_F(WorkshopDetails, AClickOnTheCurveChoosesAPointAndChangesNothing) {
  draw_three();
  find<QListWidget>("workshop_strokes_list")->setCurrentRow(1, QItemSelectionModel::ClearAndSelect);
  const auto before = character().strokes[1].points;
  drag_curve(curve("workshop_width_curve"), 0, 1);
  EXPECT_EQ(workshop->bench().selection(), (author::Selection{1, 0}));
  EXPECT_EQ(workshop->bench().editor().state().undoes, author::EditKind::draw_stroke) << "a hand trembles";
  EXPECT_EQ(character().strokes[1].points, before);
}

TEST_F(WorkshopDetails, TheCurvesAreWorkedWithByKeysAndSaid) {
  press(Qt::Key_W);
  EXPECT_EQ(feedback(), QStringLiteral("There are no strokes yet."));
  draw_three();
  find<QListWidget>("workshop_strokes_list")->setCurrentRow(0, QItemSelectionModel::ClearAndSelect);
  press(Qt::Key_W);
  auto* width = curve("workshop_width_curve");
  ASSERT_TRUE(width->hasFocus());
  const std::size_t points = character().strokes[0].points.size();
  const double before = character().strokes[0].points[0].half_width;
  press(Qt::Key_Right);
  EXPECT_EQ(workshop->bench().selection(), (author::Selection{0, 0}));
  press(Qt::Key_Up);
  EXPECT_NEAR(character().strokes[0].points[0].half_width, before + 0.25, 1e-9);
  EXPECT_EQ(feedback(),
            QStringLiteral("Point 1 of %1: width %2").arg(points).arg(2 * before + 0.5, 0, 'f', 1));
  press(Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(character().strokes[0].points[0].half_width, before + 0.2, 1e-9);
  press(Qt::Key_End);
  EXPECT_EQ(workshop->bench().selection().point, points - 1);
  press(Qt::Key_Left);
  EXPECT_EQ(workshop->bench().selection().point, points - 2);

  auto* depth = curve("workshop_depth_curve");
  depth->setFocus();
  press(Qt::Key_Home);
  press(Qt::Key_Up);
  EXPECT_NEAR(character().strokes[0].points[0].depth, 0.95, 1e-9) << "up is shallower";
  auto* access = QAccessible::queryAccessibleInterface(depth);
  ASSERT_NE(access, nullptr);
  EXPECT_EQ(access->text(QAccessible::Name), QStringLiteral("Depth along the stroke"));
  EXPECT_EQ(access->text(QAccessible::Value), QStringLiteral("Point 1 of %1: depth 95%").arg(points));
  ASSERT_NE(access->valueInterface(), nullptr);
  EXPECT_NEAR(access->valueInterface()->currentValue().toDouble(), 0.95, 1e-9);
  access->valueInterface()->setCurrentValue(0.5);
  EXPECT_NEAR(character().strokes[0].points[0].depth, 0.5, 1e-9);
}

TEST_F(WorkshopDetails, AFunctionPlotBecomesTheReliefOfANewCharacter) {
  in_plot_dialog([](QDialog& dialog) {
    EXPECT_EQ(dialog.findChild<QLineEdit*>(QStringLiteral("plot_x0"))->text(), QStringLiteral("-6"));
    dialog.findChild<QLineEdit*>(QStringLiteral("plot_expression"))->setText(QStringLiteral("y = 1"));
    const std::pair<const char*, const char*> range[] = {
        {"plot_x0", "-2"}, {"plot_x1", "2"}, {"plot_y0", "-1"}, {"plot_y1", "7"}};
    for (const auto& [name, value] : range)
      dialog.findChild<QLineEdit*>(QString::fromLatin1(name))->setText(QString::fromLatin1(value));
    QTest::keyClick(dialog.focusWidget() != nullptr ? dialog.focusWidget() : &dialog, Qt::Key_Return);
  });
  EXPECT_EQ(feedback(), QStringLiteral("The relief is the plot of y = 1."));
  EXPECT_EQ(character().facts.name, "y = 1");
  EXPECT_TRUE(character().strokes.empty());
  EXPECT_EQ(character().hand.size, author::kMapSize) << "as fine as what is drawn by hand";
  // y = 1 is a quarter of the height above the lower border.
  const auto& map = workshop->bench().editor().map();
  const int line = map.size() * 3 / 4;
  for (const double share : {0.2, 0.4, 0.8}) {
    const int column = static_cast<int>(map.size() * share);
    EXPECT_LT(map.at(column, line), 0.1) << "the groove";
    EXPECT_GT(map.at(column, map.size() / 4), 0.8) << "the plateau above it";
  }
  EXPECT_TRUE(workshop->bench().editor().state().is_saved) << "a new document";
}

TEST_F(WorkshopDetails, WhatCannotBePlottedIsSaidAndTheDialogStays) {
  drag({20, 40}, {90, 40});
  in_plot_dialog([](QDialog& dialog) {
    auto* expression = dialog.findChild<QLineEdit*>(QStringLiteral("plot_expression"));
    auto* words = dialog.findChild<QLabel*>(QStringLiteral("plot_words"));
    auto* draw = dialog.findChild<QPushButton*>(QStringLiteral("plot_draw"));
    expression->setText(QStringLiteral("y = x +"));
    EXPECT_TRUE(words->text().startsWith(QStringLiteral("✗ Column 8: something is missing after")))
        << words->text().toStdString();
    draw->click();
    EXPECT_TRUE(dialog.isVisible());
    expression->setText(QStringLiteral("y = x"));
    EXPECT_EQ(words->text(), QStringLiteral("y equals x"));
    auto* from = dialog.findChild<QLineEdit*>(QStringLiteral("plot_x0"));
    from->setText(QStringLiteral("many"));
    draw->click();
    EXPECT_EQ(words->text(), QStringLiteral("✗ “many” is not a number."));
    from->setText(QStringLiteral("100"));
    draw->click();
    EXPECT_TRUE(words->text().startsWith(QStringLiteral("✗ This range cannot be shown: ")))
        << words->text().toStdString();
    EXPECT_TRUE(dialog.isVisible());
    dialog.reject();
  });
  EXPECT_EQ(character().strokes.size(), 1U);
}

TEST_F(WorkshopDetails, WhatIsThereIsSaidWithThePlaceOfTheCursor) {
  press(Qt::Key_S);
  EXPECT_TRUE(feedback().contains("Cursor: 55 from the left and 55 from the top, of 109."))
      << feedback().toStdString();
  press(Qt::Key_Right);
  press(Qt::Key_Up);
  press(Qt::Key_Up);
  const auto at = workshop->bench().cursor();
  EXPECT_GT(at.x - 54.5, 0);
  EXPECT_NEAR(at.y - 54.5, -2 * (at.x - 54.5), 1e-9);
  press(Qt::Key_S);
  EXPECT_TRUE(feedback().contains(QStringLiteral("Cursor: %1 from the left and %2 from the top")
                                      .arg(std::lround(at.x))
                                      .arg(std::lround(at.y))))
      << feedback().toStdString();
}

TEST_F(WorkshopDetails, EnterInAFieldAndEscapeInThePanelGiveTheKeyboardBackToTheDrawing) {
  auto* canvas = find<QWidget>("character_canvas");
  press(Qt::Key_D);
  auto* name = find<QLineEdit>("workshop_name");
  ASSERT_TRUE(name->hasFocus());
  QTest::keyClicks(name, "sign");
  EXPECT_TRUE(name->hasFocus());
  QTest::keyClick(name, Qt::Key_Return);
  EXPECT_TRUE(canvas->hasFocus());
  EXPECT_EQ(character().facts.name, "sign");
  for (const char* field :
       {"workshop_licence", "workshop_width", "workshop_strokes_list", "workshop_radical"}) {
    auto* widget = find<QWidget>(field);
    widget->setFocus();
    ASSERT_TRUE(widget->hasFocus()) << field;
    QTest::keyClick(widget, Qt::Key_Escape);
    EXPECT_TRUE(canvas->hasFocus()) << field;
  }
  auto* strokes = find<QListWidget>("workshop_strokes_list");
  strokes->setFocus();
  QTest::keyClick(strokes, Qt::Key_Return);
  EXPECT_TRUE(strokes->hasFocus()) << "Enter in a list is the list's";
}

TEST_F(WorkshopDetails, NoKeyIsGivenTwiceAndEveryFieldHasAName) {
  QStringList keys;
  for (const auto* entry : window_->findChildren<QAction*>())
    if (entry->isVisible())
      for (const auto& key : entry->shortcuts()) keys.append(key.toString());
  EXPECT_GT(keys.size(), 60);
  for (const QString& key : QStringList(keys)) EXPECT_EQ(keys.count(key), 1) << key.toStdString();
  for (const auto* field : find("workshop_panel")->findChildren<QWidget*>()) {
    if (qobject_cast<const QLineEdit*>(field) == nullptr &&
        qobject_cast<const QListWidget*>(field) == nullptr &&
        qobject_cast<const GrooveCurve*>(field) == nullptr)
      continue;
    if (field->parentWidget() != nullptr && field->parentWidget()->inherits("QAbstractSpinBox")) continue;
    EXPECT_FALSE(field->accessibleName().isEmpty()) << field->objectName().toStdString();
  }
}

}  // namespace
}  // namespace nazori::ui
