// SPDX-License-Identifier: Apache-2.0
#include "content_reader.h"

#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "nazori/base/utf8.h"

namespace nazori::print {
namespace {

constexpr double kPoints = 72 / 25.4;
constexpr int kDeepest = 4;  // objects in objects: a booklet's page, and a character on it

/// x' = a x + c y + e, y' = b x + d y + f, as "cm" and "Tm" write it.
struct Matrix {
  double a = 1;
  double b = 0;
  double c = 0;
  double d = 1;
  double e = 0;
  double f = 0;

  [[nodiscard]] PaperPoint at(double x, double y) const { return {a * x + c * y + e, b * x + d * y + f}; }
  /// First this matrix, then `outer`.
  [[nodiscard]] Matrix then(const Matrix& outer) const {
    return {a * outer.a + b * outer.c,           a * outer.b + b * outer.d,
            c * outer.a + d * outer.c,           c * outer.b + d * outer.d,
            e * outer.a + f * outer.c + outer.e, e * outer.b + f * outer.d + outer.f};
  }
  [[nodiscard]] double scale() const { return std::sqrt(std::abs(a * d - b * c)); }
};

struct State {
  Matrix matrix;
  double line_grey = 0;
  double fill_grey = 0;
  double width = 1;
  double dash = 0;
  bool round = false;
};

class Reader {
 public:
  Reader(Fonts& fonts, const ObjectContent& object, PageDrawing& into)
      : fonts_(fonts), object_(object), into_(into) {}

  void read(std::string_view content, State state, int depth) {
    std::vector<State> saved;
    std::vector<std::string_view> operands;
    std::vector<PathStep> path;
    Matrix text;
    std::size_t font = 0;
    double size = 0;
    bool invisible = false;
    const auto value = [&](std::size_t i) {
      double number = 0;
      if (i < operands.size())
        std::from_chars(operands[i].data(), operands[i].data() + operands[i].size(), number);
      return number;
    };
    const auto matrix = [&] { return Matrix{value(0), value(1), value(2), value(3), value(4), value(5)}; };
    const auto point = [&](std::size_t i) { return state.matrix.at(value(i), value(i + 1)); };
    const auto paint = [&](bool filled) {
      const double scale = state.matrix.scale();
      into_.marks.push_back({std::move(path), filled, filled ? state.fill_grey : state.line_grey,
                             filled ? 0 : state.width * scale, filled ? 0 : state.dash * scale, state.round});
      path.clear();
    };
    while (!content.empty()) {
      const std::string_view word = next_word(content);
      if (word.empty()) break;
      if (is_operand(word)) {
        operands.push_back(word);
        continue;
      }
      if (word == "m") {
        path.push_back({PathStep::Kind::move, {point(0)}});
      } else if (word == "l") {
        path.push_back({PathStep::Kind::line, {point(0)}});
      } else if (word == "c") {
        // One operator may follow several curves' points only in other writers: here each has its own.
        path.push_back({PathStep::Kind::curve, {point(0), point(2), point(4)}});
      } else if (word == "re") {
        const double x = value(0);
        const double y = value(1);
        path.push_back({PathStep::Kind::move, {state.matrix.at(x, y)}});
        path.push_back({PathStep::Kind::line, {state.matrix.at(x + value(2), y)}});
        path.push_back({PathStep::Kind::line, {state.matrix.at(x + value(2), y + value(3))}});
        path.push_back({PathStep::Kind::line, {state.matrix.at(x, y + value(3))}});
        path.push_back({PathStep::Kind::close, {}});
      } else if (word == "S" || word == "f") {
        paint(word == "f");
      } else if (word == "q") {
        saved.push_back(state);
      } else if (word == "Q" && !saved.empty()) {
        state = saved.back();
        saved.pop_back();
      } else if (word == "cm") {
        state.matrix = matrix().then(state.matrix);
      } else if (word == "G") {
        state.line_grey = value(0);
      } else if (word == "g") {
        state.fill_grey = value(0);
      } else if (word == "w") {
        state.width = value(0);
      } else if (word == "d") {
        // "[2 2] 0 d" or "[] 0 d": the words are "[2", "2]", "0" and "[]", "0".
        state.dash = operands.size() > 2 ? dash_of(operands.front()) : 0;
      } else if (word == "J" || word == "j") {
        state.round = value(0) == 1;
      } else if (word == "Do" && !operands.empty()) {
        if (depth < kDeepest) read(object_(operands.back().substr(1)), state, depth + 1);
      } else if (word == "BT") {
        text = {};
      } else if (word == "Tm") {
        text = matrix();
      } else if (word == "Tr") {
        invisible = value(0) == 3;
      } else if (word == "Tf" && !operands.empty()) {
        font = index_of(operands.front());
        size = value(1);
      } else if (word == "Tj" && !operands.empty()) {
        show(operands.back(), font, size, invisible, text, state);
      }
      operands.clear();
    }
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n'; }
  static bool is_operand(std::string_view word) {
    const char c = word.front();
    return (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '/' || c == '<' || c == '[' || c == ']';
  }
  static std::string_view next_word(std::string_view& content) {
    while (!content.empty() && is_space(content.front())) content.remove_prefix(1);
    std::size_t length = 0;
    while (length < content.size() && !is_space(content[length])) ++length;
    const std::string_view word = content.substr(0, length);
    content.remove_prefix(length);
    return word;
  }
  static double dash_of(std::string_view word) {
    double dash = 0;
    std::from_chars(word.data() + 1, word.data() + word.size(), dash);
    return dash;
  }
  /// Of "/F1".
  static std::size_t index_of(std::string_view name) {
    std::size_t index = 0;
    if (name.size() > 2) std::from_chars(name.data() + 2, name.data() + name.size(), index);
    return index;
  }

  /// Glyphs as "<0A3F0B11>", one after another; the text moves on.
  void show(std::string_view glyphs, std::size_t font_index, double size, bool invisible, Matrix& text,
            const State& state) {
    if (font_index >= fonts_.count()) return;
    Font& font = fonts_.at(font_index);
    PageMark mark;
    mark.filled = true;
    mark.grey = state.fill_grey;
    for (std::size_t at = 1; at + 4 < glyphs.size(); at += 4) {
      GlyphId glyph = 0;
      std::from_chars(glyphs.data() + at, glyphs.data() + at + 4, glyph, 16);
      const Matrix whole = Matrix{size, 0, 0, size, 0, 0}.then(text).then(state.matrix);
      if (!invisible) {
        for (PathStep step : font.outline(glyph)) {
          for (PaperPoint& p : step.points) p = whole.at(p.x, p.y);
          mark.path.push_back(step);
        }
      }
      if (const auto used = font.used().find(glyph); used != font.used().end())
        into_.text += base::encode_utf8(used->second);
      text = Matrix{1, 0, 0, 1, font.advance(glyph) * size, 0}.then(text);
    }
    into_.text += '\n';
    if (!mark.path.empty()) into_.marks.push_back(std::move(mark));
  }

  Fonts& fonts_;
  const ObjectContent& object_;
  PageDrawing& into_;
};

}  // namespace

void read_content(std::string_view content, double height_mm, Fonts& fonts, const ObjectContent& object,
                  PageDrawing& into) {
  State state;
  // From points with y up to millimetres with y down.
  state.matrix = {1 / kPoints, 0, 0, -1 / kPoints, 0, height_mm};
  Reader(fonts, object, into).read(content, state, 0);
}

}  // namespace nazori::print
