// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/sheet_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "nazori/base/bytes.h"
#include "nazori/base/file.h"
#include "packed_tile.h"

namespace nazori::paint {
namespace {

using base::ByteReader;
using base::ByteWriter;
using base::Errc;
using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'N', 'Z', 'S', '\r', '\n', 0x1A, '\n'};
constexpr std::uint16_t kVersion = 1, kVersionWithAttachment = 2;
constexpr std::size_t kMostBytes = std::size_t{64} << 20U;
constexpr std::size_t kMostText = 65536;
constexpr TotalAmount kMostInk = TotalAmount{1} << 60;

std::string next_text(ByteReader& reader) {
  const auto part = reader.take(std::min<std::size_t>(reader.u32(), kMostText + 1));
  return {part.begin(), part.end()};
}

void append_part(ByteWriter& out, const InkLoad::Part& part) {
  out.i64(part.water);
  for (const TotalAmount pigment : part.pigment) out.i64(pigment);
}

bool next_part(ByteReader& reader, InkLoad::Part& part) {
  const auto amount = [&](TotalAmount& value) {
    value = reader.i64();
    return value >= 0 && value <= kMostInk;
  };
  bool fine = amount(part.water);
  for (TotalAmount& pigment : part.pigment) fine = amount(pigment) && fine;
  return fine;
}

void append_pigment(ByteWriter& out, const Pigment& pigment) {
  out.text(pigment.name);
  for (const double k : pigment.absorption) out.f64(k);
  for (const double s : pigment.scattering) out.f64(s);
  out.f64(pigment.mobility);
  out.f64(pigment.granulation);
}

Pigment next_pigment(ByteReader& reader) {
  Pigment pigment;
  pigment.name = next_text(reader);
  for (double& k : pigment.absorption) k = reader.f64();
  for (double& s : pigment.scattering) s = reader.f64();
  pigment.mobility = reader.f64();
  pigment.granulation = reader.f64();
  return pigment;
}

void append_tiles(ByteWriter& out, const Sheet& sheet) {
  ByteWriter packed_tiles;
  std::size_t count = 0;
  const auto& tiles = sheet.inside().tiles;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Bytes packed = pack(*tiles[i]);
    if (packed.empty()) continue;
    ++count;
    packed_tiles.count(i);
    packed_tiles.count(packed.size());
    packed_tiles.raw(packed);
  }
  out.count(count);
  out.raw(packed_tiles.bytes());
}

void append_packed(ByteWriter& out, std::span<const std::uint8_t> attached) {
  uLongf length = compressBound(attached.size());
  Bytes packed(length);
  const int result =
      compress2(packed.data(), &length, attached.data(), attached.size(), Z_DEFAULT_COMPRESSION);
  assert(result == Z_OK);
  static_cast<void>(result);
  out.count(attached.size());
  out.count(length);
  out.raw(std::span(packed).first(length));
}

/// @return nothing for bytes that append_packed() did not make.
std::optional<Bytes> next_packed(ByteReader& reader) {
  const std::size_t length = reader.u32();
  const auto packed = reader.take(reader.u32());
  if (!reader.ok() || length == 0 || length > kMostAttached) return std::nullopt;
  Bytes attached(length);
  uLongf unpacked = length, used = packed.size();
  if (uncompress2(attached.data(), &unpacked, packed.data(), &used) != Z_OK || unpacked != length ||
      used != packed.size())
    return std::nullopt;
  return attached;
}

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

base::Result<void> read_tiles(ByteReader& reader, Sheet& sheet) {
  Sheet::Inside& inside = sheet.inside();
  const auto count = reader.u32();
  std::size_t first = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t index = reader.u32();
    const auto bytes = reader.take(reader.u32());
    if (!reader.ok()) return base::fail(Errc::parse, "ends too early");
    if (index < first || index >= inside.tiles.size() || bytes.empty() ||
        !unpack(bytes, inside.paper_inside, *inside.tiles[index]))
      return base::fail(Errc::parse, "has a tile with values that paper cannot have");
    inside.settle(*inside.tiles[index]);
    first = index + 1;
  }
  return {};
}

template <class T>
tl::unexpected<base::Error> in_file(base::Result<T>&& failed, const std::filesystem::path& path) {
  base::Error error = std::move(failed).error();
  error.where = error.where.empty() ? path.string() : path.string() + ": " + error.where;
  return tl::unexpected(std::move(error));
}

}  // namespace

std::vector<std::uint8_t> to_bytes(const Sheet& sheet, const InkLoad& load,
                                   std::span<const std::uint8_t> attached) {
  assert(attached.size() <= kMostAttached);
  ByteWriter out;
  out.raw(kMagic);
  // Older programs read what has no attachment.
  out.u16(attached.empty() ? kVersion : kVersionWithAttachment);
  out.u16(0);
  out.u32(static_cast<std::uint32_t>(sheet.size()));
  out.u32(sheet.is_frozen() ? 1 : 0);
  out.text(to_text(sheet.paper()));
  for (const Pigment& pigment : sheet.palette()) append_pigment(out, pigment);
  out.i64(load.capacity);
  append_part(out, load.tip);
  append_part(out, load.root);
  append_tiles(out, sheet);
  if (!attached.empty()) append_packed(out, attached);
  out.u32(checksum(out.bytes()));
  return std::move(out.bytes());
}

base::Result<SavedSheet> parse_sheet(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLeast = kMagic.size() + 8;
  if (bytes.size() < kLeast || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin()))
    return base::fail(Errc::parse, "is not a sheet of paper", {}, "give a file that Nazori saved (.nzs)");
  ByteReader reader(bytes.subspan(kMagic.size()).first(bytes.size() - kMagic.size() - 4));
  const auto version = reader.u16();
  if (version < kVersion || version > kVersionWithAttachment || reader.u16() != 0)
    return base::fail(Errc::schema, "is of version " + std::to_string(version), {},
                      "open it with a newer Nazori; this one reads versions up to " +
                          std::to_string(kVersionWithAttachment));
  ByteReader end(bytes.last(4));
  if (end.u32() != checksum(bytes.first(bytes.size() - 4)))
    return base::fail(Errc::parse, "is damaged: its checksum is wrong");
  const auto size = reader.u32();
  const auto flags = reader.u32();
  const auto paper = parse_paper(next_text(reader));
  if (!paper) return tl::unexpected(paper.error());
  std::array<Pigment, kSlots> palette;
  for (Pigment& pigment : palette) pigment = next_pigment(reader);
  InkLoad load;
  load.capacity = reader.i64();
  const bool has_ink = next_part(reader, load.tip) && next_part(reader, load.root) && load.capacity >= 0 &&
                       load.capacity <= kMostInk;
  if (!reader.ok()) return base::fail(Errc::parse, "ends too early");
  if (!has_ink || size > Sheet::kLargest || flags > 1)
    return base::fail(Errc::parse, "has values that a sheet of paper cannot have");
  auto sheet = Sheet::create(static_cast<int>(size), *paper, palette);
  if (!sheet) return tl::unexpected(sheet.error());
  if (auto read = read_tiles(reader, *sheet); !read) return tl::unexpected(std::move(read).error());
  Bytes attached;
  if (version == kVersionWithAttachment) {
    auto unpacked = next_packed(reader);
    if (!unpacked) return base::fail(Errc::parse, "has strokes that cannot be unpacked");
    attached = std::move(*unpacked);
  }
  if (!reader.ok() || reader.left() != 0)
    return base::fail(Errc::parse, "does not end where its last part does");
  sheet->set_frozen(flags == 1);
  return SavedSheet{std::move(*sheet), load, std::move(attached)};
}

base::Result<void> save_sheet(const Sheet& sheet, const InkLoad& load, const std::filesystem::path& path,
                              std::span<const std::uint8_t> attached) {
  return base::write_file(path, to_bytes(sheet, load, attached));
}

base::Result<SavedSheet> load_sheet(const std::filesystem::path& path) {
  const auto bytes = base::read_file(path, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto saved = parse_sheet(*bytes);
  if (!saved) return in_file(std::move(saved), path);
  return saved;
}

}  // namespace nazori::paint
