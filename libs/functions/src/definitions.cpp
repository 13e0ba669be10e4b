// SPDX-License-Identifier: Apache-2.0
// Letters with a meaning of their own: parameters "a = 2; 0 <= a <= 3" and functions "f(x) = a x^2".
#include <algorithm>
#include <cmath>
#include <utility>

#include "algebra.h"
#include "derivative.h"
#include "lists.h"
#include "parser.h"
#include "regression_model.h"

namespace nazori::functions {
namespace {

// A function of a function of a function grows quickly.
constexpr std::size_t kMostParts = 20'000;
constexpr int kMostPrimes = 4;
constexpr double kDefaultReach = 10;

bool ends_part(const Token& t) {
  return t.kind == TokenKind::semicolon || t.kind == TokenKind::end || t.kind == TokenKind::either;
}

/// Parts of the tree, counted up to one more than `most`.
std::size_t count_up_to(const Expression& e, std::size_t most) {
  std::size_t n = 1;
  for (const Expression& a : e->arguments) {
    if (n > most) break;
    n += count_up_to(a, most - n);
  }
  return n;
}

std::size_t occurrences(const Expression& e, Variable v) {
  if (e->kind == NodeKind::variable) return e->variable == v ? 1 : 0;
  std::size_t n = 0;
  for (const Expression& a : e->arguments) n += occurrences(a, v);
  return n;
}

/// "a" or "f(x)" at the start of a part, in front of "=".
bool defines(std::span<const Token> t) {
  return t.size() > 1 && t[0].kind == TokenKind::name && t[1].kind == TokenKind::comparison &&
         t[1].comparison == Comparison::equal;
}

/// The number of 2.5 and of -2.5; null for anything else.
const Node* typed_number(const Expression& e) {
  const Node& n = e->kind == NodeKind::negate ? *e->arguments[0] : *e;
  return n.kind == NodeKind::number ? &n : nullptr;
}

}  // namespace

bool is_function_head(std::span<const Token> t) {
  return t.size() > 4 && t[0].kind == TokenKind::name && t[1].kind == TokenKind::open &&
         t[1].bracket == U'(' && t[2].kind == TokenKind::variable &&
         (t[2].variable == Variable::x || t[2].variable == Variable::t || t[2].variable == Variable::theta) &&
         t[3].kind == TokenKind::close && t[4].kind == TokenKind::comparison &&
         t[4].comparison == Comparison::equal;
}

bool is_too_large(const Expression& e) { return count_up_to(e, kMostParts) > kMostParts; }

tl::expected<void, SyntaxError> Parser::find_definitions() {
  std::size_t start = 0;
  int depth = 0;
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (tokens_[i].kind == TokenKind::open) ++depth;
    if (tokens_[i].kind == TokenKind::close) depth = std::max(0, depth - 1);
    if (!(depth == 0 && ends_part(tokens_[i])) && tokens_[i].kind != TokenKind::end) continue;
    const std::span<const Token> part = tokens_.subspan(start, i - start);
    const bool function = is_function_head(part);
    if (function || defines(part)) {
      const std::string& letter = part[0].text;
      if (definition(letter) != nullptr)
        return tl::unexpected(SyntaxError{part[0].column, SyntaxFault::defined_twice, letter});
      Definition d;
      d.letter = letter;
      d.is_function = function;
      if (function) d.variable = part[2].variable;
      d.start = start + (function ? 5 : 2);
      d.column = part[0].column;
      named_.push_back(std::move(d));
    }
    note_range(start, i);
    start = i + 1;
  }
  return {};
}

/// Notes 0 <= a <= 3, which has two comparisons around one letter and no variable.
void Parser::note_range(std::size_t start, std::size_t end) {
  std::vector<std::size_t> signs;
  for (std::size_t i = start; i < end; ++i) {
    if (tokens_[i].kind == TokenKind::variable) return;
    if (tokens_[i].kind == TokenKind::comparison) signs.push_back(i);
  }
  if (signs.size() != 2 || signs[1] != signs[0] + 2 || tokens_[signs[0] + 1].kind != TokenKind::name) return;
  ranges_.push_back({tokens_[signs[0] + 1].text, start, end});
}

Parser::Definition* Parser::definition(const std::string& letter) {
  const auto found = std::find_if(named_.begin(), named_.end(),
                                  [&letter](const Definition& d) { return d.letter == letter; });
  return found != named_.end() ? &*found : nullptr;
}

Parser::ParameterRange* Parser::range_of(const std::string& letter) {
  const auto found = std::find_if(ranges_.begin(), ranges_.end(),
                                  [&letter](const ParameterRange& r) { return r.letter == letter; });
  return found != ranges_.end() ? &*found : nullptr;
}

Parser::Parsed Parser::body_of(Definition& d) {
  if (d.state == Definition::State::read) return d.body;
  if (d.state == Definition::State::reading)
    return tl::unexpected(SyntaxError{d.column, SyntaxFault::defined_by_itself, d.letter});
  d.state = Definition::State::reading;
  const std::size_t here = std::exchange(at_, d.start);
  const int bars_outside = std::exchange(open_bars_, 0);
  const bool was_in_model = std::exchange(in_model_, false);
  Parsed body = sum();
  if (!body) return body;
  auto conditions = restrictions();
  if (!conditions) return tl::unexpected(std::move(conditions.error()));
  for (const Expression& c : *conditions) body = call(Function::where, {c, std::move(*body)});
  if (!ends_part(now())) return refuse(SyntaxFault::does_not_fit, now().text);
  for (const Variable v : variables_of(*body)) {
    if (!d.is_function) return tl::unexpected(SyntaxError{d.column, SyntaxFault::not_a_number, d.letter});
    if (v != d.variable)
      return tl::unexpected(
          SyntaxError{d.column, SyntaxFault::other_variable, d.letter, std::string(name_of(v))});
  }
  if (is_too_large(*body)) return tl::unexpected(SyntaxError{d.column, SyntaxFault::too_many_parts});
  d.end = at_;
  at_ = here;
  open_bars_ = bars_outside;
  in_model_ = was_in_model;
  d.state = Definition::State::read;
  d.body = *body;
  return body;
}

tl::expected<Parameter, SyntaxError> Parser::read_parameter(const std::string& letter) {
  const auto known = std::find_if(definitions_.parameters.begin(), definitions_.parameters.end(),
                                  [&letter](const Parameter& p) { return p.name == letter; });
  if (known != definitions_.parameters.end()) return *known;
  Parameter p;
  p.name = letter;
  Definition* const d = definition(letter);
  if (d != nullptr) {
    const Parsed body = body_of(*d);
    if (!body) return tl::unexpected(body.error());
    if (has_list(*body)) return tl::unexpected(SyntaxError{d->column, SyntaxFault::list_misplaced, letter});
    p.value = constant_value(*body);
    if (!std::isfinite(p.value))
      return tl::unexpected(SyntaxError{d->column, SyntaxFault::not_a_number, letter});
    p.from = std::min(-kDefaultReach, p.value);
    p.to = std::max(kDefaultReach, p.value);
  }
  ParameterRange* const range = range_of(letter);
  if (d == nullptr && range == nullptr)
    return tl::unexpected(SyntaxError{now().column, SyntaxFault::unknown_name, letter});
  if (range != nullptr) {
    if (std::exchange(range->is_being_read, true))
      return tl::unexpected(
          SyntaxError{tokens_[range->start].column, SyntaxFault::defined_by_itself, letter});
    const std::size_t here = std::exchange(at_, range->start);
    const Parsed first = sum();
    if (!first) return tl::unexpected(first.error());
    const Comparison sign = now().comparison;
    if (!is(TokenKind::comparison)) return refuse(SyntaxFault::range_empty);
    at_ += 3;
    const Parsed second = sum();
    if (!second) return tl::unexpected(second.error());
    if (at_ != range->end) return refuse(SyntaxFault::does_not_fit, now().text);
    at_ = here;
    const bool falls = sign == Comparison::greater || sign == Comparison::greater_equal;
    p.from = constant_value(falls ? *second : *first);
    p.to = constant_value(falls ? *first : *second);
    p.range_given = true;
    if (!(std::isfinite(p.from) && std::isfinite(p.to) && p.from < p.to))
      return tl::unexpected(SyntaxError{tokens_[range->start].column, SyntaxFault::range_empty});
    if (d == nullptr) p.value = p.from + (p.to - p.from) / 2;
    if (p.value < p.from || p.value > p.to)
      return tl::unexpected(SyntaxError{d->column, SyntaxFault::outside_its_range, letter});
  }
  definitions_.parameters.push_back(p);
  return p;
}

Parser::Parsed Parser::parameter_value(const std::string& letter) {
  Definition* const d = definition(letter);
  if (d != nullptr) {
    Parsed body = body_of(*d);
    if (!body) return body;
    if (has_list(*body)) return named_list(*d, *body);
  }
  const auto p = read_parameter(letter);
  if (!p) return tl::unexpected(p.error());
  if (d == nullptr) return parameter(letter, p->value, true);
  if (const Node* typed = typed_number(d->body)) return parameter(letter, p->value, typed->exact);
  const auto rational = rational_value(d->body);
  // pi/2 stays what it is: as a double it would not be a quarter turn.
  if (!rational) return d->body;
  // The double of 1/4 is 1/4, that of 1/3 is not 1/3.
  return parameter(letter, p->value, (rational->q & (rational->q - 1)) == 0);
}

Parser::Parsed Parser::function_body(const Token& name) {
  int primes = 0;
  for (; is(TokenKind::prime); ++at_) primes += static_cast<int>(now().value);
  if (primes > kMostPrimes) return refuse(SyntaxFault::nested_too_deep);
  Parsed body = body_of(*definition(name.text));
  if (!body) return body;
  Expression e = *body;
  for (int i = 0; i < primes; ++i) {
    e = slope_of(e, definition(name.text)->variable);
    if (!e) return tl::unexpected(SyntaxError{name.column, SyntaxFault::no_derivative, name.text});
  }
  return e;
}

Parser::Parsed Parser::named() {
  const Token name = now();
  ++at_;
  const Definition* const d = definition(name.text);
  if (d == nullptr && range_of(name.text) == nullptr) {
    if (in_model_) return free_letter(name.text);
    return tl::unexpected(SyntaxError{name.column, SyntaxFault::unknown_name, name.text});
  }
  if (d == nullptr || !d->is_function) return parameter_value(name.text);
  const std::size_t primes_at = at_;
  while (is(TokenKind::prime)) ++at_;
  if (!is(TokenKind::open)) return refuse(SyntaxFault::argument_missing, name.text);
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  const auto arguments = argument_list();
  if (!arguments) return tl::unexpected(arguments.error());
  if (arguments->size() != 1) {
    SyntaxError error{name.column, SyntaxFault::argument_count, name.text};
    error.number = static_cast<int>(arguments->size());
    error.wanted = 1;
    return tl::unexpected(std::move(error));
  }
  const std::size_t behind = std::exchange(at_, primes_at);
  Parsed body = function_body(name);
  if (!body) return body;
  at_ = behind;
  const Expression& e = *body;
  const std::size_t size = count_up_to((*arguments)[0], kMostParts);
  if (is_too_large(e) || occurrences(e, d->variable) * size > kMostParts)
    return tl::unexpected(SyntaxError{name.column, SyntaxFault::too_many_parts});
  return substitute(e, d->variable, (*arguments)[0]);
}

tl::expected<bool, SyntaxError> Parser::take_parameter() {
  if (defines(tokens_.subspan(at_))) {
    const std::string letter = now().text;
    Definition* const d = definition(letter);
    if (d == nullptr || d->is_function || d->start != at_ + 2)
      return refuse(SyntaxFault::defined_twice, letter);
    if (auto value = parameter_value(letter); !value) return tl::unexpected(value.error());
    at_ = d->end;
    return true;
  }
  const auto range = std::find_if(ranges_.begin(), ranges_.end(),
                                  [this](const ParameterRange& r) { return r.start == at_; });
  if (range == ranges_.end()) return false;
  const Definition* const d = definition(range->letter);
  if (d != nullptr && d->is_function) return refuse(SyntaxFault::range_misplaced);
  // Of two ranges for one letter only the first was read.
  if (range_of(range->letter) != &*range) return refuse(SyntaxFault::defined_twice, range->letter);
  if (auto p = read_parameter(range->letter); !p) return tl::unexpected(p.error());
  at_ = range->end;
  return true;
}

void Parser::sort_definitions() {
  const auto place = [this](const std::string& name) {
    if (const Definition* const d = definition(name)) return d->start;
    return range_of(name)->start;
  };
  const auto in_order = [&place](const auto& a, const auto& b) { return place(a.name) < place(b.name); };
  std::sort(definitions_.parameters.begin(), definitions_.parameters.end(), in_order);
  std::sort(definitions_.lists.begin(), definitions_.lists.end(), in_order);
}

std::optional<std::array<int, 2>> Parser::value_columns(const std::string& letter) {
  const Definition* const d = definition(letter);
  if (d == nullptr || d->is_function || d->state != Definition::State::read) return std::nullopt;
  if (has_list(d->body)) return std::nullopt;
  return std::array{tokens_[d->start].column, tokens_[d->end].column};
}

}  // namespace nazori::functions
