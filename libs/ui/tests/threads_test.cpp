// SPDX-License-Identifier: Apache-2.0
// What of the window has a thread: asked again and again, and ended in the middle of it. Needs no widget, so
// that the thread sanitizer can watch it too.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QObject>
#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "device_search.h"
#include "library.h"
#include "nazori/devices/device_catalogue.h"
#include "progress/statistics_reader.h"
#include "worker.h"
#include "workshop.h"
#include "writing_judge.h"

namespace nazori::ui {
namespace {

/// Lets the event loop run until `wish` comes true; false after a minute, which only a fault takes.
template <class Wish>
bool comes_true(Wish wish) {
  QElapsedTimer waited;
  waited.start();
  while (!wish()) {
    if (waited.elapsed() > 60'000) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
    std::this_thread::yield();
  }
  return true;
}

std::filesystem::path database() {
  return std::filesystem::path(qgetenv("NAZORI_DATA").toStdString()) / "kanji.db";
}

TEST(WindowThreads, AnswersOfAWorkerAreHeardInOrderOnTheThreadThatMadeIt) {
  std::vector<int> heard;
  const auto here = std::this_thread::get_id();
  bool wrong_thread = false;
  Worker worker(QStringLiteral("test"));
  for (int i = 0; i < 200; ++i) {
    worker.post([&, i] {
      wrong_thread = wrong_thread || std::this_thread::get_id() == here;
      worker.answer([&, i, text = std::string(100, 'x')] {
        if (std::this_thread::get_id() == here && text.size() == 100) heard.push_back(i);
      });
    });
  }
  ASSERT_TRUE(comes_true([&] { return heard.size() == 200; }));
  for (int i = 0; i < 200; ++i) EXPECT_EQ(heard[static_cast<std::size_t>(i)], i);
  EXPECT_FALSE(wrong_thread);
}

TEST(WindowThreads, AnswersAreAlsoHeardWhileAnotherOneWaitsForThem) {
  bool second = false, done = false;
  Worker worker(QStringLiteral("test"));
  worker.post([&] {
    worker.answer([&] { done = comes_true([&] { return second; }); });  // as a dialog does
    worker.answer([&] { second = true; });
  });
  EXPECT_TRUE(comes_true([&] { return done; }));
}

TEST(WindowThreads, AnAnswerMayEndItsWorkerAndNothingIsHeardAfterwards) {
  auto worker = std::make_unique<Worker>(QStringLiteral("test"));
  Worker* const one = worker.get();
  bool after = false;
  one->post([&, one] {
    one->answer([&] { worker.reset(); });
    one->answer([&] { after = true; });
  });
  EXPECT_TRUE(comes_true([&] { return worker == nullptr; }));
  for (int i = 0; i < 20; ++i) QCoreApplication::processEvents();
  EXPECT_FALSE(after);
}

TEST(WindowThreads, TheLibraryIsAskedWhileItOpensAndEndedWhileItAnswers) {
  for (int round = 0; round < 3; ++round) {
    Library library(database());
    int sheets = 0, found = 0;
    QObject::connect(&library, &Library::sheet_ready, &library, [&] { ++sheets; });
    QObject::connect(&library, &Library::found, &library, [&] { ++found; });
    for (const char32_t character : {U'休', U'木', U'人', U'永'}) {
      library.request_search(QStringLiteral("mountain"));
      library.request_sheet(character);
    }
    if (round == 0) continue;  // ended at once
    EXPECT_TRUE(comes_true([&] { return sheets > 0 && found > 0; }));
    library.request_sheet(U'休');
  }
}

TEST(WindowThreads, TheJudgeAnswersTheNewestOfManyRequestsAndMayBeEndedBefore) {
  JudgeRequest request;
  request.character = U'木';
  for (const auto& line : kanji::KanjiDatabase::open(database())->find(U'木')->lines()) {
    auto& stroke = request.ink.strokes.emplace_back();
    for (const auto& p : line.points) stroke.points.push_back({p.x, p.y});
  }
  for (int round = 0; round < 2; ++round) {
    WritingJudge judge(database());
    std::uint64_t answered = 0, asked = 0;
    QObject::connect(&judge, &WritingJudge::judged, &judge, [&](std::uint64_t ticket) { answered = ticket; });
    for (int i = 0; i < 30; ++i) asked = judge.judge(request);
    if (round == 0) continue;
    EXPECT_TRUE(comes_true([&] { return answered == asked; }));
  }
}

TEST(WindowThreads, TabletsAreCarvedOneAfterTheOther) {
  const auto database_file = kanji::KanjiDatabase::open(database());
  ASSERT_TRUE(database_file);
  Workshop workshop;
  char32_t newest = 0;
  Tablet tablet;
  QObject::connect(&workshop, &Workshop::carved, &workshop, [&](char32_t character, const Tablet& carved) {
    newest = character;
    tablet = carved;
  });
  for (const char32_t character : {U'一', U'人', U'一'}) workshop.carve(*database_file->find(character));
  EXPECT_TRUE(comes_true([&] { return newest == U'一'; }));
  EXPECT_TRUE(tablet);
  workshop.carve(*database_file->find(U'二'));  // ended in the middle
}

TEST(WindowThreads, DevicesAreLookedForCancelledAndOpenedAgain) {
  DeviceSearch::BackEnds back_ends;
  back_ends.push_back(devices::simulated_back_end());
  back_ends.push_back(devices::pointer_back_end());
  DeviceSearch search(std::move(back_ends), {});
  std::vector<devices::BackEndFindings> findings;
  search.find([&](auto found) { findings = std::move(found); });
  int heard = 0;
  std::string id;
  for (int i = 0; i < 20; ++i) {
    search.open({"simulated:touch", true, {}}, {}, [&](DeviceFind found) {
      ++heard;
      if (found.opened) id = found.opened->id;
      if (found.opened) search.close(std::move(*found.opened));
    });
    if (i == 10) search.cancel();
  }
  EXPECT_TRUE(comes_true([&] { return !id.empty(); }));
  EXPECT_EQ(id, "simulated:touch");
  EXPECT_EQ(heard, 1);
  EXPECT_EQ(findings.size(), 2U);
  search.open({"simulated:touch", true, {}}, {}, [](const DeviceFind&) {});  // ended before it is heard
}

TEST(WindowThreads, OfManyRequestsForStatisticsTheNewestIsAnswered) {
  StatisticsReader reader;
  int answers = 0;
  QObject::connect(&reader, &StatisticsReader::failed, &reader, [&] { ++answers; });
  QObject::connect(&reader, &StatisticsReader::ready, &reader, [&] { ++answers; });
  for (int i = 0; i < 10; ++i) reader.request("/nowhere/learner.db", {});
  EXPECT_TRUE(comes_true([&] { return !reader.is_busy(); }));
  EXPECT_EQ(answers, 1);
  reader.request("/nowhere/learner.db", {});  // ended before it is heard
}

}  // namespace
}  // namespace nazori::ui
