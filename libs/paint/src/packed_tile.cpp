// SPDX-License-Identifier: Apache-2.0
#include "packed_tile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "nazori/base/bytes.h"

namespace nazori::paint {
namespace {

using base::ByteReader;
using base::ByteWriter;

constexpr std::size_t kFields = 2 + 2 * kSlots;
constexpr std::size_t kMaskBytes = kCells / 8;
constexpr std::uint16_t kHasGround = 1U << kFields;
// Rounding may fill a cell a few units too high.
constexpr Amount kMostFibre = kOne + 4096;
constexpr TotalAmount kMostEvaporated = TotalAmount{1} << 60;

template <class T>
auto fields_of(T& tile) {
  return std::array{&tile.surface,   &tile.fibre,    &tile.moving[0], &tile.moving[1],
                    &tile.moving[2], &tile.fixed[0], &tile.fixed[1],  &tile.fixed[2]};
}

constexpr std::array<Amount, kFields> kMost{kMostWater,      kMostFibre, 2 * kMostMoving, 2 * kMostMoving,
                                            2 * kMostMoving, kMostFixed, kMostFixed,      kMostFixed};

bool is_empty(const Field& field) {
  return std::all_of(field.begin(), field.end(), [](Amount a) { return a == 0; });
}

void pack_field(const Field& field, ByteWriter& out) {
  const std::size_t mask = out.bytes().size();
  out.bytes().resize(mask + kMaskBytes);
  for (std::size_t i = 0; i < kCells; ++i) {
    if (field[i] == 0) continue;
    out.bytes()[mask + i / 8] |= static_cast<std::uint8_t>(1U << i % 8);
    out.i32(field[i]);
  }
}

bool unpack_field(ByteReader& reader, Amount most, Field& field) {
  const auto mask = reader.take(kMaskBytes);
  if (mask.size() != kMaskBytes) return false;
  for (std::size_t i = 0; i < kCells; ++i) {
    field[i] = 0;
    if ((mask[i / 8] >> i % 8 & 1U) == 0) continue;
    field[i] = reader.i32();
    if (field[i] <= 0 || field[i] > most) return false;
  }
  return reader.ok();
}

bool unpack_ground(ByteReader& reader, const Bands& paper_inside, Tile& tile) {
  tile.ground = std::make_unique<Ground>();
  Ground& ground = *tile.ground;
  if (!unpack_field(reader, INT32_MAX, ground.covered)) return false;
  for (std::size_t band = 0; band < 3; ++band) {
    for (std::size_t i = 0; i < kCells; ++i) {
      float& value = ground.reflectance[band][i];
      value = ground.covered[i] != 0 ? reader.f32() : static_cast<float>(paper_inside[band]);
      if (!(value >= 0.0F && value <= 1.0F) || std::signbit(value)) return false;
    }
  }
  return reader.ok();
}

}  // namespace

std::vector<std::uint8_t> pack(const Tile& tile) {
  ByteWriter out;
  std::uint16_t present = tile.ground ? kHasGround : 0;
  const auto fields = fields_of(tile);
  for (std::size_t k = 0; k < kFields; ++k)
    if (!is_empty(*fields[k])) present |= static_cast<std::uint16_t>(1U << k);
  if (present == 0 && tile.evaporated == 0) return {};
  out.i64(tile.evaporated);
  out.u16(present);
  for (std::size_t k = 0; k < kFields; ++k)
    if ((present >> k & 1U) != 0) pack_field(*fields[k], out);
  if (tile.ground) {
    pack_field(tile.ground->covered, out);
    for (const auto& band : tile.ground->reflectance)
      for (std::size_t i = 0; i < kCells; ++i)
        if (tile.ground->covered[i] != 0) out.f32(band[i]);
  }
  return std::move(out.bytes());
}

bool unpack(std::span<const std::uint8_t> bytes, const Bands& paper_inside, Tile& tile) {
  ByteReader reader(bytes);
  std::uint16_t present = 0;
  tile.evaporated = 0;
  tile.ground.reset();
  if (!bytes.empty()) {
    tile.evaporated = reader.i64();
    present = reader.u16();
    if (tile.evaporated < 0 || tile.evaporated > kMostEvaporated || present >= 2 * kHasGround ||
        (present == 0 && tile.evaporated == 0))
      return false;
  }
  const auto fields = fields_of(tile);
  for (std::size_t k = 0; k < kFields; ++k) {
    if ((present >> k & 1U) == 0) {
      fields[k]->fill(0);
    } else if (!unpack_field(reader, kMost[k], *fields[k]) || is_empty(*fields[k])) {
      return false;
    }
  }
  if ((present & kHasGround) != 0 && !unpack_ground(reader, paper_inside, tile)) return false;
  return reader.ok() && reader.left() == 0;
}

}  // namespace nazori::paint
