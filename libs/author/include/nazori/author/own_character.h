// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/author/own_stroke.h"
#include "nazori/base/result.h"
#include "nazori/carving/carve.h"
#include "nazori/carving/groove.h"
#include "nazori/geometry/frames.h"
#include "nazori/kanji/character.h"
#include "nazori/surface/height_map.h"
#include "nazori/tablet/carved_tablet.h"

namespace nazori::author {

/// Samples per side of the hand's layer and of the map of a new document.
inline constexpr int kMapSize = 1024;
/// Most strokes of a character. @source KanjiVG's longest has 34; its reader takes 200.
inline constexpr std::size_t kMostStrokes = 200;
/// Most points of one stroke, and of all strokes together.
inline constexpr std::size_t kMostPoints = 1'000;
inline constexpr std::size_t kMostPointsInAll = 20'000;
/// Longest text in bytes of UTF-8: a name, a reading or the name of a part, a meaning; and most of a list.
inline constexpr std::size_t kLongestName = 200;
inline constexpr std::size_t kLongestText = 1'000;
inline constexpr std::size_t kMostTexts = 100;

/// A part of a character: a name, and its strokes.
struct OwnPart {
  std::string name;          ///< "亻"
  std::vector<int> strokes;  ///< 0-based, ascending, each once
  friend bool operator==(const OwnPart&, const OwnPart&) = default;
};

/// Who made a character and what others may do with it. What was made from KanjiVG keeps its licence.
struct Rights {
  std::string licence;  ///< SPDX name ("CC-BY-SA-3.0") or a sentence; empty: not said
  std::string author;   ///< to be named with every copy
  std::string source;   ///< kKanjiVgSource, the name of a picture; empty: drawn here
  friend bool operator==(const Rights&, const Rights&) = default;
};
inline constexpr std::string_view kKanjiVgSource = "KanjiVG";
inline constexpr std::string_view kKanjiVgLicence = "CC-BY-SA-3.0";
inline constexpr std::string_view kKanjiVgAuthor =
    "Ulrich Apel and the KanjiVG contributors, kanjivg.tagaini.net";
/// The rights in a copy of a character of the database. @source the licence in each file of KanjiVG.
[[nodiscard]] Rights kanjivg_rights();

/// What is said about a character: everything but its form. Texts are UTF-8 without control characters.
struct Facts {
  std::string name;                   ///< "永" or "our sign"
  std::vector<std::string> readings;  ///< kana or any text
  std::vector<std::string> meanings;
  std::vector<OwnPart> parts;
  std::optional<int> radical;  ///< classical radical, 1..214
  /// The published character that it replaces once it is kept; none: it stands beside all others.
  std::optional<char32_t> instead_of;
  Rights rights;
  friend bool operator==(const Facts&, const Facts&) = default;
};

/// Height differences made by hand, which are added to what the strokes carve: below 0 deeper, above 0
/// higher. Samples lie as in a HeightMap.
struct HandLayer {
  int size = 0;                ///< samples per side; 0: untouched
  std::vector<float> heights;  ///< size x size, row-major, each -1..1
  [[nodiscard]] bool is_untouched() const { return size == 0; }
  friend bool operator==(const HandLayer&, const HandLayer&) = default;
};

/// A character or sign that somebody makes: strokes in writing order, what is said about it, and the relief
/// that was changed by hand.
struct OwnCharacter {
  Facts facts;
  std::vector<OwnStroke> strokes;  ///< in writing order
  HandLayer hand;
  friend bool operator==(const OwnCharacter&, const OwnCharacter&) = default;
};

/// Whether a character is within all limits and its parts name strokes that are there. Everything that makes
/// or reads a character calls it.
/// @return Errc::bad_argument naming the place: "name", "reading 2", "part 1", "stroke 3, point 5", "hand".
[[nodiscard]] base::Result<void> validate(const OwnCharacter& character);
[[nodiscard]] base::Result<void> validate(const Facts& facts, std::size_t strokes);
[[nodiscard]] base::Result<void> validate(const std::vector<OwnStroke>& strokes);

/// A copy of a character of the database. Carved, it is the same as carving::carve() makes it but for the
/// small differences that carving::groove_of() names. It gets its name, readings, meanings in English, parts,
/// radical, places of numbers and KanjiVG's rights.
[[nodiscard]] OwnCharacter copy_of(const kanji::Character& character, const carving::Brush& brush = {});
/// The strokes alone.
[[nodiscard]] std::vector<OwnStroke> own_strokes(const std::vector<kanji::StrokeLine>& lines,
                                                 const carving::Brush& brush = {});

/// A height map (of a file, or of a plot) as a character without strokes: all of it is the hand's layer, of
/// the map's size.
/// @param map  loaded.
[[nodiscard]] OwnCharacter from_height_map(const surface::HeightMap& map);

/// Strokes that were found in a picture, or made elsewhere.
[[nodiscard]] OwnCharacter from_strokes(std::vector<OwnStroke> strokes);

/// The relief: what the strokes carve and the hand's layer, limited to 0..1. A layer of another size is
/// interpolated bilinearly.
/// @return the errors of carving::carve_grooves().
[[nodiscard]] base::Result<surface::HeightMap> carve(const OwnCharacter& character, int size);

/// Carves only a box again; in it the result is equal, bit for bit, to that of carve().
/// @param map  that is changed. @param box  within the map.
[[nodiscard]] base::Result<void> carve_box(const OwnCharacter& character, const carving::GridBox& box,
                                           surface::HeightMap& map);

/// The character as a tablet to see and to feel. The depths of its lines are those of the relief, so they
/// follow what the hand changed. Milliseconds: for a worker thread.
/// @return the errors of carve() and tablet::CarvedTablet::from_height_map().
[[nodiscard]] base::Result<std::shared_ptr<const tablet::CarvedTablet>> carved_tablet(
    const OwnCharacter& character, int size = kMapSize, const geometry::TabletShape& shape = {});
/// The same from a map that carve() made.
[[nodiscard]] base::Result<std::shared_ptr<const tablet::CarvedTablet>> carved_tablet(
    surface::HeightMap map, const std::vector<OwnStroke>& strokes, const geometry::TabletShape& shape = {});

}  // namespace nazori::author
