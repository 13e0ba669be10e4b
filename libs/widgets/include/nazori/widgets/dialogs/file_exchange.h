// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QStringList>

#include "nazori/practice/tablet_workshop.h"
#include "nazori/widgets/words/feedback.h"

class QWidget;

namespace nazori::ui {

/// Opens and saves files: asks the learner, lets the workshop do the work, and announces the result in one
/// sentence. A file that cannot be opened leaves the tablet as it is.
class FileExchange final : public QObject {
  Q_OBJECT
 public:
  FileExchange(practice::TabletWorkshop* workshop, QWidget* window);

  /// The folder in which file dialogs begin.
  void set_folder(const QString& folder) { folder_ = folder; }

  /// @return as open().
  bool ask_and_open(const practice::OwnTablet& onto);
  /// At most one height map (RAW, PNG) and one stroke order (.str) of the list.
  /// @return whether they are being loaded; false where they were refused or nothing was chosen.
  bool open(const QStringList& paths, const practice::OwnTablet& onto);
  /// @param own  what was loaded; an empty one: the tablet is a carved character. @param name  proposed for
  /// the file.
  void ask_and_save(const practice::Tablet& tablet, const practice::OwnTablet& own, const QString& name);

 signals:
  void announced(nazori::ui::Feedback kind, QString sentence);
  /// Files were opened from or saved to this folder.
  void folder_changed(QString folder);

 private:
  void remember_folder_of(const QString& path);
  int ask_grid(const QString& path, int proposed);

  practice::TabletWorkshop* workshop_;
  QWidget* window_;
  QString folder_;
};

}  // namespace nazori::ui
