// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "canvas.h"
#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/base/utf8.h"
#include "nazori/print/sheet_mark.h"
#include "nazori/print/worksheet.h"
#include "sheet_parts.h"

namespace nazori::print {

constexpr double kHeader_mm = 9;
constexpr double kFooter_mm = 4;
constexpr double kMarkDepth_mm = 6;  // above the footer, with the gap to the cells
constexpr double kMarkGap_mm = 1.2;
constexpr double kGap_mm = 3;
constexpr double kText_mm = 3.6;
constexpr double kLargestStep_mm = 12;
constexpr double kSmallestModel_mm = 24;
constexpr double kLargestModel_mm = 60;

/// Millimetres.
struct Size {
  double width;
  double height;
};

/// Of one page; of a booklet, half a sheet.
[[nodiscard]] Size size_of(const SheetSettings& s);

/// Where the cells of a page with a mark lie. The mark relies on it: another area needs another version of
/// it.
[[nodiscard]] constexpr Rect practice_area(Size size) {
  return {kMargin_mm, kMargin_mm + kHeader_mm, size.width - 2 * kMargin_mm,
          size.height - 2 * kMargin_mm - kHeader_mm - kFooter_mm - kMarkDepth_mm};
}

/// Cells in a row of this length, at least one.
[[nodiscard]] inline int cells_in(double length, double cell_mm) {
  return std::max(1, static_cast<int>((length + 1e-6) / cell_mm));
}

/// The pages of a document.
class Sheets {
 public:
  Sheets(const std::vector<SheetCharacter>& characters, const SheetSettings& settings, Fonts fonts)
      : characters_(characters),
        s_(settings),
        fonts_(std::move(fonts)),
        size_(size_of(settings)),
        credits_(credits_of(characters)) {
    for (std::size_t i = 0; i < characters.size(); ++i)
      index_.emplace(base::encode_utf8(characters[i].character.code_point), i);
  }

  base::Result<void> draw(const base::Progress& progress);
  /// The document as PDF. @return Errc::cancelled.
  [[nodiscard]] base::Result<std::string> file(const base::Progress& progress);
  /// Sides of paper; of a booklet, each shows two pages.
  [[nodiscard]] std::size_t side_count() const;
  /// @param index  less than side_count().
  [[nodiscard]] PageDrawing side(std::size_t index);

 private:
  /// A side of paper, in PDF.
  struct Side {
    Size size;
    std::string content;
  };
  [[nodiscard]] Side content_of_side(std::size_t index) const;
  /// The content of a form object that pages place by its name: a cell "G0", a character "C0", half a side of
  /// a booklet "P0".
  [[nodiscard]] std::string content_of_object(std::string_view name);
  [[nodiscard]] Rect area() const { return practice_area(size_); }
  /// Of a page without header and mark.
  [[nodiscard]] Rect inside_margins() const {
    return {kMargin_mm, kMargin_mm, size_.width - 2 * kMargin_mm, size_.height - 2 * kMargin_mm - kFooter_mm};
  }
  Canvas& new_page(bool with_header);
  void draw_header(Canvas& canvas);
  /// A cell with its guides; without, a thin box.
  void place_cell(Canvas& canvas, const Rect& rect, std::optional<Guide> guide);
  void practice(std::size_t i);
  double practice_depth(const kanji::Character& character, int rows) const;
  void draw_facts(const SheetCharacter& one, const Flow& flow, double along, double across, double length,
                  double depth);
  /// What may stand over the strokes of a character: arrows and numbers; and the character as invisible text.
  void annotate(Canvas& canvas, const SheetCharacter& one, const Rect& box);
  /// 0 for the first of the copies that fade, 1 for the last.
  [[nodiscard]] double faded(int copy) const {
    return s_.copies > 1 ? static_cast<double>(copy) / (s_.copies - 1) : 0;
  }
  /// The character as invisible text over a square, so that it can be searched for and copied.
  void place_text(Canvas& canvas, const SheetCharacter& one, const Rect& box);
  void draw_model(const SheetCharacter& one, std::size_t i, const Rect& box);
  void quiz();
  void quiz_line(const kanji::Word& word, const Flow& flow, double across, Canvas& canvas, bool answer);
  void cards();
  void card_front(Canvas& canvas, std::size_t i, const Rect& card);
  void card_back(std::size_t i, const Rect& card);
  void manuscript();
  base::Result<void> brush(const base::Progress& progress);
  /// A sheet with the characters from `first` on. @param grey  of the models; none without a value.
  void brush_sheet(std::size_t first, std::optional<double> grey);
  [[nodiscard]] std::u32string label(const char* english, const char* japanese) const {
    return wide(s_.language == Language::japanese ? japanese : english);
  }
  [[nodiscard]] double model_mm() const {
    return std::clamp(s_.cell_mm * 1.6, kSmallestModel_mm, kLargestModel_mm);
  }
  [[nodiscard]] double step_mm() const { return std::min(s_.cell_mm, kLargestStep_mm); }
  [[nodiscard]] double flow_length() const { return s_.vertical ? area().height : area().width; }
  [[nodiscard]] double flow_depth() const { return s_.vertical ? area().width : area().height; }
  [[nodiscard]] int cells_in_row() const { return cells_in(flow_length(), s_.cell_mm); }
  /// Begins the mark of the last page.
  void begin_mark();
  /// Adds a line of a quiz. @return false where the mark has no room for it.
  bool add_to_mark(const kanji::Word& word);
  /// Draws the mark of the last page, if it has one.
  void draw_mark();

  const std::vector<SheetCharacter>& characters_;
  const SheetSettings& s_;
  Fonts fonts_;
  Size size_;
  std::u32string credits_;
  std::map<std::string, std::size_t> index_;
  std::vector<std::unique_ptr<Canvas>> pages_;
  /// A cell of one size, which is written once and placed often: side in micrometres, kind.
  std::map<std::pair<long, bool>, std::string> cells_;
  std::set<std::size_t> used_;  // characters that are drawn as an object
  double used_depth_ = 0;       // of the last page
  std::optional<SheetMark> mark_;
};

}  // namespace nazori::print
