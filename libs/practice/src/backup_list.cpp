// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/backup_list.h"

#include <string>
#include <string_view>

namespace nazori::practice {
namespace {

ListedBackup listed(const study::Backup& backup) {
  constexpr std::string_view kDaily = "daily-";
  const std::string name = backup.file.stem().string();
  ListedBackup made{backup, BackupKind::before_upgrade, std::nullopt, std::nullopt};
  if (backup.automatic) {
    made.kind = BackupKind::daily;
    if (const auto day = study::parse_day(name.substr(kDaily.size()))) made.day = *day;
  } else if (name.starts_with("own-")) {
    made.kind = BackupKind::own;
  } else if (name.starts_with("before-restore-")) {
    made.kind = BackupKind::before_restore;
  }
  return made;
}

}  // namespace

BackupList::BackupList(base::Inbox& inbox, const Learner& learner)
    : learner_(learner),
      reading_(
          "backups", inbox,
          [](const Files& files, const auto& run) {
            for (std::size_t i = 0; i < files.size() && run.is_wanted(); ++i)
              run.report({i, study::look_into(files[i])});
            return std::monostate();
          },
          [](std::monostate) {},
          [this](Part part) {
            backups_[part.first].contents = std::move(part.second);
            read(part.first);
          }) {}

void BackupList::refresh() {
  backups_.clear();
  Files files;
  for (const study::Backup& backup : study::backups_of(learner_.file())) {
    backups_.push_back(listed(backup));
    files.push_back(backup.file);
  }
  reading_.request(std::move(files));
}

}  // namespace nazori::practice
