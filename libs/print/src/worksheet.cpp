// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/worksheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sheets.h"

namespace nazori::print {
namespace {

base::Result<void> check(const std::vector<SheetCharacter>& characters, const SheetSettings& s) {
  const auto refuse = [](const std::string& what, const std::string& remedy) {
    return base::fail(base::Errc::bad_argument, what, "worksheet", remedy);
  };
  if (s.layout != Layout::manuscript && characters.empty())
    return refuse("there is no character to print", "give one or more");
  if (!(s.cell_mm >= kSmallestCell_mm && s.cell_mm <= kLargestCell_mm))
    return refuse(fmt::format("a cell cannot be {:.4g} mm", s.cell_mm), "give 8 to 60 mm");
  if (s.rows < 0 || s.rows > kMostRows || s.copies < 0 || s.copies > kMostRows)
    return refuse("the number of rows or copies is out of range", fmt::format("give 0 to {}", kMostRows));
  if (std::find(kPerSheet.begin(), kPerSheet.end(), s.per_sheet) == kPerSheet.end())
    return refuse(fmt::format("{} characters on a sheet are not offered", s.per_sheet), "give 1, 2, 4 or 6");
  if (s.layout == Layout::practice && !s.whole_page) {
    const Size size = size_of(s);
    const Rect area = practice_area(size);
    const double depth = s.vertical ? area.width : area.height;
    const double model = std::clamp(s.cell_mm * 1.6, kSmallestModel_mm, kLargestModel_mm);
    // Thirty steps take three rows at most on any paper but the narrowest.
    if (model + kGap_mm + s.rows * s.cell_mm + (s.steps ? 4 * std::min(s.cell_mm, kLargestStep_mm) : 0) >
        depth)
      return refuse(fmt::format("{} rows of {:.4g} mm do not fit on a page", s.rows, s.cell_mm),
                    "take fewer rows or smaller cells");
  }
  return {};
}

}  // namespace

struct Worksheet::Inside {
  Inside(std::vector<SheetCharacter> all, SheetSettings chosen, Fonts fonts)
      : characters(std::move(all)),
        settings(std::move(chosen)),
        sheets(characters, settings, std::move(fonts)) {}

  std::vector<SheetCharacter> characters;
  SheetSettings settings;
  Sheets sheets;  // refers to the others
};

Worksheet::Worksheet(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Worksheet::Worksheet(Worksheet&&) noexcept = default;
Worksheet& Worksheet::operator=(Worksheet&&) noexcept = default;
Worksheet::~Worksheet() = default;

base::Result<Worksheet> Worksheet::lay_out(std::vector<SheetCharacter> characters, SheetSettings settings,
                                           const base::Progress& progress) {
  if (auto fine = check(characters, settings); !fine) return tl::unexpected(std::move(fine.error()));
  auto fonts = Fonts::installed();
  if (!fonts) return tl::unexpected(std::move(fonts.error()));
  auto inside = std::make_unique<Inside>(std::move(characters), std::move(settings), *std::move(fonts));
  if (auto drawn = inside->sheets.draw(progress); !drawn) return tl::unexpected(std::move(drawn.error()));
  return Worksheet(std::move(inside));
}

std::size_t Worksheet::page_count() const { return inside_->sheets.side_count(); }

PageDrawing Worksheet::page(std::size_t index) { return inside_->sheets.side(index); }

base::Result<std::string> Worksheet::pdf(const base::Progress& progress) {
  return inside_->sheets.file(progress);
}

base::Result<std::string> worksheet_pdf(const std::vector<SheetCharacter>& characters,
                                        const SheetSettings& settings, const base::Progress& progress) {
  auto sheet = Worksheet::lay_out(characters, settings, base::part_of(progress, 0, 0.6));
  if (!sheet) return tl::unexpected(std::move(sheet.error()));
  return sheet->pdf(base::part_of(progress, 0.6, 1));
}

}  // namespace nazori::print
