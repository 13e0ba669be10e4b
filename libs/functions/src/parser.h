// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tokens.h"

namespace nazori::functions {

/// One ";"-separated part: terms with the comparisons between them.
struct Relation {
  std::vector<Expression> terms;
  std::vector<Comparison> comparisons;
  int column = 1;
  std::vector<Expression> conditions{};  ///< in braces behind it: {0 <= x <= 2}
  std::vector<Relation> also{};          ///< joined to it by "and"
  bool either = false;                   ///< "or" stands before it, not ";"
  std::string name{};                    ///< of f(x) = ...: "f"
  bool is_point = false;                 ///< (1, 2): terms are x and y
  bool is_model = false;                 ///< y ~ a x + b: terms are both sides
  std::optional<Area> area{};            ///< area(x^2, 0, 2)
};

/// What a text contains besides what is drawn.
struct Definitions {
  std::vector<Parameter> parameters;
  std::vector<NamedList> lists;
  std::vector<SyntaxError> questions;
};

/// Whether the tokens begin with f(x) =, the head of a definition.
[[nodiscard]] bool is_function_head(std::span<const Token> tokens);
/// Whether functions of functions have made an expression larger than is drawn.
[[nodiscard]] bool is_too_large(const Expression& e);

/// Reads tokens into relations by precedence (a Pratt parser).
class Parser {
 public:
  explicit Parser(std::span<const Token> tokens) : tokens_(tokens) {}
  [[nodiscard]] tl::expected<std::vector<Relation>, SyntaxError> run();
  /// The parameters, and what can be read in two ways; after run().
  [[nodiscard]] Definitions definitions() && { return std::move(definitions_); }
  /// The columns of the value of "a = 2": of its first character and of the one behind it; after run().
  [[nodiscard]] std::optional<std::array<int, 2>> value_columns(const std::string& letter);

 private:
  using Parsed = tl::expected<Expression, SyntaxError>;

  // With deeper nesting a hostile text could overflow the stack.
  static constexpr int kMostDepth = 200;
  static constexpr std::size_t kMostQuestions = 8;
  static constexpr std::size_t kMostCases = 32;

  /// Counts nesting while it lives.
  class Nesting {
   public:
    explicit Nesting(int& depth) : depth_(depth) { ++depth_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    ~Nesting() { --depth_; }

   private:
    int& depth_;
  };

  [[nodiscard]] const Token& now() const { return tokens_[at_]; }
  [[nodiscard]] bool is(TokenKind kind) const { return now().kind == kind; }
  [[nodiscard]] tl::expected<void, SyntaxError> check_lines() const;
  [[nodiscard]] bool starts_operand() const;
  [[nodiscard]] tl::unexpected<SyntaxError> missing_operand() const;
  [[nodiscard]] tl::unexpected<SyntaxError> not_closed(const Token& open) const;
  /// An error at the present token.
  [[nodiscard]] tl::unexpected<SyntaxError> refuse(SyntaxFault fault, std::string subject = {}) const;
  /// Notes what can be read in two ways.
  void ask(const Token& at, SyntaxFault fault, std::string subject = {});
  void ask_about_exponent();
  void skip_definition_head();
  /// Consumes the bracket that closes `open`.
  tl::expected<void, SyntaxError> close(const Token& open);

  tl::expected<Relation, SyntaxError> relation();
  tl::expected<Relation, SyntaxError> chain();
  /// What stands behind "~".
  tl::expected<Relation, SyntaxError> model(Relation r);
  /// Whether a parenthesis with a comma, (1, 2), starts here and is all there is.
  [[nodiscard]] bool starts_point() const;
  tl::expected<Relation, SyntaxError> point();

  /// "a = 2" or "f(x) = x^2" somewhere in the text.
  struct Definition {
    enum class State : std::uint8_t { unread, reading, read };
    std::string letter;
    bool is_function = false;
    Variable variable = Variable::x;  ///< of a function
    std::size_t start = 0;            ///< the first token behind "="
    std::size_t end = 0;              ///< the token behind the last one, once it is read
    int column = 1;
    State state = State::unread;
    Expression body;
  };
  /// "0 <= a <= 3"
  struct ParameterRange {
    std::string letter;
    std::size_t start = 0;
    std::size_t end = 0;
    bool is_being_read = false;
  };
  /// Notes where each letter is defined.
  tl::expected<void, SyntaxError> find_definitions();
  void note_range(std::size_t start, std::size_t end);
  [[nodiscard]] Definition* definition(const std::string& letter);
  /// The first range of a letter, or null.
  [[nodiscard]] ParameterRange* range_of(const std::string& letter);
  /// Reads what stands behind "=", the first time that it is needed.
  Parsed body_of(Definition& d);
  tl::expected<Parameter, SyntaxError> read_parameter(const std::string& letter);
  /// The value of a parameter, or a call f(x), f'(x).
  Parsed named();
  Parsed parameter_value(const std::string& letter);
  /// "a = [1, 2, 3]": notes the letter, once. @return what stands for it in an expression.
  Parsed named_list(const Definition& d, const Expression& typed);
  /// Of a function whose value is a list, the slope of each element.
  static Expression slope_of(const Expression& e, Variable v);
  /// What f, f', f'' computes from its variable; `name` was consumed.
  Parsed function_body(const Token& name);
  /// In the order of the text, not of their first use.
  void sort_definitions();
  /// Takes "a = 2" and "0 <= a <= 3". @return whether it did.
  tl::expected<bool, SyntaxError> take_parameter();

  /// What a brace contains.
  enum class Brace : std::uint8_t { group, cases, restriction };
  [[nodiscard]] Brace brace() const;
  Parsed cases();
  Parsed condition(Expression first);
  [[nodiscard]] static Expression joined(Expression left, const Expression& right);
  Parsed comparison_chain(Expression first);
  /// The conditions behind an expression.
  tl::expected<std::vector<Expression>, SyntaxError> restrictions();
  Parsed sum();
  Parsed product();
  Parsed signed_operand();
  Parsed raised();
  Parsed exponent();
  Parsed factored();
  Parsed operand();
  Parsed bars();
  Parsed group();
  /// What stands in square brackets: a list, or parentheses around one expression with a variable.
  Parsed list();
  Parsed function_call();
  Parsed bare_argument();
  Parsed integral_call();
  Parsed integral_sign();
  Parsed integral_argument();
  Parsed integral_end();
  static Parsed integral_between(int column, const Expression& integrand, Variable v, Expression from,
                                 Expression to);
  [[nodiscard]] bool stands_alone();
  /// A function of x: an expression, or the name of a defined function.
  Parsed area_border();
  tl::expected<Relation, SyntaxError> area();
  tl::expected<std::vector<Expression>, SyntaxError> argument_list();
  Parsed finish_call(const Token& name, std::vector<Expression> arguments, const Expression& base,
                     const Expression& power);

  std::span<const Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int open_bars_ = 0;
  bool in_model_ = false;
  std::vector<Definition> named_;
  std::vector<ParameterRange> ranges_;
  Definitions definitions_;
};

}  // namespace nazori::functions
