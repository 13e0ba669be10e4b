// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "nazori/study/exchange.h"

namespace nazori::study {

inline constexpr const char* kLearnerFormat = "nazori-learner";
inline constexpr int kLearnerFormatVersion = 1;

/// Collects small texts and passes larger ones to a sink. After the sink has failed nothing more is passed to
/// it.
class TextPieces {
 public:
  /// @param sink  must outlive this.
  explicit TextPieces(const TextSink& sink) : sink_(sink) { piece_.reserve(2 * kPieceBytes); }
  void add(std::string_view text) {
    if (!sent_) return;
    piece_ += text;
    if (piece_.size() >= kPieceBytes) send();
  }
  [[nodiscard]] bool ok() const { return sent_.has_value(); }
  /// Passes the rest. @return the error of the sink.
  [[nodiscard]] base::Result<void> finish() {
    if (sent_ && !piece_.empty()) send();
    return sent_;
  }

 private:
  static constexpr std::size_t kPieceBytes = std::size_t{64} << 10;
  void send() {
    sent_ = sink_(piece_);
    piece_.clear();
  }
  const TextSink& sink_;
  std::string piece_;
  base::Result<void> sent_;
};

/// Everything that `write` passes to its sink, as one text.
template <class Write>
[[nodiscard]] base::Result<std::string> as_one_text(Write write) {
  std::string text;
  auto written = write([&text](std::string_view piece) -> base::Result<void> {
    text += piece;
    return {};
  });
  if (!written) return tl::unexpected(std::move(written.error()));
  return text;
}

}  // namespace nazori::study
