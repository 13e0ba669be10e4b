// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/sheet_mark.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "reed_solomon.h"
#include "sheets.h"

namespace nazori::print {
namespace {

constexpr double kAcrossPer_mm = 20;
constexpr double kCellPer_mm = 100;
constexpr double kSizePer_mm = 10;
constexpr char32_t kFirstShort = 0x4E00;  // kanji have short codes
constexpr unsigned kShortBits = 15;
constexpr unsigned kLongBits = 21;
constexpr std::size_t kSum = 2;  // bytes of the checksum
constexpr double kBesideDisc_mm = kDisc_mm / 2 + 1.6;

/// Half of them can be corrected.
constexpr std::size_t parity_of(std::size_t bytes) { return 2 * std::max<std::size_t>(3, (bytes + 6) / 7); }

/// Bytes of a mark with so much content, `most` at most.
std::size_t sealed_size(std::size_t content, std::size_t most) {
  std::size_t all = kFewestMarkBytes;
  while (all - parity_of(all) < content + kSum && all < most) all += kMarkStep;
  return all;
}

/// CRC-16 with the polynomial x^16 + x^12 + x^5 + 1. @source ITU-T V.41.
std::uint16_t checksum(std::span<const std::uint8_t> bytes) {
  unsigned sum = 0xFFFF;
  for (const std::uint8_t b : bytes) {
    sum ^= static_cast<unsigned>(b) << 8U;
    for (int k = 0; k < 8; ++k) sum = (sum & 0x8000U) != 0 ? sum << 1U ^ 0x1021U : sum << 1U;
    sum &= 0xFFFFU;
  }
  return static_cast<std::uint16_t>(sum);
}

class BitWriter {
 public:
  void put(unsigned value, unsigned bits) {
    for (unsigned k = bits; k-- > 0;) {
      if (used_ % 8 == 0) bytes_.push_back(0);
      if ((value >> k & 1U) != 0)
        bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | 0x80U >> used_ % 8);
      ++used_;
    }
  }
  void put(double value, double per_unit, unsigned bits) {
    const double units = std::round(value * per_unit);
    fits_ = fits_ && units >= 0 && units < std::ldexp(1.0, static_cast<int>(bits));
    put(fits_ ? static_cast<unsigned>(units) : 0U, bits);
  }
  void put_character(char32_t c) {
    const bool is_short = c >= kFirstShort && c < kFirstShort + (1U << kShortBits);
    put(is_short ? 0U : 1U, 1);
    put(is_short ? c - kFirstShort : c, is_short ? kShortBits : kLongBits);
  }
  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t used_ = 0;
  bool fits_ = true;
};

/// Behind the last bit there are zeros, and has_ended() is true.
class BitReader {
 public:
  explicit BitReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  unsigned get(unsigned bits) {
    unsigned value = 0;
    for (unsigned k = 0; k < bits; ++k, ++used_) {
      const bool set = used_ / 8 < bytes_.size() && (bytes_[used_ / 8] & 0x80U >> used_ % 8) != 0;
      value = value << 1U | (set ? 1U : 0U);
    }
    return value;
  }
  double get(double per_unit, unsigned bits) { return get(bits) / per_unit; }
  char32_t get_character() { return get(1) == 0 ? kFirstShort + get(kShortBits) : get(kLongBits); }
  [[nodiscard]] bool has_ended() const { return used_ > bytes_.size() * 8; }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t used_ = 0;
};

bool is_scalar(char32_t c) { return c >= 0x20 && c <= 0x10FFFF && (c < 0xD800 || c > 0xDFFF); }

Rect area_of(const SheetMark& mark) { return practice_area({mark.width_mm, mark.height_mm}); }

/// Whether all cells lie on the page.
bool is_sound(const SheetMark& mark) {
  const Rect area = area_of(mark);
  const Flow flow(area, mark.vertical);
  if (mark.cell_mm < kSmallestCell_mm - 1 / kCellPer_mm || mark.cell_mm > kLargestCell_mm + 1 / kCellPer_mm)
    return false;
  if (area.width < mark.cell_mm || area.height < mark.cell_mm) return false;
  for (const MarkedRun& run : mark.runs) {
    const bool practice = mark.layout == Layout::practice;
    if (run.characters.empty()) return false;
    if (run.across_mm + run.rows * mark.cell_mm > flow.depth() + 0.1) return false;
    if (!practice && static_cast<double>(run.characters.size()) * mark.cell_mm > flow.length() + 0.1)
      return false;
    for (const char32_t c : run.characters)
      if (!is_scalar(c) && (practice || c != 0)) return false;
  }
  return true;
}

std::optional<SheetMark> read_content(std::span<const std::uint8_t> content) {
  BitReader in(content);
  in.get(4);
  SheetMark mark;
  mark.layout = in.get(1) == 0 ? Layout::practice : Layout::quiz;
  mark.vertical = in.get(1) != 0;
  mark.guide = static_cast<Guide>(in.get(2));
  mark.width_mm = in.get(kSizePer_mm, 12);
  mark.height_mm = in.get(kSizePer_mm, 12);
  mark.cell_mm = in.get(kCellPer_mm, 13);
  mark.copies = static_cast<int>(in.get(6));
  mark.page = static_cast<int>(in.get(10));
  const unsigned count = in.get(6);
  for (unsigned i = 0; i < count && !in.has_ended(); ++i) {
    MarkedRun& run = mark.runs.emplace_back();
    run.across_mm = in.get(kAcrossPer_mm, 13);
    if (mark.layout == Layout::practice) {
      run.rows = static_cast<int>(in.get(6));
      run.characters.push_back(in.get_character());
    } else {
      const unsigned letters = in.get(5);
      for (unsigned k = 0; k < letters && !in.has_ended(); ++k)
        run.characters.push_back(in.get(1) == 0 ? 0 : in.get_character());
    }
  }
  if (in.has_ended() || !is_sound(mark)) return std::nullopt;
  return mark;
}

}  // namespace

std::array<PaperPoint, 4> disc_centres(double width_mm, double height_mm) {
  const double left = kMargin_mm + kDisc_mm / 2;
  const double top = kMargin_mm + kDisc_mm / 2;
  const double right = width_mm - left;
  const double bottom = height_mm - kMargin_mm - kFooter_mm - kMarkDepth_mm / 2 + kMarkGap_mm / 2;
  return {PaperPoint{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

PaperPoint module_centre(double height_mm, int column, int row) {
  const PaperPoint disc = disc_centres(0, height_mm)[3];
  return {disc.x + kBesideDisc_mm + (column + 0.5) * kModule_mm,
          disc.y + (row - kMarkRows / 2.0) * kModule_mm};
}

std::size_t mark_room(double width_mm) {
  const double length = width_mm - 2 * (kMargin_mm + kDisc_mm / 2 + kBesideDisc_mm);
  const auto bytes = static_cast<std::size_t>(std::max(0.0, length / kModule_mm) * kMarkRows / 8);
  return std::min(bytes / kMarkStep * kMarkStep, kMostMarkBytes);
}

std::vector<MarkedBox> boxes_of(const SheetMark& mark) {
  std::vector<MarkedBox> boxes;
  const Flow flow(area_of(mark), mark.vertical);
  const double side = mark.cell_mm;
  const auto add = [&](char32_t c, double along, double across, bool traced) {
    const Rect box = flow.rect(along, across, side, side);
    boxes.push_back({c, {box.x, box.y}, side, traced});
  };
  const int in_row = cells_in(flow.length(), side);
  for (const MarkedRun& run : mark.runs) {
    if (mark.layout == Layout::practice) {
      for (int cell = 0; cell < run.rows * in_row; ++cell) {
        const int row = cell / in_row;
        add(run.characters.front(), cell % in_row * side, run.across_mm + row * side, cell < mark.copies);
      }
    } else {
      double along = 0;
      for (const char32_t c : run.characters) {
        if (c != 0) add(c, along, run.across_mm, false);
        along += side;
      }
    }
  }
  return boxes;
}

base::Result<std::vector<std::uint8_t>> mark_bytes(const SheetMark& mark, std::size_t room) {
  BitWriter out;
  out.put(kMarkVersion, 4);
  out.put(mark.layout == Layout::quiz ? 1U : 0U, 1);
  out.put(mark.vertical ? 1U : 0U, 1);
  out.put(static_cast<unsigned>(mark.guide), 2);
  out.put(mark.width_mm, kSizePer_mm, 12);
  out.put(mark.height_mm, kSizePer_mm, 12);
  out.put(mark.cell_mm, kCellPer_mm, 13);
  out.put(mark.copies, 1.0, 6);
  out.put(mark.page, 1.0, 10);
  out.put(static_cast<double>(mark.runs.size()), 1.0, 6);
  for (const MarkedRun& run : mark.runs) {
    out.put(run.across_mm, kAcrossPer_mm, 13);
    if (mark.layout == Layout::practice) {
      out.put(run.rows, 1.0, 6);
      out.put_character(run.characters.front());
    } else {
      out.put(static_cast<double>(run.characters.size()), 1.0, 5);
      for (const char32_t c : run.characters) {
        out.put(c == 0 ? 0U : 1U, 1);
        if (c != 0) out.put_character(c);
      }
    }
  }
  if (!out.fits() || sealed_size(out.bytes().size(), room + 1) > room)
    return base::fail(base::Errc::bad_argument, "the mark has no room for so many characters", "worksheet");
  return sealed_mark(out.bytes());
}

std::vector<std::uint8_t> sealed_mark(std::span<const std::uint8_t> content) {
  const std::size_t all = sealed_size(content.size(), kMostMarkBytes);
  std::vector<std::uint8_t> bytes(content.begin(), content.end());
  bytes.resize(all - parity_of(all) - kSum);
  const std::uint16_t sum = checksum(bytes);
  bytes.push_back(static_cast<std::uint8_t>(sum >> 8U));
  bytes.push_back(static_cast<std::uint8_t>(sum & 0xFFU));
  append_parity(bytes, parity_of(all));
  return bytes;
}

base::Result<SheetMark> read_mark(std::span<const std::uint8_t> bytes) {
  const auto damaged = [] {
    return base::fail(base::Errc::parse, "the mark cannot be read: it is damaged, or of another program", {},
                      "photograph the whole page sharply, from above");
  };
  if (bytes.size() < kFewestMarkBytes || bytes.size() > kMostMarkBytes || bytes.size() % kMarkStep != 0)
    return damaged();
  std::vector<std::uint8_t> all(bytes.begin(), bytes.end());
  const std::size_t parity = parity_of(all.size());
  if (!correct(all, parity)) return damaged();
  const std::size_t length = all.size() - parity - kSum;
  const std::span<const std::uint8_t> content(all.data(), length);
  if (checksum(content) != (static_cast<unsigned>(all[length]) << 8U | all[length + 1])) return damaged();
  const int version = content[0] >> 4U;
  if (version != kMarkVersion)
    return base::fail(base::Errc::schema,
                      "the mark has version " + std::to_string(version) + ", this program reads version " +
                          std::to_string(kMarkVersion),
                      {}, "use the version of Nazori that printed the sheet");
  auto mark = read_content(content);
  if (!mark) return damaged();
  return *std::move(mark);
}

const std::vector<std::array<double, 2>>& page_sizes() {
  static const std::vector<std::array<double, 2>> sizes = [] {
    std::vector<std::array<double, 2>> made;
    SheetSettings settings;
    for (const Paper paper : {Paper::a4, Paper::b5, Paper::letter, Paper::hanshi})
      for (const bool booklet : {false, true}) {
        settings.paper = paper;
        settings.booklet = booklet;
        const Size size = size_of(settings);
        made.push_back({size.width, size.height});
      }
    return made;
  }();
  return sizes;
}

}  // namespace nazori::print
