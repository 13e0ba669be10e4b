// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>

#include "nazori/practice/chart.h"
#include "nazori/study/statistics.h"
#include "nazori/widgets/charts/chart_text.h"

namespace nazori::ui {

/// The words of a learner's statistics and of their charts. Pure: no widget.
class StudyCharts {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::StudyCharts)
 public:
  /// Title, summary, names and numbers of a chart.
  [[nodiscard]] static ChartText text(const practice::Chart& chart);
  /// "forecast": never translated.
  [[nodiscard]] static QString id(practice::ChartId chart);
  /// What the menu calls a chart, with its mnemonic: "Up&coming reviews".
  [[nodiscard]] static QString menu_text(practice::ChartId chart);
  /// What its menu item does: "Go to the upcoming reviews".
  [[nodiscard]] static QString menu_tip(practice::ChartId chart);
  /// The hardest strokes as numbers only.
  [[nodiscard]] static Numbers hard_strokes(const study::Statistics& statistics);

  /// "wrong shape 3, wrong turn 1".
  [[nodiscard]] static QString mistakes(const study::HardStroke& stroke);
  [[nodiscard]] static QString mistake(kanji::MistakeKind kind);
  [[nodiscard]] static QString strength(study::Strength strength);
  /// "12.5", "91 %".
  [[nodiscard]] static QString number(double value, practice::NumberFormat format);
  /// "91 %".
  [[nodiscard]] static QString percent(double share);
  /// "20 Nov 2026".
  [[nodiscard]] static QString date(study::Day day);
  /// "8 h 20 min".
  [[nodiscard]] static QString duration(std::chrono::milliseconds time);
};

}  // namespace nazori::ui
