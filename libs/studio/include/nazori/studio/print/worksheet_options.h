// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "nazori/practice/worksheet_choice.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;
class QPlainTextEdit;
class QSpinBox;

namespace nazori::ui {

class ListChoice;

/// The options of a worksheet as a form. Only what has an effect on the chosen kind of sheet is shown.
class WorksheetOptions final : public QWidget {
  Q_OBJECT
 public:
  /// @param store  for the learner's own lists. @param shown  the character that is shown; 0: none.
  WorksheetOptions(const study::LearnerStore& store, char32_t shown, QWidget* parent);

  void set_choice(const practice::WorksheetChoice& choice);
  [[nodiscard]] practice::WorksheetChoice choice() const;

 signals:
  /// The learner changed something.
  void changed();

 private:
  QComboBox* add_box(const char* name, const QString& text, const QStringList& entries);
  QSpinBox* add_spin(const char* name, const QString& text, int low, int high, const QString& unit);
  QCheckBox* add_check(const char* name, const QString& text);
  void show_what_matters();
  void note_change();

  char32_t shown_;
  QFormLayout* form_;
  QComboBox *source_, *layout_;
  ListChoice* list_;
  QPlainTextEdit* text_;
  QComboBox *paper_, *guide_, *per_sheet_, *language_;
  QSpinBox *cell_, *rows_, *copies_;
  QCheckBox *whole_page_, *steps_, *numbers_, *arrows_, *facts_, *answers_;
  QCheckBox *vertical_, *booklet_, *name_line_;
  QLineEdit* title_;
};

}  // namespace nazori::ui
