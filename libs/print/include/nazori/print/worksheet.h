// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/progress.h"
#include "nazori/base/result.h"
#include "nazori/kanji/character.h"
#include "nazori/print/page_drawing.h"

namespace nazori::print {

/// What is printed.
enum class Layout : std::uint8_t {
  practice,    ///< for each character its model, its facts, its order, and cells to write it
  quiz,        ///< words by reading and meaning, with empty cells for their characters
  cards,       ///< flash cards: the character in front, its facts on the back; both sides with cut marks
  manuscript,  ///< genkouyoushi: 20 columns of 20 cells for a text
  brush,       ///< sheets for the brush: a few large characters, fold lines, a column for the name
};

/// The lines inside a cell.
enum class Guide : std::uint8_t {
  none,
  cross,      ///< 十, dashed
  field,      ///< 田, solid
  diagonals,  ///< 米, dashed
};

enum class Paper : std::uint8_t {
  a4,
  b5,
  letter,
  hanshi,  ///< the paper of calligraphy classes; makers differ by a few millimetres
};

/// The names in settings and in commands, in the order of the enumerations.
inline constexpr std::array<std::string_view, 5> kLayoutNames{"practice", "quiz", "cards", "manuscript",
                                                              "brush"};
inline constexpr std::array<std::string_view, 4> kGuideNames{"none", "十", "田", "米"};
inline constexpr std::array<std::string_view, 4> kPaperNames{"a4", "b5", "letter", "hanshi"};

/// Upright, [mm].
struct PaperSize {
  double width;
  double height;
};
[[nodiscard]] constexpr PaperSize paper_size(Paper paper) {
  switch (paper) {
    case Paper::b5:
      return {182, 257};  // of JIS P 0138
    case Paper::letter:
      return {215.9, 279.4};
    case Paper::hanshi:
      return {243, 334};
    case Paper::a4:
      break;
  }
  return {210, 297};
}

/// The language of what is printed around the characters: Name or 名前.
enum class Language : std::uint8_t { english, japanese };

struct SheetSettings {
  Layout layout = Layout::practice;
  Paper paper = Paper::a4;
  Guide guide = Guide::cross;
  Language language = Language::english;
  double cell_mm = 15;      ///< side of a cell to write in, kSmallestCell_mm..kLargestCell_mm
  int rows = 2;             ///< of cells for each character (practice), 0..kMostRows; sheets of the same
                            ///< characters (brush), at least one
  int copies = 4;           ///< cells (brush: sheets) of them that show the character, fainter and fainter;
                            ///< 0..kMostRows
  int per_sheet = 4;        ///< brush: characters on a sheet, one of kPerSheet
  bool whole_page = false;  ///< practice: one character a page, filled with rows
  bool vertical = false;    ///< cells and text from top to bottom, from right to left
  bool steps = true;        ///< practice: a box a stroke that shows how the character grows
  bool numbers = true;      ///< stroke numbers in the model
  bool arrows = true;       ///< direction of each stroke in the model
  bool facts = true;        ///< readings, meanings, words
  bool answers = false;     ///< quiz: behind each page another with the answers
  bool booklet = false;  ///< two pages side by side on each side of a sheet, in the order of a folded booklet
  bool name_line = true;  ///< practice and quiz: lines for name, class and date beside the title
  std::string title;
  std::string text;  ///< manuscript: the text, in faint letters; empty for empty paper

  friend bool operator==(const SheetSettings&, const SheetSettings&) = default;
};

/// The greatest number of rows, and of cells that show the character.
inline constexpr int kMostRows = 40;
inline constexpr std::array<int, 4> kPerSheet{1, 2, 4, 6};
inline constexpr double kSmallestCell_mm = 8;
inline constexpr double kLargestCell_mm = 60;
/// Nothing is printed closer to an edge of the paper; of a booklet, to an edge of its page.
inline constexpr double kMargin_mm = 12;

/// What is said about a form that somebody made. Texts may be empty.
struct MadeForm {
  std::string name;              ///< "永" or "our sign"
  std::string author;            ///< to be named with every copy
  std::string licence;           ///< SPDX name or a sentence
  bool is_from_kanjivg = false;  ///< made from a published form
};

/// A character to print, with words that are written with it.
struct SheetCharacter {
  kanji::Character character;
  std::vector<kanji::Word> words;
  std::optional<MadeForm> made = {};  ///< nothing for a published form
};

/// A document whose pages are laid out: they can be shown one by one, and written as PDF. What is shown is
/// read from the content of the file, so both are the same. Thread rules: one thread at a time.
class Worksheet {
 public:
  /// @return the errors of worksheet_pdf().
  [[nodiscard]] static base::Result<Worksheet> lay_out(std::vector<SheetCharacter> characters,
                                                       SheetSettings settings,
                                                       const base::Progress& progress = {});
  Worksheet(Worksheet&&) noexcept;
  Worksheet& operator=(Worksheet&&) noexcept;
  ~Worksheet();

  /// Sides of paper, at least one. Of a booklet, each shows two of its pages.
  [[nodiscard]] std::size_t page_count() const;
  /// @param index  less than page_count(). @cost a few milliseconds.
  [[nodiscard]] PageDrawing page(std::size_t index);
  /// The file, as worksheet_pdf() describes. @return Errc::cancelled.
  [[nodiscard]] base::Result<std::string> pdf(const base::Progress& progress = {});

 private:
  struct Inside;
  explicit Worksheet(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

/// The pages as PDF 1.5. Strokes are paths. All letters are text in embedded fonts of which only the used
/// glyphs are there; the model of a character is accompanied by invisible text, so that it can be searched
/// for and copied. The same input and fonts always give the same bytes.
/// @return Errc::bad_argument for a setting out of range or nothing to print, Errc::not_found without a font
/// (fonts-klee, fonts-ipaexfont-gothic), Errc::cancelled.
/// @cost 80 characters in less than a second. Thread-safe: yes.
[[nodiscard]] base::Result<std::string> worksheet_pdf(const std::vector<SheetCharacter>& characters,
                                                      const SheetSettings& settings,
                                                      const base::Progress& progress = {});

}  // namespace nazori::print
