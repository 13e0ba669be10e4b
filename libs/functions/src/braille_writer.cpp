// SPDX-License-Identifier: Apache-2.0
#include "braille_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "restricted_statement.h"
#include "strength.h"

namespace nazori::functions {
namespace {

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

bool is_whole_number(const Expression& e) {
  return e->kind == NodeKind::number && e->name.empty() && e->value >= 0 && e->value == std::round(e->value);
}
bool is_atom(const Expression& e) {
  return (e->kind == NodeKind::number && (e->value >= 0 || !e->name.empty())) ||
         e->kind == NodeKind::constant || e->kind == NodeKind::variable || is_list(*e);
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

}  // namespace

void BrailleWriter::write(const Expression& e, bool followed, bool follows_operation) {
  const Node& n = *e;
  const auto& a = n.arguments;
  switch (n.kind) {
    case NodeKind::number:
      if (!n.name.empty())
        cells_.put_letters(braille_word(n.name));
      else
        write_number(n.value, follows_operation);
      return;
    case NodeKind::constant:
      if (n.constant == Constant::e)
        cells_.put_letters(braille_letter('e'));
      else
        cells_.put(n.constant == Constant::pi ? cells_.signs().pi : cells_.signs().tau);
      return;
    case NodeKind::variable:
      if (n.variable == Variable::theta)
        cells_.put(cells_.signs().theta);
      else
        cells_.put_letters(braille_word(name_of(n.variable)));
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

void BrailleWriter::comparison(Comparison c) {
  const BrailleSigns& s = cells_.signs();
  const std::array<std::string_view, 5> signs{s.equals, s.less, s.less_equal, s.greater, s.greater_equal};
  if (c == Comparison::both) return sign(braille_word("and"));
  sign(signs[static_cast<std::size_t>(c)]);
}

void BrailleWriter::sign(std::string_view cells) {
  cells_.space();
  cells_.put(cells);
  cells_.space();
}

void BrailleWriter::condition(const Node& n) {
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
    cells_.put(braille_word(n.function == Function::both ? "and" : "or"));
    cells_.space();
    return condition(*a[1]);
  }
  write(a[0]);
  comparison(comparison_of(n.function));
  write(a[1]);
}

void BrailleWriter::braced(const Expression& condition_of) {
  cells_.put(cells_.signs().open_brace);
  condition(*condition_of);
  cells_.put(cells_.signs().close_brace);
}

void BrailleWriter::write_number(double v, bool follows_operation) {
  if (v < 0) cells_.put_operation(cells_.signs().minus, follows_operation);
  cells_.number(std::abs(v));
}

void BrailleWriter::grouped(const Expression& e) {
  cells_.put(cells_.signs().open);
  write(e);
  cells_.put(cells_.signs().close);
}

void BrailleWriter::part(const Expression& e, int least, bool followed, bool follows_operation) {
  if (e->kind != NodeKind::divide && strength(*e) < least) return grouped(e);
  write(e, followed, follows_operation);
}

void BrailleWriter::product(const Node& n, bool followed, bool follows_operation) {
  const auto& a = n.arguments;
  if (is_degrees(n)) {
    part(a[0], 5, true, follows_operation);
    // § 10: the degree sign is a superscript.
    if (cells_.is_nemeth()) {
      cells_.go_up();
      cells_.put("⠨⠡");
      cells_.go_back();
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

bool BrailleWriter::is_factorial(const Node& n) {
  return n.kind == NodeKind::function && n.function == Function::factorial;
}

void BrailleWriter::fraction(const Expression& top, const Expression& bottom) {
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

void BrailleWriter::exponent(const Expression& e) {
  if (cells_.is_nemeth()) {
    cells_.go_up();
    write(e);
    return cells_.go_back();
  }
  cells_.put("⠔");
  item(e);
}

/// In UEB an indicator holds for one item: a letter, a number, a fraction or what is grouped.
void BrailleWriter::item(const Expression& e) {
  const bool single = is_atom(e) || e->kind == NodeKind::divide;
  if (!single) cells_.put("⠣");
  write(e);
  if (!single) cells_.put("⠜");
}

bool BrailleWriter::has_name(Function f) {
  return (f >= Function::sin && f <= Function::log2 && f != Function::exp) || f == Function::erf;
}

void BrailleWriter::power(const Expression& base, const Expression& e, bool followed) {
  // sin^2 x
  if (base->kind == NodeKind::function && has_name(base->function) && is_whole_number(e) && e->value > 0) {
    cells_.put_letters(braille_word(printed_name(base->function)));
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

void BrailleWriter::return_subscript() {
  if (cells_.is_nemeth())
    cells_.number(2);
  else {
    cells_.put("⠢");
    cells_.number(2);
  }
}

void BrailleWriter::argument(const Expression& e, bool followed) {
  const bool plain = !followed && (is_atom(e) || (is_degrees(*e) && is_atom(e->arguments[0])) ||
                                   (e->kind == NodeKind::multiply && is_whole_number(e->arguments[0]) &&
                                    e->arguments[1]->kind == NodeKind::variable));
  if (cells_.is_nemeth() || plain) cells_.space();
  if (plain)
    write(e);
  else
    grouped(e);
}

void BrailleWriter::radical(const Expression& inside, const Expression& index) {
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

void BrailleWriter::cases(const Node& n) {
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

void BrailleWriter::list(const Node& n) {
  if (!n.name.empty()) return cells_.put_letters(braille_word(n.name));
  cells_.put(cells_.signs().open_list);
  for (std::size_t i = 0; i < n.arguments.size(); ++i) {
    if (i > 0) cells_.comma(true);
    if (n.function == Function::range && i + 1 == n.arguments.size()) {
      cells_.put(cells_.signs().ellipsis);
      cells_.comma(true);
    }
    write(n.arguments[i]);
  }
  cells_.put(cells_.signs().close_list);
}

void BrailleWriter::between(std::string_view open, const Expression& e, std::string_view close) {
  cells_.put(open);
  write(e);
  cells_.put(close);
}

void BrailleWriter::function(const Node& n, bool followed) {
  const auto& a = n.arguments;
  const BrailleSigns& s = cells_.signs();
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
      cells_.put_letters(braille_word("log"));
      return_subscript();
      return argument(a[0], followed);
    case Function::log_base:
      cells_.put_letters(braille_word("log"));
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
    case Function::list:
    case Function::range:
      return list(n);
    case Function::integral:
      return integral(n, followed);
    case Function::where:
    case Function::choose:
      cells_.put(s.open_brace);
      cases(n);
      return cells_.put(s.close_brace);
    default:
      break;
  }
  if (is_condition(n.function)) return condition(n);
  cells_.put_letters(braille_word(printed_name(n.function)));
  if (a.size() == 1) return argument(a[0], followed);
  if (cells_.is_nemeth()) cells_.space();
  cells_.put(s.open);
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (i > 0) cells_.comma(true);
    write(a[i]);
  }
  cells_.put(s.close);
}

}  // namespace nazori::functions
