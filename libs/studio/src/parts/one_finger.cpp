// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/parts/one_finger.h"

#include <QTouchEvent>
#include <utility>

namespace nazori::ui {
namespace {

constexpr int kPenGone_ms = 500;  ///< the palm leaves this long after the pen

}  // namespace

std::optional<OneFinger::Move> OneFinger::take(const QTouchEvent& event,
                                               const std::function<bool(QPointF)>& writes,
                                               const std::function<void()>& lose) {
  const bool pen_is_near = since_pen_.isValid() && since_pen_.elapsed() < kPenGone_ms;
  const auto& points = event.points();
  int fingers = 0;
  for (const auto& point : points) fingers += point.state() != QEventPoint::Released ? 1 : 0;
  if (pen_is_near || event.type() == QEvent::TouchCancel || points.isEmpty() || fingers > 1) {
    if (std::exchange(writes_, false)) lose();
    return {};
  }
  const QPointF at = points.front().position();
  if (event.type() == QEvent::TouchBegin) writes_ = writes(at);
  if (!writes_) return {};
  writes_ = fingers == 1;
  return Move{at, writes_};
}

}  // namespace nazori::ui
