// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/focus_frame.h"

#include <QApplication>
#include <QEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kRing_px = 2;

}  // namespace

FocusFrame::FocusFrame(QWidget* inner, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("tablet_frame"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kRing_px, kRing_px, kRing_px, kRing_px);
  column->addWidget(inner);
  qApp->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this, inner](QWidget* /*before*/, QWidget* now) {
    // No widget has the focus: it went to the window inside, or to another program.
    if (now == nullptr) return;
    inside_ = now == inner;
    update();
  });
}

bool FocusFrame::eventFilter(QObject* watched, QEvent* event) {
  const bool before = shows_ring();
  switch (event->type()) {
    case QEvent::ShortcutOverride:  // a shortcut never becomes a key press
    case QEvent::KeyPress:
      by_key_ = true;
      break;
    case QEvent::MouseButtonPress:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
      by_key_ = false;
      break;
    default:
      break;
  }
  if (shows_ring() != before) update();
  return QFrame::eventFilter(watched, event);
}

void FocusFrame::paintEvent(QPaintEvent* /*event*/) {
  if (!shows_ring()) return;
  QPainter painter(this);
  painter.setPen(QPen(current_colours().indigo, 2 * kRing_px));
  painter.drawRect(rect());
}

}  // namespace nazori::ui
