// SPDX-License-Identifier: Apache-2.0
// Which entries make a log.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "learner_fixture.h"
#include "nazori/study/exchange.h"
#include "nazori/study/store_filling.h"

namespace nazori::study {
namespace {

using test::MovedClock;
using test::must;
using test::some_ink;
using testing::HasSubstr;

constexpr char32_t kRest = U'休';
constexpr char32_t kTree = U'木';

LearnerStore in_memory(const MovedClock& clock) { return must(LearnerStore::in_memory(clock.clock())); }

/// The error for entries that do not form a valid log; empty where they do.
std::string refused(const std::vector<LogEntry>& entries,
                    const std::vector<std::uint8_t>& ink_of_the_last = {}) {
  const auto checked =
      LearnerStore::check_contents([&](LearnerStore::Filling& filling) -> base::Result<void> {
        for (std::size_t i = 0; i < entries.size(); ++i) {
          const bool last = i + 1 == entries.size();
          if (auto added = filling.add(entries[i], last ? ink_of_the_last : std::vector<std::uint8_t>());
              !added)
            return added;
        }
        return {};
      });
  return checked ? std::string() : base::to_line(checked.error());
}

LogEntry entry(std::int64_t id, EntryKind kind, char32_t character = 0, std::int64_t action = 0) {
  LogEntry entry;
  entry.id = id;
  entry.action = action == 0 ? id : action;
  entry.kind = kind;
  entry.character = character;
  return entry;
}

TEST(Filling, EntriesAreNumberedInOrderAndBelongToAnAction) {
  EXPECT_EQ(refused({entry(1, EntryKind::pause, kTree), entry(2, EntryKind::pause, kRest, 1),
                     entry(3, EntryKind::pause, kRest, 1), entry(4, EntryKind::resume, kRest)}),
            "");
  EXPECT_THAT(refused({entry(2, EntryKind::pause, kTree)}), HasSubstr("entry 2: is out of order"));
  EXPECT_THAT(refused({entry(0, EntryKind::pause, kTree)}), HasSubstr("out of order"));
  EXPECT_THAT(refused({entry(1, EntryKind::pause, kTree), entry(1, EntryKind::pause, kTree)}),
              HasSubstr("out of order"));
  EXPECT_THAT(refused({entry(1, EntryKind::pause, kTree), entry(3, EntryKind::pause, kTree)}),
              HasSubstr("out of order"));
  EXPECT_THAT(refused({entry(1, EntryKind::pause, kTree), entry(2, EntryKind::pause, kTree),
                       entry(3, EntryKind::pause, kTree, 1)}),
              HasSubstr("belongs to no action"))
      << "another began meanwhile";
  EXPECT_THAT(refused({entry(1, EntryKind::pause, kTree, 5)}), HasSubstr("belongs to no action"));
}

TEST(Filling, EachKindHasWhatBelongsToItAndNothingElse) {
  for (const EntryKind kind : {EntryKind::pause, EntryKind::resume, EntryKind::reset, EntryKind::leech_met}) {
    EXPECT_EQ(refused({entry(1, kind, kTree)}), "");
    EXPECT_THAT(refused({entry(1, kind)}), HasSubstr("is not the name of a character"));
    EXPECT_THAT(refused({entry(1, kind, kTree)}, must(pack(some_ink()))),
                HasSubstr("has ink but is not a writing"));
  }
  LogEntry writing = entry(1, EntryKind::writing, kTree);
  EXPECT_EQ(refused({writing}), "");
  EXPECT_EQ(refused({writing}, must(pack(some_ink()))), "");
  EXPECT_THAT(refused({writing}, {1, 2, 3}), HasSubstr("ink that cannot be read"));
  writing.writing.result.score = 101;
  EXPECT_THAT(refused({writing}), HasSubstr("0..100"));
  EXPECT_THAT(refused({entry(1, EntryKind::writing)}), HasSubstr("is not the name of a character"));

  LogEntry settings = entry(1, EntryKind::settings);
  EXPECT_THAT(refused({settings}), HasSubstr("settings that cannot be read"));
  settings.settings = "{}";
  EXPECT_EQ(refused({settings}), "");
  settings.character = kTree;
  EXPECT_THAT(refused({settings}), HasSubstr("names a character where none belongs"));

  LogEntry postpone = entry(1, EntryKind::postpone, kTree);
  EXPECT_THAT(refused({postpone}), HasSubstr("no day it postpones to"));
  postpone.until = Day();
  EXPECT_EQ(refused({postpone}), "");
  postpone.kind = EntryKind::pause;
  EXPECT_THAT(refused({postpone}), HasSubstr("no day it postpones to")) << "nor may another have one";
}

TEST(Filling, AnUndoUndoesAnActionOnCharacters) {
  const auto undo = [](std::int64_t id, std::optional<std::int64_t> action) {
    LogEntry one = entry(id, EntryKind::undo);
    one.undoes = action;
    return one;
  };
  const LogEntry pause = entry(1, EntryKind::pause, kTree);
  EXPECT_EQ(refused({pause, undo(2, 1)}), "");
  EXPECT_THAT(refused({pause, undo(2, std::nullopt)}), HasSubstr("undoes no action"));
  EXPECT_THAT(refused({pause, undo(2, 2)}), HasSubstr("undoes no action"));
  EXPECT_THAT(refused({pause, undo(2, 1), undo(3, 2)}), HasSubstr("undoes no action"));
  EXPECT_THAT(refused({pause, entry(2, EntryKind::pause, kRest, 1), undo(3, 2)}),
              HasSubstr("undoes no action"))
      << "an entry in the middle of one";
  LogEntry settings = entry(1, EntryKind::settings);
  settings.settings = "{}";
  EXPECT_THAT(refused({settings, undo(2, 1)}), HasSubstr("undoes no action"));
  LogEntry resume = entry(2, EntryKind::resume, kTree);
  resume.undoes = 1;
  EXPECT_THAT(refused({pause, resume}), HasSubstr("undoes no action"));
}

TEST(Filling, IsForAStoreThatHoldsNothing) {
  const MovedClock clock("2026-01-01T09:00:00Z");
  const LearnerStore::Source one_pause = [](LearnerStore::Filling& filling) {
    return filling.add(entry(1, EntryKind::pause, kTree), {});
  };
  LearnerStore with_list = in_memory(clock);
  ASSERT_TRUE(with_list.save_list({"a", {}}));
  LearnerStore with_tag = in_memory(clock);
  const std::vector<std::string> tags{"a"};
  ASSERT_TRUE(with_tag.set_tags(kTree, tags));
  LearnerStore with_entry = in_memory(clock);
  ASSERT_TRUE(with_entry.pause(std::array{kTree}));
  for (LearnerStore* store : {&with_list, &with_tag, &with_entry})
    EXPECT_THAT(store->fill(one_pause).error().what, HasSubstr("not empty"));
  LearnerStore empty = in_memory(clock);
  ASSERT_TRUE(empty.fill(one_pause));
  EXPECT_TRUE(empty.card(kTree).paused);
  EXPECT_EQ(empty.last_entry(), 1);
}

}  // namespace
}  // namespace nazori::study
