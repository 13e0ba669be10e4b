// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "nazori/functions/braille.h"

namespace nazori::functions {

/// The signs of a code. Sections are those of the Nemeth Code of 1972.
struct BrailleSigns {
  std::string_view plus, minus, dot, equals, less, less_equal, greater, greater_equal;
  std::string_view open, close, open_brace, close_brace, bar;
  std::string_view open_floor, close_floor, open_ceiling, close_ceiling;
  std::string_view comma, colon, decimal, factorial;
  std::string_view pi, tau, theta, gamma;
  std::string_view open_list, close_list, ellipsis, tilde;
};

/// A lower case letter from a to z.
[[nodiscard]] std::string braille_letter(char c);
/// Lower case letters from a to z in a row.
[[nodiscard]] std::string braille_word(std::string_view name);

/// Collects cells and keeps track of what the next sign needs in front of it.
class BrailleCells {
 public:
  explicit BrailleCells(BrailleCode code) : code_(code) {}

  [[nodiscard]] bool is_nemeth() const { return code_ == BrailleCode::nemeth; }
  [[nodiscard]] const BrailleSigns& signs() const;

  void put(std::string_view cells);
  void put_letters(const std::string& cells);

  /// A sign of operation. Two in a row are kept apart (§ 134), and a minus keeps the numeric indicator (§ 9).
  void put_operation(std::string_view cells, bool follows_operation);

  /// A space ends every level (§ 79).
  void space();

  /// In an enclosed list numbers have no numeric indicator (§ 11).
  void comma(bool enclosed);
  void number(double v, bool numeric_indicator = true);

  void go_up() { wanted_level_ += kUp; }
  void go_below() { wanted_level_ += kBelow; }
  /// Leaves the level of the last go_up() or go_below().
  void go_back() { wanted_level_.resize(wanted_level_.size() - kUp.size()); }
  [[nodiscard]] bool is_up() const { return !wanted_level_.empty(); }

  [[nodiscard]] std::string text() && { return std::move(text_); }

 private:
  static constexpr std::string_view kUp = "⠘";
  static constexpr std::string_view kBelow = "⠰";

  /// The level indicator in front of a sign: superscript, subscript or baseline (§ 74, § 80).
  void return_to_level();

  BrailleCode code_;
  std::string text_;
  std::string level_;  ///< its indicators; empty on the baseline
  std::string wanted_level_;
  bool after_space_ = true;
  bool after_digit_ = false;
};

}  // namespace nazori::functions
