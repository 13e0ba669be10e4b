// SPDX-License-Identifier: Apache-2.0
// The characters that the learner keeps: those of the workshop that lists, search, study and worksheets have.
#include "nazori/author/collection.h"
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

void WorkshopPage::keep() {
  const author::OwnCharacter& character = bench_->character();
  if (character.facts.name.empty()) {
    actions_->details->trigger();
    return parts().respond(Feedback::wrong, tr("Give the character a name first."));
  }
  const auto failed = [this](const base::Error& error) {
    parts().announce(Feedback::wrong, tr("The character could not be kept: %1.").arg(reason(error)));
  };
  std::optional<char32_t> place = kept_as();
  if (!place) {
    const auto same = collection().named(character.facts.name);
    if (!same) return failed(same.error());
    if (!same->empty()) {
      const Answer answers[] = {{tr("Replace it"), QMessageBox::AcceptRole},
                                {tr("Keep both"), QMessageBox::AcceptRole},
                                {tr("Go back"), QMessageBox::RejectRole}};
      const std::size_t answer =
          ask("same_name_box",
              tr("There is a character called “%1” among yours already.").arg(to_text(character.facts.name)),
              answers, 0, &parts().window());
      parts().focus_tablet();
      if (answer == 2) return;
      if (answer == 0) place = same->front();
    }
  }
  if (file_.isEmpty() || kept_as()) {
    // What has no other file is from now on the kept character.
    const auto ready = collection().prepare(character, place);
    if (!ready) return failed(ready.error());
    if (!write(to_text(collection().file_of(*ready).string()))) return;
  } else {
    if (const auto kept = collection().keep(character, place); !kept) return failed(kept.error());
    emit parts().own_characters_changed();
  }
  parts().announce(Feedback::good,
                   tr("“%1” is among your characters now: in lists, search, study and worksheets.")
                       .arg(to_text(character.facts.name)));
}

void WorkshopPage::remove_kept() {
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
  if (const auto removed = collection().remove(*place); !removed) {
    return parts().announce(Feedback::wrong,
                            tr("The character could not be taken out: %1.").arg(reason(removed.error())));
  }
  // The drawing stays in the workshop, without a file: it can be kept again.
  author::OwnCharacter character = bench_->character();
  emit parts().own_characters_changed();
  begin(std::move(character), tr("“%1” is no longer among your characters. A keeps it again.").arg(name));
}

bool WorkshopPage::open_kept(char32_t code_point) {
  if (!collection().find(code_point)) return false;
  open(to_text(collection().file_of(code_point).string()));
  return true;
}

}  // namespace nazori::ui
