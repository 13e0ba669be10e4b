// SPDX-License-Identifier: Apache-2.0
#include "nazori/study/handwriting.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "saved_point.h"

namespace nazori::study {
namespace {

constexpr std::uint8_t kVersion = 1;
// Four varints of at most five bytes per point, and one per stroke.
constexpr std::size_t kMostBytes = kMostSavedPoints * 20 + kMostSavedStrokes * 5 + 8;

using Bytes = std::vector<std::uint8_t>;

void put(Bytes& bytes, std::uint32_t value) {
  for (; value >= 0x80; value >>= 7U) bytes.push_back(static_cast<std::uint8_t>(value | 0x80U));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

void put_difference(Bytes& bytes, std::int32_t value) {
  put(bytes, (static_cast<std::uint32_t>(value) << 1U) ^ static_cast<std::uint32_t>(value >> 31));
}

/// Reads varints; after a failure every value is 0.
class VarintReader {
 public:
  explicit VarintReader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}
  std::uint32_t number() {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 35; shift += 7) {
      if (rest_.empty()) break;
      const std::uint8_t byte = rest_.front();
      rest_ = rest_.subspan(1);
      if (shift == 28 && byte > 0x0F) break;
      value |= static_cast<std::uint32_t>(byte & 0x7FU) << shift;
      if (byte < 0x80) return value;
    }
    ok_ = false;
    rest_ = {};
    return 0;
  }
  std::int32_t difference() {
    const std::uint32_t value = number();
    return static_cast<std::int32_t>((value >> 1U) ^ (0U - (value & 1U)));
  }
  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }

 private:
  std::span<const std::uint8_t> rest_;
  bool ok_ = true;
};

bool within(std::int64_t value, std::int64_t lowest, std::int64_t highest) {
  return value >= lowest && value <= highest;
}

/// Whether a number is rounded to a whole one of this range.
bool rounds_into(double value, std::int32_t lowest, std::int32_t highest) {
  return value > lowest - 0.5 && value < highest + 0.5;
}

bool may_be_saved(const Handwriting& ink) {
  constexpr std::int32_t kFarthest = SavedPoint::kFarthest;
  std::size_t points = 0;
  std::int32_t time_ms = 0;
  for (const HandwritingStroke& stroke : ink) {
    points += stroke.size();
    for (const HandwritingPoint& point : stroke) {
      if (!rounds_into(point.at.x * kSavedStepsPerUnit, -kFarthest, kFarthest) ||
          !rounds_into(point.at.y * kSavedStepsPerUnit, -kFarthest, kFarthest) ||
          !rounds_into(point.time_s.value_or(0) * 1'000, time_ms, SavedPoint::kLatest)) {
        return false;
      }
      time_ms = in_steps(point).time_ms;
    }
  }
  return ink.size() <= kMostSavedStrokes && points <= kMostSavedPoints;
}

tl::unexpected<base::Error> not_ink() {
  return base::fail(base::Errc::parse, "is not readable handwriting data");
}

base::Result<Handwriting> read_strokes(std::span<const std::uint8_t> bytes) {
  VarintReader reader(bytes);
  Handwriting ink;
  const std::uint32_t strokes = reader.number();
  if (strokes > kMostSavedStrokes) return not_ink();
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t time = 0;
  std::int64_t pressure = 0;
  std::size_t points = 0;
  for (std::uint32_t i = 0; i < strokes && reader.ok(); ++i) {
    const std::uint32_t count = reader.number();
    points += count;
    if (points > kMostSavedPoints) return not_ink();
    HandwritingStroke& stroke = ink.emplace_back();
    for (std::uint32_t k = 0; k < count && reader.ok(); ++k) {
      x += reader.difference();
      y += reader.difference();
      time += reader.number();
      pressure += reader.difference();
      if (!within(x, -SavedPoint::kFarthest, SavedPoint::kFarthest) ||
          !within(y, -SavedPoint::kFarthest, SavedPoint::kFarthest) ||
          !within(time, 0, SavedPoint::kLatest) || !within(pressure, 0, 255)) {
        return not_ink();
      }
      stroke.push_back(from_steps({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y),
                                   static_cast<std::int32_t>(time), static_cast<std::uint8_t>(pressure)}));
    }
  }
  if (!reader.ok() || !reader.at_end()) return not_ink();
  return ink;
}

}  // namespace

SavedPoint in_steps(const HandwritingPoint& point) {
  constexpr double kFarthest = SavedPoint::kFarthest;
  const auto whole = [](double value, double lowest, double highest) {
    return std::isfinite(value) ? std::lround(std::clamp(value, lowest, highest)) : 0;
  };
  SavedPoint steps;
  steps.x = static_cast<std::int32_t>(whole(point.at.x * kSavedStepsPerUnit, -kFarthest, kFarthest));
  steps.y = static_cast<std::int32_t>(whole(point.at.y * kSavedStepsPerUnit, -kFarthest, kFarthest));
  steps.time_ms = static_cast<std::int32_t>(whole(point.time_s.value_or(0) * 1'000, 0, SavedPoint::kLatest));
  steps.pressure = static_cast<std::uint8_t>(whole(point.pressure.value_or(0) * 255, 0, 255));
  return steps;
}

HandwritingPoint from_steps(const SavedPoint& point) {
  return {
      {static_cast<double>(point.x) / kSavedStepsPerUnit, static_cast<double>(point.y) / kSavedStepsPerUnit},
      point.time_ms / 1'000.0,
      point.pressure / 255.0};
}

HandwritingPoint saved_point(const HandwritingPoint& point) { return from_steps(in_steps(point)); }

base::Result<Bytes> pack(const Handwriting& ink) {
  if (ink.empty()) return Bytes();
  if (!may_be_saved(ink)) {
    return base::fail(base::Errc::bad_argument, "is too much, too far out, or its times go back", "ink",
                      "give at most 100 strokes and 50000 points");
  }
  Bytes plain;
  put(plain, static_cast<std::uint32_t>(ink.size()));
  SavedPoint last;
  for (const HandwritingStroke& stroke : ink) {
    put(plain, static_cast<std::uint32_t>(stroke.size()));
    for (const HandwritingPoint& written : stroke) {
      const SavedPoint point = in_steps(written);
      put_difference(plain, point.x - last.x);
      put_difference(plain, point.y - last.y);
      put(plain, static_cast<std::uint32_t>(point.time_ms - last.time_ms));
      put_difference(plain, point.pressure - last.pressure);
      last = point;
    }
  }
  uLongf size = compressBound(static_cast<uLong>(plain.size()));
  Bytes packed(1 + size);
  packed.front() = kVersion;
  const int status = compress2(&packed[1], &size, plain.data(), static_cast<uLong>(plain.size()), 9);
  assert(status == Z_OK);
  (void)status;
  packed.resize(1 + size);
  return packed;
}

base::Result<Handwriting> unpack_handwriting(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Handwriting{};
  if (bytes.front() != kVersion || bytes.size() > kMostBytes) return not_ink();
  const std::span<const std::uint8_t> packed = bytes.subspan(1);
  // Enough for usual ink; a DEFLATE stream can expand a thousandfold.
  Bytes plain;
  uLongf size = 0;
  uLong used = 0;
  int status = Z_BUF_ERROR;
  for (std::size_t room = packed.size() * 8 + 64; status == Z_BUF_ERROR && plain.size() < kMostBytes;
       room *= 8) {
    plain.resize(std::min(kMostBytes, room));
    size = static_cast<uLongf>(plain.size());
    used = static_cast<uLong>(packed.size());
    status = uncompress2(plain.data(), &size, packed.data(), &used);
  }
  if (status != Z_OK || used != packed.size()) return not_ink();
  return read_strokes(std::span(plain).first(size));
}

}  // namespace nazori::study
