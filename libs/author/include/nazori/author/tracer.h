// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/base/executor.h"
#include "nazori/base/latest.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/kanji/stroke.h"

namespace nazori::author {

/// A picture in which strokes are looked for: of a file, or of a character of a font.
struct TraceRequest {
  std::filesystem::path picture;         ///< PNG, JPEG or SVG; empty: of a font
  std::string family;                    ///< of the font
  char32_t glyph = 0;                    ///< the character of the font
  std::vector<kanji::StrokeLine> known;  ///< the strokes of the character, if it is a known one
};

/// Strokes that were found.
struct Traced {
  std::vector<OwnStroke> strokes;
  std::vector<std::size_t>
      unsure;          ///< of a known character: those of which too little ink was found, 0-based
  std::string source;  ///< name of the picture or font
};

/// Below this share of ink a stroke of a known character is unsure.
inline constexpr double kSureShare = 0.7;

/// Finds strokes in a picture at once. @return the errors of scan::load_photo(), font_picture(), trace() and
/// trace_as(). Thread-safe: yes.
[[nodiscard]] base::Result<Traced> trace_request(const TraceRequest& request);

/// The same on another thread; of several requests only the newest is answered, by one of the signals.
/// Thread: the owner of the inbox.
class Tracer {
 public:
  /// @param inbox  outlives this. The thread starts with the first request.
  explicit Tracer(base::Inbox& inbox) : inbox_(inbox) {}

  void trace(TraceRequest request);
  [[nodiscard]] bool is_busy() const { return work_ && work_->is_busy(); }

  base::Signal<const Traced&> traced;
  base::Signal<const base::Error&> failed;

 private:
  using Work = base::Latest<TraceRequest, base::Result<Traced>>;

  base::Inbox& inbox_;
  std::optional<Work> work_;  // declared last, so that its thread ends first
};

}  // namespace nazori::author
