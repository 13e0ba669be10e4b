// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/scan/picture.h"

namespace nazori::author {

/// Families of the installed fonts that draw the character with outlines, in the order of their names, each
/// once. @cost reads the list of fonts of the system; a second call is fast. Thread-safe: yes.
[[nodiscard]] std::vector<std::string> font_families(char32_t character);

inline constexpr int kLeastFontPicture = 64;  ///< pixels
inline constexpr int kMostFontPicture = 2048;

/// The character as a font draws it, black on white, where it stands in the font's square: a small ィ stays
/// small. @param side  of the picture [pixels], kLeastFontPicture..kMostFontPicture.
/// @return Errc::not_found where no font of this family is installed or it lacks the character,
/// Errc::bad_argument for another side, Errc::parse for a damaged font. Thread-safe: yes.
[[nodiscard]] base::Result<scan::Photo> font_picture(char32_t character, const std::string& family,
                                                     int side = 512);

}  // namespace nazori::author
