// SPDX-License-Identifier: Apache-2.0
#include "characters/stroke_counter.h"

#include <QEvent>
#include <QFontInfo>
#include <algorithm>

#include "nazori/practice/tablet_control.h"

namespace nazori::ui {
namespace {

constexpr int kMostStrokes = 28;

}  // namespace

StrokeCounter::StrokeCounter(const practice::TabletControl& controller) : controller_(controller) {
  setObjectName(QStringLiteral("stroke_label"));
  setAlignment(Qt::AlignCenter);
  fit();
}

void StrokeCounter::refresh() {
  const int count = controller_.stroke_count();
  const int current = controller_.current_stroke();
  if (count == 0)
    setText(tr("no strokes"));
  else if (current == 0)
    setText(tr("all %n strokes", nullptr, count));
  else
    setText(tr("stroke %1 of %2").arg(current).arg(count));
}

void StrokeCounter::changeEvent(QEvent* event) {
  QLabel::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void StrokeCounter::fit() {
  const QFontMetrics metrics(font());
  setMinimumWidth(
      std::max(metrics.horizontalAdvance(tr("stroke %1 of %2").arg(kMostStrokes).arg(kMostStrokes)),
               metrics.horizontalAdvance(tr("all %n strokes", nullptr, kMostStrokes))) +
      QFontInfo(font()).pixelSize());
}

}  // namespace nazori::ui
