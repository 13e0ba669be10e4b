// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace nazori::practice {

/// How a learner answered a question of the check.
enum class PlacementAnswer : std::uint8_t {
  written,  ///< written from memory and accepted
  refused,  ///< written and not accepted
  unknown,  ///< the learner said so
};

/// How often an answer says the opposite of what the learner can write.
struct PlacementRates {
  double slip = 0.08;    ///< a character that can be written is refused
  double modest = 0.02;  ///< a character that can be written is called unknown
  double luck = 0.03;    ///< a character that cannot be written is accepted
  double spread = 0.12;  ///< how gradually knowledge ends, in units of the scale (see PlacementCheck)
};

/// Finds out in about a dozen questions how many characters of a list a learner can write. The list is
/// ordered by difficulty. The model is logistic: a learner who can write `a` characters writes character
/// number `i` (from 0) with the probability luck + (1 - luck - slip - modest) / (1 + exp((u(i + 1/2) - u(a))
/// / spread)). Positions are compared on the scale u(x) = log(1 + 16 x / n), n characters: near the beginning
/// of a long list few characters tell more than near its end. Every ability from 0 to n is weighed with all
/// answers so far (Bayes), all being equally probable on the scale before. The next question is the character
/// nearest to the median that was not asked yet. Deterministic: the same answers lead to the same questions.
class PlacementCheck {
 public:
  static constexpr int kFewest = 12;                             ///< questions, if the list has as many
  static constexpr int kMost = 14;                               ///< questions
  static constexpr std::chrono::milliseconds kLongest{120'000};  ///< after that the 8th is the last

  /// @param by_difficulty  easiest first, each character once.
  explicit PlacementCheck(std::vector<char32_t> by_difficulty, const PlacementRates& rates = {});

  /// The character to write now; nullopt: the check is over.
  [[nodiscard]] std::optional<char32_t> question() const;
  /// The answer to question(). @param elapsed  since the first question was asked.
  void answer(PlacementAnswer answer, std::chrono::milliseconds elapsed);
  [[nodiscard]] bool is_over() const { return !question().has_value(); }
  [[nodiscard]] int answered() const { return answered_; }
  /// How many characters of the list the learner can write: the median of what is probable, 0..n.
  [[nodiscard]] int ability() const { return quantile(0.5); }
  /// As ability(), as people say it: from 100 on in tens, from 20 on in fives; never more than the list has;
  /// 0 where it is not certain enough (95 %) that any can be written.
  [[nodiscard]] int rounded_ability() const;
  /// The number of characters below which the ability lies with the probability `share`, 0..1.
  [[nodiscard]] int quantile(double share) const;
  [[nodiscard]] const std::vector<char32_t>& characters() const { return characters_; }

 private:
  [[nodiscard]] double scale(double position) const;
  [[nodiscard]] double chance(int ability, int position, PlacementAnswer answer) const;
  void choose_next();

  std::vector<char32_t> characters_;
  PlacementRates rates_;
  std::vector<double> weights_;  ///< probability of each ability, 0..n
  std::vector<bool> asked_;
  std::optional<int> next_;
  int answered_ = 0;
};

}  // namespace nazori::practice
