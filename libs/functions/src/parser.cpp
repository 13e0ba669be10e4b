// SPDX-License-Identifier: Apache-2.0
#include "parser.h"

#include <algorithm>
#include <utility>

namespace nazori::functions {
namespace {

const char* closing(char32_t open) { return open == U'(' ? ")" : open == U'[' ? "]" : "}"; }

bool closes(char32_t open, char32_t close) {
  return (open == U'(' && close == U')') || (open == U'[' && close == U']') ||
         (open == U'{' && close == U'}');
}

}  // namespace

tl::expected<std::vector<Relation>, SyntaxError> Parser::run() {
  std::vector<Relation> relations;
  if (auto lines = check_lines(); !lines) return tl::unexpected(std::move(lines.error()));
  if (auto found = find_definitions(); !found) return tl::unexpected(std::move(found.error()));
  bool either = false;
  while (true) {
    while (is(TokenKind::semicolon)) ++at_;
    if (is(TokenKind::end)) break;
    const auto taken = take_parameter();
    if (!taken) return tl::unexpected(taken.error());
    if (!*taken) {
      auto one = relation();
      if (!one) return tl::unexpected(std::move(one.error()));
      one->either = std::exchange(either, false);
      for (const Expression& e : one->terms) {
        if (is_too_large(e)) return tl::unexpected(SyntaxError{one->column, SyntaxFault::too_many_parts});
      }
      relations.push_back(std::move(*one));
    }
    if (!relations.empty() && relations.back().is_point && is(TokenKind::comma)) {
      ++at_;
    } else if (is(TokenKind::either)) {
      either = true;
      ++at_;
      if (!starts_operand() && !is(TokenKind::minus) && !is(TokenKind::plus)) return missing_operand();
    } else if (!is(TokenKind::semicolon) && !is(TokenKind::end)) {
      return refuse(SyntaxFault::does_not_fit, now().text);
    }
  }
  if (relations.empty()) {
    return refuse(SyntaxFault::no_expression);
  }
  sort_definitions();
  return relations;
}

/// A line break between two parts that would otherwise be multiplied.
tl::expected<void, SyntaxError> Parser::check_lines() const {
  const auto goes_on = [](const Token& t) {
    switch (t.kind) {
      case TokenKind::plus:
      case TokenKind::minus:
      case TokenKind::times:
      case TokenKind::divide:
      case TokenKind::power:
      case TokenKind::comma:
      case TokenKind::dots:
      case TokenKind::tilde:
      case TokenKind::comparison:
      case TokenKind::semicolon:
      case TokenKind::colon:
      case TokenKind::both:
      case TokenKind::either:
      case TokenKind::end:
        return true;
      default:
        return false;
    }
  };
  for (std::size_t i = 1; i < tokens_.size(); ++i) {
    const Token& before = tokens_[i - 1];
    const Token& t = tokens_[i];
    if (!t.line_before || goes_on(before) || goes_on(t)) continue;
    if (before.kind == TokenKind::open || t.kind == TokenKind::close || t.bracket == U'{') continue;
    return tl::unexpected(SyntaxError{t.column, SyntaxFault::line_break, t.text});
  }
  return {};
}

bool Parser::starts_operand() const {
  switch (now().kind) {
    case TokenKind::number:
    case TokenKind::variable:
    case TokenKind::constant:
    case TokenKind::function:
    case TokenKind::root:
    case TokenKind::name:
    case TokenKind::integral:
      return true;
    case TokenKind::open:
      return brace() != Brace::restriction;
    case TokenKind::bar:
      return open_bars_ == 0;
    default:
      return false;
  }
}

tl::unexpected<SyntaxError> Parser::refuse(SyntaxFault fault, std::string subject) const {
  return tl::unexpected(SyntaxError{now().column, fault, std::move(subject)});
}

void Parser::ask(const Token& at, SyntaxFault fault, std::string subject) {
  // What is defined is read once more where it is used.
  for (const SyntaxError& q : definitions_.questions) {
    if (q.column == at.column && q.fault == fault) return;
  }
  if (definitions_.questions.size() < kMostQuestions)
    definitions_.questions.push_back({at.column, fault, std::move(subject)});
}

/// 1e3 is 1*e*3 here, and 1000 in most programs.
void Parser::ask_about_exponent() {
  const auto token = [this](std::size_t i) { return at_ + i < tokens_.size() ? tokens_[at_ + i] : Token{}; };
  const Token e = token(1);
  if (e.kind != TokenKind::constant || e.constant != Constant::e || e.text != "e" || e.space_before) return;
  const Token sign = token(2);
  const bool is_signed = sign.kind == TokenKind::minus || sign.kind == TokenKind::plus;
  const Token digits = is_signed ? token(3) : sign;
  if (sign.space_before || digits.kind != TokenKind::number || digits.space_before) return;
  ask(now(), SyntaxFault::ask_exponent, now().text + "e" + (is_signed ? sign.text : "") + digits.text);
}

tl::unexpected<SyntaxError> Parser::missing_operand() const {
  if (at_ > 0 && tokens_[at_ - 1].kind != TokenKind::semicolon)
    return refuse(SyntaxFault::operand_missing, tokens_[at_ - 1].text);
  return refuse(SyntaxFault::not_an_operand, now().text);
}

tl::unexpected<SyntaxError> Parser::not_closed(const Token& open) const {
  if (is(TokenKind::comma)) {
    // [1, 2], or [(1, 2), (3, 4)]
    auto first = std::find_if(tokens_.begin(), tokens_.end(),
                              [&open](const Token& t) { return t.column == open.column; });
    if (first != tokens_.begin() && std::prev(first)->bracket == U'[') --first;
    if (first->kind == TokenKind::open && first->bracket == U'[')
      return tl::unexpected(SyntaxError{first->column, SyntaxFault::list});
  }
  return tl::unexpected(
      SyntaxError{now().column, SyntaxFault::bracket_open, open.text, closing(open.bracket), open.column, 0});
}

tl::expected<void, SyntaxError> Parser::close(const Token& open) {
  if (!is(TokenKind::close) || !closes(open.bracket, now().bracket)) return not_closed(open);
  ++at_;
  return {};
}

// "y(x) = ..." and "f(x) = ..." are drawn as "y = ...".
void Parser::skip_definition_head() {
  if (at_ + 4 >= tokens_.size()) return;
  const auto kind = [this](std::size_t i) { return tokens_[at_ + i].kind; };
  const bool named = kind(0) == TokenKind::name;
  const bool fits = (named || (kind(0) == TokenKind::variable && tokens_[at_].variable == Variable::y)) &&
                    kind(1) == TokenKind::open && kind(2) == TokenKind::variable &&
                    (named || tokens_[at_ + 2].variable == Variable::x) && kind(3) == TokenKind::close &&
                    kind(4) == TokenKind::comparison;
  // In a model every letter is a name, not only those with a definition.
  const bool is_defined =
      named && is_function_head(tokens_.subspan(at_)) && definition(now().text) != nullptr;
  if (fits && (!named || is_defined)) at_ += 3;
}

/// Terms with the comparisons between them.
tl::expected<Relation, SyntaxError> Parser::chain() {
  Relation r;
  r.column = now().column;
  const Token& head = now();
  const std::size_t start = at_;
  skip_definition_head();
  std::optional<Variable> local;
  if (at_ != start) {
    if (head.kind == TokenKind::name) {
      r.name = head.text;
      local = tokens_[start + 2].variable;
    }
    r.terms.push_back(variable(Variable::y));
    ++at_;
  } else {
    auto first = sum();
    if (!first) return tl::unexpected(std::move(first.error()));
    r.terms.push_back(std::move(*first));
  }
  if (is(TokenKind::tilde)) return model(std::move(r));
  while (is(TokenKind::comparison)) {
    r.comparisons.push_back(now().comparison);
    ++at_;
    auto next = sum();
    if (!next) return tl::unexpected(std::move(next.error()));
    r.terms.push_back(std::move(*next));
  }
  auto conditions = restrictions();
  if (!conditions) return tl::unexpected(std::move(conditions.error()));
  r.conditions = std::move(*conditions);
  if (local) {
    if (auto body = body_of(*definition(r.name)); !body) return tl::unexpected(std::move(body.error()));
  }
  if (local && *local != Variable::x) {
    for (Expression& e : r.terms) e = substitute(e, *local, variable(Variable::x));
    for (Expression& e : r.conditions) e = substitute(e, *local, variable(Variable::x));
  }
  return r;
}

tl::expected<Relation, SyntaxError> Parser::model(Relation r) {
  ++at_;
  in_model_ = true;
  auto right = sum();
  in_model_ = false;
  if (!right) return tl::unexpected(std::move(right.error()));
  auto conditions = restrictions();
  if (!conditions) return tl::unexpected(std::move(conditions.error()));
  r.is_model = true;
  r.terms.push_back(std::move(*right));
  r.conditions = std::move(*conditions);
  return r;
}

bool Parser::starts_point() const {
  if (!is(TokenKind::open) || now().bracket != U'(') return false;
  int depth = 0;
  bool separated = false;
  for (std::size_t i = at_; i < tokens_.size(); ++i) {
    const Token& t = tokens_[i];
    if (t.kind == TokenKind::open) ++depth;
    if (t.kind == TokenKind::comma && depth == 1) separated = true;
    if (t.kind != TokenKind::close || --depth > 0) continue;
    const TokenKind next = tokens_[i + 1].kind;
    return separated && (next == TokenKind::end || next == TokenKind::semicolon || next == TokenKind::comma);
  }
  return false;
}

tl::expected<Relation, SyntaxError> Parser::point() {
  Relation r;
  r.column = now().column;
  r.is_point = true;
  auto places = argument_list();
  if (!places) return tl::unexpected(std::move(places.error()));
  const bool are_numbers = std::all_of(places->begin(), places->end(),
                                       [](const Expression& e) { return variables_of(e).empty(); });
  if (places->size() != 2 || !are_numbers)
    return tl::unexpected(SyntaxError{r.column, SyntaxFault::point_not_two_numbers});
  r.terms = std::move(*places);
  return r;
}

tl::expected<Relation, SyntaxError> Parser::relation() {
  if (starts_point()) return point();
  if (is(TokenKind::area)) return area();
  auto r = chain();
  while (r && is(TokenKind::both)) {
    ++at_;
    auto next = chain();
    if (!next) return next;
    r->also.push_back(std::move(*next));
  }
  return r;
}

Parser::Parsed Parser::sum() {
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  Parsed left = product();
  while (left && (is(TokenKind::plus) || is(TokenKind::minus))) {
    const NodeKind kind = is(TokenKind::plus) ? NodeKind::add : NodeKind::subtract;
    ++at_;
    Parsed right = product();
    if (!right) return right;
    left = binary(kind, std::move(*left), std::move(*right));
  }
  return left;
}

Parser::Parsed Parser::product() {
  Parsed left = signed_operand();
  while (left) {
    NodeKind kind = NodeKind::multiply;
    if (is(TokenKind::times) || is(TokenKind::divide)) {
      kind = is(TokenKind::times) ? NodeKind::multiply : NodeKind::divide;
      ++at_;
    } else if (!starts_operand()) {
      break;
    } else if (is(TokenKind::number) && at_ > 0 && tokens_[at_ - 1].kind == TokenKind::number) {
      return refuse(SyntaxFault::no_operator, now().text);
    }
    Parsed right = signed_operand();
    if (!right) return right;
    left = binary(kind, std::move(*left), std::move(*right));
  }
  return left;
}

Parser::Parsed Parser::signed_operand() {
  if (!is(TokenKind::plus) && !is(TokenKind::minus)) return raised();
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  const bool negative = is(TokenKind::minus);
  ++at_;
  Parsed inner = signed_operand();
  if (inner && negative) return negate(std::move(*inner));
  return inner;
}

Parser::Parsed Parser::raised() {
  Parsed base = factored();
  if (!base || !is(TokenKind::power)) return base;
  ++at_;
  Parsed e = exponent();
  if (!e) return e;
  return binary(NodeKind::power, std::move(*base), std::move(*e));
}

/// What stands after ^: signs bind looser than a further power, 2^-x^2 = 2^(-(x^2)).
Parser::Parsed Parser::exponent() {
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  if (is(TokenKind::plus) || is(TokenKind::minus)) {
    const bool negative = is(TokenKind::minus);
    ++at_;
    Parsed inner = exponent();
    if (inner && negative) return negate(std::move(*inner));
    return inner;
  }
  return raised();
}

Parser::Parsed Parser::factored() {
  Parsed e = operand();
  int raised = 0;
  while (e && (is(TokenKind::factorial) || is(TokenKind::superscript) || is(TokenKind::degree))) {
    if (depth_ + ++raised > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
    if (is(TokenKind::factorial)) {
      e = call(Function::factorial, {std::move(*e)});
    } else if (is(TokenKind::degree)) {
      e = degrees(std::move(*e));
    } else {
      e = binary(NodeKind::power, std::move(*e), number(now().value));
    }
    ++at_;
  }
  return e;
}

Parser::Parsed Parser::operand() {
  const Token& token = now();
  switch (token.kind) {
    case TokenKind::number:
      ask_about_exponent();
      ++at_;
      return number(token.value, token.exact);
    case TokenKind::variable:
      ++at_;
      return variable(token.variable);
    case TokenKind::constant:
      ++at_;
      return constant(token.constant);
    case TokenKind::open:
      return brace() == Brace::cases ? cases() : group();
    case TokenKind::name:
      return named();
    case TokenKind::bar:
      return bars();
    case TokenKind::function:
      return token.function == Function::integral ? integral_call() : function_call();
    case TokenKind::integral:
      return integral_sign();
    case TokenKind::root: {
      ++at_;
      const Nesting nesting(depth_);
      if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
      Parsed inner = raised();
      if (!inner) return inner;
      if (token.degree == 2) return call(Function::sqrt, {std::move(*inner)});
      if (token.degree == 3) return call(Function::cbrt, {std::move(*inner)});
      return call(Function::root, {number(token.degree), std::move(*inner)});
    }
    default:
      return missing_operand();
  }
}

Parser::Parsed Parser::bars() {
  const int column = now().column;
  const Nesting nesting(depth_);
  if (depth_ > kMostDepth) return refuse(SyntaxFault::nested_too_deep);
  ++at_;
  ++open_bars_;
  Parsed inner = sum();
  --open_bars_;
  if (!inner) return inner;
  if (!is(TokenKind::bar)) {
    SyntaxError error{now().column, SyntaxFault::bar_open};
    error.number = column;
    return tl::unexpected(std::move(error));
  }
  ++at_;
  return call(Function::abs, {std::move(*inner)});
}

Parser::Parsed Parser::group() {
  const Token open = now();
  if (brace() == Brace::restriction) return refuse(SyntaxFault::condition_alone, open.text);
  if (open.bracket == U'[') return list();
  ++at_;
  if (is(TokenKind::number) && tokens_[at_ + 1].kind == TokenKind::close &&
      now().text.find(',') != std::string::npos)
    ask(open, SyntaxFault::ask_point, now().text);
  const int bars_outside = std::exchange(open_bars_, 0);
  Parsed inner = sum();
  open_bars_ = bars_outside;
  if (!inner) return inner;
  if (auto closed = close(open); !closed) return tl::unexpected(std::move(closed.error()));
  return inner;
}

}  // namespace nazori::functions
