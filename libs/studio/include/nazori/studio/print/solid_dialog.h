// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QTimer>
#include <vector>

#include "nazori/practice/solid_maker.h"

class QBoxLayout;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSpinBox;

namespace nazori::ui {

class MachineOptions;
class ReliefView;
class SpokenLine;
class WindowParts;

/// What is made to be touched.
struct SolidSubject {
  QString name;  ///< of the file and of the object in it: "休", "y = sin(x)"
  std::vector<practice::LabelledTablet> tablets;  ///< empty for a plot
  functions::SharedDrawing plot;                  ///< null for tablets
};

/// Make a model to touch: how, how it looks from above, its figures, and a button that saves it for a
/// printer.
class SolidDialog final : public QDialog {
  Q_OBJECT
 public:
  SolidDialog(WindowParts& parts, SolidSubject subject, QWidget* parent);
  ~SolidDialog() override;

  /// Writes the model that is shown, or a file for a machine if the name ends as its files do, without asking
  /// for a name.
  void save(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void done(int result) override;

 private:
  [[nodiscard]] practice::SolidSettings settings() const;
  void load();
  void store_choice() const;
  void choose_later();
  void request();
  void show_what_matters();
  void show_view(const practice::SolidView& view);
  void say(const QString& sentence, bool wrong);
  void fit_options();
  [[nodiscard]] bool is_surface() const;
  [[nodiscard]] QStringList file_kinds() const;
  void ask_and_save();

  WindowParts& parts_;
  SolidSubject subject_;
  QComboBox* kind_;
  QSpinBox* size_;
  QCheckBox *numbers_, *dots_, *hole_, *mould_;
  MachineOptions* machines_ = nullptr;
  ReliefView* view_;
  QScrollArea* area_;  ///< of the options
  QBoxLayout* sides_;
  QLabel* words_;
  QPushButton* save_;
  SpokenLine* spoken_;
  QTimer soon_;  ///< several changes in a row ask for one model
  std::shared_ptr<const practice::Solid> solid_;
  practice::SolidMaker maker_;  // declared last, so that its thread ends first
};

/// Opens the dialog above the window.
void ask_solid(WindowParts& parts, SolidSubject subject);

}  // namespace nazori::ui
