// SPDX-License-Identifier: Apache-2.0
// How a chart behaves at its edges, and how its card gives the keyboard on.
#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QHeaderView>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>

#include "nazori/widgets/charts/chart_card.h"
#include "nazori/widgets/charts/day_chart.h"
#include "nazori/widgets/charts/role_colours.h"
#include "nazori/widgets/look/palette.h"
#include "painting_under_test.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using practice::Side;

/// A chart of columns with a row a day, and its words.
struct Made {
  practice::Chart chart;
  ChartText text;
};

Made made_of(std::vector<practice::Series> series, const std::vector<std::vector<double>>& columns) {
  Made made;
  for (const auto& column : columns) made.chart.columns.push_back({practice::Quantity::reviews, column});
  made.chart.series = std::move(series);
  made.text.title = QStringLiteral("T");
  made.text.summary = QStringLiteral("S.");
  made.text.numbers.head = {QStringLiteral("Day"), QStringLiteral("N")};
  for (std::size_t row = 0; row < columns.front().size(); ++row) {
    made.chart.positions.push_back(static_cast<double>(row));
    made.text.row_names.append(QString::number(row));
    made.text.numbers.rows.append({QStringLiteral("d%1").arg(row), QString::number(row)});
  }
  for (std::size_t i = 0; i < made.chart.series.size(); ++i)
    made.text.series_names.append(QStringLiteral("Series"));
  return made;
}

class EdgesOfAChart : public testing::Test {
 protected:
  EdgesOfAChart() { view_.resize(600, 300); }
  void show(const Made& made) { view_.show_chart(made.chart, made.text); }
  QImage painted() {
    QImage picture(view_.size(), QImage::Format_ARGB32);
    picture.fill(Qt::white);
    view_.render(&picture, {}, {}, QWidget::RenderFlags());
    return picture;
  }
  static bool is(const QImage& picture, QPointF at, const QColor& colour) {
    const QColor seen = picture.pixelColor(at.toPoint());
    return std::abs(seen.red() - colour.red()) + std::abs(seen.green() - colour.green()) +
               std::abs(seen.blue() - colour.blue()) <
           20;
  }
  const Colours& c_ = current_colours();
  DayChart view_;
};

TEST_F(EdgesOfAChart, AMarkAtTheHighestValueIsWholeAndWhatIsHigherIsCutOff) {
  // 10 at the left axis, whose end is 10, and 40 by a second line of the same side.
  show(made_of({{0, practice::first_line_look(), Side::left}, {1, practice::first_line_look(), Side::left}},
               {{10, 10, 10}, {0, 40, 0}}));
  const QRectF plot = view_.plot_area();
  const QImage picture = painted();
  const double first = plot.left() + plot.width() / 6;
  EXPECT_TRUE(is(picture, {first, plot.top() - 2.5}, c_.ink)) << "the upper half of the disc";
  // The way up to 40 leaves the plot. A pixel above the marks nothing is left of it.
  int above = 0;
  for (int y = 0; y + 1 <= plot.top() - 5; ++y)
    for (int x = static_cast<int>(plot.left()) + 10; x < static_cast<int>(plot.right()); ++x)
      above += is(picture, QPointF(x, y), c_.ink) ? 1 : 0;
  EXPECT_EQ(above, 0);
}

TEST_F(EdgesOfAChart, TheFirstAndTheLastBarOfManyAreWhole) {
  show(made_of({{0, practice::bars_look(), Side::left}}, {std::vector<double>(60, 5.0)}));
  const QRectF plot = view_.plot_area();
  const QImage picture = painted();
  const QColor fill = colour_of(practice::bars_look().fill, c_);
  const double period = plot.width() / 60;
  // A bar is 0.8 of its period wide.
  for (const double x : {plot.left() + 0.25 * period, plot.right() - 0.35 * period})
    EXPECT_TRUE(is(picture, {x, plot.bottom() - 20}, fill)) << x;
  EXPECT_TRUE(is(picture, {plot.center().x() + 0.5 * period, plot.bottom() - 2}, fill));
}

TEST_F(EdgesOfAChart, AnEmptyChartDrawsNothingAndHasNoRow) {
  practice::Chart none;
  none.columns = {{practice::Quantity::reviews, {}}};
  none.series = {{0, practice::bars_look(), Side::left}};
  view_.setFrameShape(QFrame::NoFrame);
  view_.show_chart(none, {});
  EXPECT_TRUE(test::drawn_by(view_).all.empty());
  const QSignalSpy changed(&view_, &DayChart::row_changed);
  view_.set_row(0);
  EXPECT_EQ(view_.row(), -1);
  EXPECT_EQ(changed.count(), 0);
  QTest::mouseClick(&view_, Qt::LeftButton, {}, {300, 100});
  EXPECT_EQ(view_.row(), -1);
}

TEST_F(EdgesOfAChart, OneRowIsDrawnAndReadLikeMany) {
  show(made_of({{0, practice::bars_look(), Side::left}}, {{3}}));
  EXPECT_EQ(view_.property("role").toString(), QStringLiteral("chart"));
  EXPECT_EQ(view_.focusPolicy(), Qt::StrongFocus);
  const QRectF plot = view_.plot_area();
  const auto boxes = test::drawn_by(view_).boxes();
  const auto is_bar = [&](const test::Drawn& one) {
    return std::abs(one.box.width() - 0.8 * plot.width()) < 0.01;
  };
  EXPECT_EQ(std::count_if(boxes.begin(), boxes.end(), is_bar), 1);
  const QSignalSpy changed(&view_, &DayChart::row_changed);
  view_.set_row(7);
  EXPECT_EQ(view_.row(), 0);
  view_.set_row(-3);
  EXPECT_EQ(view_.row(), 0);
  ASSERT_EQ(changed.count(), 1) << "it stayed the same";
  EXPECT_EQ(changed.at(0).at(0).toInt(), 0);
  EXPECT_NEAR(view_.mark_x(), plot.center().x(), 0.01);
}

TEST_F(EdgesOfAChart, ALineHasNoFillAndKeysThatMoveNothingGoOn) {
  show(made_of({{0, practice::bars_look(), Side::left}, {1, practice::second_line_look(), Side::left}},
               {{1, 2, 3}, {3, 2, 1}}));
  int polylines = 0;
  for (const auto& one : test::drawn_by(view_).all)
    if (one.kind == test::Drawn::Kind::shape && one.points.size() == 3) {
      ++polylines;
      EXPECT_EQ(one.fill_words(), QStringLiteral("none"));
      EXPECT_EQ(one.pen_words(), QStringLiteral("indigo 2.5 dashed"));
    }
  EXPECT_EQ(polylines, 1);
  const auto taken = [this](Qt::Key which) {
    QKeyEvent key(QEvent::KeyPress, which, Qt::NoModifier);
    QCoreApplication::sendEvent(&view_, &key);
    return key.isAccepted();
  };
  EXPECT_FALSE(taken(Qt::Key_N));
  EXPECT_TRUE(taken(Qt::Key_Home));
  EXPECT_EQ(view_.row(), 0);
}

TEST_F(EdgesOfAChart, IsPaintedAnewWhereItsContentOrItsRowChanges) {
  view_.show();
  const auto shows_anew = [this](const std::function<void()>& change) {
    QCoreApplication::sendPostedEvents();
    for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
    /// Counts what is painted.
    class Count final : public QObject {
     public:
      int painted = 0;
      bool eventFilter(QObject*, QEvent* event) override {
        painted += event->type() == QEvent::Paint ? 1 : 0;
        return false;
      }
    } count;
    view_.installEventFilter(&count);
    change();
    return QTest::qWaitFor([&] { return count.painted > 0; }, 1000);
  };
  const Made made = made_of({{0, practice::bars_look(), Side::left}}, {{1, 2, 3}});
  EXPECT_TRUE(shows_anew([&] { show(made); }));
  EXPECT_TRUE(shows_anew([&] { view_.set_row(1); }));
}

TEST_F(EdgesOfAChart, TheMouseReadsARowAndBringsTheKeyboard) {
  QWidget window;
  auto* other = new QLineEdit(&window);
  auto* chart = new DayChart(&window);
  chart->resize(600, 300);
  const Made made = made_of({{0, practice::bars_look(), Side::left}}, {{1, 2, 3}});
  chart->show_chart(made.chart, made.text);
  window.resize(700, 400);
  window.show();
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  other->setFocus();
  const QRectF plot = chart->plot_area();
  QMouseEvent press(QEvent::MouseButtonPress, {plot.left() + plot.width() / 2, 50}, QPointF(), Qt::LeftButton,
                    Qt::LeftButton, {});
  QCoreApplication::sendEvent(chart, &press);
  EXPECT_TRUE(chart->hasFocus());
  EXPECT_EQ(chart->row(), 1);
}

class CardWithTheKeyboard : public testing::Test {
 protected:
  CardWithTheKeyboard() {
    window_.resize(600, 400);
    card_.resize(600, 400);
    const Made made = made_of({{0, practice::bars_look(), Side::left}}, {{1, 2, 3}});
    card_.show_chart(made.chart, made.text);
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
  }
  QWidget window_;
  ChartCard& card_ = *new ChartCard(QStringLiteral("x"), &window_);
  QTableWidget& table_ = *card_.findChild<QTableWidget*>();
  DayChart& chart_ = *card_.findChild<DayChart*>();
  QStackedWidget& stack_ = *card_.findChild<QStackedWidget*>();
};

TEST_F(CardWithTheKeyboard, GivesItFromTheDrawingToTheFirstNumberAndBack) {
  chart_.setFocus();
  card_.set_shows_numbers(true);
  EXPECT_TRUE(table_.hasFocus());
  EXPECT_EQ(table_.currentRow(), 0);
  EXPECT_EQ(table_.currentColumn(), 0);
  table_.setCurrentCell(2, 1);
  card_.set_shows_numbers(false);
  EXPECT_TRUE(chart_.hasFocus());
  card_.set_shows_numbers(true);
  EXPECT_EQ(table_.currentRow(), 2) << "where it was";
  EXPECT_EQ(table_.currentColumn(), 1);
}

TEST_F(CardWithTheKeyboard, LeavesItWhereItWasElse) {
  auto* numbers = card_.findChild<QToolButton*>(QStringLiteral("x_numbers"));
  numbers->setFocus();
  card_.set_shows_numbers(true);
  EXPECT_TRUE(numbers->hasFocus());
  EXPECT_FALSE(table_.hasFocus());
  card_.set_shows_numbers(false);
  card_.focus_content();
  EXPECT_TRUE(chart_.hasFocus());
}

TEST_F(CardWithTheKeyboard, ItsColumnsAreAsWideAsTheirNumbersWhereTheyAreShown) {
  Made made = made_of({{0, practice::bars_look(), Side::left}}, {{1, 2, 3}});
  made.text.numbers.rows[1][0] = QStringLiteral("a day with an unusually long and wide name");
  const int before = table_.columnWidth(0);
  card_.show_chart(made.chart, made.text);
  EXPECT_EQ(table_.columnWidth(0), before) << "not measured while it is hidden";
  card_.set_shows_numbers(true);
  const int wide = table_.columnWidth(0);
  EXPECT_GT(wide, table_.fontMetrics().horizontalAdvance(made.text.numbers.rows[1][0]));
  made.text.numbers.rows[1][0] += made.text.numbers.rows[1][0];
  card_.show_chart(made.chart, made.text);
  EXPECT_GT(table_.columnWidth(0), wide) << "measured again";
  EXPECT_EQ(table_.horizontalScrollMode(), QAbstractItemView::ScrollPerPixel);
  EXPECT_EQ(table_.selectionBehavior(), QAbstractItemView::SelectRows);
  EXPECT_EQ(table_.accessibleName(), QStringLiteral("Numbers of T"));
  EXPECT_EQ(card_.accessibleName(), QStringLiteral("T"));
  QFont font = card_.font();
  font.setPixelSize(30);
  card_.setFont(font);
  table_.setFont(font);
  const int small = table_.columnWidth(0);
  card_.refresh_appearance();
  EXPECT_GT(table_.columnWidth(0), small) << "larger letters";
}

TEST_F(CardWithTheKeyboard, FewerRowsLeaveNoneOfThoseBefore) {
  Made made = made_of({{0, practice::bars_look(), Side::left}}, {{1, 2, 3}});
  made.text.numbers.head.append(QStringLiteral("More"));
  for (QStringList& row : made.text.numbers.rows) row.append(QStringLiteral("more"));
  card_.show_chart(made.chart, made.text);
  ASSERT_EQ(table_.rowCount(), 3);
  ASSERT_NE(table_.item(0, 2), nullptr);
  made = made_of({{0, practice::bars_look(), Side::left}}, {{1}});
  made.text.numbers.head.append(QStringLiteral("More"));
  card_.show_chart(made.chart, made.text);
  EXPECT_EQ(table_.rowCount(), 1);
  EXPECT_EQ(table_.columnCount(), 3);
  EXPECT_EQ(table_.item(0, 2), nullptr);
  EXPECT_EQ(table_.item(0, 0)->text(), QStringLiteral("d0"));
  EXPECT_EQ(table_.item(0, 0)->data(Qt::AccessibleTextRole).toString(), QStringLiteral("d0: N 0"));
}

TEST_F(CardWithTheKeyboard, ItsPartsAreInTheirOrderAndTheDrawingHasTheRoom) {
  const auto* column = qobject_cast<QBoxLayout*>(card_.layout());
  ASSERT_EQ(column->count(), 4);
  const auto* head = qobject_cast<QBoxLayout*>(column->itemAt(0)->layout());
  ASSERT_NE(head, nullptr);
  EXPECT_EQ(head->spacing(), 6);
  QStringList names;
  for (int i = 0; i < head->count(); ++i) {
    names.append(head->itemAt(i)->widget()->objectName());
    EXPECT_EQ(head->stretch(i), i == 0 ? 1 : 0);
    if (i > 0) {
      EXPECT_EQ(head->itemAt(i)->alignment(), Qt::AlignTop);
    }
  }
  for (int i = 1; i < 4; ++i) {
    names.append(column->itemAt(i)->widget()->objectName());
    EXPECT_EQ(column->stretch(i), i == 2 ? 1 : 0);
  }
  EXPECT_EQ(names,
            (QStringList{QStringLiteral("x_heading"), QStringLiteral("x_numbers"), QStringLiteral("x_copy"),
                         QStringLiteral("x_summary"), stack_.objectName(), QStringLiteral("x_reading")}));
  EXPECT_EQ(card_.findChild<QLabel*>(QStringLiteral("x_summary"))->textInteractionFlags(),
            Qt::TextSelectableByMouse);
  EXPECT_EQ(card_.findChild<QLabel*>(QStringLiteral("x_empty"))->focusPolicy(), Qt::NoFocus);
  EXPECT_EQ(card_.findChild<QLabel*>(QStringLiteral("x_summary"))->property("role").toString(), QString());
}

/// A card whose drawing is no chart.
class CardOfALabel final : public ChartCard {
 public:
  explicit CardOfALabel(QLabel* label) : ChartCard(QStringLiteral("y"), label, nullptr) {}
  using ChartCard::show_text;
};

TEST(CardOfADrawing, HasNoRowsToReadAndKeepsItsNumbers) {
  auto* drawing = new QLabel;
  CardOfALabel card(drawing);
  EXPECT_EQ(drawing->objectName(), QStringLiteral("y_chart"));
  EXPECT_TRUE(card.isAncestorOf(drawing));
  const Made made = made_of({{0, practice::bars_look(), Side::left}}, {{1, 2}});
  card.show_text(made.text);
  const auto* reading = card.findChild<QLabel*>(QStringLiteral("y_reading"));
  EXPECT_TRUE(reading->isHidden());
  EXPECT_EQ(drawing->accessibleDescription(),
            QStringLiteral("S. Left and Right: read row by row. N: show all numbers."));
  EXPECT_EQ(card.findChild<QStackedWidget*>()->currentWidget(), drawing);
  card.set_shows_numbers(true);
  EXPECT_EQ(card.findChild<QStackedWidget*>()->currentWidget(), card.findChild<QTableWidget*>());
  EXPECT_EQ(card.findChild<QTableWidget*>()->rowCount(), 2);
  card.set_shows_numbers(false);
  EXPECT_TRUE(reading->isHidden()) << "there are no rows in a drawing";
  EXPECT_EQ(card.findChild<QStackedWidget*>()->minimumHeight(), 13 * QFontMetrics(card.font()).lineSpacing());
}

}  // namespace
}  // namespace nazori::ui
