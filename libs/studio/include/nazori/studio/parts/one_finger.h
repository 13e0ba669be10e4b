// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QPointF>
#include <functional>
#include <optional>

class QTouchEvent;

namespace nazori::ui {

/// Lets one finger write: not a second one, and not the palm that lies beside a pen. Thread: interface.
class OneFinger {
 public:
  /// What a finger did.
  struct Move {
    QPointF at;
    bool down = false;
  };

  /// The pen was used: what touches now is the palm.
  void note_pen() { since_pen_.start(); }
  /// @param writes  whether a finger that comes down at a place writes. @param lose  is called where the
  /// finger must stop without a last position.
  /// @return nothing where no finger writes.
  [[nodiscard]] std::optional<Move> take(const QTouchEvent& event, const std::function<bool(QPointF)>& writes,
                                         const std::function<void()>& lose);

 private:
  QElapsedTimer since_pen_;
  bool writes_ = false;
};

}  // namespace nazori::ui
