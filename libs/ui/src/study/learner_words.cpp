// SPDX-License-Identifier: Apache-2.0
#include "study/learner_words.h"

#include "error_text.h"
#include "kanji_text.h"

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
      return tr("the disk is full. Make room; what was kept before is safe");
    case LearnerEvent::Cause::not_allowed:
      return tr("%1 may not be written. Check the permissions of the folder")
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
      return tr("No folder for learners is known: set NAZORI_LEARNERS. Nothing is kept.");
    case Kind::no_file:
      return reason(event.error);
    case Kind::in_use:
      return tr("“%1” is open in another window of Nazori. Close it there; until then nothing is kept here.")
          .arg(profile);
    case Kind::newer:
      return tr("The store of %1 was written by a newer Nazori or another program: %2. Nothing was changed, "
                "and nothing is kept.")
          .arg(profile, to_text(event.error.where));
    case Kind::damaged:
      return tr("The store of %1 is damaged: %2. Nothing was changed. A backup can be put in its place.")
          .arg(profile, to_text(event.error.where));
    case Kind::not_writable:
      return tr("The store of %1 cannot be written: %2. Nothing is kept.").arg(profile, cause(event));
    case Kind::changing_settings:
      return tr("Every character of %1 is being worked out anew. Nothing is kept until that is done.")
          .arg(profile);
    case Kind::replacing:
      return tr("Something is being put in the place of what %1 has done. Nothing is kept until it is there.")
          .arg(profile);
    case Kind::name_refused:
      return tr("“%1” cannot be the name of a learner: up to 60 bytes, no “/”, and no dot at "
                "its beginning.")
          .arg(profile);
    case Kind::opened_again:
      return tr("“%1” is open here now: everything is kept.").arg(profile);
    case Kind::not_saved:
      return tr("It could not be kept: %1.").arg(cause(event));
    case Kind::unread:
      return tr("The study data cannot be read: %1.").arg(reason(event.error));
    case Kind::backup_failed:
      return tr("Today's backup could not be made: %1. Studying works.").arg(reason(event.error));
  }
  return {};
}

QString LearnerWords::sentence(const std::optional<LearnerEvent>& event) {
  return event ? sentence(*event) : QString();
}

}  // namespace nazori::ui
