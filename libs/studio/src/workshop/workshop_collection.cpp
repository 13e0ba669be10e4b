// SPDX-License-Identifier: Apache-2.0
// The characters that the learner keeps: those of the workshop that lists, search, study and worksheets have.
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "nazori/author/collection.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "nazori/studio/workshop/workshop_panel.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

enum class Same : std::uint8_t { replace, beside, stay };

}  // namespace

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
      QMessageBox box(
          QMessageBox::Question, QStringLiteral("Nazori"),
          tr("There is a character called “%1” among yours already.").arg(to_text(character.facts.name)),
          QMessageBox::NoButton, &parts().window());
      box.setObjectName(QStringLiteral("same_name_box"));
      auto* replace = box.addButton(tr("Replace it"), QMessageBox::AcceptRole);
      box.addButton(tr("Keep both"), QMessageBox::AcceptRole);
      auto* stay = box.addButton(tr("Go back"), QMessageBox::RejectRole);
      box.setDefaultButton(replace);
      box.setEscapeButton(stay);
      box.exec();
      parts().focus_tablet();
      if (box.clickedButton() == stay) return;
      if (box.clickedButton() == replace) place = same->front();
    }
  }
  const auto kept = collection().keep(character, place);
  if (!kept) return failed(kept.error());
  // What has no other file is from now on the kept character.
  if (file_.isEmpty() || kept_as()) write(to_text(collection().file_of(*kept).string()));
  emit parts().own_characters_changed();
  show_bench();
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
  QMessageBox box(QMessageBox::Question, QStringLiteral("Nazori"),
                  tr("Take “%1” out of your characters? What you learned of it stays.").arg(name),
                  QMessageBox::NoButton, &parts().window());
  box.setObjectName(QStringLiteral("remove_kept_box"));
  auto* remove = box.addButton(tr("Take it out"), QMessageBox::DestructiveRole);
  auto* stay = box.addButton(tr("Go back"), QMessageBox::RejectRole);
  box.setDefaultButton(stay);
  box.setEscapeButton(stay);
  box.exec();
  parts().focus_tablet();
  if (box.clickedButton() != remove) return;
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
