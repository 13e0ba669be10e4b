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

/// Records every servo tick to a file, whatever device is active. When another device becomes active, the
/// recording continues in a new, numbered file, because a recording names its device. The name of the file
/// being written is saved, so that the next start can complete it after a crash. Tables are written and
/// broken recordings completed on a separate thread. Thread: the owner of the inbox.
class TabletRecording {
 public:
  using Path = std::filesystem::path;
  /// Where the list of unfinished files is saved.
  struct UnfinishedFiles {
    std::function<std::vector<std::string>()> read;
    std::function<void(const std::vector<std::string>& files)> write;
  };

  /// @param inbox, device  outlive this.
  TabletRecording(base::Inbox& inbox, devices::TabletDevice& device, UnfinishedFiles unfinished);
  ~TabletRecording();
  TabletRecording(const TabletRecording&) = delete;
  TabletRecording& operator=(const TabletRecording&) = delete;

  /// Ends the present recording, if any, and begins another one.
  /// @param path  .nzr or .csv. @param character  what is on the tablet, for people.
  /// @param tip_radius_m  of the ball at the tip of the stylus; 0: a point.
  [[nodiscard]] base::Result<void> start(const Path& path, const std::string& character,
                                         const geometry::TabletShape& shape, double tip_radius_m = 0);
  /// @return the files that were recorded; the error of the last one. For a table, `exported` follows.
  base::Result<std::vector<Path>> finish();
  /// Whether a table is being written. A table that is unfinished when the program ends is written at the
  /// next start.
  [[nodiscard]] bool is_exporting() const { return exports_ > 0; }
  [[nodiscard]] bool is_on() const { return recorder_ != nullptr; }
  /// The file that is being written.
  [[nodiscard]] const Path& path() const { return path_; }
  [[nodiscard]] recording::RecorderStatus status() const;
  /// Checks whether the disk is full. To be called every second.
  void tick();

  /// Recordings that a crashed program left unfinished, completed.
  struct Recovered {
    std::vector<Path> files;   ///< complete to the last moment
    std::vector<Path> broken;  ///< end before the last moment: the computer was restarted
  };
  /// Completes unfinished recordings; `recovered` follows if there were any.
  void recover();

  base::Signal<> changed;
  base::Signal<const Recovered&> recovered;
  /// Progress of writing a table, 0..1.
  base::Signal<const Path&, double> export_progressed;
  /// A table is complete.
  base::Signal<const Path&> exported;
  /// The recording continues in another file, with another device.
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
  base::Background background_;  // declared last, so that it stops before the members it uses are destroyed
};

}  // namespace nazori::practice
