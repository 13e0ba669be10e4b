// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "nazori/base/executor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/devices/tablet_device.h"
#include "nazori/geometry/frames.h"
#include "nazori/recording/session_recorder.h"

namespace nazori::practice {

/// Records every moment of feeling to a file, whatever device has the tablet. Another device goes on in a
/// file of its own, numbered, because a recording says of which device it is. Which file is being written is
/// remembered, so that the next start can complete it after a crash. Tables are written and broken recordings
/// completed behind the thread that asks. Thread: the owner of the inbox.
class TabletRecording {
 public:
  using Path = std::filesystem::path;
  /// Where the list of unfinished files outlives the program.
  struct UnfinishedFiles {
    std::function<std::vector<std::string>()> read;
    std::function<void(const std::vector<std::string>& files)> write;
  };

  /// @param inbox, device  outlive this.
  TabletRecording(base::Inbox& inbox, devices::TabletDevice& device, UnfinishedFiles unfinished);
  ~TabletRecording();
  TabletRecording(const TabletRecording&) = delete;
  TabletRecording& operator=(const TabletRecording&) = delete;

  /// Ends what is being recorded, and begins another recording.
  /// @param path  .nzr or .csv. @param character  what is on the tablet, for people.
  [[nodiscard]] base::Result<void> start(const Path& path, const std::string& character,
                                         const geometry::TabletShape& shape);
  /// @return the files that were recorded; the error of the last. A table follows with `exported`.
  base::Result<std::vector<Path>> finish();
  /// Whether a table is being written. One that nobody waits for is written by the next start.
  [[nodiscard]] bool is_exporting() const { return exports_ > 0; }
  [[nodiscard]] bool is_on() const { return recorder_ != nullptr; }
  /// The file that is being written.
  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] recording::RecorderStatus status() const;
  /// Looks whether the disk is full. To be called every second.
  void tick();

  /// What a program that died has left unfinished, completed.
  struct Recovered {
    std::vector<Path> files;   ///< complete to the last moment
    std::vector<Path> broken;  ///< end before the last moment: the computer was restarted
  };
  /// Completes it; `recovered` follows where there was something.
  void recover();

  base::Signal<> changed;
  base::Signal<const Recovered&> recovered;
  /// How much of a table is written, 0..1.
  base::Signal<const Path&, double> export_progressed;
  /// A table is complete.
  base::Signal<const Path&> exported;
  /// Recording goes on in another file, with another device.
  base::Signal<const Path&> moved_on;
  base::Signal<const Path&, const base::Error&> failed;

 private:
  base::Result<void> begin(const Path& path);
  base::Result<void> close();
  void export_table(const Path& path);
  void finish_export(const Path& path, const base::Result<recording::RecordingEnd>& result);
  void recover_file(const Path& path);
  void finish_recovery(const Path& path, const base::Result<recording::Recovery>& result);
  void move_on();
  void remember(const Path& path) const;
  void forget(const Path& path) const;

  devices::TabletDevice& device_;
  UnfinishedFiles unfinished_;
  Path first_path_;
  Path path_;
  std::vector<Path> written_;
  recording::Session session_;
  bool is_between_devices_ = false;
  int exports_ = 0;  ///< tables that are being written
  std::unique_ptr<recording::SessionRecorder> recorder_;
  base::Connection leaving_, changed_;
  std::atomic<bool> is_ending_{false};
  base::Background background_;  // declared last, so that it stops before what it uses goes
};

}  // namespace nazori::practice
