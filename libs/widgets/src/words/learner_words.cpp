// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/learner_words.h"

#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

using practice::LearnerEvent;
using Kind = LearnerEvent::Kind;

Feedback LearnerWords::kind(const LearnerEvent& event) {
  if (event.kind == Kind::opened_again) return Feedback::good;
  return event.kind == Kind::backup_failed ? Feedback::advice : Feedback::wrong;
}

QString LearnerWords::cause(const LearnerEvent& event) {
  switch (event.cause) {
    case LearnerEvent::Cause::disk_full:
      return tr("the disk is full. Free up some space; everything saved before is safe");
    case LearnerEvent::Cause::not_allowed:
      return tr("there is no permission to write to %1. Check the permissions of the folder")
          .arg(to_text(event.folder.string()));
    case LearnerEvent::Cause::other:
      return reason(event.error);
  }
  return {};
}

QString LearnerWords::sentence(const LearnerEvent& event) {
  const QString profile = to_text(event.profile);
  switch (event.kind) {
    case Kind::no_folder:
      return tr("There is no folder for study data: set NAZORI_LEARNERS. Nothing will be saved.");
    case Kind::no_file:
      return reason(event.error);
    case Kind::in_use:
      return tr("“%1” is open in another Nazori window. Close it there; until then nothing is saved here.")
          .arg(profile);
    case Kind::newer:
      return tr("The study data of %1 was written by a newer Nazori or by another program: %2. Nothing was "
                "changed, and nothing will be saved.")
          .arg(profile, to_text(event.error.where));
    case Kind::damaged:
      return tr("The study data of %1 is damaged: %2. Nothing was changed. You can restore a backup.")
          .arg(profile, to_text(event.error.where));
    case Kind::not_writable:
      return tr("The study data of %1 cannot be saved: %2. Nothing will be saved.")
          .arg(profile, cause(event));
    case Kind::changing_settings:
      return tr("Every character of %1 is being worked out anew. Nothing is kept until that is done.")
          .arg(profile);
    case Kind::replacing:
      return tr("The study data of %1 is being replaced. Nothing is saved until this is done.").arg(profile);
    case Kind::name_refused:
      return tr("“%1” cannot be a learner name: use at most 60 letters (20 in Japanese), no “/”, and no dot "
                "at the start.")
          .arg(profile);
    case Kind::opened_again:
      return tr("“%1” is now open here. Everything is saved again.").arg(profile);
    case Kind::not_saved:
      return tr("Could not save: %1.").arg(cause(event));
    case Kind::unread:
      return tr("The study data cannot be read: %1.").arg(reason(event.error));
    case Kind::backup_failed:
      return tr("Today's backup failed: %1. You can still study.").arg(reason(event.error));
  }
  return {};
}

QString LearnerWords::sentence(const std::optional<LearnerEvent>& event) {
  return event ? sentence(*event) : QString();
}

}  // namespace nazori::ui
