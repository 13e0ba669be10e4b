// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/carving/carve.h"
#include "nazori/model/embosser.h"
#include "nazori/model/english_braille.h"
#include "nazori/model/mill.h"
#include "nazori/practice/solid_model.h"
#include "nazori/print/worksheet.h"

namespace nazori::practice {

/// The machine that makes a tablet to touch from a file.
enum class TouchKind : std::uint8_t {
  mill,         ///< G-code for a ball cutter
  laser,        ///< SVG with a layer for each step of depth
  swell_paper,  ///< PDF in black, for paper that swells where it is black
  embosser,     ///< BRF, dots and braille
};

/// A file for such a machine, and what is in it.
struct TouchFile {
  TouchKind kind = TouchKind::mill;
  std::string content;
  double width_mm = 0;
  double height_mm = 0;
  int pages = 1;                    ///< of paper
  std::vector<int> without_number;  ///< strokes (from 1, of any tablet) for whose number there was no room
  model::MillPath path;             ///< of a mill
  double closest_mm = 0;            ///< swell paper: between lines that run side by side, 0 if none do
};

/// Distance of lines that run side by side on swell paper, so that fingers tell them apart [mm].
/// @source 6.4 mm: guidelines for tactile graphics.
inline constexpr double kSwellGap_mm = 6.4;

/// What a page in braille says about a tablet.
struct TouchLabel {
  std::vector<std::string> meanings;                   ///< in English, one line of them
  std::vector<std::vector<model::BrailleCell>> lines;  ///< below them, in Japanese braille
};

/// The label of a character: its meanings in English, its number of strokes, and its readings in Japanese
/// braille, the on readings before the kun readings. Readings without cells are left out.
[[nodiscard]] TouchLabel touch_label(const kanji::Character& character);

/// The label of a tablet that is no character: its name, in English or kana, and its number of strokes where
/// it has any. Another name has no cells and is left out.
[[nodiscard]] TouchLabel touch_label(const std::string& name, std::size_t strokes);

/// A label line by line. Meanings without cells, and those that do not fit into their line, are left out.
/// @return the errors of model::english_braille().
[[nodiscard]] base::Result<std::vector<std::vector<model::BrailleCell>>> braille_lines(
    const TouchLabel& label, model::EnglishBraille english = model::EnglishBraille::uncontracted);

/// A tablet, and what stands in braille below it.
struct LabelledTablet {
  SolidTablet tablet;
  TouchLabel label;
};

/// The same tablets alone.
[[nodiscard]] std::vector<SolidTablet> without_labels(std::span<const LabelledTablet> tablets);

/// How a page of swell paper looks.
struct SwellSettings {
  double side_mm = 100;  ///< of the square of a character
  print::Paper paper = print::Paper::a4;
  bool start_dots = true;
  bool numbers = true;
  bool label = true;
  model::EnglishBraille english = model::EnglishBraille::uncontracted;  ///< of the label
};

/// How a page of an embosser looks.
struct EmbosserSettings {
  model::EmbosserPaper paper;
  model::EmbossedMarks marks;
  bool label = true;
  model::EnglishBraille english = model::EnglishBraille::uncontracted;  ///< of the label
};

/// The machines and the paper that files are made for.
struct TouchMachines {
  model::MillSettings mill;
  int layers = 10;  ///< of a laser
  print::Paper paper = print::Paper::a4;
  model::EmbosserPaper embosser;
  model::EnglishBraille english = model::EnglishBraille::uncontracted;
};

/// The grooves of tablets as a program for a mill. @param subject  for the comment at its start, where other
/// letters than those of ASCII become code points.
/// @return Errc::bad_argument for raised lines or a mould, and the errors of tablet_plate() and
/// model::mill_path().
[[nodiscard]] base::Result<TouchFile> mill_file(std::span<const SolidTablet> tablets,
                                                const SolidSettings& settings,
                                                const model::MillSettings& mill, const std::string& subject,
                                                const carving::Brush& brush = {});

/// The grooves of tablets as a drawing for a laser. @return as mill_file(), and the errors of
/// model::to_laser_svg().
[[nodiscard]] base::Result<TouchFile> laser_file(std::span<const SolidTablet> tablets,
                                                 const SolidSettings& settings, int layers,
                                                 const std::string& subject,
                                                 const carving::Brush& brush = {});

/// A page for each tablet: strokes 1.6 mm wide that thin out where they sink, a dot where each starts, its
/// number in braille, and the label in braille below. Nothing is filled but dots of 3 mm.
/// @return Errc::bad_argument for a square that does not fit on the paper, or a tablet without strokes, and
/// the errors of braille_lines().
[[nodiscard]] base::Result<TouchFile> swell_file(std::span<const LabelledTablet> tablets,
                                                 const SwellSettings& settings, const std::string& subject);

/// A page for each tablet, as model::embossed() lays it out. @return its errors, and those of
/// braille_lines().
[[nodiscard]] base::Result<TouchFile> embosser_file(std::span<const LabelledTablet> tablets,
                                                    const EmbosserSettings& settings = {});

/// The machine that takes files with such a name: .nc, .svg, .pdf or .brf, in any case; nothing for other
/// names.
[[nodiscard]] std::optional<TouchKind> touch_kind_of(const std::filesystem::path& name);

/// A file for any of these machines. @param settings  size, depth, numbers and start dots; whether lines are
/// raised and the mould are ignored. @return the errors of the functions above.
[[nodiscard]] base::Result<TouchFile> touch_file(TouchKind kind, std::span<const LabelledTablet> tablets,
                                                 SolidSettings settings, const TouchMachines& machines,
                                                 const std::string& subject);

}  // namespace nazori::practice
