// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "nazori/exchange/document.h"
#include "nazori/recording/recording_file.h"
#include "nazori/recording/sample_statistics.h"
#include "nazori/recording/session_recorder.h"

namespace nazori::exchange {

/// A recording that was read to its end.
struct ReadRecording {
  recording::Session session;
  recording::SampleStatistics samples;
  recording::RecordingEnd end;
  recording::Recovery recovery = recording::Recovery::not_needed;
  std::uint64_t late_ticks = 0;  ///< began more than half a period late
  std::uint64_t gaps = 0;        ///< number of missing tick numbers

  /// "complete", "recovered", "being recorded" or "incomplete".
  [[nodiscard]] std::string_view state() const;
  /// When it began: "2026-01-02T03:04:05Z".
  [[nodiscard]] std::string start() const;
  /// How much longer than a period the longest one was [s].
  [[nodiscard]] double max_lateness_s() const;
};
/// docs/schemas/tablets.json, record_info.
[[nodiscard]] Value to_json(const ReadRecording& read, const std::string& file);

/// docs/schemas/tablets.json, record_export. @param file  the table that was written.
[[nodiscard]] Value exported_recording(const recording::RecordingEnd& end, const std::string& file);

}  // namespace nazori::exchange
