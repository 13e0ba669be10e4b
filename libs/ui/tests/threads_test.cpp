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

#include "functions/plotter.h"
#include "progress/statistics_reader.h"
#include "worker.h"

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

TEST(WindowThreads, APlotIsStoppedByTheNextAndByItsEnd) {
  const auto request = [](const char* text) {
    PlotRequest made;
    made.plot = *functions::parse(text);
    made.plate.size = 64;
    return made;
  };
  Plotter plotter;
  SharedDrawing last;
  QObject::connect(&plotter, &Plotter::drawn, &plotter,
                   [&](const SharedDrawing& drawing) { last = drawing; });
  plotter.draw(request("y = sin(100 x)"));
  plotter.draw(request("y = x"));
  EXPECT_TRUE(comes_true([&] { return last && last->final; }));
  EXPECT_EQ(last->asked.plot.statements.size(), 1U);
  plotter.draw(request("y = sin(x)"));
  plotter.stop();
  EXPECT_TRUE(comes_true([&] { return !plotter.is_busy(); }));
  plotter.draw(request("y = sin(1/x)"));
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
