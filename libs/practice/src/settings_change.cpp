// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/settings_change.h"

#include "nazori/study/card.h"

namespace nazori::practice {
namespace {

constexpr std::int64_t kSoonDone = 1'000;  ///< entries

}  // namespace

bool SettingsChange::takes_long(const study::LearnerStore& store, const study::Settings& wanted) {
  return study::changes_memory(store.settings(), wanted) && store.last_entry() > kSoonDone;
}

SettingsChange::SettingsChange(base::Inbox& inbox, Learner& learner)
    : learner_(learner), work_("settings", inbox) {}

void SettingsChange::start(const study::Settings& wanted) {
  if (!work_.begin()) return;
  const study::Time now = learner_.store().now();
  learner_.let_go(LearnerEvent::Kind::changing_settings);
  work_.run(
      [wanted, now, file = learner_.file()](const base::Progress& progress) -> base::Result<void> {
        auto store = study::LearnerStore::open(
            file, study::Access::write, [now] { return now; }, study::Upkeep::later);
        if (!store) return tl::unexpected(store.error());
        return store->change_settings(wanted, progress);
      },
      [this](const base::Result<void>& changed) {
        work_.end();
        (void)learner_.open_again();
        finished(changed);
      });
}

}  // namespace nazori::practice
