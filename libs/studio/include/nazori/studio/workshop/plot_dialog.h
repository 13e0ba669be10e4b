// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <array>
#include <memory>

#include "nazori/functions/plot_model.h"
#include "nazori/functions/plotter.h"
#include "nazori/surface/height_map.h"

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace nazori::ui {

class SpokenLine;

/// Asks for an expression and a range, and draws the plot. The dialog is accepted once the plot is drawn;
/// what cannot be read or drawn is said in it, and it stays open.
class PlotDialog final : public QDialog {
  Q_OBJECT
 public:
  /// @param inbox  of this thread; outlives this. @param model  its range and settings are proposed.
  /// @param side  samples per side of the relief.
  PlotDialog(base::Inbox& inbox, functions::PlotModel model, const QString& expression, int side,
             QWidget* parent);
  ~PlotDialog() override;

  /// The expression that was drawn, as it was typed.
  [[nodiscard]] QString expression() const;
  /// The plot as a relief; null until the dialog is accepted.
  [[nodiscard]] const std::shared_ptr<const surface::HeightMap>& relief() const { return relief_; }

 private:
  /// A picture on the way to the relief.
  struct Drawn {
    std::shared_ptr<const surface::HeightMap> relief;
    bool is_final = false;
  };

  void read_expression();
  /// Reads the range; says what is wrong with it. @return whether it can be shown.
  bool read_range();
  void draw();
  void stop();
  void say(const QString& sentence, bool wrong);

  functions::PlotModel model_;
  int side_;
  QLineEdit* line_;
  std::array<QLineEdit*, 4> borders_{};  ///< x from, x to, y from, y to
  QLabel* words_;
  QProgressBar* progress_;
  QPushButton* draw_;
  SpokenLine* spoken_;
  QString error_;  ///< why the expression cannot be read; empty where it can
  std::shared_ptr<const surface::HeightMap> relief_;
  functions::Plotter<Drawn> plotter_;  // declared last, so that its thread ends first
};

}  // namespace nazori::ui
