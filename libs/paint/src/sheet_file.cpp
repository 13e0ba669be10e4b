// SPDX-License-Identifier: Apache-2.0
#include "nazori/paint/sheet_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "bytes.h"
#include "nazori/base/file.h"
#include "packed_tile.h"

namespace nazori::paint {
namespace {

using base::Errc;
using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'N', 'Z', 'S', '\r', '\n', 0x1A, '\n'};
constexpr std::uint16_t kVersion = 1;
constexpr std::size_t kMostBytes = std::size_t{64} << 20U;
constexpr std::size_t kMostText = 65536;
constexpr TotalAmount kMostInk = TotalAmount{1} << 60;

void append_text(Bytes& bytes, std::string_view text) {
  append(bytes, static_cast<std::uint32_t>(text.size()));
  bytes.insert(bytes.end(), text.begin(), text.end());
}

std::string next_text(ByteReader& reader) {
  const auto length = reader.next<std::uint32_t>();
  const auto part = reader.take(std::min<std::size_t>(length, kMostText + 1));
  return {part.begin(), part.end()};
}

void append_part(Bytes& bytes, const InkLoad::Part& part) {
  append(bytes, part.water);
  for (const TotalAmount pigment : part.pigment) append(bytes, pigment);
}

bool next_part(ByteReader& reader, InkLoad::Part& part) {
  const auto amount = [&](TotalAmount& value) {
    value = reader.next<TotalAmount>();
    return value >= 0 && value <= kMostInk;
  };
  bool fine = amount(part.water);
  for (TotalAmount& pigment : part.pigment) fine = amount(pigment) && fine;
  return fine;
}

void append_pigment(Bytes& bytes, const Pigment& pigment) {
  append_text(bytes, pigment.name);
  for (const double k : pigment.absorption) append(bytes, k);
  for (const double s : pigment.scattering) append(bytes, s);
  append(bytes, pigment.mobility);
  append(bytes, pigment.granulation);
}

Pigment next_pigment(ByteReader& reader) {
  Pigment pigment;
  pigment.name = next_text(reader);
  for (double& k : pigment.absorption) k = reader.next<double>();
  for (double& s : pigment.scattering) s = reader.next<double>();
  pigment.mobility = reader.next<double>();
  pigment.granulation = reader.next<double>();
  return pigment;
}

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

base::Result<void> read_tiles(ByteReader& reader, Sheet& sheet) {
  Sheet::Inside& inside = sheet.inside();
  const auto count = reader.next<std::uint32_t>();
  std::size_t first = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::size_t index = reader.next<std::uint32_t>();
    const auto bytes = reader.take(reader.next<std::uint32_t>());
    if (!reader.is_whole()) return base::fail(Errc::parse, "ends too early");
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

std::vector<std::uint8_t> to_bytes(const Sheet& sheet, const InkLoad& load) {
  Bytes bytes(kMagic.begin(), kMagic.end());
  append(bytes, kVersion);
  append(bytes, std::uint16_t{0});
  append(bytes, static_cast<std::uint32_t>(sheet.size()));
  append(bytes, static_cast<std::uint32_t>(sheet.is_frozen() ? 1 : 0));
  append_text(bytes, to_text(sheet.paper()));
  for (const Pigment& pigment : sheet.palette()) append_pigment(bytes, pigment);
  append(bytes, load.capacity);
  append_part(bytes, load.tip);
  append_part(bytes, load.root);
  const std::size_t count_at = bytes.size();
  append(bytes, std::uint32_t{0});
  std::uint32_t count = 0;
  const auto& tiles = sheet.inside().tiles;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const Bytes packed = pack(*tiles[i]);
    if (packed.empty()) continue;
    ++count;
    append(bytes, static_cast<std::uint32_t>(i));
    append(bytes, static_cast<std::uint32_t>(packed.size()));
    bytes.insert(bytes.end(), packed.begin(), packed.end());
  }
  for (std::size_t i = 0; i < 4; ++i) bytes[count_at + i] = static_cast<std::uint8_t>(count >> (8 * i));
  append(bytes, checksum(bytes));
  return bytes;
}

base::Result<SavedSheet> parse_sheet(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kLeast = kMagic.size() + 8;
  if (bytes.size() < kLeast || !std::equal(kMagic.begin(), kMagic.end(), bytes.begin()))
    return base::fail(Errc::parse, "is not a sheet of paper", {}, "give a file that Nazori saved (.nzs)");
  ByteReader reader(bytes.subspan(kMagic.size()).first(bytes.size() - kMagic.size() - 4));
  const auto version = reader.next<std::uint16_t>();
  if (version != kVersion || reader.next<std::uint16_t>() != 0)
    return base::fail(Errc::schema, "is of version " + std::to_string(version), {},
                      "open it with a newer Nazori; this one reads version " + std::to_string(kVersion));
  ByteReader end(bytes.last(4));
  if (end.next<std::uint32_t>() != checksum(bytes.first(bytes.size() - 4)))
    return base::fail(Errc::parse, "is damaged: its checksum is wrong");
  const auto size = reader.next<std::uint32_t>();
  const auto flags = reader.next<std::uint32_t>();
  const auto paper = parse_paper(next_text(reader));
  if (!paper) return tl::unexpected(paper.error());
  std::array<Pigment, kSlots> palette;
  for (Pigment& pigment : palette) pigment = next_pigment(reader);
  InkLoad load;
  load.capacity = reader.next<TotalAmount>();
  const bool has_ink = next_part(reader, load.tip) && next_part(reader, load.root) && load.capacity >= 0 &&
                       load.capacity <= kMostInk;
  if (!reader.is_whole()) return base::fail(Errc::parse, "ends too early");
  if (!has_ink || size > Sheet::kLargest || flags > 1)
    return base::fail(Errc::parse, "has values that a sheet of paper cannot have");
  auto sheet = Sheet::create(static_cast<int>(size), *paper, palette);
  if (!sheet) return tl::unexpected(sheet.error());
  if (auto read = read_tiles(reader, *sheet); !read) return tl::unexpected(std::move(read).error());
  if (!reader.is_whole() || reader.left() != 0)
    return base::fail(Errc::parse, "does not end after its last tile");
  sheet->set_frozen(flags == 1);
  return SavedSheet{std::move(*sheet), load};
}

base::Result<void> save_sheet(const Sheet& sheet, const InkLoad& load, const std::filesystem::path& path) {
  return base::write_file(path, to_bytes(sheet, load));
}

base::Result<SavedSheet> load_sheet(const std::filesystem::path& path) {
  const auto bytes = base::read_file(path, kMostBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto saved = parse_sheet(*bytes);
  if (!saved) return in_file(std::move(saved), path);
  return saved;
}

}  // namespace nazori::paint
