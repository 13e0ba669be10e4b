// SPDX-License-Identifier: Apache-2.0
// A file of a sheet: its header is right, paper and tiles are the fuzzer's.
#include <zlib.h>

#include <cstdlib>
#include <vector>

#include "nazori/paint/sheet_file.h"

namespace {

using namespace nazori::paint;

TotalAmount water_of(const Sheet& sheet) { return sheet.holding().water + sheet.evaporated(); }

TotalAmount pigment_of(const Sheet& sheet) {
  const Holding held = sheet.holding();
  return held.pigment[0] + held.pigment[1] + held.pigment[2] + held.covered;
}

/// Everything that is saved before the tiles of an empty sheet.
std::vector<std::uint8_t> head() {
  const Pigment ink = find_pigment("sumi").value();
  auto bytes = to_bytes(Sheet::create(128, {}, {ink, ink, ink}).value(), {});
  bytes.resize(bytes.size() - 8);
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<std::uint8_t> kHead = head();
  // The first byte says whether the whole file is the fuzzer's.
  std::vector<std::uint8_t> bytes;
  if (size > 0 && data[0] % 2 == 0) bytes = kHead;
  if (size > 0) bytes.insert(bytes.end(), data + 1, data + size);
  bytes.resize(bytes.size() + 4);
  const auto sum = static_cast<std::uint32_t>(crc32(0, bytes.data(), static_cast<uInt>(bytes.size() - 4)));
  for (std::size_t i = 0; i < 4; ++i) bytes[bytes.size() - 4 + i] = static_cast<std::uint8_t>(sum >> (8 * i));
  auto saved = parse_sheet(bytes);
  if (!saved) return 0;
  const auto written = to_bytes(saved->sheet, saved->load, saved->attached);
  const auto again = parse_sheet(written);
  if (!again || !again->sheet.is_same_as(saved->sheet) || again->attached != saved->attached) std::abort();
  const TotalAmount water = water_of(saved->sheet), pigment = pigment_of(saved->sheet);
  saved->sheet.set_frozen(false);
  for (int i = 0; i < 3; ++i) saved->sheet.step();
  if (water_of(saved->sheet) != water || pigment_of(saved->sheet) != pigment) std::abort();
  if (!parse_sheet(to_bytes(saved->sheet, saved->load))) std::abort();
  return 0;
}
