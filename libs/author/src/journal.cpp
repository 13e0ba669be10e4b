// SPDX-License-Identifier: Apache-2.0
#include "journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "facts_json.h"
#include "nazori/base/bytes.h"
#include "nazori/base/file.h"

namespace nazori::author {
namespace {

using base::ByteReader;
using base::ByteWriter;

constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'N', 'Z', 'J', '\r', '\n', 0x1A, 1};
constexpr std::size_t kHead = 5;  // kind and length
constexpr std::size_t kTail = 4;  // checksum

std::uint32_t checksum_of(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

/// Kind, length, content, and a checksum over all of them.
std::vector<std::uint8_t> record_of(RecordKind kind, std::span<const std::uint8_t> content) {
  ByteWriter out;
  out.u8(static_cast<std::uint8_t>(kind));
  out.count(content.size());
  out.raw(content);
  out.u32(checksum_of(out.bytes()));
  return std::move(out.bytes());
}

void write(ByteWriter& out, const OwnStroke& stroke) {
  out.count(stroke.points.size());
  for (const GroovePoint& p : stroke.points)
    for (const double value : {p.at.x, p.at.y, p.half_width, p.depth}) out.f64(value);
  out.u8(static_cast<std::uint8_t>(stroke.ending));
  out.u8(stroke.number_position ? 1 : 0);
  if (stroke.number_position)
    for (const double value : {stroke.number_position->x, stroke.number_position->y}) out.f64(value);
}

OwnStroke read_stroke(ByteReader& in) {
  OwnStroke stroke;
  for (std::size_t left = in.count(32); left > 0 && in.ok(); --left) {
    GroovePoint p;
    for (double* value : {&p.at.x, &p.at.y, &p.half_width, &p.depth}) *value = in.f64();
    stroke.points.push_back(p);
  }
  stroke.ending = static_cast<kanji::StrokeEnding>(in.u8());
  if (in.u8() == 1) {
    geometry::GlyphPoint at;
    for (double* value : {&at.x, &at.y}) *value = in.f64();
    stroke.number_position = at;
  }
  return stroke;
}

void write(ByteWriter& out, const std::vector<float>& heights) {
  out.count(heights.size());
  for (const float height : heights) out.f32(height);
}

std::vector<float> read_heights(ByteReader& in) {
  std::vector<float> heights(in.count(4));
  for (float& height : heights) height = in.f32();
  return heights;
}

/// Locks a file until it is closed. @return false where another editor has locked it; true also where the
/// file system knows no locks.
bool is_locked_now(int fd) {
  while (::flock(fd, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) break;
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> to_record(const Change& change) {
  ByteWriter out;
  out.u8(static_cast<std::uint8_t>(change.kind));
  out.count(change.stroke);
  out.count(change.point);
  out.u8(static_cast<std::uint8_t>((change.strokes ? 1 : 0) | (change.facts ? 2 : 0) |
                                   (change.patch ? 4 : 0) | (change.layer ? 8 : 0)));
  if (change.strokes) {
    out.count(change.strokes->first);
    out.count(change.strokes->count);
    out.count(change.strokes->held.size());
    for (const OwnStroke& stroke : change.strokes->held) write(out, stroke);
  }
  if (change.facts) out.text(to_json(*change.facts));
  if (change.patch) {
    for (const int value : {change.patch->box.left, change.patch->box.top, change.patch->box.right,
                            change.patch->box.bottom, change.patch->size})
      out.u32(static_cast<std::uint32_t>(value));
    write(out, change.patch->heights);
  }
  if (change.layer) {
    out.u32(static_cast<std::uint32_t>(change.layer->size));
    write(out, change.layer->heights);
  }
  return std::move(out.bytes());
}

std::optional<Change> parse_change(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  Change change;
  const std::uint8_t kind = in.u8();
  if (kind > static_cast<std::uint8_t>(EditKind::clear_relief)) return std::nullopt;
  change.kind = static_cast<EditKind>(kind);
  change.stroke = in.u32();
  change.point = in.u32();
  const std::uint8_t has = in.u8();
  if ((has & 1U) != 0) {
    Change::Strokes& strokes = change.strokes.emplace();
    strokes.first = in.u32();
    strokes.count = in.u32();
    for (std::size_t left = in.count(6); left > 0 && in.ok(); --left) strokes.held.push_back(read_stroke(in));
  }
  if ((has & 2U) != 0) {
    auto facts = parse_facts(in.text());
    if (!facts) return std::nullopt;
    change.facts = *std::move(facts);
  }
  if ((has & 4U) != 0) {
    Change::Patch& patch = change.patch.emplace();
    for (int* value : {&patch.box.left, &patch.box.top, &patch.box.right, &patch.box.bottom, &patch.size})
      *value = static_cast<int>(in.u32());
    patch.heights = read_heights(in);
  }
  if ((has & 8U) != 0) {
    HandLayer& layer = change.layer.emplace();
    layer.size = static_cast<int>(in.u32());
    layer.heights = read_heights(in);
  }
  if (!in.ok() || in.left() != 0 || has > 15) return std::nullopt;
  return change;
}

std::vector<std::uint8_t> to_record(const JournalBase& base) {
  ByteWriter out;
  out.u32(static_cast<std::uint32_t>(base.map_size));
  out.u8(base.is_of_file ? 1 : 0);
  out.raw(base.document);
  return std::move(out.bytes());
}

std::optional<JournalBase> parse_base(std::span<const std::uint8_t> content) {
  ByteReader in(content);
  JournalBase base;
  base.map_size = static_cast<int>(in.u32());
  base.is_of_file = in.u8() == 1;
  if (!in.ok()) return std::nullopt;
  const auto document = in.take(in.left());
  base.document.assign(document.begin(), document.end());
  return base;
}

std::optional<std::vector<JournalRecord>> read_journal(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kMagic.size() || !std::ranges::equal(bytes.first(kMagic.size()), kMagic))
    return std::nullopt;
  std::vector<JournalRecord> records;
  std::size_t at = kMagic.size();
  while (bytes.size() - at >= kHead + kTail) {
    ByteReader in(bytes.subspan(at));
    const std::uint8_t kind = in.u8();
    const std::size_t length = in.u32();
    if (in.left() < kTail || length > in.left() - kTail) break;
    const auto content = in.take(length);
    if (in.u32() != checksum_of(bytes.subspan(at, kHead + length))) break;
    const bool is_known = kind >= static_cast<std::uint8_t>(RecordKind::base) &&
                          kind <= static_cast<std::uint8_t>(RecordKind::redo);
    if (!is_known || (kind == static_cast<std::uint8_t>(RecordKind::base)) != records.empty()) break;
    at += kHead + length + kTail;
    records.push_back({static_cast<RecordKind>(kind), {content.begin(), content.end()}, at});
  }
  if (records.empty()) return std::nullopt;
  return records;
}

base::Result<std::unique_ptr<Journal>> Journal::begin(const std::filesystem::path& path,
                                                      const JournalBase& base) {
  std::vector<std::uint8_t> bytes(kMagic.begin(), kMagic.end());
  const auto first = record_of(RecordKind::base, to_record(base));
  bytes.insert(bytes.end(), first.begin(), first.end());
  if (auto written = base::write_file(path, bytes); !written)
    return tl::unexpected(std::move(written).error());
  return go_on(path, bytes.size());
}

tl::unexpected<base::Error> Journal::refuse(const std::filesystem::path& path) {
  return base::fail(base::Errc::in_use, "is being edited in another window or program", path.string(),
                    "close it there");
}

bool is_being_edited(const std::filesystem::path& journal) {
  const int fd = ::open(journal.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool held = !is_locked_now(fd);
  ::close(fd);
  return held;
}

base::Result<std::unique_ptr<Journal>> Journal::go_on(const std::filesystem::path& path, std::size_t length) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (fd >= 0 && !is_locked_now(fd)) {
    ::close(fd);
    return refuse(path);
  }
  if (fd < 0 || ::ftruncate(fd, static_cast<off_t>(length)) != 0) {
    const std::string why = std::generic_category().message(errno);
    if (fd >= 0) ::close(fd);
    return base::fail(base::Errc::io, "cannot be written: " + why, path.string());
  }
  return std::unique_ptr<Journal>(new Journal(path, fd));
}

Journal::~Journal() { ::close(fd_); }

void Journal::fail(int error_number) {
  error_ = base::Error{base::Errc::io, "cannot be written: " + std::generic_category().message(error_number),
                       path_.string(), "save the document"};
}

void Journal::append(RecordKind kind, std::span<const std::uint8_t> content, bool flush) {
  if (error_) return;
  const std::vector<std::uint8_t> record = record_of(kind, content);
  std::span<const std::uint8_t> left(record);
  while (!left.empty()) {
    const ssize_t count = ::write(fd_, left.data(), left.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return fail(count < 0 ? errno : ENOSPC);
    left = left.subspan(static_cast<std::size_t>(count));
  }
  if (flush && ::fdatasync(fd_) != 0) fail(errno);
}

}  // namespace nazori::author
