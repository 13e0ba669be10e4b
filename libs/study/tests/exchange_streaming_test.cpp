// SPDX-License-Identifier: Apache-2.0
// Export and import go piece by piece: what they hold does not grow with the log.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "big_learner.h"
#include "learner_fixture.h"
#include "nazori/base/file.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define NAZORI_SANITIZED
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define NAZORI_SANITIZED
#endif

namespace nazori::study {
namespace {

using base::Errc;
using test::BigLearner;
using test::MovedClock;
using test::must;
using test::TemporaryFolder;
using testing::HasSubstr;

constexpr std::size_t kLongestPiece = std::size_t{80} << 10;

LearnerStore in_memory() { return must(LearnerStore::in_memory(MovedClock("2026-01-01T09:00:00Z").clock())); }

LearnerStore learner_of(std::int64_t entries) {
  LearnerStore store = in_memory();
  BigLearner big(entries);
  const auto imported = import_json(store, big.json());
  EXPECT_TRUE(imported) << base::to_line(imported.error());
  return store;
}

using Export = base::Result<void> (*)(const LearnerStore&, const TextSink&, const base::Progress&);
constexpr std::array<Export, 2> kExports{export_json, export_csv};

TEST(ExchangeStreaming, AnExportIsHandedOverInSmallPieces) {
  const LearnerStore store = learner_of(2'000);
  for (const Export& write : kExports) {
    std::size_t longest = 0;
    std::size_t all = 0;
    ASSERT_TRUE(write(store,
                      [&](std::string_view piece) -> base::Result<void> {
                        longest = std::max(longest, piece.size());
                        all += piece.size();
                        return {};
                      },
                      {}));
    EXPECT_LE(longest, kLongestPiece);
    EXPECT_GT(all, 2 * kLongestPiece) << "else nothing was tried";
  }
}

TEST(ExchangeStreaming, ASinkThatFailsEndsTheExportWithItsError) {
  const LearnerStore store = learner_of(2'000);
  for (const Export& write : kExports) {
    int calls = 0;
    const auto done = write(store,
                            [&](std::string_view) -> base::Result<void> {
                              ++calls;
                              return base::fail(Errc::io, "the disk is full", "here");
                            },
                            {});
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().what, "the disk is full");
    EXPECT_EQ(calls, 1);
  }
}

TEST(ExchangeStreaming, AnExportTellsHowFarItIsAndStopsWhenAsked) {
  const LearnerStore store = learner_of(2'000);
  for (const Export& write : kExports) {
    std::vector<double> reported;
    const auto keep = [](std::string_view) -> base::Result<void> { return {}; };
    ASSERT_TRUE(write(store, keep, [&](double done, std::string_view) {
      reported.push_back(done);
      return true;
    }));
    ASSERT_GT(reported.size(), 4U);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
    EXPECT_GE(reported.front(), 0);
    EXPECT_LE(reported.back(), 1);
    EXPECT_GT(reported.back(), 0.8);
    // Stops at each moment at which it may be stopped.
    for (std::size_t at = 1; at <= reported.size(); at += 3) {
      std::size_t asked = 0;
      const auto stopped = write(store, keep, [&](double, std::string_view) { return ++asked < at; });
      ASSERT_FALSE(stopped) << at;
      EXPECT_EQ(stopped.error().code, Errc::cancelled);
      EXPECT_EQ(asked, at);
    }
  }
}

TEST(ExchangeStreaming, AnImportThatNeverEndsIsStoppedAndChangesNothing) {
  BigLearner endless(0);
  LearnerStore store = in_memory();
  int asked = 0;
  const auto stopped =
      import_json(store, endless.json(), [&](double, std::string_view) { return ++asked < 3'000; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, Errc::cancelled);
  EXPECT_EQ(store.last_entry(), 0);
  EXPECT_TRUE(store.cards().empty());
  EXPECT_TRUE(import_json(store, BigLearner(300).json())) << "it is as empty as before";
  EXPECT_EQ(store.last_entry(), 300);
}

TEST(ExchangeStreaming, AnImportIsStoppedWhileCardsAreWorkedOutToo) {
  BigLearner big(1'000);
  double last = 0;
  int asked = 0;
  LearnerStore store = in_memory();
  ASSERT_TRUE(import_json(store, big.json(), [&](double done, std::string_view) {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1);
    last = done;
    ++asked;
    return true;
  }));
  EXPECT_GT(last, 0.8) << "told after the text was read";
  LearnerStore other = in_memory();
  const auto stopped =
      import_json(other, BigLearner(1'000).json(), [&](double, std::string_view) { return --asked > 0; });
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().code, Errc::cancelled);
  EXPECT_EQ(other.last_entry(), 0);
}

TEST(ExchangeStreaming, ASourceThatFailsIsNamedAndNothingChanges) {
  BigLearner big(1'000);
  LearnerStore store = in_memory();
  TextSource source = big.json();
  int pieces = 0;
  source.read = [read = source.read, &pieces](std::span<char> room) -> base::Result<std::size_t> {
    if (++pieces > 500) return base::fail(Errc::io, "cannot be read: the stick was pulled out", "me.json");
    return read(room);
  };
  const auto done = import_json(store, source);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, Errc::io);
  EXPECT_EQ(done.error().where, "me.json");
  EXPECT_EQ(store.last_entry(), 0);
}

TEST(ExchangeStreaming, ATextWithoutEndInOneEntryIsRefused) {
  struct Endless {
    std::string begin, on;
  };
  for (const auto& [begin, on] :
       {Endless{"{\"entries\": [{\"ink\": \"", "A"}, Endless{"{\"entries\": [\n  ", " "},
        Endless{"{\"entries\": [{\"id\": 1", ", \"id\": 1"}, Endless{"{\"other\": \"", "x"},
        Endless{" ", "\n"}}) {
    std::string rest = begin;
    std::string piece;
    while (piece.size() < 50'000) piece += on;
    const TextSource endless{[&rest, &piece](std::span<char> room) -> base::Result<std::size_t> {
                               while (rest.size() < room.size()) rest += piece;
                               rest.copy(room.data(), room.size());
                               rest.erase(0, room.size());
                               return room.size();
                             },
                             0};
    const auto checked = check_json(endless);
    ASSERT_FALSE(checked) << begin;
    EXPECT_EQ(checked.error().code, Errc::parse);
    EXPECT_THAT(checked.error().what, HasSubstr("too long")) << begin;
  }
}

TEST(ExchangeStreaming, WhatIsPassedOverMayBeLong) {
  std::string notes = "[0";
  for (int i = 0; i < 6'000'000; ++i) notes += ", 0";
  std::string text = must(export_json(learner_of(3)));
  text.insert(1, "\"notes\": " + notes + "], ");
  ASSERT_LT(std::size_t{17} << 20, text.size()) << "longer than an entry may be";
  text.insert(1, "\"more\": " + notes + "], ");
  EXPECT_TRUE(check_json(text_source(text)));
}

/// A small export as another program might write it: many lines for an entry, members in another order.
nlohmann::json rewritten() { return nlohmann::json::parse(must(export_json(learner_of(3)))); }

TEST(ExchangeStreaming, MembersMayStandInAnyOrderAndOnManyLines) {
  const std::string text = rewritten().dump(2);
  ASSERT_LT(text.find("\"entries\""), text.find("\"format\"")) << "sorted";
  LearnerStore store = in_memory();
  const auto imported = import_json(store, text_source(text));
  ASSERT_TRUE(imported) << base::to_line(imported.error());
  EXPECT_EQ(must(export_json(store)), must(export_json(learner_of(3))));
}

TEST(ExchangeStreaming, AFaultIsNamedByTheLineItStandsInAndItsPlace) {
  nlohmann::json json = rewritten();
  json["entries"][1]["score"] = 850;
  const std::string text = json.dump(2);
  const auto before = text.begin() + static_cast<std::ptrdiff_t>(text.find("850"));
  const auto checked = check_json(text_source(text));
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().where,
            "line " + std::to_string(1 + std::count(text.begin(), before, '\n')) + ", entries/1/score");
}

TEST(ExchangeStreaming, AnotherFormatIsTheReasonWhereverItStands) {
  nlohmann::json json = rewritten();
  json["format"] = "nazori-teacher";
  json["entries"][1]["score"] = "high";
  EXPECT_EQ(check_json(text_source(json.dump())).error().code, Errc::schema);
  json["format"] = "nazori-learner";
  json["version"] = 2;
  EXPECT_THAT(base::to_line(check_json(text_source(json.dump())).error()), HasSubstr("newer"));
}

TEST(ExchangeStreaming, WhatIsMissingOrOfAnotherKindIsNamed) {
  const auto refusal = [](const nlohmann::json& json) {
    const auto checked = check_json(text_source(json.dump()));
    return checked ? std::string() : base::to_line(checked.error());
  };
  ASSERT_EQ(refusal(rewritten()), "");
  for (const char* member : {"entries", "lists", "tags", "format", "version"}) {
    nlohmann::json json = rewritten();
    json.erase(member);
    EXPECT_THAT(refusal(json), testing::AllOf(HasSubstr(member), HasSubstr("missing")));
    json[member] = nlohmann::json::object();
    EXPECT_THAT(refusal(json), testing::AllOf(HasSubstr(member), HasSubstr("is not "))) << member;
    json[member] = true;
    EXPECT_THAT(refusal(json), testing::AllOf(HasSubstr(member), HasSubstr("is not "))) << member;
  }
  for (const char* list : {"entries", "lists", "tags"}) {
    for (const nlohmann::json& element : {nlohmann::json(7), nlohmann::json::array({1, 2})}) {
      nlohmann::json json = rewritten();
      json[list].push_back(element);
      EXPECT_THAT(refusal(json), testing::AllOf(HasSubstr(list), HasSubstr("is not an object"))) << list;
    }
  }
  nlohmann::json json = rewritten();
  json["notes"] = {{"entries", {1, 2, {{"id", 3}}}}};
  EXPECT_EQ(refusal(json), "") << "what is not known is passed over";
  EXPECT_THAT(refusal(nlohmann::json::array({rewritten()})), HasSubstr("is not an object"));
  EXPECT_THAT(refusal(nlohmann::json("text")), HasSubstr("is not an object"));
  EXPECT_THAT(base::to_line(check_json(text_source(rewritten().dump() + "x")).error()),
              HasSubstr("not JSON"));
  EXPECT_THAT(base::to_line(check_json(text_source("")).error()), HasSubstr("not JSON"));
  EXPECT_THAT(base::to_line(check_json(text_source(std::string(100'000, '['))).error()),
              HasSubstr("is not an object"));
  EXPECT_THAT(base::to_line(check_json(text_source("{\"x\":" + std::string(100'000, '['))).error()),
              HasSubstr("nested too deeply"));
}

TEST(ExchangeStreaming, AFileIsReadAsItsTextIs) {
  const TemporaryFolder folder;
  const LearnerStore store = learner_of(500);
  const std::string text = must(export_json(store));
  ASSERT_TRUE(base::write_file(folder / "me.json", std::string_view(text)));
  const TextSource source = must(file_source(folder / "me.json"));
  EXPECT_EQ(source.bytes, text.size());
  LearnerStore other = in_memory();
  ASSERT_TRUE(import_json(other, source));
  EXPECT_EQ(must(export_json(other)), text);
  EXPECT_EQ(other.cards(), store.cards());
  EXPECT_EQ(file_source(folder / "none.json").error().code, Errc::not_found);
  EXPECT_EQ(file_source(folder / "").error().code, Errc::io);
}

#ifndef NAZORI_SANITIZED
/// The largest growth of the memory of a separate process during `work`, in MiB.
template <class Work>
double growth_mib(Work work) {
  const auto field = [](const char* name) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
      long kib = 0;
      if (word == name && status >> kib) return kib;
    }
    return -1L;
  };
  std::array<int, 2> channel{};
  EXPECT_EQ(::pipe(channel.data()), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    (void)::malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // resets the peak to the present value
    const long before = field("VmRSS:");
    const bool fine = work();
    const double grown = static_cast<double>(field("VmHWM:") - before) / 1024;
    ::_exit(fine && ::write(channel[1], &grown, sizeof grown) == sizeof grown ? 0 : 1);
  }
  ::close(channel[1]);
  double grown = -1;
  EXPECT_EQ(::read(channel[0], &grown, sizeof grown), static_cast<ssize_t>(sizeof grown));
  ::close(channel[0]);
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  return grown;
}

TEST(ExchangeStreaming, WhatAnExchangeHoldsDoesNotGrowWithTheLog) {
  // As JSON these are 17 MB, and several times that as values in memory.
  constexpr std::int64_t kEntries = 12'000;
  constexpr double kMost = 16;
  const TemporaryFolder folder;
  BigLearner big(kEntries);
  EXPECT_LT(growth_mib([&] {
              auto store = LearnerStore::open(folder / "learner.db", Access::write);
              return store && import_json(*store, big.json()).has_value();
            }),
            kMost);
  const auto nothing = [](std::string_view) -> base::Result<void> { return {}; };
  EXPECT_LT(growth_mib([&] {
              const auto store = LearnerStore::open(folder / "learner.db", Access::read);
              return store && store->last_entry() == kEntries && export_json(*store, nothing).has_value();
            }),
            kMost);
  EXPECT_LT(growth_mib([&] {
              const auto store = LearnerStore::open(folder / "learner.db", Access::read);
              return store && export_csv(*store, nothing).has_value();
            }),
            kMost);
  EXPECT_LT(growth_mib([&] { return check_json(big.json()).has_value(); }), kMost);
}
#endif

}  // namespace
}  // namespace nazori::study
