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

namespace nazori::kanji {

/// What a search may ask for. Every condition that is set must hold.
struct Query {
  /// A character or several, a reading in kana (with or without the okurigana dot), romaji (Hepburn or
  /// Kunrei, "kyuu", "kyû"), or the beginning of an English word of a meaning. Text with kanji in it asks for
  /// each of these, in its order. Empty: no condition.
  std::string text;
  std::optional<int> grade;
  std::optional<int> strokes;  ///< as drawn, or as the dictionary counts them: they differ for a few
  std::optional<int> radical;  ///< classical number 1..214
  bool drawn_only = true;      ///< only characters that have strokes; false: the whole dictionary
  int limit = 500;             ///< at most so many answers, >= 1
};

/// One line of a list of characters.
struct Summary {
  char32_t code_point = 0;
  std::string meaning;  ///< first English meaning, empty for kana and letters
  std::string reading;  ///< first kun or on reading
  int strokes = 0;      ///< number of strokes in the main form; the dictionary's where it is not drawn
  std::optional<int> grade;

  friend bool operator==(const Summary&, const Summary&) = default;
};

/// The ready lists of characters.
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
  all,  ///< every character that has strokes
};

/// A published source the database was built from.
struct Source {
  std::string name;
  std::string version;
  std::string sha256;  ///< of the file as fetched, hexadecimal
  std::string licence;
};

/// One stroke of one of all characters, as for_each_stroke() hands it on.
struct StrokePath {
  char32_t code_point = 0;
  int place = 0;          ///< of the character, 0 the commonest
  std::string_view path;  ///< SVG path data, glyph frame; gone after the call
};

/// The kanji database kanji.db, opened read only.
/// Thread-safe: no; each thread opens its own. Not for the servo thread. Where a row cannot be read the
/// function answers as if there were none, and trouble() says why.
class KanjiDatabase {
 public:
  /// @return Errc::not_found for a missing file, Errc::schema for a file that is no kanji.db of this version.
  [[nodiscard]] static base::Result<KanjiDatabase> open(const std::filesystem::path& path);

  /// Where kanji.db is looked for, in order: the folder in NAZORI_DATA; the folder of the running program;
  /// for a program that runs where it was built, build/data (base::BuildTree::data); nazori/ in XDG_DATA_HOME
  /// and in each of XDG_DATA_DIRS; for a program in PREFIX/bin, PREFIX/share/nazori. The first that exists,
  /// or Errc::not_found whose remedy says how to build one.
  [[nodiscard]] static base::Result<std::filesystem::path> locate();

  /// Where a new kanji.db is written when no file was named: to the folder in NAZORI_DATA, else build/data of
  /// the program's build tree, else nazori/ in XDG_DATA_HOME. Errc::not_found where none of these is known.
  [[nodiscard]] static base::Result<std::filesystem::path> place_to_build();

  KanjiDatabase(KanjiDatabase&&) noexcept;
  KanjiDatabase& operator=(KanjiDatabase&&) noexcept;
  ~KanjiDatabase();

  /// The first thing that could not be read since open(); empty where all could. Ask it before "there is
  /// none" is taken for the answer.
  [[nodiscard]] const std::optional<base::Error>& trouble() const;

  /// One character whole; `variant` is a suffix, empty for the main form. nullopt where it is not in the
  /// database.
  [[nodiscard]] std::optional<Character> find(char32_t code_point, std::string_view variant = {}) const;

  /// Characters that fit, best first: the character itself; whole readings and first meanings; readings
  /// without their okurigana and other whole meanings; names and single words of meanings; then beginnings.
  /// Among equals the commoner before the rarer.
  [[nodiscard]] std::vector<Summary> search(const Query& query) const;

  /// Members of a ready list, in the order a learner meets them (grades: by frequency, then code
  /// point; kana: as in the table of fifty sounds, then the voiced, then the small ones).
  [[nodiscard]] std::vector<Summary> list(List which) const;

  /// Words written with the character, commonest first.
  [[nodiscard]] std::vector<Word> words(char32_t code_point, int limit) const;

  /// Characters that have `element` as a component, commonest first.
  [[nodiscard]] std::vector<Summary> containing(std::string_view element, int limit) const;

  /// @param number 1..214; nullopt otherwise.
  [[nodiscard]] std::optional<Radical> radical(int number) const;

  [[nodiscard]] std::vector<Source> sources() const;

  /// Hands every stroke of every main form to `take`: a character's strokes one after another, in writing
  /// order. For those who need them all at once; find() is many times slower for that.
  void for_each_stroke(const std::function<void(const StrokePath&)>& take) const;

 private:
  struct Inside;
  explicit KanjiDatabase(std::unique_ptr<Inside> inside);
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::kanji
