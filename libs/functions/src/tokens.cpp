// SPDX-License-Identifier: Apache-2.0
#include "tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "nazori/base/utf8.h"
#include "typed_names.h"

namespace nazori::functions {
namespace {

constexpr std::size_t kMostBytes = 10'000;

constexpr std::u32string_view kSuperscriptDigits = U"⁰¹²³⁴⁵⁶⁷⁸⁹";

bool is_digit(char32_t c) { return c >= U'0' && c <= U'9'; }
bool is_letter(char32_t c) { return c >= U'a' && c <= U'z'; }
bool is_space(char32_t c) {
  return c == U' ' || c == U'\t' || c == U'\n' || c == U'\r' || c == 0xA0 || c == 0x3000 ||
         (c >= 0x2000 && c <= 0x200B) || c == 0x202F || c == 0x2060 || c == 0xFEFF;
}

/// One spelling for each sign; capitals become small.
char32_t plain(char32_t c) {
  if (c >= 0xFF01 && c <= 0xFF5E) c = c - 0xFF01 + U'!';
  if (c >= U'A' && c <= U'Z') return c - U'A' + U'a';
  switch (c) {
    case U'×':
    case U'·':
    case U'⋅':
    case U'∙':
    case U'∗':
    case U'•':
    case U'・':
      return U'*';
    case U'÷':
    case U'∕':
    case U'⁄':
      return U'/';
    case U'−':
    case U'–':
    case U'—':
    case U'‐':
    case U'‑':
      return U'-';
    case U'∣':
    case U'│':
      return U'|';
    case U'≦':
    case U'⩽':
      return U'≤';
    case U'≧':
    case U'⩾':
      return U'≥';
    case U'ϑ':
    case U'Θ':
      return U'θ';
    case U'、':
      return U',';
    case U'∼':
    case U'〜':
      return U'~';
    default:
      return c;
  }
}

class Tokenizer {
 public:
  Tokenizer(std::u32string text, const ParseOptions& options) : text_(std::move(text)), options_(options) {
    shown_ = text_;
    std::transform(text_.begin(), text_.end(), text_.begin(), plain);
    defined_ = defined_letters(text_);
  }

  tl::expected<std::vector<Token>, SyntaxError> run() {
    while (true) {
      const std::size_t before = at_;
      while (at_ < text_.size() && is_space(text_[at_])) {
        line_before_ = line_before_ || text_[at_] == U'\n';
        ++at_;
      }
      space_before_ = at_ > before;
      if (at_ >= text_.size()) break;
      if (auto error = next()) return tl::unexpected(std::move(*error));
    }
    push(TokenKind::end, 0);
    return std::move(tokens_);
  }

 private:
  [[nodiscard]] char32_t peek(std::size_t ahead) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : U'\0';
  }

  Token& push(TokenKind kind, std::size_t length) {
    Token token;
    token.kind = kind;
    token.column = static_cast<int>(at_) + 1;
    token.text = base::encode_utf8(std::u32string_view(shown_).substr(at_, length));
    token.space_before = space_before_;
    space_before_ = false;
    token.line_before = std::exchange(line_before_, false);
    at_ += length;
    tokens_.push_back(std::move(token));
    return tokens_.back();
  }

  std::optional<SyntaxError> next() {
    const char32_t c = text_[at_];
    if (is_digit(c) || ((c == U'.' || c == U',') && is_digit(peek(1)) && !comma_separates())) return number();
    if (is_letter(c)) return letters();
    if (kSuperscriptDigits.find(c) != std::u32string_view::npos || c == U'⁻' || c == U'⁺')
      return superscript();
    switch (c) {
      case U'+':
        push(TokenKind::plus, 1);
        return {};
      case U'-':
        push(TokenKind::minus, 1);
        return {};
      case U'*':
        push(peek(1) == U'*' ? TokenKind::power : TokenKind::times, peek(1) == U'*' ? 2 : 1);
        return {};
      case U'/':
        push(TokenKind::divide, 1);
        return {};
      case U'^':
        push(TokenKind::power, 1);
        return {};
      case U'!':
        if (peek(1) == U'=') return question(SyntaxFault::not_equal, 2);
        push(TokenKind::factorial, 1);
        return {};
      case U'≠':
        return question(SyntaxFault::not_equal, 1);
      case U'°':
      case U'º':
        push(TokenKind::degree, 1);
        return {};
      case U'\'':
      case U'’':
      case U'′':
        push(TokenKind::prime, 1).value = 1;
        return {};
      case U'″':
        push(TokenKind::prime, 1).value = 2;
        return {};
      case U':':
        push(TokenKind::colon, 1);
        return {};
      case U'~':
        push(TokenKind::tilde, 1);
        return {};
      case U'…':
        push(TokenKind::dots, 1);
        return {};
      case U'.':
        if (peek(1) != U'.') break;
        push(TokenKind::dots, peek(2) == U'.' ? 3 : 2);
        return {};
      case U'∧':
        push(TokenKind::both, 1);
        return {};
      case U'∨':
        push(TokenKind::either, 1);
        return {};
      case U'_':
        push(TokenKind::underscore, 1);
        return {};
      case U'|':
        push(TokenKind::bar, 1);
        return {};
      case U',':
        push(TokenKind::comma, 1);
        return {};
      case U';':
        push(TokenKind::semicolon, 1);
        return {};
      case U'∫':
        push(TokenKind::integral, 1);
        ++open_integrals_;
        return {};
      case U'√':
        push(TokenKind::root, 1).degree = 2;
        return {};
      case U'∛':
        push(TokenKind::root, 1).degree = 3;
        return {};
      case U'∜':
        push(TokenKind::root, 1).degree = 4;
        return {};
      case U'(':
      case U'[':
      case U'{':
        bracket(TokenKind::open, c);
        return {};
      case U')':
      case U']':
      case U'}':
        bracket(TokenKind::close, c);
        return {};
      case U'π':
        push(TokenKind::constant, 1).constant = Constant::pi;
        return {};
      case U'τ':
        push(TokenKind::constant, 1).constant = Constant::tau;
        return {};
      case U'ℯ':
        push(TokenKind::constant, 1).constant = Constant::e;
        return {};
      case U'θ':
        push(TokenKind::variable, 1).variable = Variable::theta;
        return {};
      case U'Γ':
        push(TokenKind::function, 1).function = Function::gamma;
        return {};
      default:
        break;
    }
    if (comparison()) return {};
    return SyntaxError{static_cast<int>(at_) + 1, SyntaxFault::unknown_character,
                       base::encode_utf8(shown_[at_])};
  }

  void bracket(TokenKind kind, char32_t c) {
    // The function before the innermost parenthesis decides whether a comma separates arguments.
    if (kind == TokenKind::open) {
      const bool arguments =
          !tokens_.empty() &&
          (tokens_.back().kind == TokenKind::area ||
           (tokens_.back().kind == TokenKind::function && takes_several(tokens_.back().function)));
      // In a list a comma separates, also in the parentheses right inside it: [1,2], [(1,2), (3,4)].
      const bool is_listed = c == U'[' || (c == U'(' && !tokens_.empty() && tokens_.back().bracket == U'[');
      argument_lists_.push_back(arguments || is_listed || (c == U'{' && are_cases()));
    } else if (!argument_lists_.empty()) {
      argument_lists_.pop_back();
    }
    push(kind, 1).bracket = c;
  }

  [[nodiscard]] std::optional<SyntaxError> question(SyntaxFault fault, std::size_t length) const {
    return SyntaxError{static_cast<int>(at_) + 1, fault,
                       base::encode_utf8(std::u32string_view(shown_).substr(at_, length))};
  }

  /// Whether what stands in this brace is cases, "{x < 0: 1,5}": a comma then separates.
  [[nodiscard]] bool are_cases() const {
    int depth = 0;
    for (std::size_t i = at_; i < text_.size(); ++i) {
      const char32_t c = text_[i];
      if (c == U'{' || c == U'(' || c == U'[') ++depth;
      if ((c == U'}' || c == U')' || c == U']') && --depth == 0) return false;
      if (c == U':' && depth == 1) return true;
    }
    return false;
  }

  static bool takes_several(Function f) {
    return f == Function::min || f == Function::max || f == Function::mod || f == Function::atan2 ||
           f == Function::root || f == Function::hypot || f == Function::integral;
  }

  [[nodiscard]] bool comma_separates() const {
    return text_[at_] == U',' && !argument_lists_.empty() && argument_lists_.back() &&
           !options_.decimal_comma;
  }

  std::optional<SyntaxError> number() {
    std::string digits;
    std::size_t length = 0;
    bool fraction = false;
    int decimals = 0;
    while (true) {
      const char32_t c = peek(length);
      if (is_digit(c)) {
        digits += static_cast<char>(c);
        decimals += fraction ? 1 : 0;
        // The points of 1...5 are no decimal point.
      } else if ((c == U'.' && peek(length + 1) != U'.') ||
                 (c == U',' && is_digit(peek(length + 1)) && !separates(length))) {
        if (fraction) {
          return SyntaxError{static_cast<int>(at_ + length) + 1, SyntaxFault::two_decimal_signs};
        }
        fraction = true;
        digits += '.';
      } else {
        break;
      }
      ++length;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || !std::isfinite(value)) {
      return SyntaxError{static_cast<int>(at_) + 1, SyntaxFault::number_too_large, digits.substr(0, 40)};
    }
    Token& token = push(TokenKind::number, length);
    token.value = value;
    const double scale = decimals <= 22 ? std::pow(10.0, decimals) : 0;
    const double whole = value * scale;
    token.exact = scale > 0 && std::abs(whole) < 9e15 && std::floor(whole) == whole &&
                  std::fma(value, scale, -whole) == 0 && digits.size() <= 17;
    return {};
  }

  [[nodiscard]] bool separates(std::size_t ahead) const {
    return peek(ahead) == U',' && !argument_lists_.empty() && argument_lists_.back() &&
           !options_.decimal_comma;
  }

  std::optional<SyntaxError> superscript() {
    std::size_t length = 0;
    bool negative = false;
    if (text_[at_] == U'⁻' || text_[at_] == U'⁺') {
      negative = text_[at_] == U'⁻';
      ++length;
    }
    double value = 0;
    std::size_t digits = 0;
    for (; length < 12; ++length, ++digits) {
      const std::size_t digit = kSuperscriptDigits.find(peek(length));
      if (digit == std::u32string_view::npos) break;
      value = value * 10 + static_cast<double>(digit);
    }
    if (digits == 0) {
      return SyntaxError{static_cast<int>(at_ + length) + 1, SyntaxFault::raised_digit_missing};
    }
    push(TokenKind::superscript, length).value = negative ? -value : value;
    return {};
  }

  bool comparison() {
    const char32_t c = text_[at_];
    const char32_t after = peek(1);
    Comparison which = Comparison::equal;
    std::size_t length = 1;
    switch (c) {
      case U'=':
        if (after == U'<') which = Comparison::less_equal, length = 2;
        if (after == U'>') which = Comparison::greater_equal, length = 2;
        if (after == U'=') length = 2;
        break;
      case U'<':
        which = after == U'=' ? Comparison::less_equal : Comparison::less;
        length = after == U'=' ? 2 : 1;
        break;
      case U'>':
        which = after == U'=' ? Comparison::greater_equal : Comparison::greater;
        length = after == U'=' ? 2 : 1;
        break;
      case U'≤':
        which = Comparison::less_equal;
        break;
      case U'≥':
        which = Comparison::greater_equal;
        break;
      default:
        return false;
    }
    push(TokenKind::comparison, length).comparison = which;
    return true;
  }

  std::optional<SyntaxError> letters() {
    std::size_t length = 0;
    while (is_letter(peek(length))) ++length;
    for (const FunctionName& name : kNumberedFunctions) {
      const std::size_t n = name.text.size();
      if (n > length && std::u32string_view(text_).substr(at_, n) == name.text && peek(n) == U'(') {
        push(TokenKind::function, n).function = name.function;
        return {};
      }
    }
    const std::u32string_view run = std::u32string_view(text_).substr(at_, length);
    if (run == U"int" && peek(length) == U'_') {
      push(TokenKind::integral, length);
      ++open_integrals_;
      return {};
    }
    if (open_integrals_ > 0 && run == U"d" && peek(length) == U'θ') {
      differential(2, Variable::theta);
      return {};
    }
    if (run == U"area" && peek(length) == U'(') {
      push(TokenKind::area, length);
      return {};
    }
    if (run == U"and" || run == U"or") {
      push(run == U"and" ? TokenKind::both : TokenKind::either, length);
      return {};
    }
    std::vector<std::size_t> cuts;
    std::vector<bool> dead(length + 1, false);
    if (!cut(run, 0, cuts, dead)) {
      const std::string word = base::encode_utf8(std::u32string_view(shown_).substr(at_, length));
      const bool calls = peek(length) == U'(';
      return SyntaxError{static_cast<int>(at_) + 1,
                         calls ? SyntaxFault::unknown_function : SyntaxFault::unknown_name, word};
    }
    for (const std::size_t n : cuts) name(n);
    return {};
  }

  [[nodiscard]] std::size_t longest_first(std::u32string_view rest, std::size_t shorter_than) const {
    std::size_t best = 0;
    const auto consider = [&](std::u32string_view word) {
      if (word.size() < shorter_than && word.size() > best && rest.substr(0, word.size()) == word)
        best = word.size();
    };
    for (const auto& n : kFunctions) consider(n.text);
    for (const auto& n : kVariables) consider(n.text);
    for (const auto& n : kConstants) consider(n.text);
    if (defined_.contains(rest[0]) || (is_in_model() && can_be_defined(rest[0]))) consider(rest.substr(0, 1));
    if (differential_of(rest) != nullptr) {
      const std::size_t length = 1 + differential_of(rest)->text.size();
      if (length < shorter_than && length > best) best = length;
    }
    return best;
  }

  [[nodiscard]] bool is_in_model() const {
    return std::any_of(defined_.models.begin(), defined_.models.end(),
                       [this](const auto& m) { return at_ >= m.first && at_ < m.second; });
  }

  /// The variable of "dt" at the start of a text, if it can end an integral.
  [[nodiscard]] const VariableName* differential_of(std::u32string_view rest) const {
    if (open_integrals_ == 0 || rest.empty() || rest[0] != U'd') return nullptr;
    for (const VariableName& n : kVariables) {
      if (rest.substr(1, n.text.size()) == n.text) return &n;
    }
    return nullptr;
  }

  void differential(std::size_t length, Variable v) {
    push(TokenKind::differential, length).variable = v;
    if (open_integrals_ > 0) --open_integrals_;
  }

  bool cut(std::u32string_view run, std::size_t from, std::vector<std::size_t>& cuts,
           std::vector<bool>& dead) const {
    if (from == run.size()) return true;
    if (dead[from]) return false;
    const std::u32string_view rest = run.substr(from);
    for (std::size_t n = longest_first(rest, rest.size() + 1); n > 0; n = longest_first(rest, n)) {
      cuts.push_back(n);
      if (cut(run, from + n, cuts, dead)) return true;
      cuts.pop_back();
    }
    dead[from] = true;
    return false;
  }

  void name(std::size_t length) {
    const std::u32string_view word = std::u32string_view(text_).substr(at_, length);
    if (const VariableName* const v = differential_of(word);
        v != nullptr && word.size() == 1 + v->text.size())
      return differential(length, v->variable);
    for (const auto& n : kFunctions) {
      if (n.text == word) {
        push(TokenKind::function, length).function = n.function;
        return;
      }
    }
    for (const auto& n : kVariables) {
      if (n.text == word) {
        push(TokenKind::variable, length).variable = n.variable;
        return;
      }
    }
    for (const auto& n : kConstants) {
      if (n.text == word) {
        push(TokenKind::constant, length).constant = n.constant;
        return;
      }
    }
    // In small letters: A and a are one parameter.
    const std::string letter = base::encode_utf8(word);
    push(TokenKind::name, length).text = letter;
  }

  std::u32string text_;
  std::u32string shown_;
  ParseOptions options_;
  std::size_t at_ = 0;
  bool space_before_ = false;
  bool line_before_ = false;
  DefinedLetters defined_;
  int open_integrals_ = 0;
  std::vector<bool> argument_lists_;
  std::vector<Token> tokens_;
};

}  // namespace

tl::expected<std::vector<Token>, SyntaxError> tokenize(std::string_view text, const ParseOptions& options) {
  if (text.size() > kMostBytes) {
    return tl::unexpected(SyntaxError{1, SyntaxFault::too_long});
  }
  auto points = base::decode_utf8(text);
  if (!points) return tl::unexpected(SyntaxError{1, SyntaxFault::not_utf8});
  return Tokenizer(std::move(*points), options).run();
}

}  // namespace nazori::functions
