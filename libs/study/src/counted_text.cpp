// SPDX-License-Identifier: Apache-2.0
#include "counted_text.h"

#include <algorithm>
#include <utility>

namespace nazori::study {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{64} << 10;

}  // namespace

CountedText::CountedText(const TextSource& source, base::Progress progress)
    : source_(source), progress_(std::move(progress)), buffer_(kPieceBytes) {}

bool CountedText::refill() {
  if (ended_) return false;
  if (keeps_part_) {
    part_.append(buffer_.data() + part_from_, at_ - part_from_);
    part_from_ = 0;
  }
  taken_ += at_;
  at_ = size_ = 0;
  const auto stop = [this](base::Error error) {
    trouble_ = std::move(error);
    ended_ = true;
    return false;
  };
  if (taken_ >= limit_)
    return stop({base::Errc::parse, "is too long for one entry", "line " + std::to_string(line_), ""});
  const double done = source_.bytes == 0
                          ? 0
                          : std::min(1.0, static_cast<double>(taken_) / static_cast<double>(source_.bytes));
  if (progress_ && !progress_(done, "read")) return stop({base::Errc::cancelled, "stopped", "", ""});
  auto read = source_.read(buffer_);
  if (!read) return stop(std::move(read.error()));
  size_ = *read;
  ended_ = size_ == 0;
  return !ended_;
}

void CountedText::begin_part() {
  keeps_part_ = true;
  part_.assign(1, last_);
  part_from_ = at_;
}

std::string_view CountedText::part() {
  part_.append(buffer_.data() + part_from_, at_ - part_from_);
  part_from_ = at_;
  return part_;
}

}  // namespace nazori::study
