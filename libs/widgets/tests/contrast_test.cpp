// SPDX-License-Identifier: Apache-2.0
// Contrasts as they are on the screen: what the style draws, not what the table of colours says. The limits
// are those of WCAG 2.2: 4.5 for text (1.4.3), 3 for what shows where a control is and in which state
// (1.4.11).
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QStyleOptionButton>
#include <QTextBrowser>
#include <algorithm>

#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/look/style_sheet.h"

namespace nazori::ui {
namespace {

constexpr double kForControls = 3;
constexpr double kForText = 4.5;
constexpr int kMargin = 8;

class ContrastOnScreen : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    QApplication::setPalette(make_palette(colours()));
    qApp->setStyleSheet(style_sheet(colours()));
    QPalette paper = box_.palette();
    paper.setColor(QPalette::Window, colours().paper);
    box_.setPalette(paper);
    box_.setAutoFillBackground(true);
  }
  void TearDown() override {
    qApp->setStyleSheet(sheet_);
    QApplication::setPalette(palette_);
  }

  [[nodiscard]] const Colours& colours() const { return GetParam() ? dark_colours() : light_colours(); }

  template <class Widget>
  Widget* put(Widget* widget, QSize size) {
    widget->setParent(&box_);
    widget->setGeometry(QRect(QPoint(kMargin, kMargin), size));
    box_.resize(size + QSize(2 * kMargin, 2 * kMargin));
    widget->show();
    return widget;
  }

  QImage picture() { return box_.grab().toImage(); }

  /// The strongest contrast with `back` on a part of the picture.
  static double strongest(const QImage& picture, const QRect& part, const QColor& back) {
    double most = 1;
    for (int y = part.top(); y <= part.bottom(); ++y)
      for (int x = part.left(); x <= part.right(); ++x)
        most = std::max(most, contrast_ratio(picture.pixelColor(x, y), back));
    return most;
  }

  /// Of each edge of a widget, at its middle, the contrast of the border with the paper around it; the
  /// weakest.
  double weakest_edge(const QWidget* widget) {
    constexpr int kBorder = 3;
    const QImage seen = picture();
    const QRect r = widget->geometry();
    const QPoint mid = r.center();
    double least = 21;
    for (const QRect& edge :
         {QRect(r.left(), mid.y(), kBorder, 1), QRect(r.right() - kBorder + 1, mid.y(), kBorder, 1),
          QRect(mid.x(), r.top(), 1, kBorder), QRect(mid.x(), r.bottom() - kBorder + 1, 1, kBorder)})
      least = std::min(least, strongest(seen, edge, colours().paper));
    return least;
  }

 private:
  QPalette palette_ = QApplication::palette();
  QString sheet_ = qApp->styleSheet();
  QWidget box_;
};

INSTANTIATE_TEST_SUITE_P(LightAndDark, ContrastOnScreen, testing::Values(false, true),
                         [](const auto& which) { return which.param ? "Dark" : "Light"; });

TEST_P(ContrastOnScreen, FieldsAndButtonsHaveAnEdgeThatCanBeSeen) {
  for (QWidget* control : std::initializer_list<QWidget*>{new QLineEdit, new QComboBox, new QSpinBox,
                                                          new QPushButton, new QTextBrowser}) {
    put(control, QSize(120, 48));
    EXPECT_GE(weakest_edge(control), kForControls) << control->metaObject()->className();
    delete control;
  }
  auto* lists = new QListWidget;
  lists->setObjectName(QStringLiteral("study_lists"));
  EXPECT_GE(weakest_edge(put(lists, QSize(120, 80))), kForControls);
}

TEST_P(ContrastOnScreen, ACheckBoxCanBeSeenAndSoCanItsTick) {
  auto* box = put(new QCheckBox, QSize(60, 40));
  const auto mark = [&] {
    QStyleOptionButton option;
    option.initFrom(box);
    return box->style()->subElementRect(QStyle::SE_CheckBoxIndicator, &option, box).translated(box->pos());
  };
  const QRect place = mark();
  ASSERT_GE(place.width(), 8);
  const QImage open = picture();
  for (const int x : {place.left(), place.right() - 2})
    EXPECT_GE(strongest(open, QRect(x, place.center().y(), 3, 1), colours().paper), kForControls) << x;
  // Inside it is empty.
  EXPECT_LT(strongest(open, place.adjusted(4, 4, -4, -4), colours().paper), 1.2);
  box->setChecked(true);
  const QImage ticked = picture();
  EXPECT_GE(strongest(ticked, place, colours().paper), kForControls);
  EXPECT_GE(strongest(ticked, place.adjusted(3, 3, -3, -3), colours().indigo), kForControls);
}

TEST_P(ContrastOnScreen, AScrollBarShowsWhereItIs) {
  for (const auto direction : {Qt::Vertical, Qt::Horizontal}) {
    auto* bar = new QScrollBar(direction);
    bar->setRange(0, 10);
    bar->setPageStep(10);
    put(bar, direction == Qt::Vertical ? QSize(12, 200) : QSize(200, 12));
    const QRect near_start =
        direction == Qt::Vertical ? QRect(kMargin, kMargin + 30, 12, 1) : QRect(kMargin + 30, kMargin, 1, 12);
    EXPECT_GE(strongest(picture(), near_start, colours().paper), kForControls) << direction;
    delete bar;
  }
}

TEST_P(ContrastOnScreen, ASliderShowsItsWayAndWhereItStands) {
  auto* slider = put(new QSlider(Qt::Horizontal), QSize(200, 30));
  slider->setRange(0, 100);
  slider->setValue(50);
  const QImage seen = picture();
  for (const int x : {40, 108, 170})
    EXPECT_GE(strongest(seen, QRect(x, kMargin, 1, 30), colours().paper), kForControls) << x;
}

TEST_P(ContrastOnScreen, TextCanBeReadAndSoCanWhatAnEmptyFieldAsksFor) {
  QFont large = QApplication::font();
  large.setPointSize(28);  // so that some pixel lies wholly inside a letter
  auto* line = put(new QLineEdit, QSize(300, 64));
  line->setFont(large);
  const QRect inside = line->geometry().adjusted(6, 6, -6, -6);
  line->setPlaceholderText(QStringLiteral("HHH"));
  EXPECT_GE(strongest(picture(), inside, colours().surface), kForText);
  line->setText(QStringLiteral("HHH"));
  EXPECT_GE(strongest(picture(), inside, colours().surface), 12);
  auto* button = put(new QPushButton(QStringLiteral("HHH")), QSize(300, 64));
  line->hide();
  button->setFont(large);
  EXPECT_GE(strongest(picture(), inside, colours().surface), 12);
}

}  // namespace
}  // namespace nazori::ui
