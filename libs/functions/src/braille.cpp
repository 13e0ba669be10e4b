// SPDX-License-Identifier: Apache-2.0
#include "nazori/functions/braille.h"

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <utility>

#include "area.h"
#include "braille_writer.h"
#include "nazori/functions/curve_kinds.h"
#include "restricted_statement.h"

namespace nazori::functions {
namespace {

/// Technical material is in grade 1 mode from its passage indicator to the terminator.
std::string finished(BrailleWriter writer, BrailleCode code) {
  std::string text = std::move(writer).text();
  return code == BrailleCode::ueb ? "⠰⠰⠰" + text + "⠰⠄" : text;
}

/// A line "a = 2".
std::string definition(const std::string& letter, const Expression& value, BrailleCode code) {
  BrailleWriter writer(code);
  writer.cells().put_letters(braille_word(letter));
  writer.comparison(Comparison::equal);
  writer.write(value);
  return "\n" + finished(std::move(writer), code);
}

/// What was found for the letters of a model, with four digits.
std::string lines_of(const Fit& fit, BrailleCode code) {
  std::string text;
  for (const FittedLetter& l : fit.letters)
    text += definition(l.name, number(std::stod(fmt::format("{:.4g}", l.value))), code);
  return text;
}

}  // namespace

std::string in_braille(const Expression& expression, BrailleCode code) {
  BrailleWriter writer(code);
  writer.write(expression);
  return finished(std::move(writer), code);
}

std::string in_braille(const Statement& typed, BrailleCode code) {
  if (typed.fit) return in_braille(*typed.typed, code) + lines_of(*typed.fit, code);
  BrailleWriter writer(code);
  BrailleCells& cells = writer.cells();
  // The area as a number; its region is what it is of.
  if (typed.area) return in_braille(area_integral(*typed.area), code);
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
      cells.put_letters(braille_word(s.name));
      cells.put(cells.signs().open);
      cells.put_letters(braille_letter('x'));
      cells.put(cells.signs().close);
      writer.comparison(Comparison::equal);
    } else if (kind.left[0]) {
      if (i > 0) cells.comma(false);
      writer.write(variable(*kind.left[i]));
      if (s.is_model)
        writer.sign(cells.signs().tilde);
      else
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
  for (const Statement& s : plot.statements) {
    if (s.element > 0 || s.is_data) continue;
    text += (text.empty() ? "" : "\n") + in_braille(s.typed && !s.fit ? *s.typed : s, code);
  }
  for (const Parameter& p : plot.parameters) text += definition(p.name, number(p.value), code);
  for (const NamedList& l : plot.lists) text += definition(l.name, l.typed, code);
  return text;
}

}  // namespace nazori::functions
