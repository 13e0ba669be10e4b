// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/among.h"
#include "nazori/writing/written_character.h"

namespace nazori::writing {

/// A character that may be the one written.
struct Candidate {
  char32_t character = 0;
  double likeness = 0;  ///< 1 for the model itself, towards 0 for anything else

  friend bool operator==(const Candidate&, const Candidate&) = default;
};

struct RecogniseOptions {
  int limit = 10;  ///< maximum number of candidates, >= 1
  bool unfinished =
      false;  ///< strokes may still follow: characters that begin with these strokes are candidates, too
  Among among = Among::all;  ///< only these characters
};

class KnownCharacters;

/// Finds the characters of a database by their strokes, whatever their number, order and direction.
/// Thread-safe once made.
class Recogniser {
 public:
  /// Loads every character of the database that has strokes.
  /// @return Errc::not_found where it has none.
  [[nodiscard]] static base::Result<Recogniser> make(const kanji::KanjiDatabase& database);
  /// Loads only these characters, the commonest first; those without strokes are ignored.
  [[nodiscard]] static base::Result<Recogniser> make(const std::vector<kanji::Character>& characters);

  Recogniser(Recogniser&&) noexcept;
  Recogniser& operator=(Recogniser&&) noexcept;
  ~Recogniser();

  /// The likeliest characters, best first. 3 ms for 12 strokes and all characters.
  /// @return the errors of check(ink); Errc::bad_argument for a limit below 1.
  [[nodiscard]] base::Result<std::vector<Candidate>> recognise(const WrittenCharacter& ink,
                                                               const RecogniseOptions& options = {}) const;

  /// Number of loaded characters.
  [[nodiscard]] int size() const;

 private:
  explicit Recogniser(std::unique_ptr<const KnownCharacters> known);
  std::unique_ptr<const KnownCharacters> known_;
};

}  // namespace nazori::writing
