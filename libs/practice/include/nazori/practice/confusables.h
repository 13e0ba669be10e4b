// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "nazori/kanji/character.h"
#include "nazori/kanji/kanji_database.h"

namespace nazori::practice {

/// Characters that learners confuse with `character`, the most easily confused first: those of our own table,
/// then those whose strokes differ in lengths and places alone (writing::lookalikes_of()).
/// @param database  characters without strokes, and rare ones that only look alike, are left out.
/// @param most  maximum number.
[[nodiscard]] std::vector<char32_t> confusables_of(const kanji::KanjiDatabase& database, char32_t character,
                                                   std::size_t most = 4);

/// The same by the table alone, also characters that a database may not have.
[[nodiscard]] std::vector<char32_t> confusables_in_table(char32_t character);

/// The strokes in which two characters differ: those that have no counterpart in the other of about the same
/// place, length and shape.
struct StrokeContrast {
  std::vector<bool> first;   ///< for each stroke of the first character
  std::vector<bool> second;  ///< for each stroke of the second
};
[[nodiscard]] StrokeContrast contrast_of(const kanji::Character& first, const kanji::Character& second);

/// One question of a drill: which of the characters it is.
struct ConfusableQuestion {
  char32_t answer = 0;
  std::string meaning;  ///< of the character
  std::string reading;  ///< as the dictionary writes it; empty if it has none
  std::string gap;  ///< a word with ◯ for the character; empty without a word that only fits one of them
  std::string gap_reading;

  friend bool operator==(const ConfusableQuestion&, const ConfusableQuestion&) = default;
};

/// What a drill knows of a character.
struct ConfusableFacts {
  char32_t character = 0;
  std::string meaning;
  std::string reading;
  std::vector<kanji::Word> words;  ///< the most helpful first
};
[[nodiscard]] ConfusableFacts confusable_facts(const kanji::KanjiDatabase& database, char32_t character);

/// Asks several times which of some confusable characters is meant. What was answered wrongly comes once more
/// at the end.
class ConfusableDrill {
 public:
  /// @param characters  two or more. @param seed  decides the order.
  ConfusableDrill(const std::vector<ConfusableFacts>& characters, unsigned seed);

  /// nullptr when there are no more questions.
  [[nodiscard]] const ConfusableQuestion* question() const;
  /// Answers the question, and goes on to the next. @return whether the answer is right.
  bool answer(char32_t character);
  [[nodiscard]] int asked() const { return asked_; }
  [[nodiscard]] int right() const { return right_; }
  [[nodiscard]] int total() const { return static_cast<int>(questions_.size()); }

 private:
  std::vector<ConfusableQuestion> questions_;
  std::size_t at_ = 0;
  std::size_t first_round_ = 0;  ///< number of questions before the wrong ones come again
  int asked_ = 0;
  int right_ = 0;
};

}  // namespace nazori::practice
