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
  std::uint64_t samples = 0;  ///< ticks seen
  std::uint64_t written = 0;  ///< of these, in the file
  std::uint64_t lost = 0;     ///< ticks for which there was no room
  base::Error error;          ///< `what` is empty while the file can be written
};

/// Records every tick of a live servo to a file, off the servo thread: the servo pushes each sample into a
/// ring in shared memory and waits for nothing; a thread of the recorder moves them to the file, fifty times
/// a second, and once a second to the disk.
///
/// When the program dies in whatever way, what was in the ring is still there: recover() brings it into the
/// file, so that the recording ends with the last whole tick. When the machine dies, the last second may be
/// missing.
///
/// A ".nzr" is written in place, a ".csv" from a ".csv.nzr" beside it when it is finished.
/// Thread rules: all members by one thread (the interface).
class SessionRecorder {
 public:
  /// Records `servo` from its next tick on. `servo` must outlive the recorder.
  /// @param path     ends with .nzr or .csv; replaced where it exists.
  /// @param session  id and start_ns are set here.
  /// @return Errc::bad_argument for another extension, Errc::io for file and memory.
  [[nodiscard]] static base::Result<std::unique_ptr<SessionRecorder>> start(haptics::Servo& servo,
                                                                            const std::filesystem::path& path,
                                                                            Session session);
  /// As finish(), but after close() nothing more.
  ~SessionRecorder();
  SessionRecorder(const SessionRecorder&) = delete;
  SessionRecorder& operator=(const SessionRecorder&) = delete;

  [[nodiscard]] RecorderStatus status() const;
  /// Waits until at least half of the ring is free. For servos that are stepped faster than real time by the
  /// calling thread; a live one must not wait.
  void wait_for_room();

  /// The ".nzr" that is recorded into; for a ".csv" the one beside it.
  [[nodiscard]] const std::filesystem::path& raw_path() const;
  /// Takes the ring away from the servo, writes what is left and closes raw_path(). A few milliseconds.
  /// @return how it ended; Errc::io when the file could not be written whole.
  [[nodiscard]] base::Result<RecorderStatus> close();
  /// As close(), and a ".csv" is exported from its ".nzr", which is then removed: half a second for each
  /// million ticks and more.
  [[nodiscard]] base::Result<RecorderStatus> finish();

 private:
  struct Inside;
  explicit SessionRecorder(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

/// What recover() found.
enum class Recovery {
  not_needed,  ///< the recording is complete
  recovered,  ///< its program had died; the rest was brought in from memory and the recording is complete now
  in_progress,  ///< it is being recorded at this moment
  nothing_left  ///< it breaks off, and there is no memory of the rest: the machine was restarted, or it was
                ///< moved
};

/// Completes a recording whose program died. Harmless for all others.
/// @return Errc::io where the file cannot be read or written; the errors of decode_header.
[[nodiscard]] base::Result<Recovery> recover(const std::filesystem::path& path);

/// Writes a recording as CSV, see sample_csv.h; what `recording` has left out as damaged is not in it.
/// @return the errors of the file and of RecordingReader; Errc::cancelled.
[[nodiscard]] base::Result<RecordingEnd> export_csv(const std::filesystem::path& recording,
                                                    const std::filesystem::path& csv,
                                                    const base::Progress& progress);

}  // namespace nazori::recording
