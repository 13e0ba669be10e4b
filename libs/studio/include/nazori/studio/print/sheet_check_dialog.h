// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <memory>
#include <utility>
#include <vector>

#include "nazori/practice/worksheet_reader.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace nazori::ui {

class PhotoView;
class SpokenLine;
class WindowParts;

/// Check worksheets: reads photographs of printed sheets, shows what was found in each cell, and lists the
/// cells that need care.
class SheetCheckDialog final : public QDialog {
  Q_OBJECT
 public:
  SheetCheckDialog(WindowParts& parts, QWidget* parent);
  ~SheetCheckDialog() override;

  /// Reads photographs, one after the other; they are added to those that were read.
  void read(const QStringList& photos);
  /// Saves the picture that is shown without asking for a name.
  void save(const QString& path);
  /// Whether everything that was asked for is done.
  [[nodiscard]] bool is_idle() const { return reader_.waiting() == 0; }

 protected:
  void done(int result) override;

 private:
  void show_read(const std::shared_ptr<const practice::WorksheetsRead>& photo);
  void show_photo(int number);
  void mark_cell(int row);
  void say(const QString& sentence, bool wrong);
  void ask_photos();
  void ask_and_save();

  WindowParts& parts_;
  QComboBox* photos_;
  QListWidget* cells_;
  PhotoView* view_;
  QLabel* words_;
  QPushButton *open_, *save_;
  SpokenLine* spoken_;
  std::vector<std::shared_ptr<const practice::WorksheetsRead>> read_;
  std::vector<const scan::CellReading*> listed_;  ///< the cells of the list
  practice::WorksheetReader reader_;              // declared last, so that its thread ends first
};

/// Asks for photographs and opens the dialog above the window.
void ask_sheet_check(WindowParts& parts);

}  // namespace nazori::ui
