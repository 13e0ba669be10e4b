// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLineEdit>
#include <QMouseEvent>
#include <functional>
#include <memory>

#include "characters/characters.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/brush/paper_view.h"
#include "window_under_test.h"

namespace nazori::ui {

/// The page of the window under test.
inline BrushPage* the_page = nullptr;
inline std::unique_ptr<Page> make_brush(WindowParts& parts) {
  auto page = std::make_unique<BrushPage>(parts);
  the_page = page.get();
  return page;
}

class BrushWindow : public WindowTest {
 protected:
  BrushWindow() {
    pages_ = {[](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); },
              make_brush};
  }
  void SetUp() override {
    WindowTest::SetUp();
    press(Qt::Key_2, Qt::AltModifier);
    ASSERT_NE(the_page->writing(), nullptr);
    settle();
  }
  void TearDown() override {
    window_.reset();
    the_page = nullptr;
  }

  PaperView* paper() { return find<PaperView>("paper_view"); }
  const calligraphy::SheetState& state() { return the_page->writing()->state(); }
  void wait_until(const std::function<bool()>& met) {
    EXPECT_TRUE(QTest::qWaitFor(met, 20000)) << feedback().toStdString();
  }
  /// Waits for what was asked of the other thread.
  void settle() {
    wait_until([] { return !the_page->writing()->is_waiting(); });
  }
  void key(Qt::Key which, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    press(which, modifiers);
    settle();
  }

  /// A place on the sheet by shares of its side.
  QPoint on_paper(double x, double y) {
    const QRectF sheet = paper()->place().rect;
    return QPointF(sheet.left() + x * sheet.width(), sheet.top() + y * sheet.height()).toPoint();
  }
  void send_mouse(QEvent::Type type, QPoint at, Qt::MouseButton button) {
    QMouseEvent event(type, at, paper()->mapToGlobal(at), button,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    event.setTimestamp(static_cast<quint64>(ms_ += 25));
    QCoreApplication::sendEvent(paper(), &event);
  }
  void write_stroke(double y = 0.5) {
    const int before = state().strokes;
    send_mouse(QEvent::MouseButtonPress, on_paper(0.25, y), Qt::LeftButton);
    constexpr int kMoves = 60;
    for (int i = 1; i <= kMoves; ++i)
      send_mouse(QEvent::MouseMove, on_paper(0.25 + 0.5 * i / kMoves, y), Qt::NoButton);
    send_mouse(QEvent::MouseButtonRelease, on_paper(0.75, y), Qt::LeftButton);
    wait_until([&] { return state().strokes == before + 1 && !state().is_writing; });
    settle();
  }
  /// Types the text of the model and waits until its strokes are known.
  void take_model(const QString& text) {
    auto* line = find<QLineEdit>("brush_text");
    line->setText(text);
    emit line->textEdited(text);
    wait_until([&] { return paper()->accessibleDescription().contains(text) && !paper()->model().empty(); });
    settle();
  }
  /// How dark the sheet is there, 0 paper to 255.
  int darkness(double x, double y) {
    const QImage& picture = paper()->picture();
    return 255 - qGray(picture.pixel(static_cast<int>(x * picture.width()),
                                     static_cast<int>(y * picture.height())));
  }

  qint64 ms_ = 1'000'000;
};

}  // namespace nazori::ui
