// SPDX-License-Identifier: Apache-2.0
#include "regression_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace nazori::functions {
namespace {

using Letters = std::vector<std::string>;

bool contains(const Letters& letters, const std::string& name) {
  return std::find(letters.begin(), letters.end(), name) != letters.end();
}

void collect(const Expression& e, Letters& found) {
  if (is_free_letter(*e) && !contains(found, e->name)) found.push_back(e->name);
  for (const Expression& a : e->arguments) collect(a, found);
}

bool has_any(const Expression& e, const Letters& letters) {
  if (is_free_letter(*e)) return contains(letters, e->name);
  return std::any_of(e->arguments.begin(), e->arguments.end(),
                     [&letters](const Expression& a) { return has_any(a, letters); });
}

Expression replaced(const Expression& e, const std::function<Expression(const std::string&)>& value) {
  if (is_free_letter(*e)) {
    Expression with = value(e->name);
    return with ? with : e;
  }
  if (e->arguments.empty()) return e;
  std::vector<Expression> arguments;
  for (const Expression& a : e->arguments) arguments.push_back(replaced(a, value));
  // a x + b with a negative b is written a x - |b|.
  const Node* const right = arguments.back().get();
  if (e->kind == NodeKind::add && right->kind == NodeKind::negate && is_free_letter(*e->arguments.back()))
    return binary(NodeKind::subtract, arguments[0], right->arguments[0]);
  return with_arguments(*e, std::move(arguments));
}

/// Whether the tree is a sum of terms with at most one of these letters each, as a factor.
bool is_linear(const Expression& e, const Letters& letters) {
  if (!has_any(e, letters)) return true;
  const auto& a = e->arguments;
  const auto linear = [&letters](const Expression& part) { return is_linear(part, letters); };
  const auto constant = [&letters](const Expression& part) { return !has_any(part, letters); };
  switch (e->kind) {
    case NodeKind::number:
      return true;
    case NodeKind::negate:
    case NodeKind::add:
    case NodeKind::subtract:
      return std::all_of(a.begin(), a.end(), linear);
    case NodeKind::multiply:
      return (constant(a[0]) && linear(a[1])) || (linear(a[0]) && constant(a[1]));
    case NodeKind::divide:
      return linear(a[0]) && constant(a[1]);
    case NodeKind::function:
      // The sum under an integral may be taken apart, too.
      if (is_integral(*e)) return linear(a[0]) && constant(a[1]) && constant(a[2]);
      if (e->function != Function::where && e->function != Function::choose) return false;
      return constant(a[0]) && std::all_of(a.begin() + 1, a.end(), linear);
    default:
      return false;
  }
}

/// What a linear letter is multiplied by; 0 where it does not occur.
Expression factor_of(const Expression& e, const std::string& letter) {
  if (!has_any(e, {letter})) return number(0);
  const auto& a = e->arguments;
  switch (e->kind) {
    case NodeKind::number:
      return number(1);
    case NodeKind::negate:
      return negate(factor_of(a[0], letter));
    case NodeKind::add:
    case NodeKind::subtract:
      return binary(e->kind, factor_of(a[0], letter), factor_of(a[1], letter));
    case NodeKind::multiply:
      if (has_any(a[0], {letter})) return binary(e->kind, factor_of(a[0], letter), a[1]);
      return binary(e->kind, a[0], factor_of(a[1], letter));
    case NodeKind::divide:
      return binary(e->kind, factor_of(a[0], letter), a[1]);
    default: {
      if (is_integral(*e)) return with_arguments(*e, {factor_of(a[0], letter), a[1], a[2]});
      std::vector<Expression> parts{a[0]};
      for (std::size_t i = 1; i < a.size(); ++i) parts.push_back(factor_of(a[i], letter));
      return call(e->function, std::move(parts));
    }
  }
}

/// A letter of these in what is integrated; empty where there is none.
std::string letter_under_integral(const Expression& e, const Letters& letters) {
  for (const std::string& name : letters) {
    if (is_integral(*e) && has_any(e->arguments[0], {name})) return name;
  }
  for (const Expression& a : e->arguments) {
    if (auto name = letter_under_integral(a, letters); !name.empty()) return name;
  }
  return "";
}

/// Stands for letter number `i` in a tape. Nothing else sees it: it has no name.
Variable input_of(std::size_t i) { return static_cast<Variable>(64 + i); }

}  // namespace

Expression free_letter(std::string name) {
  return parameter(std::move(name), std::numeric_limits<double>::quiet_NaN(), false);
}

bool is_free_letter(const Node& n) {
  return n.kind == NodeKind::number && !n.name.empty() && std::isnan(n.value);
}

RegressionModel::RegressionModel(Expression typed) : typed_(std::move(typed)) {
  collect(typed_, letters_);
  Letters linear;
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    linear.push_back(letters_[i]);
    if (is_linear(typed_, linear)) {
      linear_.push_back(i);
    } else {
      linear.pop_back();
      nonlinear_.push_back(i);
    }
  }
  const auto number_of = [this](const std::string& name) {
    return static_cast<std::size_t>(std::find(letters_.begin(), letters_.end(), name) - letters_.begin());
  };
  const auto with_inputs = [&](const Expression& e) {
    return replaced(e, [&](const std::string& name) { return variable(input_of(number_of(name))); });
  };
  std::vector<Variable> all{Variable::x};
  for (std::size_t i = 0; i < letters_.size(); ++i) all.push_back(input_of(i));
  std::vector<Variable> searched{Variable::x};
  Letters nonlinear;
  for (const std::size_t i : nonlinear_) {
    searched.push_back(input_of(i));
    nonlinear.push_back(letters_[i]);
  }
  searched_under_integral_ = letter_under_integral(typed_, nonlinear);
  std::vector<Expression> parts{with_inputs(replaced(typed_, [&linear](const std::string& name) {
    return contains(linear, name) ? number(0) : Expression();
  }))};
  Expression sum = parts[0];
  for (std::size_t k = 0; k < linear.size(); ++k) {
    parts.push_back(with_inputs(factor_of(typed_, linear[k])));
    const Expression letter = variable(input_of(linear_[k]));
    sum = binary(NodeKind::add, sum, binary(NodeKind::multiply, letter, parts.back()));
  }
  whole_ = Tape::compile(std::array{sum}, all);
  terms_ = Tape::compile(parts, searched);
}

Expression RegressionModel::with_values(const std::vector<double>& values) const {
  return replaced(typed_, [&](const std::string& name) {
    const auto at = std::find(letters_.begin(), letters_.end(), name) - letters_.begin();
    const double value = values[static_cast<std::size_t>(at)] + 0.0;  // no negative zero
    return value < 0 ? negate(number(-value)) : number(value);
  });
}

}  // namespace nazori::functions
