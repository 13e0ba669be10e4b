// SPDX-License-Identifier: Apache-2.0
#include "focus_frame.h"

#include <QFocusEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "palette.h"

namespace nazori::ui {
namespace {

constexpr int kRing_px = 2;

}  // namespace

FocusFrame::FocusFrame(QWidget* inner, QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("tablet_frame"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kRing_px, kRing_px, kRing_px, kRing_px);
  column->addWidget(inner);
  inner->installEventFilter(this);
}

bool FocusFrame::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusIn) {
    const auto reason = static_cast<QFocusEvent*>(event)->reason();
    ring_ = reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason;
    update();
  } else if (event->type() == QEvent::FocusOut) {
    // The focus goes on into the window inside; the ring stays until another widget takes it.
    const auto reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason != Qt::ActiveWindowFocusReason && reason != Qt::OtherFocusReason) ring_ = false;
    update();
  }
  return QFrame::eventFilter(watched, event);
}

void FocusFrame::paintEvent(QPaintEvent* /*event*/) {
  if (!ring_) return;
  QPainter painter(this);
  painter.setPen(QPen(current_colours().indigo, 2 * kRing_px));
  painter.drawRect(rect());
}

}  // namespace nazori::ui
