// SPDX-License-Identifier: Apache-2.0
// Sheets as files, and what was done or failed.
#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/brush/brush_words.h"
#include "nazori/studio/parts/unsaved_box.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

using calligraphy::Outcome;
using calligraphy::Task;

QString name_of(const std::filesystem::path& path) { return QFileInfo(to_text(path.string())).fileName(); }

}  // namespace

void BrushPage::show_outcome(const Outcome& outcome) {
  const auto& state = writing_->state();
  const QString file = name_of(outcome.file);
  if (outcome.failed) {
    closes_when_saved_ = false;
    is_quiet_ = false;
    const QString why = reason(outcome.error);
    switch (outcome.task) {
      case Task::open:
        return parts().announce(Feedback::wrong,
                                tr("Could not open %1: %2. The sheet was not changed.").arg(file, why));
      case Task::save:
      case Task::save_png:
      case Task::save_svg:
      case Task::save_pdf:
        return parts().announce(Feedback::wrong, tr("Could not save %1: %2.").arg(file, why));
      case Task::ink:
        choice_.ink = state.ink;
        return parts().announce(Feedback::advice,
                                tr("The sheet is still wet with other inks. D: dry it now."));
      default:
        return parts().announce(Feedback::wrong, tr("This is not possible: %1.").arg(why));
    }
  }
  const bool changes_sheet = outcome.task == Task::undo || outcome.task == Task::redo ||
                             outcome.task == Task::new_sheet || outcome.task == Task::open;
  if (changes_sheet) clear_advice();
  switch (outcome.task) {
    case Task::undo:
      return parts().respond(Feedback::hint, undo_words(outcome.edit, state.strokes));
    case Task::redo:
      return parts().respond(Feedback::hint, redo_words(outcome.edit, state.strokes));
    case Task::dry:
      return parts().respond(Feedback::hint,
                             outcome.changed ? tr("The sheet is dry.") : tr("The sheet was dry already."));
    case Task::new_sheet:
      file_.clear();
      emit title_changed();
      choice_.ink = state.ink;
      if (std::exchange(is_quiet_, false)) return;
      return parts().announce(
          Feedback::hint,
          tr("New sheet: %1. %2 brings the old one back.")
              .arg(paper_name(state.paper), actions_->undo->shortcut().toString(QKeySequence::NativeText)));
    case Task::ink:
      choice_.ink = state.ink;
      if (std::exchange(starts_, false)) return;
      return parts().respond(Feedback::hint, tr("Ink: %1.").arg(ink_name(state.ink)));
    case Task::open:
      file_ = file;
      choice_.paper = state.paper;
      choice_.ink = state.ink;
      emit title_changed();
      return parts().announce(Feedback::good, tr("Opened %1.").arg(file));
    case Task::save:
      file_ = file;
      emit title_changed();
      parts().announce(Feedback::good, tr("Saved %1.").arg(file));
      if (closes_when_saved_) parts().window().close();
      return;
    case Task::save_png:
    case Task::save_svg:
    case Task::save_pdf:
      return parts().announce(Feedback::good, tr("Saved %1.").arg(file));
    case Task::carve:
      return show_tablet(outcome);
    case Task::advise:
      return show_advice(outcome.advice);
    case Task::hand:
      return begin_hand(outcome.hand);
  }
}

void BrushPage::show_tablet(const Outcome& outcome) {
  parts().workshop().show(
      {outcome.tablet, tr("Brush sheet").toStdString(), outcome.tablet->height_map().size(), false});
}

bool BrushPage::opens(const QStringList& paths) const {
  return paths.size() == 1 && QFileInfo(paths.front()).suffix().toLower() == QLatin1String("nzs");
}

void BrushPage::open_files(const QStringList& paths) {
  if (!entered_) emit wants_to_be_entered();
  stop_teacher();
  writing_->open(paths.front().toStdString());
  wake();
}

void BrushPage::ask_and_open() {
  const QString path =
      QFileDialog::getOpenFileName(&parts().window(), tr("Open a sheet"),
                                   parts().preferences().start_folder(), tr("Sheet of paper (*.nzs)"));
  if (path.isEmpty()) return;
  parts().preferences().folder = QFileInfo(path).absolutePath();
  open_files({path});
}

void BrushPage::ask_and_save() { ask_and_write(QStringLiteral("nzs")); }

void BrushPage::ask_and_write(const QString& suffix) {
  const bool is_sheet = suffix == QLatin1String("nzs");
  QString name;
  for (const char32_t c : models()) name += to_text(c);
  if (!file_.isEmpty()) name = QFileInfo(file_).completeBaseName();
  QString filter;
  QString path = QFileDialog::getSaveFileName(
      &parts().window(), tr("Save as"),
      QStringLiteral("%1/%2.%3").arg(parts().preferences().start_folder(), name.left(20), suffix),
      is_sheet
          ? tr("Sheet of paper (*.nzs)")
          : QStringList{tr("Picture (*.png)"), tr("Strokes (*.svg)"), tr("Page at real size (*.pdf)")}.join(
                QStringLiteral(";;")),
      &filter);
  parts().focus_tablet();
  if (path.isEmpty()) {
    closes_when_saved_ = false;
    return;
  }
  if (QFileInfo(path).suffix().isEmpty()) {
    const qsizetype star = filter.lastIndexOf(QLatin1String("*."));
    path += QLatin1Char('.') + (star < 0 ? suffix : filter.mid(star + 2).chopped(1));
  }
  parts().preferences().folder = QFileInfo(path).absolutePath();
  parts().save_later();
  write(path);
}

void BrushPage::write(const QString& path) {
  const QString suffix = QFileInfo(path).suffix().toLower();
  const std::string file = path.toStdString();
  if (suffix == QLatin1String("png"))
    writing_->save_png(file);
  else if (suffix == QLatin1String("svg"))
    writing_->save_svg(file);
  else if (suffix == QLatin1String("pdf"))
    writing_->save_pdf(file, QFileInfo(path).completeBaseName().toStdString());
  else
    writing_->save(file);
  wake();
}

bool BrushPage::may_close(bool quits) {
  if (!writing_ || writing_->state().is_saved || writing_->state().strokes == 0) return true;
  const Unsaved choice = ask_unsaved(
      "unsaved_sheet_box", tr("The sheet with your brush writing is not saved."), &parts().window());
  if (choice == Unsaved::discard) return true;
  if (choice == Unsaved::save) {
    // The window closes when the file is written. To open again it must be asked again.
    closes_when_saved_ = quits;
    ask_and_save();
  }
  return false;
}

}  // namespace nazori::ui
