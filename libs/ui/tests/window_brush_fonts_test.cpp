// SPDX-License-Identifier: Apache-2.0
// The model of the page for the brush in the lines of a calligraphy font.
#include <QComboBox>
#include <QLineEdit>

#include "brush_window.h"

namespace nazori::ui {
namespace {

class BrushWindowWithFonts : public BrushWindow {
 protected:
  void SetUp() override {
    BrushWindow::SetUp();
    wait_for_models();
    ASSERT_GE(fonts()->findData(kFont), 0) << "the package fonts-kouzan-mouhitsu is missing";
    type(QStringLiteral("三"));
  }
  void wait_for_models() {
    wait_until([] { return !the_page->awaits_models(); });
  }
  QComboBox* fonts() { return find<QComboBox>("brush_font_box"); }
  void choose(const QString& family) {
    fonts()->setCurrentIndex(fonts()->findData(family));
    emit fonts()->activated(fonts()->currentIndex());
    wait_for_models();
  }
  void type(const QString& characters) {
    auto* line = find<QLineEdit>("brush_text");
    line->setText(characters);
    emit line->textEdited(line->text());
    wait_until([this] { return model_pixels() > 500; });
    wait_for_models();
  }
  /// Pixels in which the model is seen beneath the ink.
  int model_pixels() {
    const QImage seen = paper()->grab().toImage();
    int pixels = 0;
    for (int y = 0; y < seen.height(); ++y)
      for (int x = 0; x < seen.width(); ++x) {
        const QColor colour = seen.pixelColor(x, y);
        // Lines of the ruling are darker.
        pixels += colour.red() > 227 && colour.red() - colour.blue() > 50 ? 1 : 0;
      }
    return pixels;
  }
  const QString kFont = QStringLiteral("KouzanBrushFont");
};

TEST_F(BrushWindowWithFonts, AModelHasTheLinesOfTheFontThatIsChosen) {
  EXPECT_EQ(fonts()->itemText(0), QStringLiteral("Printed lines"));
  EXPECT_EQ(fonts()->currentIndex(), 0);
  const QImage printed = paper()->grab().toImage();
  choose(kFont);
  EXPECT_EQ(feedback(), QStringLiteral("Model: KouzanBrushFont."));
  EXPECT_EQ(text("model_words"), QStringLiteral("Model beneath: 三. Font: KouzanBrushFont."));
  EXPECT_GT(model_pixels(), 500);
  EXPECT_NE(paper()->grab().toImage(), printed);
  choose(QString());
  EXPECT_EQ(feedback(), QStringLiteral("Model: Printed lines."));
  EXPECT_EQ(paper()->grab().toImage(), printed);
}

TEST_F(BrushWindowWithFonts, AKeyGoesThroughTheFontsAndBackToPrintedLines) {
  for (int i = 1; i < fonts()->count(); ++i) {
    key(Qt::Key_F);
    EXPECT_EQ(fonts()->currentIndex(), i);
    EXPECT_EQ(feedback(), QStringLiteral("Model: %1.").arg(fonts()->itemText(i)));
    wait_for_models();
  }
  key(Qt::Key_F);
  EXPECT_EQ(fonts()->currentIndex(), 0);
}

TEST_F(BrushWindowWithFonts, ACharacterThatTheFontLacksKeepsPrintedLinesAndThisIsSaid) {
  type(QStringLiteral("剝"));  // jouyou, not in the font
  const QImage printed = paper()->grab().toImage();
  choose(kFont);
  EXPECT_EQ(feedback(),
            QStringLiteral("剝 has printed lines: KouzanBrushFont does not have it with the same strokes."));
  EXPECT_EQ(paper()->grab().toImage(), printed);
}

TEST_F(BrushWindowWithFonts, AdviceComparesWithTheFont) {
  choose(kFont);
  write_stroke(0.3);
  write_stroke(0.7);
  key(Qt::Key_J);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Advice: "))) << feedback().toStdString();
  const auto marks = paper()->marks().size();
  EXPECT_GT(marks, 0U);
  choose(QString());
  EXPECT_TRUE(paper()->marks().empty()) << "another model takes corrections away";
}

TEST_F(BrushWindowWithFonts, AdviceWaitsForModelsThatAreBeingMade) {
  write_stroke(0.3);
  write_stroke(0.7);
  fonts()->setCurrentIndex(fonts()->findData(kFont));
  emit fonts()->activated(fonts()->currentIndex());
  press(Qt::Key_J);
  wait_until([this] { return feedback().startsWith(QStringLiteral("Advice: ")); });
  EXPECT_FALSE(the_page->awaits_models());
}

TEST_F(BrushWindowWithFonts, TheFontIsThereAgainAfterARestart) {
  choose(kFont);
  window_->close();
  window_ = std::make_unique<MainWindow>(setup(), appearance_);
  window_->show();
  settle();
  wait_for_models();
  EXPECT_EQ(fonts()->currentData().toString(), kFont);
  EXPECT_TRUE(text("model_words").endsWith(QStringLiteral("Font: KouzanBrushFont.")))
      << text("model_words").toStdString();
}

}  // namespace
}  // namespace nazori::ui
