// SPDX-License-Identifier: Apache-2.0
#include "nazori/base/latest.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace nazori::base {
namespace {

/// Answers with the square of a number, once the test lets it continue.
struct Squares {
  std::atomic<int> begun{0};
  std::atomic<bool> held{false};
  std::vector<int> answers;
  std::vector<double> parts;
  Inbox inbox;
  Latest<int, int> latest{"squares", inbox,
                          [this](int number, const auto& run) {
                            ++begun;
                            while (held && run.is_wanted()) std::this_thread::yield();
                            run.report(0.5);
                            return number * number;
                          },
                          [this](int answer) { answers.push_back(answer); },
                          [this](double part) { parts.push_back(part); }};

  void wait_for_begun(int count) const {
    while (begun < count) std::this_thread::yield();
  }
};

TEST(Latest, AnswersARequestOnTheOwnersThread) {
  Squares squares;
  EXPECT_FALSE(squares.latest.is_busy());
  EXPECT_EQ(squares.latest.request(3), 1U);
  EXPECT_TRUE(squares.latest.is_busy());
  squares.inbox.run_until([&] { return !squares.latest.is_busy(); });
  EXPECT_EQ(squares.answers, std::vector{9});
  EXPECT_EQ(squares.parts, std::vector{0.5});
}

TEST(Latest, PartsThatNobodyWantsAreDropped) {
  Inbox inbox;
  int answer = 0;
  Latest<int, int> latest{"parts", inbox,
                          [](int number, const auto& run) {
                            run.report(0.5);
                            return number;
                          },
                          [&answer](int made) { answer = made; }};
  latest.request(7);
  inbox.run_until([&] { return !latest.is_busy(); });
  EXPECT_EQ(answer, 7);
}

TEST(Latest, ANewerRequestStopsTheOneThatRunsAndDropsItsAnswerAndItsParts) {
  Squares squares;
  squares.held = true;
  squares.latest.request(2);
  squares.wait_for_begun(1);
  EXPECT_EQ(squares.latest.request(3), 2U);
  squares.held = false;
  squares.inbox.run_until([&] { return !squares.latest.is_busy(); });
  EXPECT_EQ(squares.answers, std::vector{9});
  EXPECT_EQ(squares.parts, std::vector{0.5});
  EXPECT_EQ(squares.begun, 2);
}

TEST(Latest, ARequestThatIsOvertakenBeforeItBeginsNeverRuns) {
  Squares squares;
  squares.held = true;
  squares.latest.request(2);
  squares.wait_for_begun(1);
  for (int number = 3; number <= 6; ++number) squares.latest.request(number);
  squares.held = false;
  squares.inbox.run_until([&] { return !squares.latest.is_busy(); });
  EXPECT_EQ(squares.answers, std::vector{36});
  EXPECT_EQ(squares.begun, 2);
}

TEST(Latest, AnAnswerThatWaitsInTheInboxIsDroppedByANewerRequest) {
  Squares squares;
  squares.latest.request(2);
  bool is_posted = false;
  squares.latest.cancel_and_wait();
  squares.inbox.post([&] { is_posted = true; });
  squares.inbox.run_until([&] { return is_posted; });
  EXPECT_TRUE(squares.answers.empty());
  EXPECT_TRUE(squares.parts.empty());
}

TEST(Latest, CancellingLeavesItReadyForTheNextRequest) {
  Squares squares;
  squares.held = true;
  squares.latest.request(2);
  squares.wait_for_begun(1);
  squares.latest.cancel();
  EXPECT_FALSE(squares.latest.is_busy());
  squares.held = false;
  EXPECT_EQ(squares.latest.request(4), 3U) << "a cancelled number is not given out again";
  squares.inbox.run_until([&] { return !squares.latest.is_busy(); });
  EXPECT_EQ(squares.answers, std::vector{16});
}

TEST(Latest, AnAnswerMayMakeTheNextRequest) {
  Inbox inbox;
  std::vector<int> answers;
  std::unique_ptr<Latest<int, int>> latest;
  latest = std::make_unique<Latest<int, int>>(
      "test", inbox, [](int number, const auto&) { return number; },
      [&](int answer) {
        answers.push_back(answer);
        if (answer < 3) latest->request(answer + 1);
      });
  latest->request(1);
  inbox.run_until([&] { return !latest->is_busy(); });
  EXPECT_EQ(answers, (std::vector{1, 2, 3}));
}

TEST(Latest, AnAnswerMayEndIt) {
  Inbox inbox;
  std::unique_ptr<Latest<int, std::string>> latest;
  latest = std::make_unique<Latest<int, std::string>>(
      "test", inbox,
      [](int length, const auto&) { return std::string(static_cast<std::size_t>(length), 'x'); },
      [&, kept = std::string(1000, 'y')](const std::string& text) {
        latest.reset();
        EXPECT_EQ(text.size() + kept.size(), 2000U);
      });
  latest->request(1000);
  inbox.run_until([&] { return latest == nullptr; });
}

TEST(Latest, TwoMayShareAThreadAndTheEndOfOneLeavesTheOther) {
  Inbox inbox;
  const auto background = std::make_shared<Background>("shared", inbox);
  const auto same = [](int number, const auto&) { return number; };
  int received = 0;
  auto first = std::make_unique<Latest<int, int>>(background, same, [](int) { FAIL() << "it is gone"; });
  Latest<int, int> second(background, same, [&](int number) { received = number; });
  first->request(1);
  second.request(2);
  first.reset();
  inbox.run_until([&] { return !second.is_busy(); });
  EXPECT_EQ(received, 2);
}

TEST(Latest, ItsEndStopsTheWorkAndWaitsForIt) {
  Inbox inbox;
  std::atomic<bool> begun{false}, ended{false};
  {
    Latest<int, int> latest(
        "test", inbox,
        [&](int number, const auto& run) {
          begun = true;
          while (run.is_wanted()) std::this_thread::yield();
          ended = true;
          return number;
        },
        [](int) { FAIL() << "nobody hears it"; });
    latest.request(1);
    while (!begun) std::this_thread::yield();
  }
  EXPECT_TRUE(ended);
  while (inbox.run_one()) {
  }
}

}  // namespace
}  // namespace nazori::base
