// SPDX-License-Identifier: Apache-2.0
#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QPointingDevice>
#include <QPushButton>
#include <QScrollArea>
#include <QTabletEvent>
#include <QTimer>

#include "brush_window.h"

namespace nazori::ui {
namespace {

TEST_F(BrushWindow, AStrokeByMouseLeavesInkAndUndoTakesItAway) {
  const int bare = darkness(0.5, 0.5);
  write_stroke();
  EXPECT_GT(darkness(0.5, 0.5), bare + 80);
  EXPECT_LT(darkness(0.5, 0.9), bare + 10);
  EXPECT_TRUE(action("brush_undo")->isEnabled());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Stroke 1 undone."));
  EXPECT_LT(darkness(0.5, 0.5), bare + 10);
  EXPECT_FALSE(action("brush_undo")->isEnabled());
  key(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(feedback(), QStringLiteral("Stroke 1 redone."));
  EXPECT_GT(darkness(0.5, 0.5), bare + 80);
}

TEST_F(BrushWindow, AStrokeIsWrittenByKeysAlone) {
  qputenv("SDL_AUDIODRIVER", "dummy");
  EXPECT_FALSE(action("brush_harder")->isEnabled());
  key(Qt::Key_Plus);
  key(Qt::Key_M);
  EXPECT_EQ(feedback(),
            QStringLiteral("The keys move the pen. Arrow keys: move. U: pen down or up. N: next start. "
                           "K: where."));
  const int bare = darkness(0.6, 0.5);
  for (int i = 0; i < 10; ++i) QTest::keyClick(paper(), Qt::Key_Right);
  key(Qt::Key_U);
  EXPECT_EQ(feedback(), QStringLiteral("Pen down."));
  key(Qt::Key_Plus);
  EXPECT_EQ(feedback(), QStringLiteral("Pressure: 60%."));
  for (int i = 0; i < 10; ++i) QTest::keyClick(paper(), Qt::Key_Left);
  key(Qt::Key_U);
  wait_until([&] { return state().strokes == 1 && !state().is_writing; });
  settle();
  // There are gaps between the hairs.
  int darkest = 0;
  for (int i = -4; i <= 4; ++i) darkest = std::max(darkest, darkness(0.6, 0.5 + 0.004 * i));
  EXPECT_GT(darkest, bare + 80) << "between the middle and 20 mm to its right";
  EXPECT_LT(darkness(0.8, 0.5), bare + 10);
  EXPECT_LT(darkness(0.3, 0.5), bare + 10);
  key(Qt::Key_K);
  EXPECT_TRUE(feedback().endsWith(QStringLiteral("50% from the left, 50% from the top.")))
      << feedback().toStdString();
  for (int i = 0; i < 4; ++i) key(Qt::Key_Plus);
  EXPECT_EQ(feedback(), QStringLiteral("Pressure: 100%."));
  key(Qt::Key_Plus);
  EXPECT_EQ(feedback(), QStringLiteral("The brush cannot be pressed harder."));
  key(Qt::Key_M);
  EXPECT_FALSE(action("brush_press")->isEnabled());
  const int strokes = state().strokes;
  QTest::keyClick(paper(), Qt::Key_Left);
  settle();
  EXPECT_EQ(state().strokes, strokes);
}

TEST_F(BrushWindow, ATeacherWritesTheModelOnANewSheetAndStopsForThePen) {
  write_stroke(0.9);
  take_model(QStringLiteral("十"));
  key(Qt::Key_V);
  wait_until([this] { return feedback() == QStringLiteral("Watch: 2 strokes. V: stop."); });
  wait_until([this] { return state().strokes == 2 && !state().is_writing; });
  wait_until([this] { return feedback().startsWith(QStringLiteral("That is how it is written.")); });
  EXPECT_GT(darkness(0.5, 0.4), 80) << "the bar";
  EXPECT_LT(darkness(0.3, 0.9), 60) << "the stroke before is on the old sheet";
  key(Qt::Key_J);
  wait_until([this] { return feedback().startsWith(QStringLiteral("Advice: ")); });
  EXPECT_FALSE(feedback().contains(QStringLiteral("troke"))) << feedback().toStdString();
  // While it is written, the learner's pen and V take over.
  key(Qt::Key_V);
  wait_until([this] { return state().is_writing; });
  write_stroke(0.9);
  const int strokes = state().strokes;
  key(Qt::Key_V);
  wait_until([this] { return state().is_writing; });
  key(Qt::Key_V);
  EXPECT_EQ(feedback(), QStringLiteral("Stopped."));
  wait_until([this] { return !state().is_writing; });
  EXPECT_LE(strokes, 3);
}

TEST_F(BrushWindow, KeysNameTheStrokesOfTheModelOnlyWhileItIsShown) {
  take_model(QStringLiteral("十"));
  key(Qt::Key_2);
  key(Qt::Key_M);
  key(Qt::Key_N);
  EXPECT_EQ(feedback(), QStringLiteral("Start of stroke 1."));
  key(Qt::Key_N);
  EXPECT_EQ(feedback(), QStringLiteral("Start of stroke 2."));
  key(Qt::Key_1);
  key(Qt::Key_N);
  EXPECT_EQ(feedback(), QStringLiteral("There are no strokes to go to."));
}

TEST_F(BrushWindow, ASheetThatWasSavedOpensAgainWithTheSameBytes) {
  write_stroke();
  key(Qt::Key_D);  // a wet sheet would dry further between the two files
  const QString path = folder_.filePath(QStringLiteral("one.nzs"));
  the_page->write(path);
  settle();
  EXPECT_EQ(feedback(), QStringLiteral("Saved one.nzs."));
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("one.nzs – Nazori"));
  key(Qt::Key_N, Qt::ControlModifier);
  EXPECT_EQ(state().strokes, 0);
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Brush – Nazori"));
  press(Qt::Key_1, Qt::AltModifier);
  window_->open_files({path});
  settle();
  EXPECT_TRUE(paper()->isVisible());
  EXPECT_EQ(feedback(), QStringLiteral("Opened one.nzs."));
  EXPECT_GT(darkness(0.5, 0.5), 80);
  const QString again = folder_.filePath(QStringLiteral("two.nzs"));
  the_page->write(again);
  settle();
  QFile first(path), second(again);
  ASSERT_TRUE(first.open(QIODevice::ReadOnly));
  ASSERT_TRUE(second.open(QIODevice::ReadOnly));
  const QByteArray bytes = first.readAll();
  EXPECT_GT(bytes.size(), 1000);
  EXPECT_EQ(bytes, second.readAll());
}

TEST_F(BrushWindow, WhatCannotBeOpenedIsToldAndTheSheetStays) {
  write_stroke();
  window_->open_files({folder_.filePath(QStringLiteral("missing.nzs"))});
  settle();
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Could not open missing.nzs: ")))
      << feedback().toStdString();
  EXPECT_EQ(state().strokes, 1);
  the_page->write(folder_.filePath(QStringLiteral("no/where.png")));
  settle();
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Could not save where.png: ")))
      << feedback().toStdString();
}

TEST_F(BrushWindow, StrokesAreSavedAsSvgAndTheSheetAsPdf) {
  const auto bytes = [this](const char* name) {
    QFile file(folder_.filePath(QString::fromLatin1(name)));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
    return file.readAll();
  };
  the_page->write(folder_.filePath(QStringLiteral("none.svg")));
  settle();
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Could not save none.svg: "))) << feedback().toStdString();
  write_stroke();
  the_page->write(folder_.filePath(QStringLiteral("one.svg")));
  settle();
  EXPECT_EQ(feedback(), QStringLiteral("Saved one.svg."));
  EXPECT_EQ(bytes("one.svg").count("<path "), 1);
  the_page->write(folder_.filePath(QStringLiteral("one.pdf")));
  settle();
  EXPECT_EQ(feedback(), QStringLiteral("Saved one.pdf."));
  EXPECT_TRUE(bytes("one.pdf").startsWith("%PDF-"));
}

TEST_F(BrushWindow, AdviceIsShownAndSpokenAndTheSameKeyTakesItAway) {
  key(Qt::Key_J);
  EXPECT_EQ(feedback(), QStringLiteral("Write a character first. Then J gives advice."));
  EXPECT_FALSE(action("brush_advice")->isChecked());
  write_stroke(0.3);
  write_stroke(0.7);
  EXPECT_FALSE(find("brush_advice_words")->isVisible());
  const QImage written = paper()->picture();
  key(Qt::Key_J);
  EXPECT_TRUE(action("brush_advice")->isChecked());
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Advice: "))) << feedback().toStdString();
  EXPECT_TRUE(find("brush_advice_words")->isVisible());
  EXPECT_EQ(
      QStringLiteral("Advice: ") + text("brush_advice_words").replace(QLatin1Char('\n'), QLatin1Char(' ')),
      feedback());
  key(Qt::Key_J);
  EXPECT_FALSE(find("brush_advice_words")->isVisible());
  EXPECT_EQ(feedback(), QStringLiteral("The corrections are gone."));
  EXPECT_TRUE(paper()->marks().empty());
}

class BrushWindowWithBar : public BrushWindow {
 protected:
  /// 一 as the model, with a bar that is too short, and corrections.
  void SetUp() override {
    BrushWindow::SetUp();
    auto* line = find<QLineEdit>("brush_text");
    line->setText(QStringLiteral("一"));
    emit line->textEdited(line->text());
    // The strokes of the model come from another thread.
    wait_until([this] {
      const QColor seen = paper()->grab().toImage().pixelColor(on_paper(0.45, 0.475));
      return seen.red() - seen.blue() > 40;
    });
    settle();
    write_stroke(0.3);
    key(Qt::Key_J);
    ASSERT_FALSE(paper()->marks().empty()) << feedback().toStdString();
  }
};

TEST_F(BrushWindowWithBar, CorrectionsAreDrawnOverTheSheetAndAreNoPartOfIt) {
  EXPECT_TRUE(text("brush_advice_words").contains(QStringLiteral("The character is too high.")))
      << text("brush_advice_words").toStdString();
  const auto vermilion = [this] {
    const QImage seen = paper()->grab().toImage();
    int pixels = 0;
    for (int y = 0; y < seen.height(); ++y)
      for (int x = 0; x < seen.width(); ++x) {
        const QColor colour = seen.pixelColor(x, y);
        pixels += colour.red() > 180 && colour.green() < 110 && colour.blue() < 90 ? 1 : 0;
      }
    return pixels;
  };
  EXPECT_GT(vermilion(), 50);
  const QString before = folder_.filePath(QStringLiteral("with.png"));
  the_page->write(before);
  settle();
  key(Qt::Key_J);
  EXPECT_EQ(vermilion(), 0);
  const QString after = folder_.filePath(QStringLiteral("without.png"));
  the_page->write(after);
  settle();
  const QImage with(before), without(after);
  for (int y = 0; y < with.height(); y += 3)
    for (int x = 0; x < with.width(); x += 3) {
      const QColor colour = with.pixelColor(x, y);
      ASSERT_LT(colour.red() - colour.green(), 60) << x << ' ' << y;
    }
  EXPECT_FALSE(without.isNull());
}

TEST_F(BrushWindowWithBar, UndoRedoANewSheetANewStrokeAndAnotherModelTakeCorrectionsAway) {
  const auto gone_after = [this](const std::function<void()>& act) {
    if (!action("brush_advice")->isChecked()) key(Qt::Key_J);
    ASSERT_FALSE(paper()->marks().empty()) << feedback().toStdString();
    act();
    settle();
    EXPECT_TRUE(paper()->marks().empty());
    EXPECT_FALSE(action("brush_advice")->isChecked());
    EXPECT_FALSE(find("brush_advice_words")->isVisible());
  };
  gone_after([this] { key(Qt::Key_Z, Qt::ControlModifier); });
  key(Qt::Key_Y, Qt::ControlModifier);
  gone_after([this] { write_stroke(0.8); });
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Y, Qt::ControlModifier);
  gone_after([this] { key(Qt::Key_3); });
  gone_after([this] { key(Qt::Key_Y, Qt::ControlModifier); });
  gone_after([this] { key(Qt::Key_N, Qt::ControlModifier); });
}

TEST_F(BrushWindow, APictureIsSavedAsPng) {
  the_page->write(folder_.filePath(QStringLiteral("one.png")));
  settle();
  EXPECT_EQ(QImage(folder_.filePath(QStringLiteral("one.png"))).size(), QSize(1024, 1024));
}

TEST_F(BrushWindow, ThePageComesBackAsItWasLeft) {
  write_stroke();
  press(Qt::Key_1, Qt::AltModifier);
  EXPECT_TRUE(find("tablet")->isVisible());
  EXPECT_FALSE(paper()->isVisible());
  press(Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(paper()->isVisible());
  EXPECT_EQ(state().strokes, 1);
  EXPECT_GT(darkness(0.5, 0.5), 80);
}

TEST_F(BrushWindow, LeavingThePageEndsTheStroke) {
  QTest::mousePress(paper(), Qt::LeftButton, {}, on_paper(0.3, 0.5));
  wait_until([&] { return state().is_writing; });
  press(Qt::Key_1, Qt::AltModifier);
  wait_until([&] { return !state().is_writing; });
  QTest::mouseRelease(paper(), Qt::LeftButton, {}, on_paper(0.3, 0.5));
}

TEST_F(BrushWindow, InkWaterAndClothByKeyAndByButton) {
  key(Qt::Key_W);
  EXPECT_EQ(feedback(), QStringLiteral("Dipped in water: the ink is paler."));
  EXPECT_EQ(text("brush_words"), QStringLiteral("Brush: 100% full, ink 50%."));
  find<QPushButton>("button_brush_wipe")->click();
  settle();
  EXPECT_EQ(text("brush_words"), QStringLiteral("Brush: 50% full, ink 50%."));
  EXPECT_EQ(find("ink_gauge")->accessibleDescription(), text("brush_words"));
  key(Qt::Key_I);
  EXPECT_EQ(text("brush_words"), QStringLiteral("Brush: 100% full, ink 81%."));
}

TEST_F(BrushWindow, ABrushThatRunsDryIsToldOnce) {
  for (int i = 0; i < 4; ++i) key(Qt::Key_X);
  EXPECT_EQ(feedback(), QStringLiteral("The brush is almost dry. I: dip it in ink."));
  key(Qt::Key_S);
  key(Qt::Key_X);
  EXPECT_EQ(feedback(), QStringLiteral("Wiped: half of the ink is gone."));
}

TEST_F(BrushWindow, InkAndPaperAreChosenInTheirBoxes) {
  const auto choose = [this](const char* name, const char* data) {
    auto* box = find<QComboBox>(name);
    box->setCurrentIndex(box->findData(QString::fromLatin1(data)));
    emit box->activated(box->currentIndex());
    settle();
  };
  choose("brush_ink_box", "vermilion");
  EXPECT_EQ(state().ink, "vermilion");
  EXPECT_EQ(feedback(), QStringLiteral("Ink: Vermilion."));
  choose("brush_paper_box", "water");
  EXPECT_EQ(state().paper, "water");
  EXPECT_EQ(find<QComboBox>("brush_ink_box")->currentText(), QStringLiteral("Water only"));
  EXPECT_EQ(feedback(),
            QStringLiteral("New sheet: Water paper (fades as it dries). Ctrl+Z brings the old one back."));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(find<QComboBox>("brush_paper_box")->currentText(), QStringLiteral("Hanshi (practice paper)"));
}

TEST_F(BrushWindow, ARulingTakesTheBrushThatFitsIt) {
  EXPECT_EQ(state().brush.size, calligraphy::BrushSize::medium);
  key(Qt::Key_R);
  EXPECT_EQ(find<QComboBox>("brush_ruling_box")->currentData().toInt(), 2);
  EXPECT_EQ(state().brush.size, calligraphy::BrushSize::small);
  key(Qt::Key_BracketRight);
  EXPECT_EQ(state().brush.size, calligraphy::BrushSize::medium);
  EXPECT_EQ(feedback(), QStringLiteral("Brush: Medium, Mixed."));
}

TEST_F(BrushWindow, AScreenReaderHearsWhatIsOnThePaper) {
  write_stroke();
  key(Qt::Key_S);
  EXPECT_TRUE(feedback().startsWith(
      QStringLiteral("1 stroke, wet. Hanshi (practice paper). Model beneath: 休. Brush: ")))
      << feedback().toStdString();
  EXPECT_TRUE(paper()->accessibleDescription().startsWith(QStringLiteral("1 stroke, wet.")));
  EXPECT_EQ(paper()->accessibleName(), QStringLiteral("Sheet of paper"));
  key(Qt::Key_D);
  EXPECT_EQ(feedback(), QStringLiteral("The sheet is dry."));
  EXPECT_TRUE(paper()->accessibleDescription().startsWith(QStringLiteral("1 stroke, dry.")));
}

TEST_F(BrushWindow, EveryControlHasAName) {
  for (auto* widget : find("brush_tools_panel")->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || widget->objectName().startsWith(QLatin1String("qt_")))
      continue;
    if (!widget->isVisibleTo(find("brush_tools_panel"))) continue;
    auto* spoken = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(spoken, nullptr);
    EXPECT_FALSE(spoken->text(QAccessible::Name).isEmpty()) << widget->objectName().toStdString();
  }
}

TEST_F(BrushWindow, TypedTextIsTheModelInParts) {
  key(Qt::Key_T);
  auto* line = find<QLineEdit>("brush_text");
  EXPECT_TRUE(line->hasFocus());
  line->clear();
  QTest::keyClicks(line, QString());
  line->setText(QStringLiteral("一日"));
  emit line->textEdited(line->text());
  EXPECT_EQ(text("model_words"), QStringLiteral("Model beneath: 一. Part 1 of 2."));
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_TRUE(paper()->hasFocus());
  key(Qt::Key_Period);
  EXPECT_EQ(feedback(), QStringLiteral("Model beneath: 日. Part 2 of 2."));
  key(Qt::Key_3);
  EXPECT_EQ(feedback(), QStringLiteral("Model beside: 日. Part 2 of 2."));
  key(Qt::Key_1);
  EXPECT_EQ(feedback(), QStringLiteral("No model."));
}

TEST_F(BrushWindow, TheModelBesideLeavesRoomForTheSheet) {
  const double alone = paper()->place().rect.width();
  key(Qt::Key_3);
  EXPECT_LT(paper()->place().rect.width(), alone);
  EXPECT_GT(paper()->place().rect.width(), 0.5 * alone);
  EXPECT_TRUE(QRectF(paper()->rect()).contains(paper()->place().rect));
}

TEST_F(BrushWindow, ChoicesAreThereAgainAfterARestart) {
  key(Qt::Key_3);
  key(Qt::Key_R);
  key(Qt::Key_H);
  find<QCheckBox>("box_brush_left_hand")->click();
  window_->close();
  window_ = std::make_unique<MainWindow>(setup(), appearance_);
  window_->show();
  settle();
  EXPECT_TRUE(action("brush_model_beside")->isChecked());
  EXPECT_TRUE(action("brush_left_hand")->isChecked());
  EXPECT_EQ(find<QComboBox>("brush_ruling_box")->currentData().toInt(), 2);
  EXPECT_EQ(state().brush.hair, brush::Hair::weasel);
  EXPECT_EQ(state().brush.size, calligraphy::BrushSize::small);
}

TEST_F(BrushWindow, APenPressesByItsPressureAndItsOtherEndUndoes) {
  const QPointingDevice pen(QStringLiteral("pen"), 7, QInputDevice::DeviceType::Stylus,
                            QPointingDevice::PointerType::Pen,
                            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure |
                                QInputDevice::Capability::XTilt | QInputDevice::Capability::YTilt,
                            1, 2);
  const QPointingDevice eraser(QStringLiteral("eraser"), 8, QInputDevice::DeviceType::Stylus,
                               QPointingDevice::PointerType::Eraser, QInputDevice::Capability::Position, 1,
                               2);
  const auto send = [&](QEvent::Type type, const QPointingDevice& device, double x, double y, double pressure,
                        Qt::MouseButton button) {
    const QPointF at = on_paper(x, y);
    QTabletEvent event(type, &device, at, paper()->mapToGlobal(at), pressure, 20, 10, 0, 0, 0, {}, button,
                       Qt::LeftButton);
    event.setTimestamp(static_cast<quint64>(ms_ += 15));
    QCoreApplication::sendEvent(paper(), &event);
  };
  const auto stroke = [&](double y, double pressure) {
    const int before = state().strokes;
    send(QEvent::TabletPress, pen, 0.2, y, pressure, Qt::LeftButton);
    for (int i = 1; i <= 30; ++i) send(QEvent::TabletMove, pen, 0.2 + 0.02 * i, y, pressure, Qt::NoButton);
    send(QEvent::TabletRelease, pen, 0.8, y, 0, Qt::LeftButton);
    wait_until([&] { return state().strokes == before + 1 && !state().is_writing; });
  };
  const auto width = [&](double y) {
    int dark = 0;
    for (double at = y - 0.15; at < y + 0.15; at += 0.002) dark += darkness(0.5, at) > 90 ? 1 : 0;
    return dark;
  };
  stroke(0.25, 0.15);
  stroke(0.7, 0.8);
  EXPECT_GT(width(0.7), 1.4 * width(0.25));
  send(QEvent::TabletPress, eraser, 0.5, 0.5, 1, Qt::LeftButton);
  wait_until([&] { return state().strokes == 1; });
}

TEST_F(BrushWindow, ASheetThatIsNotSavedIsAskedAboutOnClosing) {
  write_stroke();
  QString asked;
  const auto answer = [&](const QString& words) {
    QTimer::singleShot(0, window_.get(), [&, words] {
      auto* box = window_->findChild<QMessageBox*>(QStringLiteral("unsaved_sheet_box"));
      ASSERT_NE(box, nullptr);
      asked = box->text();
      for (auto* button : box->buttons())
        if (button->text() == words) button->click();
    });
  };
  answer(QStringLiteral("Go back"));
  EXPECT_FALSE(window_->close());
  EXPECT_EQ(asked, QStringLiteral("The sheet with your brush writing is not saved."));
  answer(QStringLiteral("Do not save"));
  EXPECT_TRUE(window_->close());
}

TEST_F(BrushWindow, TheSheetIsCarvedAsATabletOfTheLearnersOwn) {
  write_stroke();
  press(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  wait_until([this] { return find("tablet")->isVisible(); });
  EXPECT_EQ(window_->windowTitle(), QStringLiteral("Brush sheet – Nazori"));
}

TEST_F(BrushWindow, ThePanelHoldsTheLargestTextInBothLanguages) {
  for (const char* language : {"en", "ja"}) {
    press(Qt::Key_1, Qt::AltModifier);  // the window opens with the page that was shown last
    window_->close();
    install_language(QString::fromLatin1(language));
    open_window();
    press(Qt::Key_2, Qt::AltModifier);
    settle();
    for (const int text_pt : {Preferences::kMinText_pt, Preferences::kMaxText_pt}) {
      for (const int width : {800, 1600}) {
        set_text_size(text_pt, width, 800);
        const auto* area = find<QScrollArea>("brush_tools_panel");
        const QWidget* content = area->widget();
        EXPECT_TRUE(QTest::qWaitFor([&] { return content->width() <= area->viewport()->width(); }))
            << content->width() << " in " << area->viewport()->width() << ' ' << width << ' ' << text_pt
            << ' ' << language;
        EXPECT_GE(paper()->place().rect.width(), 150) << width << ' ' << text_pt;
        for (const auto* child : content->findChildren<QWidget*>())
          if (child->isVisible()) {
            EXPECT_LE(child->mapTo(content, QPoint(child->width(), 0)).x(), content->width())
                << child->objectName().toStdString();
          }
      }
    }
  }
  install_language(QStringLiteral("en"));
}

TEST_F(BrushWindow, NoKeyIsGivenTwice) {
  QStringList keys;
  for (const auto* entry : window_->findChildren<QAction*>())
    if (entry->isVisible())
      for (const auto& shortcut : entry->shortcuts()) keys.append(shortcut.toString());
  EXPECT_GT(keys.size(), 30);
  QStringList twice = keys;
  EXPECT_EQ(twice.removeDuplicates(), 0) << keys.join(QLatin1Char(' ')).toStdString();
}

}  // namespace
}  // namespace nazori::ui
