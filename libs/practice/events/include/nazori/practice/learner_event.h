// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "nazori/base/result.h"

namespace nazori::practice {

/// What happened to the study data of a learner, or why nothing can be saved.
struct LearnerEvent {
  enum class Kind : std::uint8_t {
    // Why nothing can be saved.
    no_folder,          ///< no folder for learners is known
    no_file,            ///< there is no file for this learner: `error`
    in_use,             ///< another program has the file open
    newer,              ///< it was written by a newer program or by another one: `error`
    damaged,            ///< `error`
    not_writable,       ///< `error` and `cause`
    changing_settings,  ///< SettingsChange is working on the file
    replacing,          ///< LearnerExchange is putting another file in its place
    // What happened.
    name_refused,   ///< `profile` cannot be the name of a learner
    opened_again,   ///< after trouble the learner can be saved
    not_saved,      ///< an action failed: `error` and `cause`
    unread,         ///< something could not be read: `error`
    backup_failed,  ///< today's backup could not be made: `error`
  };
  /// Why a file could not be written, where that can be seen.
  enum class Cause : std::uint8_t {
    other,        ///< as `error` says
    disk_full,    ///< of `folder`
    not_allowed,  ///< `folder` or a file in it may not be written
  };

  Kind kind = Kind::no_folder;
  std::string profile;  ///< of the learner
  base::Error error;    ///< for kinds that name it
  Cause cause = Cause::other;
  std::filesystem::path folder;  ///< existing folder that contains the learner's file, or will contain it

  friend bool operator==(const LearnerEvent&, const LearnerEvent&) = default;
};

/// Adds the cause and the folder to `event`: finds out why `file` could not be written.
[[nodiscard]] LearnerEvent with_cause(LearnerEvent event, const std::filesystem::path& file);

}  // namespace nazori::practice
