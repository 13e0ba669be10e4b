// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/braille.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "nazori/functions/curve_kinds.h"
#include "restricted_statement.h"
#include "strength.h"

namespace nazori::functions {
namespace {

/// The signs of a code. Sections are those of the Nemeth Code of 1972.
struct Signs {
  std::string_view plus, minus, dot, equals, less, less_equal, greater, greater_equal;
  std::string_view open, close, open_brace, close_brace, bar;
  std::string_view open_floor, close_floor, open_ceiling, close_ceiling;
  std::string_view comma, colon, decimal, factorial;
  std::string_view pi, tau, theta, gamma;
};

constexpr Signs kNemeth{"⠬",   "⠤",   "⠡",   "⠨⠅",  "⠐⠅", "⠐⠅⠱", "⠨⠂", "⠨⠂⠱",  //
                        "⠷",   "⠾",   "⠨⠷",  "⠨⠾",  "⠳",                       // § 121, § 145
                        "⠈⠰⠷", "⠈⠰⠾", "⠈⠘⠷", "⠈⠘⠾",                            //
                        "⠠",   "⠸⠒",  "⠨",   "⠯",                              // § 37, § 40
                        "⠨⠏",  "⠨⠞",  "⠨⠹",  "⠨⠠⠛"};                           // § 24
constexpr Signs kUeb{"⠐⠖",  "⠐⠤",  "⠐⠲",  "⠐⠶",  "⠈⠣", "⠸⠈⠣", "⠈⠜", "⠸⠈⠜",     //
                     "⠐⠣",  "⠐⠜",  "⠸⠣",  "⠸⠜",  "⠸⠳",                         //
                     "⠈⠘⠣", "⠈⠘⠜", "⠈⠨⠣", "⠈⠨⠜",                               //
                     "⠂",   "⠒",   "⠲",   "⠖",                                 //
                     "⠨⠏",  "⠨⠞",  "⠨⠹",  "⠠⠨⠛"};

constexpr std::string_view kSpace = "⠀";

std::string letter(char c) {
  constexpr std::string_view kLetters = "⠁⠃⠉⠙⠑⠋⠛⠓⠊⠚⠅⠇⠍⠝⠕⠏⠟⠗⠎⠞⠥⠧⠺⠭⠽⠵";
  return std::string(kLetters.substr(static_cast<std::size_t>(c - 'a') * 3, 3));
}

std::string word(std::string_view name) {
  std::string cells;
  for (const char c : name) cells += letter(c);
  return cells;
}

std::string_view printed_name(Function f) {
  switch (f) {
    case Function::asin:
      return "arcsin";
    case Function::acos:
      return "arccos";
    case Function::atan:
    case Function::atan2:
      return "arctan";
    case Function::acot:
      return "arccot";
    case Function::asinh:
      return "arsinh";
    case Function::acosh:
      return "arcosh";
    case Function::atanh:
      return "artanh";
    case Function::log10:
      return "log";
    case Function::fraction:
      return "frac";
    case Function::sign:
      return "sgn";
    default:
      return name_of(f);
  }
}

/// Collects cells and keeps track of what the next sign needs in front of it.
class Cells {
 public:
  explicit Cells(BrailleCode code) : code_(code) {}

  [[nodiscard]] bool is_nemeth() const { return code_ == BrailleCode::nemeth; }
  [[nodiscard]] const Signs& signs() const { return is_nemeth() ? kNemeth : kUeb; }

  void put(std::string_view cells) {
    return_to_level();
    text_ += cells;
    after_space_ = after_digit_ = false;
  }

  void put_letters(const std::string& cells) {
    return_to_level();
    // A letter from a to j behind a digit would be read as a digit.
    constexpr std::string_view kDigitLetters = "⠁⠃⠉⠙⠑⠋⠛⠓⠊⠚";
    if (!is_nemeth() && after_digit_ && kDigitLetters.find(cells.substr(0, 3)) != std::string_view::npos)
      text_ += "⠰";
    text_ += cells;
    after_space_ = after_digit_ = false;
  }

  /// A sign of operation. Two in a row are kept apart (§ 134), and a minus keeps the numeric indicator (§ 9).
  void put_operation(std::string_view cells, bool follows_operation) {
    return_to_level();
    const bool keeps = after_space_ && cells == signs().minus;
    if (is_nemeth() && follows_operation) text_ += "⠐";
    text_ += cells;
    after_space_ = keeps;
    after_digit_ = false;
  }

  /// A space ends every level (§ 79).
  void space() {
    text_ += kSpace;
    level_ = wanted_level_;
    after_space_ = true;
    after_digit_ = false;
  }

  /// In an enclosed list numbers have no numeric indicator (§ 11).
  void comma(bool enclosed) {
    text_ += signs().comma;
    space();
    if (enclosed) after_space_ = false;
  }

  void number(double v, bool numeric_indicator = true) {
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

  void go_up() { ++wanted_level_; }
  void go_down() { --wanted_level_; }
  [[nodiscard]] bool is_up() const { return wanted_level_ > 0; }

  [[nodiscard]] std::string text() && { return std::move(text_); }

 private:
  /// The level indicator in front of a sign: superscript or baseline (§ 74, § 80).
  void return_to_level() {
    if (!is_nemeth() || level_ == wanted_level_) return;
    if (wanted_level_ == 0) text_ += "⠐";
    for (int i = 0; i < wanted_level_; ++i) text_ += "⠘";
    level_ = wanted_level_;
  }

  BrailleCode code_;
  std::string text_;
  int level_ = 0;
  int wanted_level_ = 0;
  bool after_space_ = true;
  bool after_digit_ = false;
};

bool is_whole_number(const Expression& e) {
  return e->kind == NodeKind::number && e->name.empty() && e->value >= 0 && e->value == std::round(e->value);
}
bool is_atom(const Expression& e) {
  return (e->kind == NodeKind::number && (e->value >= 0 || !e->name.empty())) ||
         e->kind == NodeKind::constant || e->kind == NodeKind::variable;
}

/// How deeply fractions lie in each other, without those in exponents (§ 66 to § 68).
int fraction_order(const Expression& e) {
  int inside = 0;
  for (std::size_t i = 0; i < e->arguments.size(); ++i) {
    if (e->kind == NodeKind::power && i == 1) continue;
    inside = std::max(inside, fraction_order(e->arguments[i]));
  }
  return e->kind == NodeKind::divide ? inside + 1 : inside;
}

class Writer {
 public:
  explicit Writer(BrailleCode code) : cells_(code) {}

  [[nodiscard]] std::string text() && { return std::move(cells_).text(); }
  Cells& cells() { return cells_; }

  /// @param followed  something follows in the same product: an argument needs its parentheses.
  void write(const Expression& e, bool followed = false, bool follows_operation = false) {
    const Node& n = *e;
    const auto& a = n.arguments;
    switch (n.kind) {
      case NodeKind::number:
        if (!n.name.empty())
          cells_.put_letters(word(n.name));
        else
          write_number(n.value, follows_operation);
        return;
      case NodeKind::constant:
        if (n.constant == Constant::e)
          cells_.put_letters(letter('e'));
        else
          cells_.put(n.constant == Constant::pi ? cells_.signs().pi : cells_.signs().tau);
        return;
      case NodeKind::variable:
        if (n.variable == Variable::theta)
          cells_.put(cells_.signs().theta);
        else
          cells_.put_letters(word(name_of(n.variable)));
        return;
      case NodeKind::negate:
        cells_.put_operation(cells_.signs().minus, follows_operation);
        return part(a[0], 3, followed, true);
      case NodeKind::add:
      case NodeKind::subtract:
        part(a[0], 1, false, follows_operation);
        cells_.put_operation(n.kind == NodeKind::add ? cells_.signs().plus : cells_.signs().minus, false);
        return part(a[1], 2, followed, true);
      case NodeKind::multiply:
        return product(n, followed, follows_operation);
      case NodeKind::divide:
        return fraction(a[0], a[1]);
      case NodeKind::power:
        return power(a[0], a[1], followed);
      case NodeKind::function:
        return function(n, followed);
    }
  }

  void comparison(Comparison c) {
    const Signs& s = cells_.signs();
    const std::array<std::string_view, 5> signs{s.equals, s.less, s.less_equal, s.greater, s.greater_equal};
    cells_.space();
    if (c == Comparison::both)
      cells_.put(word("and"));
    else
      cells_.put(signs[static_cast<std::size_t>(c)]);
    cells_.space();
  }

  void condition(const Node& n) {
    const auto& a = n.arguments;
    if (n.function == Function::both || n.function == Function::either) {
      condition(*a[0]);
      const Node* last = a[0].get();
      while (last->function == Function::both) last = last->arguments[1].get();
      // 0 < x < 2
      if (n.function == Function::both && to_text(last->arguments[1]) == to_text(a[1]->arguments[0])) {
        comparison(comparison_of(a[1]->function));
        return write(a[1]->arguments[1]);
      }
      cells_.space();
      cells_.put(word(n.function == Function::both ? "and" : "or"));
      cells_.space();
      return condition(*a[1]);
    }
    write(a[0]);
    comparison(comparison_of(n.function));
    write(a[1]);
  }

  void braced(const Expression& condition_of) {
    cells_.put(cells_.signs().open_brace);
    condition(*condition_of);
    cells_.put(cells_.signs().close_brace);
  }

 private:
  void write_number(double v, bool follows_operation) {
    if (v < 0) cells_.put_operation(cells_.signs().minus, follows_operation);
    cells_.number(std::abs(v));
  }

  void grouped(const Expression& e) {
    cells_.put(cells_.signs().open);
    write(e);
    cells_.put(cells_.signs().close);
  }

  /// With parentheses where it binds less than `least`; a fraction has its own ends.
  void part(const Expression& e, int least, bool followed, bool follows_operation) {
    if (e->kind != NodeKind::divide && strength(*e) < least) return grouped(e);
    write(e, followed, follows_operation);
  }

  void product(const Node& n, bool followed, bool follows_operation) {
    const auto& a = n.arguments;
    if (is_degrees(n)) {
      part(a[0], 5, true, follows_operation);
      // § 10: the degree sign is a superscript.
      if (cells_.is_nemeth()) {
        cells_.go_up();
        cells_.put("⠨⠡");
        cells_.go_down();
      } else {
        cells_.put("⠘⠚");
      }
      return;
    }
    const Node* first = a[1].get();
    while (first->kind == NodeKind::power || is_factorial(*first)) first = first->arguments[0].get();
    const bool digit_first = first->kind == NodeKind::number && first->name.empty();
    part(a[0], 2, true, follows_operation);
    if (digit_first) cells_.put(cells_.signs().dot);
    const bool fenced =
        a[1]->kind != NodeKind::divide && (strength(*a[1]) < 3 || a[1]->kind == NodeKind::negate);
    if (fenced)
      grouped(a[1]);
    else
      write(a[1], followed);
  }

  static bool is_factorial(const Node& n) {
    return n.kind == NodeKind::function && n.function == Function::factorial;
  }

  void fraction(const Expression& top, const Expression& bottom) {
    if (!cells_.is_nemeth()) {
      // A fraction of two numbers has no ends of its own.
      if (is_whole_number(top) && is_whole_number(bottom)) {
        cells_.number(top->value);
        cells_.put("⠌");
        return cells_.number(bottom->value, false);
      }
      cells_.put("⠷");
      write(top);
      cells_.put("⠨⠌");
      write(bottom);
      return cells_.put("⠾");
    }
    const int order = 1 + std::max(fraction_order(top), fraction_order(bottom));
    std::string prefix;
    for (int i = 1; i < order; ++i) prefix += "⠠";
    cells_.put(prefix + "⠹");
    write(top);
    cells_.put(prefix + "⠌");
    write(bottom);
    cells_.put(prefix + "⠼");
  }

  void exponent(const Expression& e) {
    if (cells_.is_nemeth()) {
      cells_.go_up();
      write(e);
      return cells_.go_down();
    }
    cells_.put("⠔");
    const bool single = is_atom(e) || e->kind == NodeKind::divide;
    if (!single) cells_.put("⠣");
    write(e);
    if (!single) cells_.put("⠜");
  }

  static bool has_name(Function f) {
    return (f >= Function::sin && f <= Function::log2 && f != Function::exp) || f == Function::erf;
  }

  void power(const Expression& base, const Expression& e, bool followed) {
    // sin^2 x
    if (base->kind == NodeKind::function && has_name(base->function) && is_whole_number(e) && e->value > 0) {
      cells_.put_letters(word(printed_name(base->function)));
      if (base->function == Function::log2) return_subscript();
      exponent(e);
      return argument(base->arguments[0], followed);
    }
    const bool is_root = base->kind == NodeKind::function && base->function == Function::sqrt;
    if (is_atom(base) || is_root)
      write(base);
    else
      grouped(base);
    exponent(e);
  }

  /// The 2 of log to base 2 (§ 77: a number below a function has no indicator).
  void return_subscript() {
    if (cells_.is_nemeth())
      cells_.number(2);
    else {
      cells_.put("⠢");
      cells_.number(2);
    }
  }

  /// § 119: a space behind the name of a function.
  void argument(const Expression& e, bool followed) {
    const bool plain = !followed && (is_atom(e) || (is_degrees(*e) && is_atom(e->arguments[0])) ||
                                     (e->kind == NodeKind::multiply && is_whole_number(e->arguments[0]) &&
                                      e->arguments[1]->kind == NodeKind::variable));
    if (cells_.is_nemeth() || plain) cells_.space();
    if (plain)
      write(e);
    else
      grouped(e);
  }

  void radical(const Expression& inside, const Expression& index) {
    if (!cells_.is_nemeth()) {
      cells_.put("⠩");
      if (index) {
        exponent(index);
      }
      write(inside);
      return cells_.put("⠬");
    }
    // § 104, § 105: the index, and the order of a root inside a root.
    std::string prefix;
    for (int i = 0; i < roots_; ++i) prefix += "⠨";
    if (index) {
      cells_.put(prefix + "⠣");
      write(index);
      cells_.put("⠜");
    } else {
      cells_.put(prefix + "⠜");
    }
    ++roots_;
    write(inside);
    --roots_;
    cells_.put(prefix + "⠻");
  }

  void cases(const Node& n) {
    condition(*n.arguments[0]);
    cells_.put(cells_.signs().colon);
    cells_.space();
    write(n.arguments[1]);
    if (n.function == Function::where) return;
    cells_.comma(false);
    const Node& rest = *n.arguments[2];
    if (rest.kind == NodeKind::function &&
        (rest.function == Function::choose || rest.function == Function::where))
      return cases(rest);
    write(n.arguments[2]);
  }

  void between(std::string_view open, const Expression& e, std::string_view close) {
    cells_.put(open);
    write(e);
    cells_.put(close);
  }

  void function(const Node& n, bool followed) {
    const auto& a = n.arguments;
    const Signs& s = cells_.signs();
    switch (n.function) {
      case Function::abs:
        return between(s.bar, a[0], s.bar);
      case Function::floor:
        return between(s.open_floor, a[0], s.close_floor);
      case Function::ceil:
        return between(s.open_ceiling, a[0], s.close_ceiling);
      case Function::sqrt:
        return radical(a[0], nullptr);
      case Function::cbrt:
        return radical(a[0], number(3));
      case Function::root:
        return radical(a[1], a[0]);
      case Function::factorial:
        if (is_atom(a[0]))
          write(a[0]);
        else
          grouped(a[0]);
        return cells_.put(s.factorial);
      case Function::gamma:
        cells_.put(s.gamma);
        return grouped(a[0]);
      case Function::log2:
        cells_.put_letters(word("log"));
        return_subscript();
        return argument(a[0], followed);
      case Function::log_base:
        cells_.put_letters(word("log"));
        if (cells_.is_nemeth()) {
          if (is_whole_number(a[0])) {
            cells_.number(a[0]->value);
          } else {
            cells_.put("⠰");
            grouped(a[0]);
          }
        } else {
          cells_.put("⠢");
          if (is_atom(a[0]))
            write(a[0]);
          else
            between("⠣", a[0], "⠜");
        }
        return argument(a[1], followed);
      case Function::where:
      case Function::choose:
        cells_.put(s.open_brace);
        cases(n);
        return cells_.put(s.close_brace);
      default:
        break;
    }
    if (is_condition(n.function)) return condition(n);
    cells_.put_letters(word(printed_name(n.function)));
    if (a.size() == 1) return argument(a[0], followed);
    if (cells_.is_nemeth()) cells_.space();
    cells_.put(s.open);
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (i > 0) cells_.comma(true);
      write(a[i]);
    }
    cells_.put(s.close);
  }

  Cells cells_;
  int roots_ = 0;
};

/// Technical material is in grade 1 mode from its passage indicator to the terminator.
std::string finished(Writer writer, BrailleCode code) {
  std::string text = std::move(writer).text();
  return code == BrailleCode::ueb ? "⠰⠰⠰" + text + "⠰⠄" : text;
}

}  // namespace

std::string in_braille(const Expression& expression, BrailleCode code) {
  Writer writer(code);
  writer.write(expression);
  return finished(std::move(writer), code);
}

std::string in_braille(const Statement& typed, BrailleCode code) {
  Writer writer(code);
  Cells& cells = writer.cells();
  const auto [s, conditions] = without_conditions(typed);
  if (s.is_point) {
    cells.put(cells.signs().open);
    writer.write(s.terms[0]);
    cells.comma(true);
    writer.write(s.terms[1]);
    cells.put(cells.signs().close);
    return finished(std::move(writer), code);
  }
  const CurveKind& kind = curve_kind(s.kind);
  for (std::size_t i = 0; i < s.terms.size(); ++i) {
    if (!s.name.empty()) {
      cells.put_letters(word(s.name));
      cells.put(cells.signs().open);
      cells.put_letters(letter('x'));
      cells.put(cells.signs().close);
      writer.comparison(Comparison::equal);
    } else if (kind.left[0]) {
      if (i > 0) cells.comma(false);
      writer.write(variable(*kind.left[i]));
      writer.comparison(Comparison::equal);
    } else if (i > 0) {
      writer.comparison(s.comparisons[i - 1]);
    }
    writer.write(s.terms[i]);
  }
  for (const Expression& c : conditions) {
    cells.space();
    writer.braced(c);
  }
  if (kind.says_range(s)) {
    cells.comma(false);
    writer.write(s.from);
    writer.comparison(s.from_is_open ? Comparison::less : Comparison::less_equal);
    writer.write(variable(kind.parameter));
    writer.comparison(s.to_is_open ? Comparison::less : Comparison::less_equal);
    writer.write(s.to);
  }
  return finished(std::move(writer), code);
}

std::string in_braille(const Plot& plot, BrailleCode code) {
  std::string text;
  for (const Statement& s : plot.statements) text += (text.empty() ? "" : "\n") + in_braille(s, code);
  for (const Parameter& p : plot.parameters) {
    Writer writer(code);
    writer.cells().put_letters(word(p.name));
    writer.comparison(Comparison::equal);
    writer.write(number(p.value));
    text += "\n" + finished(std::move(writer), code);
  }
  return text;
}

}  // namespace nazori::functions
