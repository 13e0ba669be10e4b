// SPDX-License-Identifier: Apache-2.0
// Plots as files: open, save and export.
#include <QFileDialog>
#include <QFileInfo>

#include "functions/expression_line.h"
#include "functions/functions_page.h"
#include "functions/plot_panel.h"
#include "functions/plot_words.h"
#include "nazori/studio/print/solid_dialog.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"

namespace nazori::ui {

void FunctionsPage::open(const functions::PlotDocument& document) {
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

bool FunctionsPage::opens(const QStringList& paths) const {
  return paths.size() == 1 && QFileInfo(paths.front()).suffix().toLower() == QLatin1String("json");
}

void FunctionsPage::open_files(const QStringList& paths) {
  const auto document = functions::load_document(paths.front().toStdString());
  if (!document) {
    parts().announce(Feedback::wrong,
                     tr("Could not open %1: %2. The plot was not changed.")
                         .arg(QFileInfo(paths.front()).fileName(), reason(document.error())));
    return;
  }
  if (!entered_) emit wants_to_be_entered();
  open(*document);
  parts().announce(Feedback::good, tr("Opened %1.").arg(QFileInfo(paths.front()).fileName()));
}

void FunctionsPage::ask_and_open() {
  const QString path =
      QFileDialog::getOpenFileName(&parts().window(), tr("Open a plot"), parts().preferences().folder,
                                   file_filter(functions::PlotFile::document));
  if (path.isEmpty()) return;
  parts().preferences().folder = QFileInfo(path).absolutePath();
  open_files({path});
}

void FunctionsPage::ask_and_save() { ask_and_write(functions::PlotFile::document); }

void FunctionsPage::ask_and_write(functions::PlotFile kind) {
  if (!shown() || !shown()->final) {
    parts().announce(Feedback::advice, tr("There is no plot to save yet."));
    return;
  }
  if (!functions::can_be_written(shown()->request.plot, kind)) {
    parts().respond(Feedback::advice, kind == functions::PlotFile::print
                                          ? tr("A surface has no lines to print.")
                                          : tr("A surface has no curve to play."));
    return;
  }
  const auto extension = functions::extension_of(kind);
  const QString suffix = QString::fromLatin1(extension.data(), static_cast<qsizetype>(extension.size()));
  QString path = QFileDialog::getSaveFileName(
      &parts().window(), tr("Save as"),
      QStringLiteral("%1/%2.%3").arg(parts().preferences().start_folder(), tr("plot"), suffix),
      file_filter(kind));
  parts().focus_tablet();
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + suffix;
  parts().preferences().folder = QFileInfo(path).absolutePath();
  parts().save_later();
  write(kind, path);
}

void FunctionsPage::ask_model() {
  if (!shown() || !shown()->final)
    return parts().announce(Feedback::advice, tr("There is no plot to make a model of yet."));
  ask_solid(parts(), {QString::fromStdString(functions::canonical(shown()->request.plot)), {}, shown()});
}

void FunctionsPage::write(functions::PlotFile kind, const QString& path) {
  export_.write(kind, path.toStdString(), shown(), model_.document({uses_decimal_comma()}));
}

}  // namespace nazori::ui
