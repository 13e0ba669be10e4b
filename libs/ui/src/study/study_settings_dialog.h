// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>

#include "nazori/practice/learner.h"
#include "nazori/study/pace.h"
#include "nazori/widgets/settings/preferences.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QSpinBox;
class QTabWidget;

namespace nazori::ui {

class NumberSlider;

/// How much, what, when and how a learner wants to study. A new list is saved at once, everything else when
/// the dialog is accepted.
class StudySettingsDialog final : public QDialog {
  Q_OBJECT
 public:
  StudySettingsDialog(practice::Learner& learner, const Preferences& preferences, QWidget* parent);

  /// The settings as chosen.
  [[nodiscard]] study::Settings settings() const;
  /// Writes the settings that concern the window.
  void fill(Preferences& preferences) const;

 private:
  static constexpr int kButtonGap_px = 6;

  QWidget* make_amount();
  QWidget* make_lists();
  QWidget* make_schedule();
  QWidget* make_window(const Preferences& preferences);
  QWidget* add_page(const QString& name);
  QSpinBox* add_spin(QWidget* page, const QString& name, const char* object, int low, int high, int value);
  QCheckBox* add_check(QWidget* page, const QString& name, const char* object, bool on);
  void show_workload();
  void show_lists();
  void show_choice();
  void show_weights();
  void new_list();
  void mark_known();
  void remove_list();
  void move_list(int by);
  void import_weights();
  /// Calls `what` with every character of the current list, and shows the sentence of `done`.
  void for_list(const std::function<base::Result<void>(std::span<const char32_t>)>& what,
                const std::function<QString(int)>& done);
  [[nodiscard]] QString current_list() const;
  [[nodiscard]] std::vector<std::string> chosen_lists() const;

  practice::Learner& learner_;
  study::Settings before_;
  study::Pace pace_;  ///< for the expected workload
  study::FsrsWeights weights_;
  QTabWidget* tabs_;
  NumberSlider* retention_;
  QLabel* workload_;
  QSpinBox *new_, *reviews_, *brush_, *day_starts_;
  QComboBox* zone_;
  QComboBox* order_;
  QListWidget* lists_;
  QLabel* choice_;
  QCheckBox *fuzz_, *balance_;
  QSpinBox *leech_, *hint_, *show_;
  QLabel* weights_words_;
  QCheckBox *by_words_, *at_home_, *left_handed_;
  QComboBox* one_hand_;
};

}  // namespace nazori::ui
