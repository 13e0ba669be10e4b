// SPDX-License-Identifier: Apache-2.0
// The window never blocks: not for a history of ten years, a new day, or a long recording.
#include <QLabel>
#include <QPointer>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <ctime>
#include <fstream>

#include "characters/characters.h"
#include "nazori/haptics/servo.h"
#include "nazori/recording/session_recorder.h"
#include "nazori/study/backups.h"
#include "nazori/study/character_lists.h"
#include "nazori/study/store_filling.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/learner_words.h"
#include "progress/progress.h"
#include "study/home.h"
#include "study/settings_progress.h"
#include "watchdog.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

using test::Watchdog;

/// Of the work that is done behind the window, the most that one event may take; work in the window comes
/// near 1.
constexpr double kMostShare = 0.2;

WindowParts* the_parts = nullptr;

std::unique_ptr<Page> make_home(WindowParts& parts) {
  the_parts = &parts;
  return std::make_unique<Home>(parts);
}
std::unique_ptr<Page> make_characters(WindowParts& parts) { return std::make_unique<Characters>(parts); }
std::unique_ptr<Page> make_progress(WindowParts& parts) { return std::make_unique<Progress>(parts); }

/// Ten years of a learner who studies much: 300,000 writings, 80 a day. The first thousand characters were
/// written once and have been due for a long time.
study::LearnerStore::Source ten_years(const std::vector<char32_t>& characters, study::Time end,
                                      int entries = 300'000) {
  return [=](study::LearnerStore::Filling& filling) -> base::Result<void> {
    constexpr int kEachDay = 80;
    const auto begin = end - std::chrono::days(entries / kEachDay);
    for (int i = 0; i < entries; ++i) {
      study::LogEntry entry;
      entry.id = entry.action = i + 1;
      entry.at = begin + std::chrono::days(i / kEachDay) + std::chrono::seconds(20 * (i % kEachDay));
      entry.day = std::chrono::floor<std::chrono::days>(entry.at);
      const bool is_first = i < 1'000;
      entry.character = characters[static_cast<std::size_t>(is_first ? 1'000 + i : i % 1'000)];
      entry.strokes = 5;
      entry.writing.rating = entry.writing.proposed = is_first ? study::Rating::easy : study::Rating::good;
      entry.writing.result.accepted = true;
      entry.writing.result.score = 90;
      entry.writing.result.duration = std::chrono::seconds(9);
      if (auto added = filling.add(entry, {}); !added) return added;
    }
    return {};
  };
}

class Waiting : public WindowTest {
 protected:
  Waiting() {
    pages_ = {make_home, make_characters, make_progress};
    clock_ = [this] { return now_; };
  }
  void SetUp() override { install_language(QStringLiteral("en")); }

  void open_home() {
    window_ = std::make_unique<MainWindow>(setup(), appearance_);
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    QObject::connect(window_.get(), &MainWindow::character_shown,
                     [this](char32_t c) { shown_character_ = c; });
    window_->show();
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    ASSERT_TRUE(opened.count() > 0 || opened.wait(20000));
    the_parts->session().set_asks_by_words(false);
  }

  [[nodiscard]] std::filesystem::path learner_file() const {
    return std::filesystem::path(folder_.filePath(QStringLiteral("learners")).toStdString()) / "learner" /
           "learner.db";
  }

  /// In the order of learning.
  [[nodiscard]] std::vector<char32_t> characters(const study::LearnerStore& store) const {
    const auto database = kanji::KanjiDatabase::open(setup().database);
    if (!database) throw std::runtime_error("no kanji database");
    study::CharacterLists lists(*database);
    auto order = lists.in_learning_order(store.settings(), store);
    if (!order) throw std::runtime_error(base::to_line(order.error()));
    return *std::move(order);
  }

  bool keeps_up_to_date() {
    return QTest::qWaitFor([] { return !the_parts->learner().keeps_up(); }, 120'000);
  }

  char32_t shown_character_ = 0;
  study::Time now_ = *study::parse_time("2036-03-01T09:00:00Z");
};

/// Longest events [ms of processor time].
struct Longest {
  double opening = 0, starting = 0, steps = 0, home = 0, midnight = 0;
};

class WaitingForAHistory : public Waiting {
 protected:
  /// A day with a history of so many entries.
  void live_a_day(int entries, Longest& longest) {
    {
      auto store = study::LearnerStore::open(learner_file(), study::Access::write, clock_);
      ASSERT_TRUE(store);
      ASSERT_TRUE(store->fill(ten_years(characters(*store), now_, entries)));
      std::filesystem::remove_all(study::backup_folder(learner_file()));
    }
    open_home();
    ASSERT_TRUE(keeps_up_to_date()) << "the check and the backup behind the window";
    EXPECT_EQ(study::backups_of(learner_file()).size(), 1U);

    const Watchdog opening;
    bool opened = false;
    QTimer::singleShot(0, qApp, [&] { opened = the_parts->learner().open_again(); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened; }));
    longest.opening = opening.longest_ms();
    ASSERT_TRUE(keeps_up_to_date());

    const Watchdog starting;
    ASSERT_TRUE(find<QPushButton>("home_start")->isVisible());
    QTest::keyClick(find<QPushButton>("home_start"), Qt::Key_Return);
    ASSERT_TRUE(the_parts->session().is_running());
    QCoreApplication::processEvents();
    longest.starting = starting.longest_ms();

    const Watchdog steps;
    for (int i = 0; i < 3; ++i) step_and_undo();
    longest.steps = steps.longest_ms();

    const Watchdog home;
    press(Qt::Key_1, Qt::AltModifier);
    ASSERT_TRUE(QTest::qWaitFor([&] { return find("home_page")->isVisible(); }));
    longest.home = home.longest_ms();

    const Watchdog midnight;
    now_ += std::chrono::days(1);
    the_parts->learner().tick();
    ASSERT_TRUE(keeps_up_to_date());
    EXPECT_EQ(study::backups_of(learner_file()).size(), 2U) << "of the new day";
    longest.midnight = midnight.longest_ms();
  }

 private:
  void step_and_undo() {
    const auto entries = [] { return the_parts->learner().store().last_entry(); };
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return shown_character_ == the_parts->session().character(); }, 20'000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return feedback().startsWith(QStringLiteral("Write the")); }, 20'000));
    const std::int64_t before = entries();
    press(Qt::Key_G);
    ASSERT_TRUE(QTest::qWaitFor(
        [] { return the_parts->session().state() == practice::StudySession::State::judged; }, 20'000))
        << feedback().toStdString();
    press(Qt::Key_3);
    EXPECT_EQ(entries(), before + 1);
    press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(entries(), before + 2);
  }
};

double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

TEST_F(WaitingForAHistory, NoEventOfTheWindowReadsAFifthOfTenYears) {
  Longest longest;
  live_a_day(300'000, longest);
  if (HasFatalFailure()) return;
  // Read once, in the same run on the same thread.
  std::int64_t entries = 0;
  const double begin_ms = thread_ms();
  ASSERT_TRUE(
      the_parts->learner().store().for_each_entry(false, [&entries](const auto&) { return ++entries > 0; }));
  const double limit_ms = kMostShare * (thread_ms() - begin_ms);
  ASSERT_GE(entries, 300'000);
  EXPECT_LT(longest.opening, limit_ms);
  EXPECT_LT(longest.starting, limit_ms);
  EXPECT_LT(longest.steps, limit_ms);
  EXPECT_LT(longest.home, limit_ms);
  EXPECT_LT(longest.midnight, limit_ms);
}

TEST_F(Waiting, ADamagedFileIsFoundBehindTheWindowAndNothingMoreIsWritten) {
  {
    auto store = study::LearnerStore::open(learner_file(), study::Access::write, clock_);
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->fill(ten_years(characters(*store), now_, 3'000)));
    std::filesystem::remove_all(study::backup_folder(learner_file()));
  }
  {
    std::fstream bytes(learner_file(), std::ios::in | std::ios::out | std::ios::binary);
    bytes.seekp(static_cast<std::streamoff>(std::filesystem::file_size(learner_file()) / 2));
    bytes << std::string(8'192, '\xee');
  }
  open_home();
  ASSERT_TRUE(QTest::qWaitFor([] { return !the_parts->learner().can_write(); }, 60'000));
  const QString trouble = LearnerWords::sentence(the_parts->learner().trouble());
  EXPECT_TRUE(trouble.contains(QStringLiteral("damaged"))) << trouble.toStdString();
  EXPECT_TRUE(study::backups_of(learner_file()).empty()) << "a damaged file is not backed up";
}

TEST_F(Waiting, SettingsThatChangeEveryCharacterAreKeptBehindTheWindowOrNotAtAll) {
  {
    auto store = study::LearnerStore::open(learner_file(), study::Access::write, clock_);
    ASSERT_TRUE(store);
    ASSERT_TRUE(store->fill(ten_years(characters(*store), now_, 20'000)));
  }
  open_home();
  ASSERT_TRUE(keeps_up_to_date());
  practice::Learner& learner = the_parts->learner();
  const study::Settings before = learner.store().settings();
  study::Settings wanted = before;
  wanted.fsrs.weights[2] *= 1.1;
  ASSERT_TRUE(practice::SettingsChange::takes_long(learner.store(), wanted));

  Feedback kind{};
  const auto change = [&](bool is_stopped) {
    const QPointer<SettingsProgress> work =
        new SettingsProgress(the_parts->settings_change(), wanted, window_.get());
    QObject::connect(work, &SettingsProgress::announced,
                     [&kind](Feedback said, const QString&) { kind = said; });
    if (is_stopped) emit find<QProgressDialog>("settings_progress")->canceled();
    return QTest::qWaitFor([&work] { return work.isNull(); }, 60'000);
  };
  ASSERT_TRUE(change(true));
  EXPECT_EQ(kind, Feedback::hint);
  EXPECT_EQ(learner.store().settings(), before);
  ASSERT_TRUE(keeps_up_to_date());

  const auto stability = [&learner] { return learner.store().cards().begin()->second.memory.stability; };
  const double as_before = stability();
  const Watchdog watchdog;
  ASSERT_TRUE(change(false));
  EXPECT_LT(watchdog.longest_ms(), kMostShare * watchdog.all_threads_ms())
      << watchdog.longest().toStdString();
  EXPECT_EQ(kind, Feedback::good);
  EXPECT_EQ(learner.store().settings(), wanted);
  EXPECT_NE(stability(), as_before);
}

TEST_F(Waiting, ABrokenRecordingIsCompletedAndItsTableWrittenBehindTheWindow) {
  const QString table = folder_.filePath(QStringLiteral("long.csv"));
  const QString raw = table + QStringLiteral(".nzr");
  // Ten minutes of ticks: their table alone takes several times the longest event.
  constexpr std::uint64_t kTicks = 600'000;
  {
    haptics::Servo servo(haptics::DeviceDescription{});
    auto recorder = recording::SessionRecorder::start(servo, raw.toStdString(), {});
    ASSERT_TRUE(recorder);
    for (std::uint64_t i = 0; i < kTicks; ++i) {
      (void)servo.tick({0.001 * static_cast<double>(i), {0, 0, 0.01}, 0, true});
      (*recorder)->wait_for_room();
    }
    ASSERT_TRUE((*recorder)->finish());
  }
  {
    QSettings settings(folder_.filePath(QStringLiteral("nazori.ini")), QSettings::IniFormat);
    settings.setValue(QStringLiteral("recording/unfinished"), QStringList{table});
  }
  const Watchdog watchdog;
  open_home();
  ASSERT_TRUE(QTest::qWaitFor([&] { return feedback().startsWith(QStringLiteral("Recorded: ")); }, 120'000))
      << feedback().toStdString();
  std::ifstream rows(table.toStdString());
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(rows), {}, '\n'),
            static_cast<std::ptrdiff_t>(kTicks) + 1);
  EXPECT_FALSE(QFile::exists(raw));
  EXPECT_LT(watchdog.longest_ms(), kMostShare * watchdog.all_threads_ms())
      << watchdog.longest().toStdString();
}

}  // namespace
}  // namespace nazori::ui
