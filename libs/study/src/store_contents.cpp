// SPDX-License-Identifier: Apache-2.0
#include "daily_backup.h"
#include "entry_progress.h"
#include "learner_store_inside.h"
#include "store_days.h"

namespace nazori::study {
namespace {

using base::Errc;

/// Computes the histories of all characters in one pass.
class WholeHistory {
 public:
  void apply(const LogEntry& entry, const Settings& settings) {
    histories_.try_emplace(entry.character, CardHistory(entry.character))
        .first->second.apply(entry, settings);
  }
  void change_settings(const Settings& settings) {
    for (auto& [character, history] : histories_) history.change_settings(settings);
  }
  [[nodiscard]] Cards cards() const {
    Cards cards;
    for (const auto& [character, history] : histories_) cards.emplace(character, history.card());
    return cards;
  }

 private:
  std::map<char32_t, CardHistory> histories_;
};

}  // namespace

base::Result<LearnerStore::Followed> LearnerStore::follow_log(const base::Progress& progress) const {
  const Inside& in = *inside_;
  Followed followed;
  WholeHistory whole;
  SettingsInForce in_force(in.timeline);
  bool cancelled = false;
  auto read = for_each_entry(false, [&](const LoggedEntry& logged) {
    const LogEntry& entry = logged.entry;
    if (++followed.entries % kEntriesBetweenProgress == 0 && progress) {
      cancelled = !progress(static_cast<double>(entry.id) / static_cast<double>(in.last_id + 1), "rebuild");
      if (cancelled) return false;
    }
    if (!names_a_character(entry.kind) || in.undone.contains(entry.action)) return true;
    whole.apply(entry, in_force.at(entry.id, whole));
    return true;
  });
  if (!read) return tl::unexpected(std::move(read.error()));
  if (cancelled) return base::fail(Errc::cancelled, "stopped", in.name);
  in_force.finish(whole);
  followed.cards = whole.cards();
  return followed;
}

base::Result<RebuildReport> LearnerStore::rebuild(const base::Progress& progress) {
  Inside& in = *inside_;
  auto followed = follow_log(progress);
  if (!followed) return tl::unexpected(std::move(followed.error()));
  RebuildReport report;
  report.entries = followed->entries;
  Cards& cards = followed->cards;
  for (const auto& [character, card] : cards) {
    if (card.introduced) ++report.studied;
    const auto kept = in.cards.find(character);
    if (kept == in.cards.end() || !(kept->second == card)) ++report.differences;
  }
  for (const auto& [character, card] : in.cards) {
    if (!cards.contains(character)) ++report.differences;
  }
  report.cards = static_cast<int>(cards.size());
  return in.guarded([&]() -> base::Result<RebuildReport> {
    SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
    in.db.exec("DELETE FROM card; DELETE FROM brush_card");
    for (const auto& [character, card] : cards) put_card(in.db, card);
    rebuild_days(in.db);
    transaction.commit();
    in.cards = std::move(cards);
    return report;
  });
}

base::Result<void> LearnerStore::copy_to(const std::filesystem::path& file,
                                         const base::Progress& progress) const {
  return copy_database(inside_->db, file, progress);
}

}  // namespace nazori::study
