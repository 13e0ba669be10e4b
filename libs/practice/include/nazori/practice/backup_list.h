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

/// How a backup came about.
enum class BackupKind : std::uint8_t {
  daily,           ///< by itself, on a study day
  own,             ///< the learner asked for it
  before_restore,  ///< what a restored backup replaced
  before_upgrade,  ///< before the file was brought to a newer version
};

/// A backup, and what is known of it.
struct ListedBackup {
  study::Backup backup;
  BackupKind kind = BackupKind::daily;
  std::optional<study::Day> day;  ///< of a daily one, where its name says it
  /// What it holds, or why it cannot be used; nothing while it is being read.
  std::optional<base::Result<study::BackupContents>> contents;

  /// Whether it can be restored.
  [[nodiscard]] bool is_sound() const { return contents && contents->has_value(); }
};

/// The backups of the present learner, newest first. What each holds is read on a thread of its own.
/// Thread: the owner of the inbox.
class BackupList {
 public:
  /// Lists nothing before refresh(). @param learner  outlives this.
  BackupList(base::Inbox& inbox, const Learner& learner);

  /// Lists what is there now; what each holds follows.
  void refresh();
  [[nodiscard]] const std::vector<ListedBackup>& backups() const { return backups_; }

  /// What this one of backups() holds is known.
  base::Signal<std::size_t> read;

 private:
  using Files = std::vector<std::filesystem::path>;
  using Part = std::pair<std::size_t, base::Result<study::BackupContents>>;

  const Learner& learner_;
  std::vector<ListedBackup> backups_;
  base::Latest<Files, std::monostate, Part> reading_;  // declared last, so that it ends before what it uses
};

}  // namespace nazori::practice
