// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"

namespace nazori::ingest {

/// The part of KANJIDIC2 that kanji.db contains.
struct Kanjidic2 {
  std::string version;  ///< date of creation, "2022-08-23"
  std::map<char32_t, kanji::DictionaryEntry> entries;
};

/// Reads the XML text. The text is parsed in place, so it is passed by value.
/// @return Errc::parse for text that is not KANJIDIC2; where: the character.
[[nodiscard]] base::Result<Kanjidic2> parse_kanjidic2(std::string xml);

}  // namespace nazori::ingest
