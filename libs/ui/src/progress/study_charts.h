// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>

#include "nazori/study/periods.h"
#include "nazori/study/statistics.h"
#include "progress/chart.h"

namespace nazori::ui {

/// What a learner's statistics look like as charts, with their words. Pure: no widget.
class StudyCharts {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::StudyCharts)
 public:
  /// Reviews that fall due on each of 30 days.
  [[nodiscard]] static Chart forecast(const study::Statistics& statistics);
  /// Reviews and minutes of each day, week or month from `first` on.
  [[nodiscard]] static Chart activity(const study::Statistics& statistics, study::Day first);
  /// True and predicted retention.
  [[nodiscard]] static Chart retention(const study::Statistics& statistics, study::Day first);
  /// Speed and smoothness of the pen.
  [[nodiscard]] static Chart motion(const study::Statistics& statistics, study::Day first);
  /// The hardest strokes as numbers only.
  [[nodiscard]] static Numbers hard_strokes(const study::Statistics& statistics);

  /// "wrong shape 3, wrong turn 1".
  [[nodiscard]] static QString mistakes(const study::HardStroke& stroke);
  [[nodiscard]] static QString mistake(kanji::MistakeKind kind);
  [[nodiscard]] static QString strength(study::Strength strength);
  /// "91 %".
  [[nodiscard]] static QString percent(double share);
  /// "20 Nov 2026".
  [[nodiscard]] static QString date(study::Day day);
  /// "8 h 20 min".
  [[nodiscard]] static QString duration(std::chrono::milliseconds time);
};

}  // namespace nazori::ui
