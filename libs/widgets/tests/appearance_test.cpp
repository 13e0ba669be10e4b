// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/appearance.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QEvent>
#include <QFontInfo>
#include <QSignalSpy>
#include <QStyleFactory>
#include <QStyleOptionSlider>
#include <QWidget>

#include "nazori/widgets/look/style_sheet.h"
#include "painting_under_test.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

/// Leaves the application as it was.
class LookOfTheProgram : public testing::Test {
 protected:
  ~LookOfTheProgram() override {
    qApp->setStyleSheet(sheet_);
    QApplication::setFont(font_);
    QApplication::setPalette(palette_);
  }
  LookOfTheProgram() = default;
  LookOfTheProgram(const LookOfTheProgram&) = delete;
  LookOfTheProgram& operator=(const LookOfTheProgram&) = delete;

 private:
  QPalette palette_ = QApplication::palette();
  QFont font_ = QApplication::font();
  QString sheet_ = qApp->styleSheet();

 protected:
  Appearance appearance_;
};

TEST_F(LookOfTheProgram, HasThePaletteTheLettersAndTheSheetOfItsTheme) {
  const QSignalSpy changed(&appearance_, &Appearance::changed);
  for (const auto& [theme, colours] :
       {std::pair(ThemeChoice::dark, &dark_colours()), {ThemeChoice::light, &light_colours()}}) {
    appearance_.apply(theme, 17);
    EXPECT_EQ(appearance_.is_dark(), theme == ThemeChoice::dark);
    EXPECT_EQ(QApplication::palette().color(QPalette::Window).name(), colours->paper.name());
    EXPECT_EQ(qApp->styleSheet(), style_sheet(*colours));
    EXPECT_EQ(QApplication::font().pointSize(), 17);
  }
  EXPECT_EQ(changed.count(), 2);
}

TEST_F(LookOfTheProgram, WhatIsThereAlreadyIsNotSetOnEveryWidgetAgain) {
  class Counted final : public QWidget {
   public:
    int style_changes = 0;

   protected:
    void changeEvent(QEvent* event) override {
      style_changes += event->type() == QEvent::StyleChange ? 1 : 0;
    }
  };
  appearance_.apply(ThemeChoice::light, 14);
  Counted widget;
  widget.ensurePolished();
  const QSignalSpy changed(&appearance_, &Appearance::changed);
  appearance_.apply(ThemeChoice::light, 14);
  EXPECT_EQ(widget.style_changes, 0);
  EXPECT_EQ(changed.count(), 1) << "what is drawn by hand may be new";
  for (const auto& [theme, text_pt] : {std::pair(ThemeChoice::light, 15), {ThemeChoice::dark, 15}}) {
    widget.style_changes = 0;
    appearance_.apply(theme, text_pt);
    EXPECT_GT(widget.style_changes, 0) << text_pt;
  }
}

TEST_F(LookOfTheProgram, LettersThatAFontLacksComeFromFontsOfJapanese) {
  for (int i = 0; i < 2; ++i) {
    appearance_.apply(ThemeChoice::light, 12 + i);
    QStringList families = QApplication::font().families();
    ASSERT_GE(families.size(), 3);
    EXPECT_EQ(families.removeDuplicates(), 0) << "also when it is applied again";
    EXPECT_EQ(families.front(), QFontInfo(QApplication::font()).family());
    for (const char* family : {"Noto Sans CJK JP", "Noto Sans JP", "IPAexGothic"})
      EXPECT_TRUE(families.contains(QString::fromLatin1(family))) << family;
  }
}

TEST_F(LookOfTheProgram, ButtonsOfDialogsHaveNoPicturesAndAllElseIsAsUsual) {
  qApp->setStyleSheet({});
  const std::unique_ptr<QStyle> usual(QStyleFactory::create(QStringLiteral("Fusion")));
  EXPECT_EQ(QApplication::style()->styleHint(QStyle::SH_DialogButtonBox_ButtonsHaveIcons), 0);
  for (const auto hint : {QStyle::SH_Slider_AbsoluteSetButtons, QStyle::SH_ToolTip_WakeUpDelay,
                          QStyle::SH_ComboBox_Popup, QStyle::SH_EtchDisabledText})
    EXPECT_EQ(QApplication::style()->styleHint(hint), usual->styleHint(hint)) << hint;
}

class TicksOfASlider : public LookOfTheProgram {
 protected:
  TicksOfASlider() {
    qApp->setStyleSheet({});
    slider_.rect = QRect(0, 0, 220, 40);
    slider_.orientation = Qt::Horizontal;
    slider_.state = QStyle::State_Enabled | QStyle::State_Horizontal;
    slider_.subControls = QStyle::SC_SliderGroove | QStyle::SC_SliderHandle | QStyle::SC_SliderTickmarks;
    slider_.minimum = 10;
    slider_.maximum = 20;
    slider_.sliderPosition = slider_.sliderValue = 13;
    slider_.tickInterval = 5;
    slider_.pageStep = 2;
    slider_.tickPosition = QSlider::TicksBelow;
    slider_.palette = make_palette(current_colours());
  }
  std::vector<test::Drawn> drawn() {
    std::vector<test::Drawn> ticks;
    const auto all = test::drawn_by(QSize(220, 40), [this](QPainter& painter) {
      QApplication::style()->drawComplexControl(QStyle::CC_Slider, &slider_, &painter, nullptr);
      // What is drawn afterwards has the pen of before.
      painter.drawLine(0, 0, 1, 0);
    });
    for (const auto& line : all.lines())
      if (line.pen.color().rgb() == current_colours().muted.rgb()) ticks.push_back(line);
    return ticks;
  }
  /// Where the middle of the handle is for a value.
  double middle_of(int value) {
    QStyleOptionSlider at = slider_;
    at.sliderPosition = at.sliderValue = value;
    const QRect handle =
        QApplication::style()->subControlRect(QStyle::CC_Slider, &at, QStyle::SC_SliderHandle);
    return QRectF(handle).center().x();
  }
  QStyleOptionSlider slider_;
};

TEST_F(TicksOfASlider, StandAtTheMiddleOfTheHandleOfTheirValueAndCanBeSeen) {
  const auto below = drawn();
  ASSERT_EQ(below.size(), 3U) << "10, 15 and 20";
  const int high = std::max(3, QApplication::style()->pixelMetric(QStyle::PM_SliderTickmarkOffset, &slider_));
  for (int i = 0; i < 3; ++i) {
    const auto& line = below[static_cast<std::size_t>(i)];
    EXPECT_NEAR(line.points[0].x(), middle_of(10 + 5 * i), 1) << i;
    EXPECT_EQ(line.points[0].x(), line.points[1].x());
    EXPECT_EQ(line.points[1].y(), 39) << "the lower edge";
    EXPECT_EQ(line.points[0].y(), 39 - high);
  }
  slider_.tickPosition = QSlider::TicksAbove;
  const auto above = drawn();
  ASSERT_EQ(above.size(), 3U);
  EXPECT_EQ(above[1].points[0].y(), 0) << "the upper edge";
  EXPECT_EQ(above[1].points[1].y(), high);
  EXPECT_EQ(above[1].points[0].x(), below[1].points[0].x());
  slider_.tickPosition = QSlider::TicksBothSides;
  EXPECT_EQ(drawn().size(), 6U);
}

TEST_F(TicksOfASlider, AreAPageApartWhereNothingElseIsSaidAndAtLeastAStep) {
  slider_.tickInterval = 0;
  EXPECT_EQ(drawn().size(), 6U) << "10, 12 ... 20";
  slider_.pageStep = 0;
  EXPECT_EQ(drawn().size(), 11U);
}

TEST_F(TicksOfASlider, AreLeftOutWhereThereAreNoneAndLeftToTheStyleOnUprightOnes) {
  slider_.subControls.setFlag(QStyle::SC_SliderTickmarks, false);
  EXPECT_TRUE(drawn().empty());
  slider_.subControls.setFlag(QStyle::SC_SliderTickmarks, true);
  slider_.orientation = Qt::Vertical;
  slider_.state.setFlag(QStyle::State_Horizontal, false);
  slider_.rect = QRect(0, 0, 40, 220);
  EXPECT_TRUE(drawn().empty());
}

}  // namespace
}  // namespace nazori::ui
