// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <QFile>
#include <QFileDialog>
#include <QSettings>
#include <QTimer>

#include "characters/characters.h"
#include "device/device_page.h"
#include "nazori/recording/recording_file.h"
#include "nazori/recording/sample_csv.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

WindowParts* parts_under_test = nullptr;

template <class T>
std::unique_ptr<Page> make(WindowParts& parts) {
  parts_under_test = &parts;
  return std::make_unique<T>(parts);
}

std::vector<haptics::ServoSample> read_all(const QString& path, recording::RecordingEnd* end = nullptr) {
  auto reader = recording::RecordingReader::open(path.toStdString());
  EXPECT_TRUE(reader) << path.toStdString();
  std::vector<haptics::ServoSample> all;
  if (!reader) return all;
  std::array<haptics::ServoSample, 512> some;
  for (;;) {
    const auto count = reader->read(some);
    if (!count || *count == 0) break;
    all.insert(all.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(*count));
  }
  if (end != nullptr) *end = reader->end();
  return all;
}

class Recording : public WindowTest {
 protected:
  Recording() { pages_ = {make<Characters>, make<DevicePage>}; }

  /// Ctrl+Shift+R and the dialog, as a learner would.
  void record_to(const QString& path) {
    QTimer::singleShot(0, window_.get(), [this, path] {
      auto* dialog = find<QFileDialog>("record_dialog");
      ASSERT_NE(dialog, nullptr);
      dialog->selectFile(path);
      static_cast<QDialog*>(dialog)->done(QDialog::Accepted);
    });
    action("record")->trigger();
  }

  /// Waits until the servo has given `count` more samples. What had queued up before does not count.
  bool samples_come(std::size_t count) {
    parts_under_test->tablet().pump();
    std::size_t seen = 0;
    QObject context;
    subscribe(parts_under_test->tablet().device().sampled, &context,
              [&seen](std::span<const haptics::ServoSample> some) { seen += some.size(); });
    return QTest::qWaitFor([&] { return seen >= count; }, 10000);
  }
};

TEST_F(Recording, HoldsEveryMomentThatTheServoSaw) {
  const QString path = folder_.filePath(QStringLiteral("session.nzr"));
  std::vector<haptics::ServoSample> seen;
  auto& stylus = parts_under_test->tablet().device();
  subscribe(stylus.sampled, window_.get(), [&seen](std::span<const haptics::ServoSample> some) {
    seen.insert(seen.end(), some.begin(), some.end());
  });
  record_to(path);
  EXPECT_TRUE(action("record")->isChecked());
  EXPECT_TRUE(find("recording")->isVisible());
  EXPECT_TRUE(text("recording").contains(QStringLiteral("session.nzr"))) << text("recording").toStdString();
  for (int i = 0; i < 60; ++i) {
    parts_under_test->tablet().move_stylus({0.0005 * i, 0.0}, i > 10);
    QTest::qWait(5);
  }
  action("record")->trigger();
  EXPECT_FALSE(action("record")->isChecked());
  EXPECT_FALSE(find("recording")->isVisible());
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("Recorded: "))) << feedback().toStdString();
  parts_under_test->tablet().pump();

  recording::RecordingEnd end;
  const auto recorded = read_all(path, &end);
  EXPECT_TRUE(end.finished);
  EXPECT_EQ(end.lost, 0U);
  ASSERT_GT(recorded.size(), 200U);
  std::size_t at = 0;
  while (at < seen.size() && seen[at].tick != recorded.front().tick) ++at;
  ASSERT_GE(seen.size(), at + recorded.size());
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    ASSERT_EQ(recorded[i].tick, seen[at + i].tick);
    ASSERT_EQ(recorded[i].device_m, seen[at + i].device_m);
    ASSERT_EQ(recorded[i].proxy_m, seen[at + i].proxy_m);
    ASSERT_EQ(recorded[i].force_n, seen[at + i].force_n);
    ASSERT_EQ(recorded[i].touching, seen[at + i].touching);
  }
}

TEST_F(Recording, AsATableHasOneRowAMoment) {
  const QString path = folder_.filePath(QStringLiteral("session.csv"));
  record_to(path);
  ASSERT_TRUE(samples_come(150));
  action("record")->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return feedback().startsWith(QStringLiteral("Recorded: ")); }, 60'000))
      << feedback().toStdString();
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << feedback().toStdString();
  EXPECT_EQ(file.readLine().toStdString(), recording::kSampleCsvHeader);
  EXPECT_GT(file.readAll().count('\n'), 100);
  EXPECT_FALSE(QFile::exists(path + QStringLiteral(".nzr")));
}

TEST_F(Recording, GoesOnInAFileOfItsOwnWhereAnotherDeviceTakesTheTablet) {
  const QString path = folder_.filePath(QStringLiteral("session.nzr"));
  record_to(path);
  ASSERT_TRUE(samples_come(50));
  parts_under_test->tablet().device().choose("simulated:touch");
  ASSERT_TRUE(QTest::qWaitFor([] { return !parts_under_test->tablet().device().is_pointer(); }, 20'000));
  ASSERT_TRUE(samples_come(50));
  action("record")->trigger();
  const auto second =
      recording::RecordingReader::open(folder_.filePath(QStringLiteral("session-2.nzr")).toStdString());
  ASSERT_TRUE(second);
  EXPECT_TRUE(second->session().device.has_force);
  EXPECT_FALSE(recording::RecordingReader::open(path.toStdString())->session().device.has_force);
  EXPECT_GT(read_all(folder_.filePath(QStringLiteral("session-2.nzr"))).size(), 20U);
}

TEST_F(Recording, OfAWindowThatWasKilledIsCompletedByTheNextOneWhichSaysSo) {
  const QString path = folder_.filePath(QStringLiteral("killed.nzr"));
  const QString settings = folder_.filePath(QStringLiteral("nazori.ini"));
  window_->close();
  window_.reset();
  int told[2];
  ASSERT_EQ(pipe(told), 0);
  // The child knows no Qt event loop: what it records with is the window's own class.
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    WindowTablet stylus;
    EventLoopInbox loop;
    practice::TabletRecording recorder(loop.inbox(), stylus.device(), unfinished_recordings(settings));
    const bool started = stylus.start() && recorder.start(path.toStdString(), "休", {});
    std::uint64_t samples = 0;
    while (started && samples < 300) samples = recorder.status().samples;
    (void)!write(told[1], &samples, sizeof samples);
    for (;;) pause();
  }
  std::uint64_t samples = 0;
  ASSERT_EQ(read(told[0], &samples, sizeof samples), static_cast<ssize_t>(sizeof samples));
  ASSERT_GE(samples, 300U);
  ::kill(child, SIGKILL);
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  close(told[0]);
  close(told[1]);
  open_window();
  EXPECT_TRUE(QTest::qWaitFor(
      [&] { return feedback().startsWith(QStringLiteral("An interrupted recording was recovered")); }, 5000))
      << feedback().toStdString();
  recording::RecordingEnd end;
  const auto recorded = read_all(path, &end);
  EXPECT_TRUE(end.recovered);
  EXPECT_GE(recorded.size(), samples);
  for (std::size_t i = 1; i < recorded.size(); ++i) ASSERT_EQ(recorded[i].tick, recorded[i - 1].tick + 1);
  EXPECT_FALSE(QSettings(settings, QSettings::IniFormat).contains(QStringLiteral("recording/unfinished")));
}

TEST_F(Recording, ThatCannotBeWrittenIsSaidAndNothingIsOn) {
  record_to(folder_.filePath(QStringLiteral("no/such/folder/session.nzr")));
  EXPECT_FALSE(action("record")->isChecked());
  EXPECT_TRUE(feedback().endsWith(QStringLiteral("Nothing is recorded."))) << feedback().toStdString();
}

}  // namespace
}  // namespace nazori::ui
