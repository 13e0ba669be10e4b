// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>

#include "feedback_line.h"
#include "nazori/practice/traced_ink.h"

namespace nazori::ui {

class TabletController;

/// Finds the words for what happens on the tablet: short, kind, exact.
class StrokeTeller {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::StrokeTeller)
 public:
  struct Sentence {
    Feedback kind = Feedback::hint;
    QString text;  ///< empty: nothing worth saying
  };

  [[nodiscard]] static Sentence invitation(const TabletController& controller);
  [[nodiscard]] static Sentence about(practice::TraceEvent event, int stroke,
                                      const TabletController& controller);
  /// Whether it is a mistake. Going on where a bit of a stroke begun before is missing is none.
  [[nodiscard]] static bool is_miss(practice::TraceEvent event, const TabletController& controller);
  [[nodiscard]] static Sentence snapping(const TabletController& controller);
  [[nodiscard]] static Sentence stroke_shown(const TabletController& controller);

 private:
  [[nodiscard]] static bool is_left_open(int stroke, const TabletController& controller);
};

}  // namespace nazori::ui
