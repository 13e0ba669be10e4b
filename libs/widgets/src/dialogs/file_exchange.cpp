// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/dialogs/file_exchange.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QStandardPaths>

#include "nazori/kanji/stroke_order.h"
#include "nazori/widgets/dialogs/save_dialog.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

FileExchange::FileExchange(practice::TabletWorkshop* workshop, QWidget* window)
    : QObject(window), workshop_(workshop), window_(window) {
  subscribe(workshop_->failed, this, [this](const std::filesystem::path& path, const base::Error& error) {
    const QString name = path.empty() ? tr("The character") : to_text(path.filename().string());
    emit announced(Feedback::wrong, tr("%1: %2. The tablet was not changed.").arg(name, reason(error)));
  });
  subscribe(workshop_->saved, this, [this](const std::filesystem::path& path) {
    emit announced(Feedback::good, tr("Saved as %1.").arg(QDir::toNativeSeparators(to_text(path.string()))));
  });
}

bool FileExchange::ask_and_open(const practice::OwnTablet& onto) {
  const QStringList paths = QFileDialog::getOpenFileNames(
      window_, tr("Open a height map, a stroke order file, or both"), folder_,
      tr("Height maps and stroke order files (*.raw *.png *.str);;All files (*)"));
  return !paths.isEmpty() && open(paths, onto);
}

bool FileExchange::open(const QStringList& paths, const practice::OwnTablet& onto) {
  QString map;
  QString strokes;
  for (const QString& path : paths) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    QString& place = suffix == QLatin1String("str") ? strokes : map;
    const bool known =
        suffix == QLatin1String("str") || suffix == QLatin1String("raw") || suffix == QLatin1String("png");
    if (!known || !place.isEmpty()) {
      const QString name = QFileInfo(path).fileName();
      emit announced(Feedback::wrong,
                     known ? tr("%1 is one file too many: open one height map and one stroke order file. The "
                                "tablet was not changed.")
                                 .arg(name)
                           : tr("%1 is not a RAW, PNG or .str file. The tablet was not changed.").arg(name));
      return false;
    }
    place = path;
  }
  if (map.isEmpty() && strokes.isEmpty()) return false;
  remember_folder_of(map.isEmpty() ? strokes : map);
  int grid = 0;
  if (map.isEmpty() && onto.map_size == 0) {
    // A stroke file does not say its grid. One that cannot be read at all is reported by the workshop.
    const auto guess = practice::TabletWorkshop::guess_grid(strokes.toStdString());
    if (guess && !guess->certain) {
      grid = ask_grid(strokes, guess->side);
      if (grid == 0) return false;
    }
  }
  workshop_->load(map.toStdString(), strokes.toStdString(), onto, grid);
  return true;
}

void FileExchange::remember_folder_of(const QString& path) {
  folder_ = QFileInfo(path).absolutePath();
  emit folder_changed(folder_);
}

int FileExchange::ask_grid(const QString& path, int proposed) {
  bool ok = false;
  const int side = QInputDialog::getInt(
      window_, tr("Grid size"),
      tr("%1 does not contain its grid size.\nColumns and rows:").arg(QFileInfo(path).fileName()), proposed,
      surface::HeightMap::kMinSize, surface::HeightMap::kMaxSize, 1, &ok);
  return ok ? side : 0;
}

void FileExchange::ask_and_save(const practice::Tablet& tablet, const practice::OwnTablet& own,
                                const QString& name) {
  if (!tablet) {
    emit announced(Feedback::advice, tr("There is no tablet to save yet."));
    return;
  }
  SaveDialog dialog(own.map_size, !tablet->lines().empty(), window_);
  if (dialog.exec() != QDialog::Accepted) return;
  const QString suffix = SaveDialog::suffix(dialog.format());
  const QString start =
      folder_.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::HomeLocation) : folder_;
  QString path = QFileDialog::getSaveFileName(window_, tr("Save as"),
                                              QStringLiteral("%1/%2.%3").arg(start, name, suffix),
                                              SaveDialog::filter(dialog.format()));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  remember_folder_of(path);
  workshop_->save(tablet, path.toStdString(), dialog.format(), dialog.size(), own.map_size > 0);
}

}  // namespace nazori::ui
