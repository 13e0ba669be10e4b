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
#include "nazori/widgets/page/window_parts.h"
#include "window_under_test.h"

namespace nazori::ui {

/// The page of the window under test.
inline WorkshopPage* workshop = nullptr;
inline WindowParts* workshop_parts = nullptr;
inline std::unique_ptr<Page> make_workshop(WindowParts& parts) {
  auto page = std::make_unique<WorkshopPage>(parts);
  workshop = page.get();
  workshop_parts = &parts;
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
    workshop_parts = nullptr;
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
  /// Waits until every file is read or written.
  static void finish_files() {
    ASSERT_TRUE(QTest::qWaitFor([] { return !workshop->is_busy_with_files(); }, 20000));
  }
  void press_and_finish(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    press(key, modifiers);
    finish_files();
  }
  void write(const QString& path) {
    workshop->write(path);
    finish_files();
  }
  void open(const QString& path) {
    workshop->open_files({path});
    finish_files();
  }
  /// Presses a button of the next question, as soon as it is asked.
  void answer_with(const QString& text) {
    auto* again = new QTimer(this->window_.get());
    QObject::connect(again, &QTimer::timeout, again, [text, again] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box == nullptr) return;
      again->deleteLater();
      again->stop();
      for (auto* button : box->buttons())
        if (button->text() == text) return button->click();
      ADD_FAILURE() << "no button " << text.toStdString();
    });
    again->start(0);
  }

  int ms_ = 1000;
};

}  // namespace nazori::ui
