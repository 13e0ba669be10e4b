// SPDX-License-Identifier: Apache-2.0
#pragma once

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
};

/// Reads tokens into relations by precedence (a Pratt parser).
class Parser {
 public:
  explicit Parser(std::span<const Token> tokens) : tokens_(tokens) {}
  [[nodiscard]] tl::expected<std::vector<Relation>, SyntaxError> run();

 private:
  using Parsed = tl::expected<Expression, SyntaxError>;

  // With deeper nesting a hostile text could overflow the stack.
  static constexpr int kMostDepth = 200;

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
  [[nodiscard]] bool starts_operand() const;
  [[nodiscard]] tl::unexpected<SyntaxError> missing_operand() const;
  [[nodiscard]] tl::unexpected<SyntaxError> not_closed(const Token& open) const;
  /// An error at the present token.
  [[nodiscard]] tl::unexpected<SyntaxError> refuse(SyntaxFault fault, std::string subject = {}) const;
  void skip_definition_head();
  /// Consumes the bracket that closes `open`.
  tl::expected<void, SyntaxError> close(const Token& open);

  tl::expected<Relation, SyntaxError> relation();
  Parsed sum();
  Parsed product();
  Parsed signed_operand();
  Parsed raised();
  Parsed exponent();
  Parsed factored();
  Parsed operand();
  Parsed bars();
  Parsed group();
  Parsed function_call();
  Parsed bare_argument();
  tl::expected<std::vector<Expression>, SyntaxError> argument_list();
  Parsed finish_call(const Token& name, std::vector<Expression> arguments, const Expression& base,
                     const Expression& power);

  std::span<const Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int open_bars_ = 0;
};

}  // namespace nazori::functions
