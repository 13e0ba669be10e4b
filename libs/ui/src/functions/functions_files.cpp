// SPDX-License-Identifier: Apache-2.0
// Plots as files: opened, saved, written for other uses.
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

#include "desk.h"
#include "error_text.h"
#include "functions/expression_line.h"
#include "functions/functions_workplace.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"

namespace nazori::ui {

void FunctionsWorkplace::open(const functions::PlotDocument& document) {
  const QString text = QString::fromStdString(model_.open(document, {uses_decimal_comma()}));
  panel_->show_window(model_.window());
  panel_->show_plate(model_.plate());
  auto* line = panel_->line();
  line->remember(text);
  if (line->text() == text)
    read_expression();
  else
    line->setText(text);
}

bool FunctionsWorkplace::opens(const QStringList& paths) const {
  return paths.size() == 1 && QFileInfo(paths.front()).suffix().toLower() == QLatin1String("json");
}

void FunctionsWorkplace::open_files(const QStringList& paths) {
  const auto document = functions::load_document(paths.front().toStdString());
  if (!document) {
    desk().say(Feedback::wrong, tr("%1 was not opened: %2. The plate is as it was.")
                                    .arg(QFileInfo(paths.front()).fileName(), reason(document.error())));
    return;
  }
  if (!entered_) emit wants_to_be_entered();
  open(*document);
  desk().say(Feedback::good, tr("%1 is on the desk.").arg(QFileInfo(paths.front()).fileName()));
}

void FunctionsWorkplace::ask_and_open() {
  const QString path =
      QFileDialog::getOpenFileName(&desk().window(), tr("Open a plot"), desk().preferences().folder,
                                   file_filter(functions::PlotFile::document));
  if (path.isEmpty()) return;
  desk().preferences().folder = QFileInfo(path).absolutePath();
  open_files({path});
}

void FunctionsWorkplace::ask_and_save() { ask_and_write(functions::PlotFile::document); }

void FunctionsWorkplace::ask_and_write(functions::PlotFile kind) {
  if (!shown() || !shown()->final) {
    desk().say(Feedback::advice, tr("There is no plot to save yet."));
    return;
  }
  if (!functions::can_be_written(shown()->request.plot, kind)) {
    desk().answer(Feedback::advice, kind == functions::PlotFile::print
                                        ? tr("A surface has no lines to print.")
                                        : tr("A surface has no curve to play."));
    return;
  }
  QString folder = desk().preferences().folder;
  if (folder.isEmpty()) folder = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
  const auto extension = functions::extension_of(kind);
  const QString suffix = QString::fromLatin1(extension.data(), static_cast<qsizetype>(extension.size()));
  QString path = QFileDialog::getSaveFileName(&desk().window(), tr("Save as"),
                                              QStringLiteral("%1/%2.%3").arg(folder, tr("plot"), suffix),
                                              file_filter(kind));
  desk().focus_tablet();
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  desk().preferences().folder = QFileInfo(path).absolutePath();
  desk().save_later();
  write(kind, path);
}

void FunctionsWorkplace::write(functions::PlotFile kind, const QString& path) {
  export_.write(kind, path.toStdString(), shown(), model_.document({uses_decimal_comma()}));
}

}  // namespace nazori::ui
