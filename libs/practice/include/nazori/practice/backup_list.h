// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "nazori/base/latest.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/practice/learner.h"
#include "nazori/study/backups.h"

namespace nazori::practice {

/// The origin of a backup.
enum class BackupKind : std::uint8_t {
  daily,           ///< made automatically, on a study day
  own,             ///< the learner asked for it
  before_restore,  ///< the data that a restored backup replaced
  before_upgrade,  ///< before the file was brought to a newer version
};

/// A backup with what is known about it.
struct ListedBackup {
  study::Backup backup;
  BackupKind kind = BackupKind::daily;
  std::optional<study::Day> day;  ///< of a daily backup, if its name contains the day
  /// Its content, or why it cannot be used; nothing while it is being read.
  std::optional<base::Result<study::BackupContents>> contents;

  /// Whether it can be restored.
  [[nodiscard]] bool is_sound() const { return contents && contents->has_value(); }
};

/// The backups of the present learner, newest first. The content of each is read on a separate thread.
/// Thread: the owner of the inbox.
class BackupList {
 public:
  /// The list is empty before refresh(). @param learner  outlives this.
  BackupList(base::Inbox& inbox, const Learner& learner);

  /// Lists the present backups; the content of each follows.
  void refresh();
  [[nodiscard]] const std::vector<ListedBackup>& backups() const { return backups_; }

  /// The content of this one of backups() is known.
  base::Signal<std::size_t> read;

 private:
  using Files = std::vector<std::filesystem::path>;
  using Part = std::pair<std::size_t, base::Result<study::BackupContents>>;

  const Learner& learner_;
  std::vector<ListedBackup> backups_;
  base::Latest<Files, std::monostate, Part>
      reading_;  // declared last, so that it is destroyed before the members it uses
};

}  // namespace nazori::practice
