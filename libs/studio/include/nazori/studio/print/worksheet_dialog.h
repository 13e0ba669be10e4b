// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDialog>
#include <QTimer>

#include "nazori/practice/worksheet_maker.h"

class QBoxLayout;
class QLabel;
class QProgressDialog;
class QPushButton;
class QScrollArea;

namespace nazori::ui {

class PageView;
class SpokenLine;
class WindowParts;
class WorksheetOptions;

/// Print a worksheet: what and how, the pages as they will be printed, and a button that saves them as PDF.
/// The choice is stored for the next time.
class WorksheetDialog final : public QDialog {
  Q_OBJECT
 public:
  /// @param shown  the character that is shown to the learner; 0: none, or it must not be revealed.
  WorksheetDialog(WindowParts& parts, char32_t shown, QWidget* parent);
  ~WorksheetDialog() override;

  /// The page that is shown, from 0.
  [[nodiscard]] std::size_t page() const { return page_; }
  /// Writes the worksheet without asking for a name.
  void save(const QString& path);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void done(int result) override;

 private:
  void load();
  void store_choice() const;
  void choose_later();
  void request();
  void turn(int pages);
  void show_view(const practice::WorksheetView& view);
  void show_refusal(const base::Error& error, std::size_t characters);
  void show_page_buttons();
  void say(const QString& sentence, bool wrong);
  void fit_options();
  void ask_and_save();
  void end_work();

  WindowParts& parts_;
  WorksheetOptions* options_;
  PageView* view_;
  QScrollArea* area_;  ///< of the options
  QBoxLayout* sides_;
  QPushButton *previous_, *next_, *save_;
  QLabel *number_, *words_;
  SpokenLine* spoken_;
  QProgressDialog* work_ = nullptr;
  QTimer soon_;  ///< several changes in a row ask for one picture
  std::size_t page_ = 0;
  std::size_t pages_ = 0;
  practice::WorksheetRequest request_;
  practice::WorksheetMaker maker_;  // declared last, so that its thread ends first
};

/// Opens the dialog above the window.
void ask_worksheet(WindowParts& parts);

}  // namespace nazori::ui
