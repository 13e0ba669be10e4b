// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/recording_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "little_endian.h"
#include "nazori/base/utf8.h"

namespace nazori::recording {
namespace {

using base::Errc;
using haptics::ServoSample;
using haptics::Vec3;

// As in PNG: a byte with its high bit set, line ends of both kinds and the end-of-file byte of DOS reveal
// damage by a transfer as text.
constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'N', 'Z', 'R', '\r', '\n', 0x1A, '\n'};
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint16_t kMajor = 1, kMinor = 1;
constexpr std::size_t kTipAt = 144;  // since 1.1; zero before
constexpr std::size_t kDeviceAt = 160, kDeviceBytes = 128, kCharacterAt = 288, kCharacterBytes = 128;
constexpr std::size_t kHeaderCrcAt = kHeaderBytes - 4, kRecordCrcAt = kRecordBytes - 4;
constexpr std::size_t kFlagsAt = 146;
constexpr std::size_t kBufferedRecords = 4096;

// Bits of a record's flags.
constexpr std::uint16_t kTouching = 1, kRecovered = 2, kEnd = 0x8000;

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(::crc32(0, bytes.data(), static_cast<uInt>(bytes.size())));
}

/// Copies `text` or its longest beginning that fits and ends with a whole character; the rest stays zero.
void store_text(std::span<std::uint8_t> bytes, std::size_t offset, std::size_t room, std::string_view text) {
  std::size_t length = std::min(text.size(), room - 1);
  while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U)
    --length;
  std::memcpy(bytes.subspan(offset, room).data(), text.data(), length);
}

std::string load_text(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t room) {
  const auto field = bytes.subspan(offset, room);
  std::string text(field.begin(), std::find(field.begin(), field.end(), 0));
  return base::decode_utf8(text) ? text : std::string();
}

/// The numbers of the header from kNumbersAt on, in order.
constexpr std::size_t kNumbersAt = 40;
template <class SessionType>
auto numbers_of(SessionType& s) {
  auto& l = s.device.limits;
  return std::array{&s.shape.width_m,     &s.shape.depth_m,     &l.max_force_n,       &l.continuous_force_n,
                    &l.max_stiffness_n_m, &l.max_damping_n_s_m, &l.own_damping_n_s_m, &l.max_slew_n_s,
                    &l.delay_s,           &l.hand_damping_n_s_m};
}

void store_vector(std::span<std::uint8_t> bytes, std::size_t offset, const Vec3& v) {
  store(bytes, offset, v.x);
  store(bytes, offset + 8, v.y);
  store(bytes, offset + 16, v.z);
}

Vec3 load_vector(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return {load<double>(bytes, offset), load<double>(bytes, offset + 8), load<double>(bytes, offset + 16)};
}

ServoSample decode_sample(std::span<const std::uint8_t> record) {
  ServoSample sample;
  sample.tick = load<std::uint64_t>(record, 0);
  sample.time_s = load<double>(record, 8);
  sample.device_m = load_vector(record, 16);
  sample.proxy_m = load_vector(record, 40);
  sample.force_n = load_vector(record, 64);
  sample.guide_m = load_vector(record, 88);
  sample.progress_m = load<double>(record, 112);
  sample.off_m = load<double>(record, 120);
  sample.stroke = load<std::int32_t>(record, 128);
  sample.guided_stroke = load<std::int32_t>(record, 132);
  sample.done_stroke = load<std::int32_t>(record, 136);
  sample.buttons = load<std::uint32_t>(record, 140);
  sample.events = load<std::uint16_t>(record, 144);
  sample.touching = (load<std::uint16_t>(record, kFlagsAt) & kTouching) != 0;
  return sample;
}

}  // namespace

std::array<std::uint8_t, kHeaderBytes> encode_header(const Session& session) {
  std::array<std::uint8_t, kHeaderBytes> bytes{};
  std::copy(kMagic.begin(), kMagic.end(), bytes.begin());
  store(bytes, 8, kByteOrder);
  store(bytes, 12, kMajor);
  store(bytes, 14, kMinor);
  store(bytes, 16, static_cast<std::uint32_t>(kHeaderBytes));
  store(bytes, 20, static_cast<std::uint32_t>(kRecordBytes));
  store(bytes, 24, session.device.rate_hz);
  store(bytes, 32, session.start_ns);
  std::size_t at = kNumbersAt;
  for (const double* number : numbers_of(session)) {
    store(bytes, at, *number);
    at += 8;
  }
  store(bytes, at, static_cast<std::uint32_t>(session.device.has_force ? 1 : 0));
  std::copy(session.id.begin(), session.id.end(), bytes.begin() + 128);
  store(bytes, kTipAt, session.tip_radius_m);
  store_text(bytes, kDeviceAt, kDeviceBytes, session.device.name);
  store_text(bytes, kCharacterAt, kCharacterBytes, session.character);
  store(bytes, kHeaderCrcAt, checksum(std::span(bytes).first(kHeaderCrcAt)));
  return bytes;
}

base::Result<Session> decode_header(std::span<const std::uint8_t> bytes, const std::string& name) {
  if (bytes.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) {
    return base::fail(Errc::schema, "is not a recording", name,
                      "give a .nzr that nazori-cli or the window recorded");
  }
  if (bytes.size() < kHeaderBytes) return base::fail(Errc::parse, "breaks off within its header", name);
  if (load<std::uint32_t>(bytes, 8) != kByteOrder)
    return base::fail(Errc::parse, "has its bytes in another order", name);
  if (const auto major = load<std::uint16_t>(bytes, 12); major != kMajor) {
    return base::fail(Errc::schema, fmt::format("is a recording of version {}", major), name,
                      fmt::format("this program reads version {}", kMajor));
  }
  if (load<std::uint32_t>(bytes, kHeaderCrcAt) != checksum(bytes.first(kHeaderCrcAt)) ||
      load<std::uint32_t>(bytes, 16) != kHeaderBytes || load<std::uint32_t>(bytes, 20) != kRecordBytes)
    return base::fail(Errc::parse, "has a damaged header", name);

  Session session;
  session.device.rate_hz = load<double>(bytes, 24);
  session.start_ns = load<std::int64_t>(bytes, 32);
  std::size_t at = kNumbersAt;
  for (double* number : numbers_of(session)) {
    *number = load<double>(bytes, at);
    at += 8;
  }
  if (!(session.device.rate_hz > 0) || !std::isfinite(session.device.rate_hz))
    return base::fail(Errc::parse, "has no sensible rate", name);
  session.device.has_force = load<std::uint32_t>(bytes, at) != 0;
  std::copy_n(bytes.begin() + 128, session.id.size(), session.id.begin());
  session.tip_radius_m = load<double>(bytes, kTipAt);
  session.device.name = load_text(bytes, kDeviceAt, kDeviceBytes);
  session.character = load_text(bytes, kCharacterAt, kCharacterBytes);
  return session;
}

void encode_record(const ServoSample& sample, std::vector<std::uint8_t>& bytes) {
  const std::size_t start = bytes.size();
  bytes.resize(start + kRecordBytes);
  const auto record = std::span(bytes).subspan(start);
  store(record, 0, sample.tick);
  store(record, 8, sample.time_s);
  store_vector(record, 16, sample.device_m);
  store_vector(record, 40, sample.proxy_m);
  store_vector(record, 64, sample.force_n);
  store_vector(record, 88, sample.guide_m);
  store(record, 112, sample.progress_m);
  store(record, 120, sample.off_m);
  store(record, 128, sample.stroke);
  store(record, 132, sample.guided_stroke);
  store(record, 136, sample.done_stroke);
  store(record, 140, sample.buttons);
  store(record, 144, sample.events);
  store(record, kFlagsAt, static_cast<std::uint16_t>(sample.touching ? kTouching : 0));
  store(record, kRecordCrcAt, checksum(record.first(kRecordCrcAt)));
}

void encode_end(std::uint64_t samples, std::uint64_t lost, bool recovered, std::vector<std::uint8_t>& bytes) {
  const std::size_t start = bytes.size();
  bytes.resize(start + kRecordBytes);
  const auto record = std::span(bytes).subspan(start);
  store(record, 0, samples);
  store(record, 8, lost);
  store(record, kFlagsAt, static_cast<std::uint16_t>(recovered ? kEnd | kRecovered : kEnd));
  store(record, kRecordCrcAt, checksum(record.first(kRecordCrcAt)));
}

RecordingReader::RecordingReader(std::unique_ptr<ByteSource> source)
    : source_(std::move(source)), buffer_(kBufferedRecords * kRecordBytes) {}

base::Result<RecordingReader> RecordingReader::open(const std::filesystem::path& path) {
  auto source = open_source(path);
  if (!source) return tl::unexpected(std::move(source.error()));
  return from(std::move(*source));
}

base::Result<RecordingReader> RecordingReader::from(std::unique_ptr<ByteSource> source) {
  RecordingReader reader(std::move(source));
  if (auto filled = reader.fill(kHeaderBytes); !filled) return tl::unexpected(std::move(filled.error()));
  const std::span header(reinterpret_cast<const std::uint8_t*>(reader.buffer_.data()),
                         std::min(reader.filled_, kHeaderBytes));
  auto session = decode_header(header, reader.source_->name());
  if (!session) return tl::unexpected(std::move(session.error()));
  reader.session_ = std::move(*session);
  reader.begin_ = kHeaderBytes;
  return reader;
}

/// Provides at least `wanted` bytes from begin_ on, fewer only at the end.
base::Result<void> RecordingReader::fill(std::size_t wanted) {
  if (filled_ - begin_ >= wanted) return {};
  std::memmove(buffer_.data(), buffer_.data() + begin_, filled_ - begin_);
  filled_ -= begin_;
  begin_ = 0;
  while (filled_ < wanted) {
    const auto got = source_->read(std::span(buffer_).subspan(filled_));
    if (!got) return tl::unexpected(got.error());
    if (*got == 0) break;
    filled_ += *got;
    bytes_ += *got;
  }
  return {};
}

base::Result<std::size_t> RecordingReader::read(std::span<ServoSample> out) {
  std::size_t count = 0;
  while (count < out.size() && !end_.finished) {
    if (auto filled = fill(kRecordBytes); !filled) return tl::unexpected(std::move(filled.error()));
    const std::size_t have = filled_ - begin_;
    if (have < kRecordBytes) {
      end_.trailing_bytes = have;
      break;
    }
    const std::span record(reinterpret_cast<const std::uint8_t*>(buffer_.data()) + begin_, kRecordBytes);
    begin_ += kRecordBytes;
    if (load<std::uint32_t>(record, kRecordCrcAt) != checksum(record.first(kRecordCrcAt))) {
      ++end_.damaged;
      continue;
    }
    if (const auto flags = load<std::uint16_t>(record, kFlagsAt); (flags & kEnd) != 0) {
      end_.finished = true;
      end_.recovered = (flags & kRecovered) != 0;
      end_.lost = load<std::uint64_t>(record, 8);
      break;
    }
    out[count++] = decode_sample(record);
    ++end_.samples;
  }
  return count;
}

double RecordingReader::progress() const {
  const std::uint64_t size = source_->size();
  if (size == 0) return 0;
  return std::min(1.0, static_cast<double>(bytes_ - (filled_ - begin_)) / static_cast<double>(size));
}

}  // namespace nazori::recording
