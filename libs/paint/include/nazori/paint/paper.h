// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "nazori/base/result.h"

namespace nazori::paint {

/// The properties of a kind of paper. Lengths in metres, times in seconds; what has no unit is a fraction.
/// @source the model of docs/brush.md; the names of the papers are those of the trade, the values were chosen
/// by eye.
struct Paper {
  std::string name = "hanshi";
  double spread_m2_s =
      1.0e-8;  ///< how fast water spreads in full fibres, 0..4e-6; with 1024 cells at most 7.5e-8
  double spread_variation = 0.5;  ///< how much the fibres change that, 0..1
  double pinning = 0.02;          ///< water that a cell needs before it wets a dry neighbour, 0..0.9
  double pinning_height = 0.1;    ///< the same, added where the neighbour stands high, 0..0.9
  double pinning_fibre = 0.1;     ///< the same, added where the neighbour's fibres are dense, 0..0.9
  double absorption_s = 0.05;     ///< time in which the fibres of a cell can fill from its surface, 0..100
  double drying_s = 40;           ///< time in which full fibres dry, 0.5 or longer; 0: never
  double rim_drying = 1.5;        ///< how much faster a cell dries whose four neighbours are dry, 0..10
  double fixing_s =
      30;  ///< time in which pigment settles in the fibres while they are wet; 0: only by drying
  double granulation = 0.4;     ///< how much more pigment settles in hollows than on tops, 0..1
  double kasure_s = 0.03;       ///< the resistance tau0 of dry paper to a fast bristle, 0..10
  double kasure_exponent = 1;   ///< gamma of the same formula, 0.25..4
  double film = 0.9;            ///< water that a full bristle leaves on a cell, in fillings, 0.05..4
  double grain_m = 0.00025;     ///< size of the hollows, 0.0001..0.005
  double wet_darkening = 0.06;  ///< how much darker full paper looks, 0..0.95
  std::array<double, 3> colour{
      0.93, 0.92, 0.88};   ///< how much light dry paper reflects: red, green, blue; linear, 0.05..1
  std::uint32_t seed = 1;  ///< two papers of one kind with different seeds have different fibres

  friend bool operator==(const Paper&, const Paper&) = default;
};

/// The papers that Nazori knows: "hanshi" (practice paper, little bleeding), "gasenshi" (bleeds fast),
/// "gasenshi-slow" (bleeds slowly and far), "board" (hardly drinks, for thick paint), "water" (darkens where
/// it is wet and fades as it dries; for writing with water).
[[nodiscard]] const std::array<std::string_view, 5>& paper_names();

/// A paper of paper_names(). @return Errc::not_found with the names.
[[nodiscard]] base::Result<Paper> find_paper(std::string_view name);

/// A paper from the text of a parameter file: lines `name = value`, where a name is a member of Paper (colour
/// as three numbers). `#` starts a comment. `paper = gasenshi` takes the values of that paper first; what is
/// not named keeps its value. At most 64 KiB.
/// @return Errc::parse with the line and what would be right.
[[nodiscard]] base::Result<Paper> parse_paper(std::string_view text);
/// The text from which parse_paper() makes the same paper, to the last bit.
[[nodiscard]] std::string to_text(const Paper& paper);
/// As parse_paper(), from a file; errors name the file.
[[nodiscard]] base::Result<Paper> load_paper(const std::filesystem::path& path);
/// Whether every value lies in its range. @return Errc::bad_argument with the name and the range.
[[nodiscard]] base::Result<void> check(const Paper& paper);

}  // namespace nazori::paint
