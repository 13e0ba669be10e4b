// SPDX-License-Identifier: Apache-2.0
#include "braille_cells.h"

#include <cstddef>

#include "nazori/functions/expression.h"

namespace nazori::functions {
namespace {

constexpr BrailleSigns kNemeth{"⠬",   "⠤",   "⠡",   "⠨⠅",  "⠐⠅", "⠐⠅⠱", "⠨⠂", "⠨⠂⠱",  //
                               "⠷",   "⠾",   "⠨⠷",  "⠨⠾",  "⠳",                       // § 121, § 145
                               "⠈⠰⠷", "⠈⠰⠾", "⠈⠘⠷", "⠈⠘⠾",                            //
                               "⠠",   "⠸⠒",  "⠨",   "⠯",                              // § 37, § 40
                               "⠨⠏",  "⠨⠞",  "⠨⠹",  "⠨⠠⠛",                            // § 24
                               "⠈⠷",  "⠈⠾",  "⠄⠄⠄", "⠈⠱"};                            // § 121
constexpr BrailleSigns kUeb{"⠐⠖",  "⠐⠤",  "⠐⠲",  "⠐⠶",  "⠈⠣", "⠸⠈⠣", "⠈⠜", "⠸⠈⠜",     //
                            "⠐⠣",  "⠐⠜",  "⠸⠣",  "⠸⠜",  "⠸⠳",                         //
                            "⠈⠘⠣", "⠈⠘⠜", "⠈⠨⠣", "⠈⠨⠜",                               //
                            "⠂",   "⠒",   "⠲",   "⠖",                                 //
                            "⠨⠏",  "⠨⠞",  "⠨⠹",  "⠠⠨⠛",                               //
                            "⠨⠣",  "⠨⠜",  "⠲⠲⠲", "⠈⠔"};

constexpr std::string_view kSpace = "⠀";

}  // namespace

std::string braille_letter(char c) {
  constexpr std::string_view kLetters = "⠁⠃⠉⠙⠑⠋⠛⠓⠊⠚⠅⠇⠍⠝⠕⠏⠟⠗⠎⠞⠥⠧⠺⠭⠽⠵";
  return std::string(kLetters.substr(static_cast<std::size_t>(c - 'a') * 3, 3));
}

std::string braille_word(std::string_view name) {
  std::string cells;
  for (const char c : name) cells += braille_letter(c);
  return cells;
}

const BrailleSigns& BrailleCells::signs() const { return is_nemeth() ? kNemeth : kUeb; }

void BrailleCells::put(std::string_view cells) {
  return_to_level();
  text_ += cells;
  after_space_ = after_digit_ = false;
}

void BrailleCells::put_letters(const std::string& cells) {
  return_to_level();
  // A letter from a to j behind a digit would be read as a digit.
  constexpr std::string_view kDigitLetters = "⠁⠃⠉⠙⠑⠋⠛⠓⠊⠚";
  if (!is_nemeth() && after_digit_ && kDigitLetters.find(cells.substr(0, 3)) != std::string_view::npos)
    text_ += "⠰";
  text_ += cells;
  after_space_ = after_digit_ = false;
}

void BrailleCells::put_operation(std::string_view cells, bool follows_operation) {
  return_to_level();
  const bool keeps = after_space_ && cells == signs().minus;
  if (is_nemeth() && follows_operation) text_ += "⠐";
  text_ += cells;
  after_space_ = keeps;
  after_digit_ = false;
}

void BrailleCells::space() {
  text_ += kSpace;
  level_ = wanted_level_;
  after_space_ = true;
  after_digit_ = false;
}

void BrailleCells::comma(bool enclosed) {
  text_ += signs().comma;
  space();
  if (enclosed) after_space_ = false;
}

void BrailleCells::number(double v, bool numeric_indicator) {
  return_to_level();
  const std::string digits = to_text(functions::number(v));
  constexpr std::string_view kNemethDigits = "⠴⠂⠆⠒⠲⠢⠖⠶⠦⠔";
  constexpr std::string_view kUebDigits = "⠚⠁⠃⠉⠙⠑⠋⠛⠓⠊";
  if (!is_nemeth() ? numeric_indicator : after_space_) text_ += "⠼";
  for (const char c : digits) {
    if (c == '.') {
      text_ += signs().decimal;
    } else {
      const auto i = static_cast<std::size_t>(c - '0') * 3;
      text_ += (is_nemeth() ? kNemethDigits : kUebDigits).substr(i, 3);
    }
  }
  after_space_ = false;
  after_digit_ = true;
}

void BrailleCells::return_to_level() {
  if (!is_nemeth() || level_ == wanted_level_) return;
  text_ += wanted_level_.empty() ? "⠐" : wanted_level_;
  level_ = wanted_level_;
}

}  // namespace nazori::functions
