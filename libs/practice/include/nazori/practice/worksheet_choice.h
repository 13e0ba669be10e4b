// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/base/settings.h"
#include "nazori/kanji/character_name.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/practice/learner.h"
#include "nazori/print/worksheet.h"

namespace nazori::practice {

/// Where the characters of a worksheet come from.
enum class WorksheetSource : std::uint8_t {
  shown,      ///< the character that is shown
  list,       ///< a list of study, or all studied characters
  due,        ///< the reviews that are due now, without new characters
  difficult,  ///< what the learner forgot too often
  text,       ///< the characters of a text; for manuscript paper, the text itself
};

/// What a worksheet is made of.
struct WorksheetChoice {
  WorksheetSource source = WorksheetSource::list;
  char32_t shown = 0;            ///< of WorksheetSource::shown
  std::string list = "grade-1";  ///< of WorksheetSource::list, as list_members() reads it
  std::string text;              ///< of WorksheetSource::text, and of manuscript paper
  print::SheetSettings sheet;    ///< its text is ignored

  friend bool operator==(const WorksheetChoice&, const WorksheetChoice&) = default;
};

/// Reads a stored choice; what is missing or invalid keeps its value in `fallback`.
[[nodiscard]] WorksheetChoice load_choice(const base::Settings& settings, WorksheetChoice fallback);
/// Stores a choice, without the shown character.
void save_choice(base::Settings& settings, const WorksheetChoice& choice);

/// The characters to write in a text: every kanji once, in the order of the text. A text without kanji gives
/// its other characters, such as kana.
/// @param draws  whether the strokes of a character are known; others are left out.
[[nodiscard]] std::vector<char32_t> characters_of_text(std::string_view text,
                                                       const std::function<bool(char32_t)>& draws);

/// The characters of the learner's study, each once. For WorksheetSource::shown that character; for
/// WorksheetSource::text none, because a text needs the kanji database: characters_of_text().
/// @return the errors of list_members() and of Learner::plan().
[[nodiscard]] base::Result<std::vector<char32_t>> chosen_characters(const WorksheetChoice& choice,
                                                                    Learner& learner);

/// Characters with what a worksheet says about them.
struct SheetCharacters {
  std::vector<print::SheetCharacter> found;
  std::vector<kanji::CharacterName> missing;  ///< not in the database
};
/// Reads characters, and words where the sheet shows some. The caller asks database.trouble() afterwards.
/// @param own  the folder of the characters that somebody made, which says who did; empty: there are none.
[[nodiscard]] SheetCharacters sheet_characters(const kanji::KanjiDatabase& database,
                                               std::span<const kanji::CharacterName> names,
                                               const print::SheetSettings& sheet,
                                               const std::filesystem::path& own = {});

}  // namespace nazori::practice
