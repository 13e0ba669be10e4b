// SPDX-License-Identifier: Apache-2.0
// Plots as files: opened, saved, written for other uses.
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>

#include "desk.h"
#include "error_text.h"
#include "functions/expression_line.h"
#include "functions/functions_workplace.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"

namespace nazori::ui {
functions::PlotDocument FunctionsWorkplace::document() const {
  functions::PlotDocument document;
  document.expression = expression_.toStdString();
  document.reading.decimal_comma = uses_decimal_comma();
  document.window = window_;
  document.plate = plate_;
  document.sound = sound_settings();
  return document;
}

void FunctionsWorkplace::take_document(const functions::PlotDocument& document) {
  window_ = first_window_ = document.window;
  plate_ = document.plate;
  speed_ = std::clamp(static_cast<int>(std::lround(12.0 / document.sound.seconds)) - 1, kSlowest, kFastest);
  panel_->show_window(window_);
  panel_->show_plate(plate_);
  auto* line = panel_->line();
  QString text = QString::fromStdString(document.expression);
  if (document.reading.decimal_comma != uses_decimal_comma()) {
    // Written where commas mean another thing: the text that means the same everywhere.
    if (const auto plot = functions::parse(document.expression, document.reading))
      text = QString::fromStdString(functions::canonical(*plot));
  }
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
  take_document(*document);
  desk().say(Feedback::good, tr("%1 is on the desk.").arg(QFileInfo(paths.front()).fileName()));
}

void FunctionsWorkplace::ask_and_open() {
  const QString path =
      QFileDialog::getOpenFileName(&desk().window(), tr("Open a plot"), desk().preferences().folder,
                                   PlotExport::filter(PlotFile::document));
  if (path.isEmpty()) return;
  desk().preferences().folder = QFileInfo(path).absolutePath();
  open_files({path});
}

void FunctionsWorkplace::ask_and_save() { ask_and_write(PlotFile::document); }

void FunctionsWorkplace::ask_and_write(PlotFile kind) {
  if (!drawing_ || !drawing_->final) {
    desk().say(Feedback::advice, tr("There is no plot to save yet."));
    return;
  }
  if (drawing_->asked.plot.is_surface() && (kind == PlotFile::print || kind == PlotFile::sound)) {
    desk().answer(Feedback::advice, kind == PlotFile::print ? tr("A surface has no lines to print.")
                                                            : tr("A surface has no curve to play."));
    return;
  }
  QString folder = desk().preferences().folder;
  if (folder.isEmpty()) folder = QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
  const QString suffix = PlotExport::suffix(kind);
  QString path = QFileDialog::getSaveFileName(&desk().window(), tr("Save as"),
                                              QStringLiteral("%1/%2.%3").arg(folder, tr("plot"), suffix),
                                              PlotExport::filter(kind));
  desk().focus_tablet();
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  desk().preferences().folder = QFileInfo(path).absolutePath();
  desk().save_later();
  write(kind, path);
}

void FunctionsWorkplace::write(PlotFile kind, const QString& path) {
  export_->write(kind, path, drawing_, document());
}

}  // namespace nazori::ui
