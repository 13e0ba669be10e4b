// SPDX-License-Identifier: Apache-2.0
// A card with a chart, its table, and what a screen reader is told of buttons of which one is chosen.
#include "nazori/widgets/charts/chart_card.h"

#include <gtest/gtest.h>

#include <QAccessible>
#include <QActionGroup>
#include <QHeaderView>
#include <QLabel>
#include <QLayout>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>
#include <QToolButton>

#include "nazori/widgets/charts/day_chart.h"
#include "nazori/widgets/controls/choice_access.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/look/resources.h"
#include "nazori/widgets/look/style_sheet.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QWidget* shown(const QWidget& card) {
  return card.findChild<QStackedWidget*>(QString(), Qt::FindDirectChildrenOnly)->currentWidget();
}

TEST(CardOfAChart, ACardShowsItsChartItsNumbersOrWhatMakesSome) {
  const auto text = [](const QWidget& in, const char* name) {
    return in.findChild<QLabel*>(QString::fromLatin1(name))->text();
  };
  QWidget window;
  ChartCard card(QStringLiteral("x"), &window);
  window.show();
  practice::Chart chart;
  ChartText words;
  words.title = QStringLiteral("T");
  words.empty = QStringLiteral("Do this.");
  card.show_chart(chart, words);
  EXPECT_EQ(text(card, "x_heading"), QStringLiteral("T"));
  EXPECT_TRUE(card.findChild<QLabel*>(QStringLiteral("x_summary"))->isHidden());
  EXPECT_EQ(shown(card)->objectName(), QStringLiteral("x_empty"));
  EXPECT_EQ(shown(card)->focusPolicy(), Qt::StrongFocus);
  EXPECT_EQ(shown(card)->accessibleName(), QStringLiteral("T. Do this."));
  auto* numbers = card.findChild<QToolButton*>(QStringLiteral("x_numbers"));
  auto* copy = card.findChild<QToolButton*>(QStringLiteral("x_copy"));
  EXPECT_TRUE(numbers->isHidden());
  EXPECT_TRUE(copy->isHidden());
  card.set_shows_numbers(true);
  EXPECT_EQ(shown(card)->objectName(), QStringLiteral("x_empty")) << "there are none";
  card.set_shows_numbers(false);

  words.summary = QStringLiteral("S.");
  words.row_names = {QStringLiteral("a"), QStringLiteral("b")};
  words.series_names = {QStringLiteral("N")};
  words.numbers.head = {QStringLiteral("Day"), QStringLiteral("N")};
  words.numbers.rows = {{QStringLiteral("d1"), QStringLiteral("1")},
                        {QStringLiteral("d2"), QStringLiteral("2")}};
  chart.positions = {0, 1};
  chart.columns = {{practice::Quantity::reviews, {1, 2}}};
  chart.series = {{0, practice::bars_look(), practice::Side::left}};
  card.show_chart(chart, words);
  EXPECT_FALSE(numbers->isHidden());
  EXPECT_FALSE(copy->isHidden());
  EXPECT_EQ(numbers->accessibleName(), QStringLiteral("Numbers of T"));
  EXPECT_EQ(copy->accessibleName(), QStringLiteral("Copy the numbers of T"));
  EXPECT_EQ(text(card, "x_summary"), QStringLiteral("S."));
  EXPECT_EQ(shown(card)->objectName(), QStringLiteral("x_chart"));
  EXPECT_EQ(shown(card)->accessibleName(), QStringLiteral("T"));
  EXPECT_EQ(shown(card)->accessibleDescription(),
            QStringLiteral("S. Left and Right: read row by row. N: show all numbers."));
  EXPECT_EQ(text(card, "x_reading"), QStringLiteral("Left and Right: read row by row."));
  const auto* reading = card.findChild<QLabel*>(QStringLiteral("x_reading"));
  EXPECT_FALSE(reading->isHidden());
  card.findChild<DayChart*>()->set_row(1);
  EXPECT_EQ(reading->text(), QStringLiteral("d2: N 2"));
  EXPECT_EQ(shown(card)->accessibleDescription(), QStringLiteral("d2: N 2"));

  numbers->click();
  EXPECT_TRUE(card.shows_numbers());
  EXPECT_TRUE(reading->isHidden());
  auto* table = qobject_cast<QTableWidget*>(shown(card));
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->rowCount(), 2);
  EXPECT_EQ(table->columnCount(), 2);
  EXPECT_EQ(table->horizontalHeaderItem(1)->text(), QStringLiteral("N"));
  EXPECT_EQ(table->item(1, 0)->text(), QStringLiteral("d2"));
  EXPECT_EQ(table->item(1, 1)->data(Qt::AccessibleTextRole).toString(), QStringLiteral("d2: N 2"));
  card.show_chart(chart, words);
  EXPECT_EQ(shown(card), table) << "the numbers stay chosen";
  EXPECT_TRUE(reading->isHidden());
  card.set_shows_numbers(false);
  EXPECT_EQ(shown(card)->objectName(), QStringLiteral("x_chart"));
  EXPECT_FALSE(reading->isHidden());
  const QSignalSpy wanted(&card, &ChartCard::copy_wanted);
  copy->click();
  EXPECT_EQ(wanted.count(), 1);
}

TEST(CardOfAChart, IsAsHighAsThirteenLinesAndItsPartsStandApart) {
  ChartCard card(QStringLiteral("x"), nullptr);
  QFont font;
  font.setPixelSize(20);
  card.setFont(font);
  card.refresh_appearance();
  const int line = QFontMetrics(font).lineSpacing();
  EXPECT_EQ(card.findChild<QStackedWidget*>()->minimumHeight(), 13 * line);
  EXPECT_EQ(card.findChild<QTableWidget*>()->verticalHeader()->defaultSectionSize(), line + 8);
  EXPECT_EQ(card.findChild<DayChart*>()->font().pixelSize(), 20);
  EXPECT_EQ(card.layout()->contentsMargins(), QMargins(14, 14, 14, 14));
  EXPECT_EQ(card.layout()->spacing(), 8);
  EXPECT_EQ(card.property("role").toString(), QStringLiteral("card"));
  for (const auto& [name, role] :
       {std::pair("x_heading", "card_title"), std::pair("x_reading", "muted"), std::pair("x_empty", "muted")})
    EXPECT_EQ(card.findChild<QLabel*>(QString::fromLatin1(name))->property("role").toString(),
              QString::fromLatin1(role));
  const auto* numbers = card.findChild<QToolButton*>(QStringLiteral("x_numbers"));
  EXPECT_EQ(numbers->text(), QStringLiteral("Numbers"));
  EXPECT_TRUE(numbers->isCheckable());
  EXPECT_EQ(numbers->toolTip(), QStringLiteral("Show the numbers as a table (N)"));
  const auto* copy = card.findChild<QToolButton*>(QStringLiteral("x_copy"));
  EXPECT_EQ(copy->text(), QStringLiteral("Copy"));
  EXPECT_EQ(copy->toolTip(), QStringLiteral("Copy the numbers (Ctrl+C)"));
  EXPECT_EQ(card.objectName(), QStringLiteral("x_card"));
  EXPECT_EQ(card.findChild<QLabel*>(QStringLiteral("x_empty"))->alignment(), Qt::AlignCenter);
}

TEST(NumbersOfAChart, AreReadRowByRowAndCopiedAsATable) {
  Numbers numbers;
  EXPECT_EQ(numbers.as_text(), QStringLiteral("\n"));
  numbers.head = {QStringLiteral("Day"), QStringLiteral("New"), QStringLiteral("Old")};
  numbers.rows = {{QStringLiteral("Mon"), QStringLiteral("1"), QStringLiteral("2")}, {}};
  EXPECT_EQ(numbers.as_text(), QStringLiteral("Day\tNew\tOld\nMon\t1\t2\n\n"));
  EXPECT_EQ(numbers.row_text(0), QStringLiteral("Mon: New 1, Old 2"));
  EXPECT_EQ(numbers.row_text(1), QString());
  EXPECT_EQ(numbers.row_text(2), QString());
  EXPECT_EQ(numbers.row_text(-1), QString());
  numbers.head.removeLast();
  EXPECT_EQ(numbers.row_text(0), QStringLiteral("Mon: New 1"));
}

TEST(ChoiceOfButtons, IsSpokenAsOneOfSeveralWithItsNameAndItsKey) {
  describe_choices();
  QWidget window;
  QActionGroup group(&window);
  QAction one(QStringLiteral("&One")), two(QStringLiteral("&Two")), alone(QStringLiteral("Alone"));
  for (auto* action : {&one, &two}) {
    action->setCheckable(true);
    group.addAction(action);
  }
  one.setIconText(QStringLiteral("One"));
  one.setShortcut(QKeySequence(QStringLiteral("F5")));
  alone.setCheckable(true);
  const auto button = [&](QAction& action) {
    auto* made = new QToolButton(&window);
    made->setDefaultAction(&action);
    return made;
  };
  auto* first = button(one);
  auto* second = button(two);
  auto* part = QAccessible::queryAccessibleInterface(first);
  ASSERT_NE(part, nullptr);
  EXPECT_EQ(part->role(), QAccessible::RadioButton);
  EXPECT_EQ(part->text(QAccessible::Name), QStringLiteral("One"));
  EXPECT_EQ(part->text(QAccessible::Accelerator), QStringLiteral("F5"));
  EXPECT_TRUE(part->state().checkable);
  EXPECT_FALSE(part->state().checked);
  ASSERT_NE(part->actionInterface(), nullptr);
  EXPECT_EQ(
      part->actionInterface()->actionNames(),
      (QStringList{QAccessibleActionInterface::pressAction(), QAccessibleActionInterface::setFocusAction()}));
  part->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
  EXPECT_TRUE(one.isChecked());
  EXPECT_TRUE(part->state().checked);
  EXPECT_FALSE(QAccessible::queryAccessibleInterface(second)->state().checked);
  first->setAccessibleName(QStringLiteral("Its own"));
  EXPECT_EQ(part->text(QAccessible::Name), QStringLiteral("Its own"));
  EXPECT_NE(QAccessible::queryAccessibleInterface(button(alone))->role(), QAccessible::RadioButton);
}

TEST(SheetOfStyles, HasTheColoursAndTheMeasuresOfTheWindowInThePlaceOfTheirNames) {
  for (const auto* c : {&light_colours(), &dark_colours()}) {
    const std::pair<const char*, QString> values[] = {
        {"indigo_hover", blend(c->indigo, c->ink, 0.15).name()},
        {"card_corner", QStringLiteral("10px")},
        {"arrow_width", QStringLiteral("10px")},
        {"arrow_height", QStringLiteral("6px")},
        {"vermilion", c->vermilion.name()},
        {"surface", c->surface.name()},
        {"indigo", c->indigo.name()},
        {"corner", QStringLiteral("8px")},
        {"paper", c->paper.name()},
        {"muted", c->muted.name()},
        {"hover", blend(c->paper, c->line, 0.45).name()},
        {"press", blend(c->paper, c->line, 0.9).name()},
        {"faint", blend(c->muted, c->paper, 0.35).name()},
        {"tint", blend(c->surface, c->indigo, 0.13).name()},
        {"mode", c == &dark_colours() ? QStringLiteral("dark") : QStringLiteral("light")},
        {"line", c->line.name()},
        {"edge", c->edge.name()},
        {"ring", QStringLiteral("2px")},
        {"thin", QStringLiteral("1px")},
        {"ink", c->ink.name()},
    };
    // The longest names first: one may begin with another.
    QString expected = QString::fromUtf8(read_resource(QStringLiteral("window.qss")));
    for (const auto& [name, value] : values) expected.replace(QLatin1Char('@') + QLatin1String(name), value);
    EXPECT_EQ(style_sheet(*c), expected);
  }
}

}  // namespace
}  // namespace nazori::ui
