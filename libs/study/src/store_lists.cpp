// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "learner_store_inside.h"
#include "nazori/base/utf8.h"

namespace nazori::study {
namespace {

constexpr std::size_t kLongestName = 100;

base::Result<void> check_name(std::string_view name, const char* what) {
  if (can_be_name(name)) return {};
  return base::fail(base::Errc::bad_argument, std::string("is not a valid ") + what + " name",
                    std::string(name),
                    "give 1 to 100 bytes of text without line breaks and without spaces at the ends");
}

}  // namespace

bool can_be_name(std::string_view text) {
  if (text.empty() || text.size() > kLongestName || text.front() == ' ' || text.back() == ' ') return false;
  const auto decoded = base::decode_utf8(text);
  return decoded && std::none_of(decoded->begin(), decoded->end(),
                                 [](char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); });
}

void put_list(SQLite::Database& db, const CustomList& list) {
  SQLite::Statement put(db, "INSERT OR REPLACE INTO list VALUES(?)");
  put.bind(1, list.name);
  put.exec();
  SQLite::Statement clear(db, "DELETE FROM list_member WHERE list = ?");
  clear.bind(1, list.name);
  clear.exec();
  SQLite::Statement add(db, "INSERT INTO list_member VALUES(?, ?, ?)");
  int position = 0;
  std::set<char32_t> known;
  for (const char32_t character : list.characters) {
    if (!known.insert(character).second) continue;
    add.bind(1, list.name);
    add.bind(2, position++);
    add.bind(3, static_cast<std::int64_t>(character));
    add.exec();
    add.reset();
  }
}

void delete_list(SQLite::Database& db, const std::string& name) {
  for (const char* const sql :
       {"DELETE FROM list WHERE name = ?", "DELETE FROM list_member WHERE list = ?"}) {
    SQLite::Statement remove(db, sql);
    remove.bind(1, name);
    remove.exec();
  }
}

void put_tag(SQLite::Database& db, char32_t character, const std::string& tag) {
  SQLite::Statement put(db, "INSERT OR IGNORE INTO tag VALUES(?, ?)");
  put.bind(1, static_cast<std::int64_t>(character));
  put.bind(2, tag);
  put.exec();
}

base::Result<std::vector<CustomList>> LearnerStore::lists() const {
  return inside_->guarded([&]() -> base::Result<std::vector<CustomList>> {
    SQLite::Statement rows(inside_->db,
                           "SELECT name, character FROM list LEFT JOIN list_member ON list = name "
                           "ORDER BY name, position");
    std::vector<CustomList> lists;
    while (rows.executeStep()) {
      const std::string name = rows.getColumn(0).getString();
      if (lists.empty() || lists.back().name != name) lists.push_back({name, {}});
      const auto character = rows.getColumn(1);
      if (!character.isNull()) lists.back().characters.push_back(static_cast<char32_t>(character.getInt64()));
    }
    return lists;
  });
}

base::Result<void> LearnerStore::save_list(const CustomList& list) {
  if (auto fine = check_name(list.name, "list"); !fine) return fine;
  return inside_->guarded([&]() -> base::Result<void> {
    SQLite::Transaction transaction(inside_->db, SQLite::TransactionBehavior::IMMEDIATE);
    put_list(inside_->db, list);
    transaction.commit();
    return {};
  });
}

base::Result<void> LearnerStore::remove_list(std::string_view name) {
  return inside_->guarded([&]() -> base::Result<void> {
    SQLite::Transaction transaction(inside_->db, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement known(inside_->db, "SELECT 1 FROM list WHERE name = ?");
    known.bind(1, std::string(name));
    if (!known.executeStep())
      return base::fail(base::Errc::not_found, "this list does not exist", std::string(name));
    known.reset();
    delete_list(inside_->db, std::string(name));
    transaction.commit();
    return {};
  });
}

base::Result<std::vector<std::string>> LearnerStore::tags_of(char32_t character) const {
  return inside_->guarded([&]() -> base::Result<std::vector<std::string>> {
    std::vector<std::string> tags;
    SQLite::Statement rows(inside_->db, "SELECT tag FROM tag WHERE character = ? ORDER BY tag");
    rows.bind(1, static_cast<std::int64_t>(character));
    while (rows.executeStep()) tags.push_back(rows.getColumn(0).getString());
    return tags;
  });
}

base::Result<std::map<std::string, std::vector<char32_t>>> LearnerStore::tags() const {
  return inside_->guarded([&]() -> base::Result<std::map<std::string, std::vector<char32_t>>> {
    std::map<std::string, std::vector<char32_t>> tags;
    SQLite::Statement rows(inside_->db, "SELECT tag, character FROM tag ORDER BY tag, character");
    while (rows.executeStep()) {
      tags[rows.getColumn(0).getString()].push_back(static_cast<char32_t>(rows.getColumn(1).getInt64()));
    }
    return tags;
  });
}

base::Result<void> LearnerStore::set_tags(char32_t character, std::span<const std::string> tags) {
  for (const std::string& tag : tags) {
    if (auto fine = check_name(tag, "tag"); !fine) return fine;
  }
  return inside_->guarded([&]() -> base::Result<void> {
    SQLite::Transaction transaction(inside_->db, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement clear(inside_->db, "DELETE FROM tag WHERE character = ?");
    clear.bind(1, static_cast<std::int64_t>(character));
    clear.exec();
    for (const std::string& tag : tags) put_tag(inside_->db, character, tag);
    transaction.commit();
    return {};
  });
}

}  // namespace nazori::study
