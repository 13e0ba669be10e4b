// SPDX-License-Identifier: Apache-2.0
// Characters as files, pictures and fonts in which strokes are found, and work that was interrupted.
#include <QDir>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "nazori/author/character_file.h"
#include "nazori/base/file.h"
#include "nazori/studio/parts/unsaved_box.h"
#include "nazori/studio/workshop/trace_dialog.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kClassicSide = 128;  ///< of a stroke order file

QString name_of(const QString& path) { return QFileInfo(path).fileName(); }

}  // namespace

QString WorkshopPage::title() const {
  if (!file_.isEmpty() && !kept_as()) return name_of(file_);
  return to_text(bench_->character().facts.name);
}

std::u32string WorkshopPage::named_character() const {
  const std::u32string name = to_text(bench_->character().facts.name).toStdU32String();
  return name.size() == 1 ? name : std::u32string();
}

std::filesystem::path WorkshopPage::unnamed_journal() const {
  return std::filesystem::path(QFileInfo(parts().settings_file()).absolutePath().toStdString()) /
         (unnamed_ == 0 ? std::string("workshop.nazori.journal")
                        : "workshop-" + std::to_string(unnamed_ + 1) + ".nazori.journal");
}

void WorkshopPage::choose_unnamed_journal() {
  constexpr int kMost = 20;
  std::error_code ignored;
  std::optional<int> unused;
  for (unnamed_ = 0; unnamed_ < kMost; ++unnamed_) {
    // Another window writes it.
    if (author::is_being_edited(unnamed_journal())) continue;
    if (std::filesystem::exists(unnamed_journal(), ignored)) return;
    if (!unused) unused = unnamed_;
  }
  unnamed_ = unused.value_or(0);
}

void WorkshopPage::finish_files() {
  QEventLoop loop;
  while (files_.is_busy())
    loop.processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
}

void WorkshopPage::say_if_slow(const QString& sentence) {
  constexpr int kSlow_ms = 300;
  slow_sentence_ = sentence;
  slow_call_ = files_.last_call() + 1;
  slow_.start(kSlow_ms);
}

void WorkshopPage::keep_journal() {
  journal_failed_ = false;
  const auto path = file_.isEmpty() ? unnamed_journal() : author::journal_path(file_.toStdString());
  files_.begin_journal(
      bench_->begin_save(), path, [this](author::SavePoint point, const base::Result<void>& begun) {
        bench_->end_save(std::move(point));
        if (begun) return;
        journal_failed_ = true;
        parts().announce(Feedback::advice,
                         tr("Your changes cannot be kept for an emergency: %1.").arg(reason(begun.error())));
      });
}

void WorkshopPage::recover() {
  choose_unnamed_journal();
  std::error_code ignored;
  const auto journal = unnamed_journal();
  if (!std::filesystem::exists(journal, ignored)) return keep_journal();
  author::Recovery recovery;
  auto editor = author::CharacterEditor::recover(journal, recovery);
  if (!editor) {
    parts().announce(
        Feedback::advice,
        tr("Work that was interrupted could not be brought back: %1.").arg(reason(editor.error())));
    return keep_journal();
  }
  if (recovery.edits == 0) return keep_journal();
  bench_->take(*std::move(editor));
  parts().announce(Feedback::good, tr("Your work that was interrupted is back: %n changes.", nullptr,
                                      static_cast<int>(recovery.edits)));
}

void WorkshopPage::begin(author::OwnCharacter character, const QString& sentence) {
  auto editor = author::CharacterEditor::create(std::move(character));
  if (!editor)
    return parts().announce(Feedback::wrong, tr("This is not possible: %1.").arg(reason(editor.error())));
  finish_files();
  bench_->close_journal();
  file_.clear();
  bench_->take(*std::move(editor));
  clear_check();
  keep_journal();
  emit parts().focus_tablet();
  parts().announce(Feedback::good, sentence);
}

bool WorkshopPage::may_replace() { return may_close(false); }

bool WorkshopPage::may_close(bool /*quits*/) {
  finish_files();
  if (bench_->editor().state().is_saved) {
    bench_->close_journal();
    return true;
  }
  const Unsaved choice = ask_unsaved("unsaved_character_box",
                                     tr("The character in the workshop is not saved."), &parts().window());
  if (choice == Unsaved::save) {
    ask_and_save();
    finish_files();
    if (!bench_->editor().state().is_saved) return false;
    bench_->close_journal();
    return true;
  }
  if (choice == Unsaved::stay) return false;
  bench_->close_journal();
  return true;
}

bool WorkshopPage::opens(const QStringList& paths) const {
  if (paths.size() != 1) return false;
  const QString suffix = QFileInfo(paths.front()).suffix().toLower();
  return suffix == QLatin1String("nazori") || suffix == QLatin1String("svg");
}

void WorkshopPage::open_files(const QStringList& paths) {
  if (!entered_) emit wants_to_be_entered();
  if (may_replace()) open(paths.front());
}

void WorkshopPage::open(const QString& path) {
  finish_files();
  say_if_slow(tr("Opening %1…").arg(name_of(path)));
  files_.open(path.toStdString(), [this, path, edits = edits_](base::Result<author::OpenedCharacter> opened) {
    if (!opened) {
      // The question about unsaved work ended the journal of the document that stays.
      if (!bench_->editor().state().is_autosaved) keep_journal();
      return parts().announce(Feedback::wrong,
                              tr("Could not open %1: %2.").arg(name_of(path), reason(opened.error())));
    }
    // Nothing that was drawn meanwhile goes without a question.
    if (edits != edits_ && !may_replace()) return;
    take_opened(path, *std::move(opened));
  });
}

void WorkshopPage::take_opened(const QString& path, author::OpenedCharacter opened) {
  bench_->close_journal();
  file_ = opened.is_document ? path : QString();
  bench_->take(std::move(opened.editor));
  clear_check();
  if (!opened.recovery) keep_journal();
  emit parts().focus_tablet();
  const QString name = opened.is_document ? title() : name_of(path);
  parts().announce(Feedback::good, opened.recovery && opened.recovery->edits > 0
                                       ? tr("Opened %1, with %n changes that were not saved.", nullptr,
                                            static_cast<int>(opened.recovery->edits))
                                             .arg(name)
                                       : tr("Opened %1.").arg(name));
}

void WorkshopPage::ask_and_open() {
  const QString path = QFileDialog::getOpenFileName(
      &parts().window(), tr("Open a character"), parts().preferences().start_folder(),
      QStringList{tr("All of these (*.nazori *.svg *.str *.raw *.png)"), tr("Character (*.nazori)"),
                  tr("Strokes (*.svg *.str)"), tr("Height map (*.raw *.png)")}
          .join(QStringLiteral(";;")));
  if (path.isEmpty()) return;
  parts().preferences().folder = QFileInfo(path).absolutePath();
  if (may_replace()) open(path);
}

QString WorkshopPage::proposed_name() const {
  if (!file_.isEmpty() && !kept_as()) return QFileInfo(file_).completeBaseName();
  const QString name = to_text(bench_->character().facts.name).replace(QLatin1Char('/'), QLatin1Char('-'));
  constexpr int kLongest = 40;
  return name.isEmpty() ? tr("character") : name.left(kLongest);
}

void WorkshopPage::ask_and_save() {
  // A kept character needs no name of a file.
  if (kept_as()) return keep();
  ask_and_write(QStringLiteral("nazori"));
}

void WorkshopPage::ask_and_write(const QString& suffix) {
  const bool is_document = suffix == QLatin1String("nazori");
  QFileDialog dialog(&parts().window(), is_document ? tr("Save the character") : tr("Save a copy"));
  dialog.setObjectName(QStringLiteral("workshop_file_dialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(
      is_document ? QStringList{tr("Character (*.nazori)")}
                  : QStringList{tr("Strokes as a drawing (*.svg)"), tr("Stroke order of 2005 (*.str)"),
                                tr("Height map, 8 bits (*.raw)"), tr("Height map, 16 bits (*.png)")});
  dialog.setDefaultSuffix(suffix);
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section(QLatin1Char('.'), -1).remove(QLatin1Char(')')));
  });
  dialog.setDirectory(file_.isEmpty() ? parts().preferences().start_folder()
                                      : QFileInfo(file_).absolutePath());
  dialog.selectFile(proposed_name());
  const bool chosen = dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty();
  parts().focus_tablet();
  if (!chosen) return;
  const QString path = dialog.selectedFiles().front();
  parts().preferences().folder = QFileInfo(path).absolutePath();
  emit parts().save_later();
  write(path);
}

void WorkshopPage::say_not_saved(const QString& path, const base::Error& error) {
  parts().announce(Feedback::wrong, tr("Could not save %1: %2.").arg(name_of(path), reason(error)));
}

void WorkshopPage::write(const QString& path) {
  const std::filesystem::path file = path.toStdString();
  const auto format = author::format_of(file);
  if (!format) {
    return say_not_saved(path, {base::Errc::bad_argument, "is not a file of a character",
                                name_of(path).toStdString(), ".nazori, .svg, .str, .raw and .png are"});
  }
  finish_files();
  say_if_slow(tr("Saving…"));
  if (*format == author::CharacterFormat::document) {
    return files_.save(bench_->begin_save(), file,
                       [this, path](author::SavePoint point, const base::Result<void>& saved) {
                         const bool is_written = point.is_written;
                         if (is_written) file_ = path;
                         bench_->end_save(std::move(point));
                         if (!is_written) return say_not_saved(path, saved.error());
                         if (kept_as()) emit parts().own_characters_changed();
                         parts().announce(Feedback::good, tr("Saved %1.").arg(title()));
                       });
  }
  const int side = *format == author::CharacterFormat::strokes ? kClassicSide : bench_->editor().map().size();
  files_.write_copy(bench_->character(), file, *format, side,
                    [this, path](const base::Result<void>& written) {
                      if (!written) return say_not_saved(path, written.error());
                      parts().announce(Feedback::good, tr("Saved a copy as %1.").arg(name_of(path)));
                    });
}

void WorkshopPage::connect_tracing() {
  subscribe(
      parts().library().characters_ready, this, [this](const std::vector<kanji::Character>& characters) {
        for (const auto& character : characters) characters_[character.code_point] = character;
        const char32_t asked = std::exchange(asked_, U'\0');
        if (asked == 0) return;
        const auto found = characters_.find(asked);
        const bool known = found != characters_.end() && !found->second.strokes.empty();
        if (auto waiting = std::exchange(waiting_, {})) {
          if (known) waiting->known = found->second.lines();
          tracer_.trace(*std::move(waiting));
        } else if (known) {
          begin(author::copy_of(found->second),
                tr("A copy of %1. Change what you like.").arg(to_text(asked)));
        } else {
          parts().announce(Feedback::wrong, tr("The database has no strokes of %1.").arg(to_text(asked)));
        }
      });
  subscribe(tracer_.traced, this, [this](const author::Traced& found) {
    author::OwnCharacter character = author::from_strokes(found.strokes);
    character.facts.rights.source = found.source;
    if (traced_ != 0) character.facts.name = to_text(traced_).toStdString();
    QString sentence = tr("%n strokes found in %1.", nullptr, static_cast<int>(found.strokes.size()))
                           .arg(to_text(found.source));
    if (!found.unsure.empty()) {
      QStringList strokes;
      for (const std::size_t stroke : found.unsure) strokes.append(QString::number(stroke + 1));
      sentence +=
          QLatin1Char(' ') +
          tr("Look at these: %1. Little ink was found for them.").arg(strokes.join(QStringLiteral(", ")));
    }
    begin(std::move(character), sentence);
  });
  subscribe(tracer_.failed, this, [this](const base::Error& error) {
    parts().announce(Feedback::wrong,
                     tr("No strokes were found: %1. The character was not changed.").arg(reason(error)));
  });
}

bool WorkshopPage::is_tracing() const { return waiting_ || tracer_.is_busy(); }

void WorkshopPage::trace(author::TraceRequest request, char32_t character) {
  traced_ = character;
  parts().announce(Feedback::hint, tr("Looking for strokes…"));
  if (character == 0) return tracer_.trace(std::move(request));
  waiting_ = std::move(request);
  asked_ = character;
  parts().library().request_characters({character});
}

void WorkshopPage::trace_picture(const QString& path, char32_t character) {
  author::TraceRequest request;
  request.picture = path.toStdString();
  trace(std::move(request), character);
}

void WorkshopPage::trace_font(const QString& family, char32_t character) {
  author::TraceRequest request;
  request.family = family.toStdString();
  request.glyph = character;
  trace(std::move(request), character);
}

void WorkshopPage::ask_picture() {
  const QString path = QFileDialog::getOpenFileName(&parts().window(), tr("Find the strokes of a picture"),
                                                    parts().preferences().start_folder(),
                                                    tr("Pictures (*.png *.jpg *.jpeg *.svg)"));
  if (path.isEmpty()) return;
  parts().preferences().folder = QFileInfo(path).absolutePath();
  TraceDialog dialog(name_of(path), to_text(bench_->character().facts.name), &parts().window());
  if (dialog.exec() == QDialog::Accepted && may_replace()) trace_picture(path, dialog.character());
  parts().focus_tablet();
}

void WorkshopPage::ask_font() {
  const auto& sheet = parts().practice().sheet();
  const char32_t shown = sheet ? sheet->character.code_point : parts().preferences().kanji;
  TraceDialog dialog({}, to_text(shown), &parts().window());
  if (dialog.exec() == QDialog::Accepted && may_replace()) trace_font(dialog.family(), dialog.character());
  parts().focus_tablet();
}

void WorkshopPage::ask_copy() {
  const auto& sheet = parts().practice().sheet();
  if (!may_replace()) return;
  asked_ = sheet ? sheet->character.code_point : parts().preferences().kanji;
  // An own character, or a form that is used instead of a published one, is changed itself.
  if (open_kept(sheet ? sheet->character.own_form.value_or(asked_) : asked_)) return void(asked_ = 0);
  waiting_.reset();
  parts().library().request_characters({asked_});
}

}  // namespace nazori::ui
