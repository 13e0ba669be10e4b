// SPDX-License-Identifier: Apache-2.0
// What a learner chose to learn and what is known already, as one action.
#include <algorithm>

#include "learner_store_inside.h"
#include "nazori/base/utf8.h"
#include "nazori/json/reader.h"
#include "settings_json.h"

namespace nazori::study {
namespace {

constexpr const char* kMadeList = "made_list";

std::string characters_of(const CustomList& list) {
  return base::encode_utf8(std::u32string(list.characters.begin(), list.characters.end()));
}

std::string choices_json(const Settings& settings, const std::optional<CustomList>& list) {
  json::Value value = settings_json(settings);
  if (list) value[kMadeList] = {{"name", list->name}, {"characters", characters_of(*list)}};
  return value.dump(-1, ' ', false, json::Value::error_handler_t::replace);
}

/// The list that was made with choices.
std::optional<CustomList> made_list(const std::string& choices) {
  const auto document = json::parse(choices);
  if (!document || !document->contains(kMadeList)) return std::nullopt;
  const json::Value& made = (*document)[kMadeList];
  if (!made.is_object()) return std::nullopt;
  const auto characters = base::decode_utf8(made.value("characters", std::string()));
  if (!characters) return std::nullopt;
  return CustomList{made.value("name", std::string()), {characters->begin(), characters->end()}};
}

base::Result<void> check_known(std::span<const KnownCharacter> known) {
  for (const KnownCharacter& one : known)
    if (auto fine = check_writing(one.character, 1, {}); !fine) return fine;
  return {};
}

}  // namespace

void LearnerStore::Inside::add_known(std::span<const KnownCharacter> known, LogEntry& next, Cards& changed) {
  LogWriter log(db);
  next.kind = EntryKind::known;
  for (const KnownCharacter& one : known) {
    next.character = one.character;
    next.until = one.due;
    log.add(next);
    ++next.id;
    if (auto card = refresh_row(one.character)) changed[one.character] = *card;
  }
}

std::vector<std::int64_t> LearnerStore::Inside::undo_choices(std::int64_t action) {
  SQLite::Statement rows(db, "SELECT id, settings FROM log WHERE action = ? AND kind = ?");
  rows.bind(1, action);
  rows.bind(2, static_cast<int>(EntryKind::choices));
  std::vector<std::int64_t> ids;
  std::optional<CustomList> made;
  while (rows.executeStep()) {
    ids.push_back(rows.getColumn(0).getInt64());
    made = made_list(rows.getColumn(1).getString());
  }
  if (!made) return ids;
  const auto before = std::find_if(timeline.rbegin(), timeline.rend(), [&](const auto& one) {
    return std::find(ids.begin(), ids.end(), one.first) == ids.end();
  });
  const auto& lists = before->second.new_lists;
  if (std::find(lists.begin(), lists.end(), "list:" + made->name) != lists.end()) return ids;
  SQLite::Statement members(db, "SELECT character FROM list_member WHERE list = ? ORDER BY position");
  members.bind(1, made->name);
  std::vector<char32_t> now;
  while (members.executeStep()) now.push_back(static_cast<char32_t>(members.getColumn(0).getInt64()));
  members.reset();
  if (now == made->characters) delete_list(db, made->name);
  return ids;
}

base::Result<void> LearnerStore::know(std::span<const KnownCharacter> known) {
  return choose({settings(), std::nullopt, {known.begin(), known.end()}});
}

base::Result<void> LearnerStore::choose(const StudyChoices& choices) {
  const Settings& present = settings();
  if (auto fine = check(choices.settings); !fine) return fine;
  if (auto fine = check_known(choices.known); !fine) return fine;
  if (changes_memory(present, choices.settings) || present.day_starts_at != choices.settings.day_starts_at ||
      present.time_zone != choices.settings.time_zone)
    return base::fail(base::Errc::bad_argument, "change intervals or days", "settings");
  if (choices.list) {
    if (!can_be_name(choices.list->name))
      return base::fail(base::Errc::bad_argument, "is not a valid list name", choices.list->name);
    const auto own = lists();
    if (!own) return tl::unexpected(own.error());
    if (std::any_of(own->begin(), own->end(),
                    [&](const CustomList& one) { return one.name == choices.list->name; }))
      return base::fail(base::Errc::bad_argument, "is the name of another list", choices.list->name);
  }
  const bool has_settings = choices.list || !(choices.settings == present);
  if (!has_settings && choices.known.empty()) return {};
  return inside_->guarded([&]() -> base::Result<void> {
    Inside& in = *inside_;
    LogEntry entry = in.next_entry(EntryKind::known);
    Cards changed = in.cards;
    SQLite::Transaction transaction(in.db, SQLite::TransactionBehavior::IMMEDIATE);
    in.add_known(choices.known, entry, changed);
    if (has_settings) {
      if (choices.list) put_list(in.db, *choices.list);
      entry.kind = EntryKind::choices;
      entry.character = 0;
      entry.until.reset();
      entry.settings = choices_json(choices.settings, choices.list);
      LogWriter(in.db).add(entry);
      ++entry.id;
    }
    transaction.commit();
    in.last_id = entry.id - 1;
    in.cards = std::move(changed);
    if (has_settings) in.timeline.emplace_back(in.last_id, choices.settings);
    return {};
  });
}

}  // namespace nazori::study
