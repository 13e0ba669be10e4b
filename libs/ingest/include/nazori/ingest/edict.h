// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"

namespace nazori::ingest {

/// One line of EDICT.
struct EdictEntry {
  std::string text;                              ///< "休日"
  std::string reading;                           ///< "きゅうじつ", empty if the line has none
  std::vector<std::vector<std::string>> senses;  ///< glosses of each sense; no sense is empty
  std::string parts_of_speech;                   ///< the marks of all senses, each once: "n,adj-no"
  bool common = false;                           ///< marked (P)

  friend bool operator==(const EdictEntry&, const EdictEntry&) = default;
};

/// Reads a line of EDICT (not EDICT2), in UTF-8, without its line break: "休日 [きゅうじつ] /(n) holiday/day
/// off/(P)/". Part-of-speech marks and sense numbers are removed from the glosses; other marks, (uk) or
/// (comp), are kept.
/// @source www.edrdg.org/jmdict/edict_doc.html
/// @return Errc::parse for a line without text, with an empty reading, without glosses or without the last
/// '/'.
[[nodiscard]] base::Result<EdictEntry> parse_edict_line(std::string_view line);

}  // namespace nazori::ingest
