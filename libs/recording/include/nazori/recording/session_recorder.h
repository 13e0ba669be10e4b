// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/haptics/servo.h"
#include "nazori/recording/recording_file.h"

namespace nazori::recording {

/// How a recording stands.
struct RecorderStatus {
  std::uint64_t samples = 0;  ///< number of ticks
  std::uint64_t written = 0;  ///< samples that are in the file
  std::uint64_t lost = 0;     ///< ticks lost because the ring was full
  base::Error error;          ///< `what` is empty while the file can be written
};

/// Records every tick of a live servo to a file, off the servo thread: the servo pushes each sample into a
/// ring in shared memory without waiting. A thread of the recorder moves them to the file fifty times a
/// second and flushes the file to the disk once a second.
///
/// If the program crashes in any way, the content of the ring is preserved: recover() writes it into the
/// file, so that the recording ends with the last complete tick. If the machine crashes, the last second may
/// be missing.
///
/// A ".nzr" is written in place. A ".csv" is made from a temporary ".csv.nzr" in the same folder when the
/// recording is finished. Thread rules: all members by one thread (the interface).
class SessionRecorder {
 public:
  /// Records `servo` from its next tick on. `servo` must outlive the recorder.
  /// @param path     ends with .nzr or .csv; replaced where it exists.
  /// @param session  id and start_ns are set here.
  /// @return Errc::bad_argument for another extension, Errc::io for file and memory.
  [[nodiscard]] static base::Result<std::unique_ptr<SessionRecorder>> start(haptics::Servo& servo,
                                                                            const std::filesystem::path& path,
                                                                            Session session);
  /// As finish(), but does nothing after close().
  ~SessionRecorder();
  SessionRecorder(const SessionRecorder&) = delete;
  SessionRecorder& operator=(const SessionRecorder&) = delete;

  [[nodiscard]] RecorderStatus status() const;
  /// Waits until at least half of the ring is free. For servos that are stepped faster than real time by the
  /// calling thread; a live one must not wait.
  void wait_for_room();

  /// The path of the ".nzr" being written; for a ".csv" the temporary one.
  [[nodiscard]] const std::filesystem::path& raw_path() const;
  /// Removes the ring from the servo, writes the rest and closes raw_path(). Takes a few milliseconds.
  /// @return the end of the recording; Errc::io when the file could not be written completely.
  [[nodiscard]] base::Result<RecorderStatus> close();
  /// As close(); a ".csv" is also exported from its ".nzr", which is then removed. This takes at least half a
  /// second per million ticks.
  [[nodiscard]] base::Result<RecorderStatus> finish();

 private:
  struct Inside;
  explicit SessionRecorder(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

/// What recover() found.
enum class Recovery {
  not_needed,   ///< the recording is complete
  recovered,    ///< its program had crashed; the rest was recovered from memory and the recording is now
                ///< complete
  in_progress,  ///< it is still being recorded
  nothing_left  ///< it is incomplete and the rest is lost: the machine was restarted, or the file was moved
};

/// Completes a recording whose program crashed. Does nothing to others.
/// @return Errc::io where the file cannot be read or written; the errors of decode_header.
[[nodiscard]] base::Result<Recovery> recover(const std::filesystem::path& path);

/// Writes a recording as CSV, see sample_csv.h; damaged records are left out.
/// @return the errors of the file and of RecordingReader; Errc::cancelled.
[[nodiscard]] base::Result<RecordingEnd> export_csv(const std::filesystem::path& recording,
                                                    const std::filesystem::path& csv,
                                                    const base::Progress& progress);

}  // namespace nazori::recording
