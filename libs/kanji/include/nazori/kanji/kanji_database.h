// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"
#include "nazori/kanji/query.h"

namespace nazori::kanji {

/// The built-in lists of characters.
enum class List : std::uint8_t {
  grade_1,
  grade_2,
  grade_3,
  grade_4,
  grade_5,
  grade_6,
  secondary,  ///< jouyou beyond grade 6 (KANJIDIC2 grade 8)
  jinmeiyou,  ///< KANJIDIC2 grades 9 and 10
  hiragana,
  katakana,
  latin_and_digits,
  own,  ///< characters that people made themselves: first those whose form takes the place of a published
        ///< one, commonest first, then the others in the order in which they were given to open()
  all,  ///< every character that has strokes, own ones, too
};

/// A published source the database was built from.
struct Source {
  std::string name;
  std::string version;
  std::string sha256;  ///< of the file as fetched, hexadecimal
  std::string licence;
};

/// One stroke, as for_each_stroke() passes it on.
struct StrokePath {
  char32_t code_point = 0;
  int place = 0;          ///< rank of the character, 0 the commonest
  std::string_view path;  ///< SVG path data, glyph frame; invalid after the call
};

/// The kanji database kanji.db, opened read only. Thread-safe: no; each thread opens its own. Not for the
/// servo thread. Where a row cannot be read, the function returns the same as for a missing row, and
/// trouble() says why.
class KanjiDatabase {
 public:
  /// @param own  characters that people made themselves: they are found, listed and read as those of the file
  /// are. Their code points are those of is_own(), each once. One with an own_form (a code point of is_own())
  /// has the code point of a published character instead, and its strokes and parts take the place of the
  /// published ones; what the dictionary says of it stays. If the file does not have that character, the own
  /// one stands beside the others, with own_form as its code point.
  /// @return Errc::not_found for a missing file, Errc::schema for a file that is not a kanji.db of this
  /// version, Errc::bad_argument for own characters with other code points, or two with the same one.
  [[nodiscard]] static base::Result<KanjiDatabase> open(const std::filesystem::path& path,
                                                        std::vector<Character> own = {});

  /// Where kanji.db is looked for, in order: the folder in NAZORI_DATA; the folder of the running program;
  /// for a program that runs where it was built, build/data (base::BuildTree::data); nazori/ in XDG_DATA_HOME
  /// and in each of XDG_DATA_DIRS; for a program in PREFIX/bin, PREFIX/share/nazori. The first that exists,
  /// or Errc::not_found whose remedy says how to build one.
  [[nodiscard]] static base::Result<std::filesystem::path> locate();

  /// Where a new kanji.db is written when no file is named: in the folder in NAZORI_DATA, else in build/data
  /// of the program's build tree, else in nazori/ in XDG_DATA_HOME. Errc::not_found where none of these is
  /// known.
  [[nodiscard]] static base::Result<std::filesystem::path> place_to_build();

  KanjiDatabase(KanjiDatabase&&) noexcept;
  KanjiDatabase& operator=(KanjiDatabase&&) noexcept;
  ~KanjiDatabase();

  /// The first read error since open(); empty where there was none. Check it before you take "not found" for
  /// the answer.
  [[nodiscard]] const std::optional<base::Error>& trouble() const;

  /// One complete character; `variant` is a suffix, empty for the main form. nullopt where it is not in the
  /// database.
  [[nodiscard]] std::optional<Character> find(char32_t code_point, std::string_view variant = {}) const;

  /// The row of a character in lists; nullopt where it is not in the database. Does not read the file.
  [[nodiscard]] std::optional<Summary> summary(char32_t code_point) const;
  /// On and kun readings as the dictionary writes them. Faster than find().
  [[nodiscard]] std::vector<std::string> readings(char32_t code_point) const;

  /// Whether a character has strokes. Does not read the file.
  [[nodiscard]] bool draws(char32_t code_point) const;

  /// The matching characters, best first: the character itself; whole readings and first meanings; readings
  /// without their okurigana and other whole meanings; names and single words of meanings; then beginnings.
  /// Among equals the commoner comes first.
  [[nodiscard]] std::vector<Summary> search(const Query& query) const;

  /// As search(), and why each of them matches.
  [[nodiscard]] std::vector<Match> matches(const Query& query) const;

  /// Words of the dictionary, best first: the whole word or reading, a whole gloss; then single words of a
  /// gloss and beginnings. Among equals the commoner comes first. A meaning and a beginning find common words
  /// only.
  /// @param text  of a Query. @param limit  maximum number of words, >= 0.
  [[nodiscard]] std::vector<WordMatch> search_words(std::string_view text, int limit) const;

  /// Members of a built-in list, in learning order (grades: by frequency, then code point; kana: as in the
  /// table of fifty sounds, then the voiced, then the small ones).
  [[nodiscard]] std::vector<Summary> list(List which) const;

  /// Words written with the character, commonest first.
  [[nodiscard]] std::vector<Word> words(char32_t code_point, int limit) const;

  /// Common words whose reading has the kana, in its syllabary, and 2 to `most_kana` kana; commonest first.
  /// Reads all words, in about 50 ms.
  [[nodiscard]] std::vector<Word> words_heard_with(char32_t kana, int most_kana, int limit) const;

  /// Characters that have `element` as a component, commonest first.
  [[nodiscard]] std::vector<Summary> containing(std::string_view element, int limit) const;

  /// @param number 1..214; nullopt otherwise.
  [[nodiscard]] std::optional<Radical> radical(int number) const;

  /// All 214 classical radicals, by number.
  [[nodiscard]] std::vector<Radical> radicals() const;
  /// The number of a radical by any of its forms, "亻"; nullopt for anything else.
  [[nodiscard]] std::optional<int> radical_of_form(std::string_view form) const;

  /// What can be chosen in a table of parts: parts that at least `fewest` characters with strokes have, with
  /// these characters. A part that is a character itself is one of its characters. By number of strokes, then
  /// the most used first.
  [[nodiscard]] std::vector<PartUse> parts(int fewest) const;

  [[nodiscard]] std::vector<Source> sources() const;

  /// Passes every stroke of every main form to `take`: all strokes of one character after another, in writing
  /// order. For callers that need all strokes at once; find() would be many times slower.
  void for_each_stroke(const std::function<void(const StrokePath&)>& take) const;

 private:
  struct Inside;
  explicit KanjiDatabase(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::kanji
