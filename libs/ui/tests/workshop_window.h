// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAccessible>
#include <QMessageBox>
#include <QMouseEvent>
#include <QPushButton>
#include <QTimer>

#include "characters/characters.h"
#include "nazori/studio/workshop/character_canvas.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "window_under_test.h"

namespace nazori::ui {

/// The page of the window under test.
inline WorkshopPage* workshop = nullptr;
inline std::unique_ptr<Page> make_workshop(WindowParts& parts) {
  auto page = std::make_unique<WorkshopPage>(parts);
  workshop = page.get();
  return page;
}

class WorkshopWindow : public WindowTest {
 protected:
  WorkshopWindow() {
    pages_ = {[](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); },
              make_workshop};
  }
  void SetUp() override {
    WindowTest::SetUp();
    press(Qt::Key_2, Qt::AltModifier);
  }
  void TearDown() override {
    window_.reset();
    workshop = nullptr;
  }

  CharacterCanvas* canvas() { return find<CharacterCanvas>("character_canvas"); }
  const author::OwnCharacter& character() { return workshop->bench().character(); }
  void send(QEvent::Type type, geometry::GlyphPoint at, Qt::MouseButton button, Qt::MouseButtons held) {
    const QPointF place = canvas()->to_widget(at);
    QMouseEvent event(type, place, canvas()->mapToGlobal(place), button, held, {});
    event.setTimestamp(static_cast<quint64>(ms_ += 25));
    QCoreApplication::sendEvent(canvas(), &event);
  }
  void drag(geometry::GlyphPoint from, geometry::GlyphPoint to) {
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    constexpr int kMoves = 20;
    for (int i = 1; i <= kMoves; ++i)
      send(QEvent::MouseMove, from + (to - from) * (static_cast<double>(i) / kMoves), Qt::NoButton,
           Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  }
  void click(geometry::GlyphPoint at) {
    send(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton);
  }
  QString description() {
    return QAccessible::queryAccessibleInterface(canvas())->text(QAccessible::Description);
  }
  /// Presses a button of the question about unsaved work.
  void answer_with(const QString& text) {
    QTimer::singleShot(0, this->window_.get(), [text] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      for (auto* button : box->buttons())
        if (button->text() == text) return button->click();
      FAIL() << "no button " << text.toStdString();
    });
  }

  int ms_ = 1000;
};

}  // namespace nazori::ui
