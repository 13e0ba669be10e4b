// SPDX-License-Identifier: Apache-2.0
// The characters that the learner keeps: those of the workshop that lists, search, study and worksheets have.
#include <system_error>
#include <utility>

#include "nazori/author/collection.h"
#include "nazori/kanji/own_characters.h"
#include "nazori/studio/parts/question_box.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
author::Collection WorkshopPage::collection() const {
  return author::Collection(parts().learner().source().own);
}

std::optional<char32_t> WorkshopPage::kept_as() const {
  return file_.isEmpty() ? std::nullopt : collection().code_point_of(file_.toStdString());
}

std::optional<char32_t> WorkshopPage::published_namesake() const {
  const std::u32string name = named_character();
  const auto* database = parts().learner().database();
  if (name.empty() || database == nullptr || kanji::is_own(name.front())) return std::nullopt;
  return database->summary(name.front()) ? std::optional(name.front()) : std::nullopt;
}

void WorkshopPage::set_instead_of(std::optional<char32_t> published) {
  author::Facts facts = bench_->character().facts;
  facts.instead_of = published;
  bench_->set_facts(facts);
}

bool WorkshopPage::choose_use() {
  const auto published = published_namesake();
  if (!published || bench_->character().facts.instead_of) return true;
  const Answer answers[] = {{tr("Use it instead"), QMessageBox::AcceptRole},
                            {tr("Keep it beside"), QMessageBox::AcceptRole},
                            {tr("Go back"), QMessageBox::RejectRole}};
  const std::size_t answer =
      ask("use_form_box",
          tr("%1 is a published character. Use your form instead of the published one? Lists, study and "
             "worksheets then have your strokes, and the study history goes on. Taking it out brings the "
             "published form back.")
              .arg(to_text(*published)),
          answers, 0, &parts().window());
  parts().focus_tablet();
  if (answer == 0) set_instead_of(published);
  return answer != 2;
}

void WorkshopPage::toggle_instead() {
  // The character says what holds; an edit shows it on the action again.
  const auto before = bench_->character().facts.instead_of;
  const auto published = before ? before : published_namesake();
  if (!published) {
    show_bench();
    return parts().respond(
        Feedback::hint,
        tr("Only a form of a published character can be used instead of it: give it that name. D: name."));
  }
  set_instead_of(before ? std::nullopt : published);
  const QString name = to_text(*published);
  parts().respond(Feedback::good,
                  before ? tr("Once kept (A), it stands beside the published %1.").arg(name)
                         : tr("Once kept (A), it is used instead of the published %1.").arg(name));
}

void WorkshopPage::keep() {
  finish_files();
  if (bench_->character().facts.name.empty()) {
    actions_->details->trigger();
    return parts().respond(Feedback::wrong, tr("Give the character a name first."));
  }
  if (bench_->character().strokes.empty())
    return parts().respond(Feedback::wrong,
                           tr("Draw a stroke first: there is nothing yet that could be written."));
  const auto place = kept_as();
  const bool was_saved = bench_->editor().state().is_saved;
  if (!place && !choose_use()) return;
  // The answer changes the character. Nobody else did, so its own file follows.
  saves_file_ = was_saved && !bench_->editor().state().is_saved && !file_.isEmpty();
  keep_as(place, author::SameName::refuse);
}

void WorkshopPage::save_answer(std::size_t edits) {
  if (!std::exchange(saves_file_, false) || edits != edits_) return;
  files_.save(bench_->begin_save(), file_.toStdString(),
              [this](author::SavePoint point, const base::Result<void>& saved) {
                bench_->end_save(std::move(point));
                if (!saved) say_not_saved(file_, saved.error());
              });
}

void WorkshopPage::keep_as(std::optional<char32_t> place, author::SameName same_name) {
  // What has no other file is from now on the kept character.
  const bool becomes_document = file_.isEmpty() || kept_as();
  say_if_slow(tr("Saving…"));
  files_.keep(
      bench_->begin_save(), collection(), place, same_name, becomes_document,
      [this, becomes_document, edits = edits_](author::SavePoint point, const base::Result<char32_t>& kept) {
        const author::Facts facts = point.character.facts;
        if (kept && becomes_document) file_ = to_text(collection().file_of(*kept).string());
        bench_->end_save(std::move(point));
        if (!kept && kept.error().code == base::Errc::in_use && kept.error().where == facts.name)
          return ask_same_name();
        if (!kept)
          return parts().announce(Feedback::wrong,
                                  tr("The character could not be kept: %1.").arg(reason(kept.error())));
        emit parts().own_characters_changed();
        save_answer(edits);
        parts().announce(
            Feedback::good,
            facts.instead_of
                ? tr("Your form is used instead of the published %1 now: in lists, search, study and "
                     "worksheets.")
                      .arg(to_text(*facts.instead_of))
                : tr("“%1” is among your characters now: in lists, search, study and worksheets.")
                      .arg(to_text(facts.name)));
      });
}

void WorkshopPage::ask_same_name() {
  const std::string name = bench_->character().facts.name;
  const auto same = collection().named(name);
  if (!same || same->empty()) return keep_as(std::nullopt, author::SameName::beside);
  const Answer answers[] = {{tr("Replace it"), QMessageBox::AcceptRole},
                            {tr("Keep both"), QMessageBox::AcceptRole},
                            {tr("Go back"), QMessageBox::RejectRole}};
  const std::size_t answer =
      ask("same_name_box", tr("There is a character called “%1” among yours already.").arg(to_text(name)),
          answers, 0, &parts().window());
  parts().focus_tablet();
  if (answer == 0) keep_as(same->front(), author::SameName::refuse);
  if (answer == 1) keep_as(std::nullopt, author::SameName::beside);
}

void WorkshopPage::remove_kept() {
  finish_files();
  const auto place = kept_as();
  if (!place)
    return parts().respond(Feedback::hint,
                           tr("This is not one of your kept characters. Open one of them with C first."));
  const QString name = to_text(bench_->character().facts.name);
  const Answer answers[] = {{tr("Take it out"), QMessageBox::DestructiveRole},
                            {tr("Go back"), QMessageBox::RejectRole}};
  const std::size_t answer =
      ask("remove_kept_box", tr("Take “%1” out of your characters? What you learned of it stays.").arg(name),
          answers, 1, &parts().window());
  parts().focus_tablet();
  if (answer != 0) return;
  files_.remove(collection(), *place, [this, name](const base::Result<void>& removed) {
    if (!removed)
      return parts().announce(Feedback::wrong,
                              tr("The character could not be taken out: %1.").arg(reason(removed.error())));
    // The drawing stays in the workshop, without a file: it can be kept again.
    author::OwnCharacter character = bench_->character();
    const auto published = character.facts.instead_of;
    emit parts().own_characters_changed();
    begin(std::move(character),
          published ? tr("The published %1 is used again. Your form is still here; A keeps it again.")
                          .arg(to_text(*published))
                    : tr("“%1” is no longer among your characters. A keeps it again.").arg(name));
  });
}

bool WorkshopPage::open_kept(char32_t code_point) {
  std::error_code ignored;
  const auto file = collection().file_of(code_point);
  if (!kanji::is_own(code_point) || collection().folder().empty() || !std::filesystem::exists(file, ignored))
    return false;
  open(to_text(file.string()));
  return true;
}

}  // namespace nazori::ui
