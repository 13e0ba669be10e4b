// SPDX-License-Identifier: Apache-2.0
#include "nazori/print/worksheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "nazori/base/utf8.h"
#include "pdf_writer.h"
#include "sheet_parts.h"

namespace nazori::print {
namespace {

constexpr double kPoints = 72 / 25.4;
constexpr double kHeader_mm = 9;
constexpr double kFooter_mm = 4;
constexpr double kGap_mm = 3;
constexpr double kText_mm = 3.6;
constexpr double kRuby_mm = 1.9;
constexpr double kLargestStep_mm = 12;
constexpr double kSmallestModel_mm = 24;
constexpr double kLargestModel_mm = 60;
constexpr double kCardWidth_mm = 85;
constexpr double kCardHeight_mm = 50;
constexpr double kCutMark_mm = 4;
constexpr int kManuscriptCells = 20;

struct Size {
  double width;
  double height;
};

Size size_of(const SheetSettings& s) {
  const Size paper = s.paper == Paper::a4   ? Size{210, 297}
                     : s.paper == Paper::b5 ? Size{182, 257}
                                            : Size{215.9, 279.4};
  if (s.booklet) return {paper.height / 2, paper.width};
  if (s.layout == Layout::manuscript) return {paper.height, paper.width};
  return paper;
}

/// The pages of a document.
class Sheets {
 public:
  Sheets(const std::vector<SheetCharacter>& characters, const SheetSettings& settings, Fonts fonts)
      : characters_(characters), s_(settings), fonts_(std::move(fonts)), size_(size_of(settings)) {
    for (std::size_t i = 0; i < characters.size(); ++i)
      index_.emplace(base::encode_utf8(characters[i].character.code_point), i);
  }

  base::Result<void> draw(const base::Progress& progress);
  [[nodiscard]] std::string file();

 private:
  [[nodiscard]] Rect area() const {
    return {kMargin_mm, kMargin_mm + kHeader_mm, size_.width - 2 * kMargin_mm,
            size_.height - 2 * kMargin_mm - kHeader_mm - kFooter_mm};
  }
  Canvas& new_page(bool with_header);
  void draw_header(Canvas& canvas);
  /// A cell with its guides; without, a thin box.
  void place_cell(Canvas& canvas, const Rect& rect, std::optional<Guide> guide);
  void practice(std::size_t i);
  double practice_depth(const kanji::Character& character, int rows) const;
  void draw_facts(const SheetCharacter& one, const Flow& flow, double along, double across, double length,
                  double depth);
  void draw_model(const SheetCharacter& one, std::size_t i, const Rect& box);
  void quiz();
  void quiz_line(const kanji::Word& word, const Flow& flow, double across, Canvas& canvas, bool answer);
  void cards();
  void card_front(Canvas& canvas, std::size_t i, const Rect& card);
  void card_back(Canvas& canvas, std::size_t i, const Rect& card);
  void manuscript();
  [[nodiscard]] std::u32string label(const char* english, const char* japanese) const {
    return wide(s_.language == Language::japanese ? japanese : english);
  }
  [[nodiscard]] double model_mm() const {
    return std::clamp(s_.cell_mm * 1.6, kSmallestModel_mm, kLargestModel_mm);
  }
  [[nodiscard]] double step_mm() const { return std::min(s_.cell_mm, kLargestStep_mm); }
  [[nodiscard]] double flow_length() const { return s_.vertical ? area().height : area().width; }
  [[nodiscard]] double flow_depth() const { return s_.vertical ? area().width : area().height; }
  [[nodiscard]] int cells_in_row() const {
    return std::max(1, static_cast<int>((flow_length() + 1e-6) / s_.cell_mm));
  }

  const std::vector<SheetCharacter>& characters_;
  const SheetSettings& s_;
  Fonts fonts_;
  Size size_;
  std::map<std::string, std::size_t> index_;
  std::vector<std::unique_ptr<Canvas>> pages_;
  /// A cell of one size, which is written once and placed often: side in micrometres, kind.
  std::map<std::pair<long, bool>, std::string> cells_;
  std::set<std::size_t> used_;  // characters that are drawn as an object
  double used_depth_ = 0;       // of the last page
};

Canvas& Sheets::new_page(bool with_header) {
  pages_.push_back(std::make_unique<Canvas>(fonts_, size_.height));
  used_depth_ = 0;
  Canvas& canvas = *pages_.back();
  if (with_header) draw_header(canvas);
  // The licence of the strokes asks to name their source.
  canvas.text(kMargin_mm, size_.height - kMargin_mm - 0.6,
              U"Strokes: KanjiVG, CC BY-SA 3.0. Made with Nazori.", 1.9, 0.5);
  const std::u32string page = wide(std::to_string(pages_.size()));
  canvas.text(size_.width - kMargin_mm - fonts_.width(page) * 2.6, size_.height - kMargin_mm - 0.6, page, 2.6,
              0.3);
  return canvas;
}

void Sheets::draw_header(Canvas& canvas) {
  const double y = kMargin_mm + 4.5;
  const double right = size_.width - kMargin_mm;
  double x = right;
  const auto field = [&](const std::u32string& name, double line_mm) {
    x -= line_mm;
    canvas.line(x, y + 0.8, x + line_mm - 2, y + 0.8, {0.4, 0.2, 0});
    x -= fonts_.width(name) * 3.2 + 1;
    canvas.text(x, y, name, 3.2, 0.2);
  };
  const double scale = std::min(1.0, (size_.width - 2 * kMargin_mm) / 186);
  field(label("Date", "日付"), 24 * scale);
  field(label("Class", "組"), 20 * scale);
  field(label("Name", "名前"), 46 * scale);
  const std::u32string title = cut(fonts_, wide(s_.title), (x - kMargin_mm - 3) / 4);
  canvas.text(kMargin_mm, y, title, 4);
}

void Sheets::place_cell(Canvas& canvas, const Rect& rect, std::optional<Guide> guide) {
  const auto [at, is_new] = cells_.try_emplace({std::lround(rect.width * 1000), guide.has_value()});
  if (is_new) at->second = fmt::format("G{}", cells_.size() - 1);
  canvas.object(at->second, rect);
}

double Sheets::practice_depth(const kanji::Character& character, int rows) const {
  double depth = model_mm();
  if (s_.steps) {
    const int in_row = std::max(1, static_cast<int>((flow_length() + 1e-6) / step_mm()));
    const int strokes = static_cast<int>(character.strokes.size());
    const int step_rows = (strokes + in_row - 1) / in_row;
    depth += kGap_mm / 2 + step_rows * step_mm();
  }
  if (rows > 0) depth += kGap_mm / 2 + rows * s_.cell_mm;
  return depth;
}

void Sheets::draw_facts(const SheetCharacter& one, const Flow& flow, double along, double across,
                        double length, double depth) {
  Canvas& canvas = *pages_.back();
  const Facts facts = facts_of(one.character);
  const double most = length / kText_mm;
  double at = across;
  const auto line = [&](const std::u32string& text) {
    if (text.empty() || at + kText_mm > across + depth) return;
    flow.text(canvas, along, at, cut(fonts_, text, most), kText_mm);
    at += kText_mm * 1.35;
  };
  if (!facts.on.empty()) line(label("on", "音") + U" " + facts.on);
  if (!facts.kun.empty()) line(label("kun", "訓") + U" " + facts.kun);
  line(facts.meanings);
  for (const kanji::Word& word : one.words) {
    const std::u32string text = wide(word.text);
    const std::u32string reading = wide(word.reading);
    if (at + kRuby_mm * 1.1 + kText_mm > across + depth) break;
    const double width = fonts_.width(text) * kText_mm;
    const double ruby = std::min(kRuby_mm, width / std::max(1.0, fonts_.width(reading)) * 1.4);
    // The reading stands above the word, to its right in vertical text.
    if (reading != text) flow.text(canvas, along, at + kRuby_mm - ruby, reading, ruby, 0.2);
    at += kRuby_mm * 1.1;
    flow.text(canvas, along, at, text, kText_mm);
    const double taken = std::max(width, fonts_.width(reading) * ruby) + 2;
    if (!word.glosses.empty())
      flow.text(canvas, along + taken, at,
                cut(fonts_, wide(word.glosses.front()), (length - taken) / kText_mm), kText_mm, 0.25);
    at += kText_mm * 1.25;
  }
}

void Sheets::draw_model(const SheetCharacter& one, std::size_t i, const Rect& box) {
  Canvas& canvas = *pages_.back();
  place_cell(canvas, box, s_.guide);
  used_.insert(i);
  canvas.character(static_cast<int>(i), box, 0);
  if (s_.arrows) draw_arrows(canvas, one.character, box);
  if (s_.numbers) draw_numbers(canvas, one.character, box);
  const char32_t text[] = {one.character.code_point};
  canvas.text(box.x, box.y + box.height * 0.88, {text, 1}, box.width, 0, true);
}

void Sheets::practice(std::size_t i) {
  const SheetCharacter& one = characters_[i];
  int rows = s_.rows;
  if (s_.whole_page) {
    const double left = flow_depth() - practice_depth(one.character, 0) - kGap_mm / 2;
    rows = std::max(0, static_cast<int>((left + 1e-6) / s_.cell_mm));
  }
  // More steps than the check of the settings reckons with take the place of rows.
  while (rows > 0 && practice_depth(one.character, rows) > flow_depth() + 1e-6) --rows;
  const double depth = practice_depth(one.character, rows);
  if (pages_.empty() || s_.whole_page || used_depth_ + depth > flow_depth() + 1e-6) new_page(true);
  Canvas& canvas = *pages_.back();
  const Flow flow(area(), s_.vertical);
  double at = used_depth_;
  const double model = model_mm();
  draw_model(one, i, flow.rect(0, at, model, model));
  if (s_.facts) draw_facts(one, flow, model + kGap_mm, at, flow.length() - model - kGap_mm, model);
  at += model;
  if (s_.steps) {
    at += kGap_mm / 2;
    const double step = step_mm();
    const int in_row = std::max(1, static_cast<int>((flow.length() + 1e-6) / step));
    const auto strokes = static_cast<int>(one.character.strokes.size());
    for (int stroke = 0; stroke < strokes; ++stroke) {
      const int row = stroke / in_row;
      const Rect box = flow.rect(stroke % in_row * step, at + row * step, step, step);
      place_cell(canvas, box, std::nullopt);
      const auto last = static_cast<std::size_t>(stroke);
      if (stroke > 0) canvas.in_square(box, strokes_content(one.character, 0, last), 0.62);
      canvas.in_square(box, strokes_content(one.character, last, last + 1), 0);
    }
    const int step_rows = (strokes + in_row - 1) / in_row;
    at += step_rows * step;
  }
  if (rows > 0) at += kGap_mm / 2;
  const int in_row = cells_in_row();
  for (int cell = 0; cell < rows * in_row; ++cell) {
    const int row = cell / in_row;
    const Rect box = flow.rect(cell % in_row * s_.cell_mm, at + row * s_.cell_mm, s_.cell_mm, s_.cell_mm);
    place_cell(canvas, box, s_.guide);
    if (cell < s_.copies) {
      const double share = s_.copies > 1 ? static_cast<double>(cell) / (s_.copies - 1) : 0;
      canvas.character(static_cast<int>(i), box, 0.5 + 0.38 * share);
    }
  }
  used_depth_ += depth + kGap_mm;
}

void Sheets::quiz_line(const kanji::Word& word, const Flow& flow, double across, Canvas& canvas,
                       bool answer) {
  const std::u32string text = wide(word.text);
  const double cells = static_cast<double>(text.size()) * s_.cell_mm;
  const double begin = cells + kGap_mm;  // of the text
  const double length = flow.length() - begin;
  const double middle = across + (s_.cell_mm - kText_mm * 2.6) / 2;
  flow.text(canvas, begin, middle, cut(fonts_, wide(word.reading), length / kText_mm), kText_mm);
  if (!word.glosses.empty())
    flow.text(canvas, begin, middle + kText_mm * 1.4,
              cut(fonts_, wide(word.glosses.front()), length / kText_mm), kText_mm, 0.25);
  double along = 0;
  for (const char32_t letter : text) {
    const Rect box = flow.rect(along, across, s_.cell_mm, s_.cell_mm);
    place_cell(canvas, box, s_.guide);
    along += s_.cell_mm;
    const auto known = index_.find(base::encode_utf8(letter));
    const double size = s_.cell_mm * 0.8;
    const double inset = s_.cell_mm * 0.1;
    if (known == index_.end()) {  // What is not asked for is printed.
      canvas.vertical_letter(box.x + inset, box.y + inset, letter, size, 0.35);
    } else if (answer) {
      used_.insert(known->second);
      canvas.character(static_cast<int>(known->second), box, 0);
      canvas.text(box.x + inset, box.y + s_.cell_mm * 0.8, {&letter, 1}, size, 0, true);
    }
  }
}

void Sheets::quiz() {
  struct Line {
    const kanji::Word* word;
    double across;
  };
  std::vector<Line> lines;
  const auto close = [&] {
    if (!s_.answers || lines.empty()) return;
    Canvas& back = new_page(false);
    const std::u32string title = label("Answers", "答え");
    back.text(kMargin_mm, kMargin_mm + 4.5, title, 4);
    for (const Line& line : lines) quiz_line(*line.word, Flow(area(), s_.vertical), line.across, back, true);
  };
  std::set<std::string> asked;
  for (const SheetCharacter& one : characters_) {
    const Flow flow(area(), s_.vertical);
    for (const kanji::Word& word : one.words) {
      const double cells = static_cast<double>(wide(word.text).size()) * s_.cell_mm;
      if (cells > flow.length() * 0.6 || !asked.insert(word.text).second) continue;
      if (lines.empty() || used_depth_ + s_.cell_mm > flow.depth() + 1e-6) {
        close();
        lines.clear();
        new_page(true);
      }
      quiz_line(word, flow, used_depth_, *pages_.back(), false);
      lines.push_back({&word, used_depth_});
      used_depth_ += s_.cell_mm + kGap_mm;
      break;
    }
  }
  close();
}

void Sheets::card_front(Canvas& canvas, std::size_t i, const Rect& card) {
  const double side = card.height - 8;
  const Rect box{card.x + (card.width - side) / 2, card.y + 4, side, side};
  used_.insert(i);
  canvas.character(static_cast<int>(i), box, 0);
  if (s_.numbers) draw_numbers(canvas, characters_[i].character, box);
  const char32_t text[] = {characters_[i].character.code_point};
  canvas.text(box.x, box.y + side * 0.88, {text, 1}, side, 0, true);
}

void Sheets::card_back(Canvas& /*canvas*/, std::size_t i, const Rect& card) {
  const Rect inside{card.x + 5, card.y + 5, card.width - 10, card.height - 10};
  draw_facts(characters_[i], Flow(inside, false), 0, 0, inside.width, inside.height);
}

void Sheets::cards() {
  const double width = size_.width - 2 * kMargin_mm - 2 * kCutMark_mm;
  const double height = size_.height - 2 * kMargin_mm - 2 * kCutMark_mm - kFooter_mm;
  const int columns = std::max(1, static_cast<int>(width / kCardWidth_mm));
  const int rows = std::max(1, static_cast<int>(height / kCardHeight_mm));
  const double card_width = std::min(kCardWidth_mm, width);
  const double left = (size_.width - columns * card_width) / 2;
  const double top = kMargin_mm + kCutMark_mm;
  const auto on_page = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  for (std::size_t first = 0; first < characters_.size(); first += on_page) {
    for (const bool back : {false, true}) {
      Canvas& canvas = new_page(false);
      const Pen pen{0.3, 0.15, 0};
      for (int c = 0; c <= columns; ++c) {
        const double x = left + c * card_width;
        canvas.line(x, top - kCutMark_mm, x, top - 1, pen);
        canvas.line(x, top + rows * kCardHeight_mm + 1, x, top + rows * kCardHeight_mm + kCutMark_mm, pen);
      }
      for (int r = 0; r <= rows; ++r) {
        const double y = top + r * kCardHeight_mm;
        canvas.line(left - kCutMark_mm, y, left - 1, y, pen);
        canvas.line(left + columns * card_width + 1, y, left + columns * card_width + kCutMark_mm, y, pen);
      }
      for (std::size_t i = first; i < std::min(first + on_page, characters_.size()); ++i) {
        const int place = static_cast<int>(i - first);
        // Turned over at its long side, a sheet has its left column on the right.
        const int column = back ? columns - 1 - place % columns : place % columns;
        const int row = place / columns;
        const Rect card{left + column * card_width, top + row * kCardHeight_mm, card_width, kCardHeight_mm};
        if (back) {
          card_back(canvas, i, card);
        } else {
          card_front(canvas, i, card);
        }
      }
    }
  }
}

void Sheets::manuscript() {
  const Rect all{kMargin_mm, kMargin_mm, size_.width - 2 * kMargin_mm,
                 size_.height - 2 * kMargin_mm - kFooter_mm};
  constexpr double kColumnInCells = 1.4;  // with the gap for readings to its right
  const double columns_wide = (kManuscriptCells + 1) * kColumnInCells;
  const double cell = std::min(all.width / columns_wide, all.height / kManuscriptCells);
  const double left = all.x + (all.width - columns_wide * cell) / 2;
  const double top = all.y + (all.height - kManuscriptCells * cell) / 2;
  const auto cell_at = [&](int place) {
    const int column = place / kManuscriptCells;
    // The middle of the sheet, where it is folded, stays free.
    const double from_right = (column + (column >= kManuscriptCells / 2 ? 1 : 0) + 1) * kColumnInCells * cell;
    return Rect{left + columns_wide * cell - from_right, top + place % kManuscriptCells * cell, cell, cell};
  };
  const auto sheet = [&]() -> Canvas& {
    Canvas& canvas = new_page(false);
    for (int place = 0; place < kManuscriptCells * kManuscriptCells; ++place)
      canvas.rectangle(cell_at(place), {0.55, 0.2, 0});
    return canvas;
  };
  Canvas* canvas = &sheet();
  constexpr int kCells = kManuscriptCells * kManuscriptCells;
  const std::u32string_view closing = U"、。，．」』）";
  int place = 0;
  for (const char32_t letter : wide(s_.text)) {
    if (letter == U'\r') continue;
    if (letter == U'\n') {
      place = (place + kManuscriptCells - 1) / kManuscriptCells * kManuscriptCells;
      continue;
    }
    // A sign that closes does not begin a column: it shares the last cell of the one before.
    const bool shares =
        place > 0 && place % kManuscriptCells == 0 && closing.find(letter) != std::u32string_view::npos;
    if (!shares && place >= kCells) {
      canvas = &sheet();
      place = 0;
    }
    const Rect box = cell_at(shares ? place - 1 : place);
    const double size = cell * 0.84;
    const double inset = (cell - size) / 2;
    canvas->vertical_letter(box.x + inset, box.y + inset + (shares ? cell * 0.12 : 0), letter, size, 0.5);
    if (!shares) ++place;
  }
}

base::Result<void> Sheets::draw(const base::Progress& progress) {
  if (s_.layout == Layout::manuscript) {
    manuscript();
  } else if (s_.layout == Layout::cards) {
    cards();
  } else if (s_.layout == Layout::quiz) {
    quiz();
    if (pages_.empty())
      return base::fail(base::Errc::bad_argument, "none of the characters has a word to ask", "quiz",
                        "choose other characters");
  } else {
    for (std::size_t i = 0; i < characters_.size(); ++i) {
      if (i % 64 == 0 && progress &&
          !progress(static_cast<double>(i) / static_cast<double>(characters_.size()), "drawing the sheets"))
        return base::fail(base::Errc::cancelled, "stopped", "worksheet");
      practice(i);
    }
  }
  return {};
}

std::string Sheets::file() {
  PdfWriter pdf;
  const int catalogue = pdf.reserve();
  const int tree = pdf.reserve();
  const int information = pdf.reserve();
  const int resources = pdf.reserve();
  std::string fonts;
  for (std::size_t i = 0; i < fonts_.count(); ++i) {
    if (fonts_.at(i).used().empty()) continue;
    const int number = pdf.reserve();
    fonts += fmt::format("/F{} {} 0 R ", i, number);
    pdf.write_font(number, fonts_.at(i));
  }
  const auto box = [](double width, double height) {
    return fmt::format("[0 0 {} {}]", number(width * kPoints), number(height * kPoints));
  };
  std::string objects;
  for (const auto& [kind, name] : cells_) {
    const double side = static_cast<double>(kind.first) / 1000;
    constexpr double kRoom_mm = 1;  // for the width of its lines
    Canvas canvas(fonts_, side);
    if (kind.second) {
      draw_cell(canvas, {0, 0, side, side}, s_.guide);
    } else {
      canvas.rectangle({0, 0, side, side}, {0.7, 0.15, 0});
    }
    const int number_of = pdf.reserve();
    objects += fmt::format("/{} {} 0 R ", name, number_of);
    const std::string low = number(-kRoom_mm * kPoints);
    const std::string high = number((side + kRoom_mm) * kPoints);
    pdf.write_stream(number_of,
                     fmt::format("/Type /XObject /Subtype /Form /BBox [{0} {0} {1} {1}]", low, high),
                     canvas.content());
  }
  for (const std::size_t i : used_) {
    const int number = pdf.reserve();
    objects += fmt::format("/C{} {} 0 R ", i, number);
    const kanji::Character& character = characters_[i].character;
    pdf.write_stream(number, "/Type /XObject /Subtype /Form /BBox [-3 -3 112 112]",
                     strokes_content(character, 0, character.strokes.size()));
  }
  std::vector<int> sheets;
  const auto add_sheet = [&](double width, double height, const std::string& content) {
    const int stream = pdf.reserve();
    const int sheet = pdf.reserve();
    pdf.write_stream(stream, "", content);
    pdf.write(sheet,
              fmt::format("<< /Type /Page /Parent {} 0 R /MediaBox {} /Resources {} 0 R /Contents {} 0 R >>",
                          tree, box(width, height), resources, stream));
    sheets.push_back(sheet);
  };
  if (s_.booklet) {
    std::vector<int> halves;
    for (const auto& page : pages_) {
      const int number = pdf.reserve();
      halves.push_back(number);
      pdf.write_stream(number,
                       fmt::format("/Type /XObject /Subtype /Form /BBox {} /Resources {} 0 R",
                                   box(size_.width, size_.height), resources),
                       page->content());
      objects += fmt::format("/P{} {} 0 R ", halves.size() - 1, number);
    }
    const std::size_t count = (halves.size() + 3) / 4 * 4;
    // A vertical text is read from right to left, so the booklet opens at its other side.
    const auto side = [&](std::size_t left, std::size_t right) {
      if (s_.vertical) std::swap(left, right);
      std::string content;
      if (left < halves.size()) content += fmt::format("/P{} Do\n", left);
      if (right < halves.size())
        content += fmt::format("q 1 0 0 1 {} 0 cm /P{} Do Q\n", number(size_.width * kPoints), right);
      add_sheet(2 * size_.width, size_.height, content);
    };
    for (std::size_t i = 0; i < count / 4; ++i) {
      side(count - 1 - 2 * i, 2 * i);
      side(2 * i + 1, count - 2 - 2 * i);
    }
  } else {
    for (const auto& page : pages_) add_sheet(size_.width, size_.height, page->content());
  }
  pdf.write(resources, fmt::format("<< /Font << {}>> /XObject << {}>> >>", fonts, objects));
  std::string kids;
  for (const int sheet : sheets) kids += fmt::format("{} 0 R ", sheet);
  pdf.write(tree, fmt::format("<< /Type /Pages /Kids [{}] /Count {} >>", kids, sheets.size()));
  pdf.write(catalogue, fmt::format("<< /Type /Catalog /Pages {} 0 R /Lang ({}) >>", tree,
                                   s_.language == Language::japanese ? "ja" : "en"));
  pdf.write(information, fmt::format("<< /Title {} /Producer (Nazori) >>", pdf_text(s_.title)));
  return pdf.finish(catalogue, information);
}

base::Result<void> check(const std::vector<SheetCharacter>& characters, const SheetSettings& s) {
  const auto refuse = [](const std::string& what, const std::string& remedy) {
    return base::fail(base::Errc::bad_argument, what, "worksheet", remedy);
  };
  if (s.layout != Layout::manuscript && characters.empty())
    return refuse("there is no character to print", "give one or more");
  if (!(s.cell_mm >= kSmallestCell_mm && s.cell_mm <= kLargestCell_mm))
    return refuse(fmt::format("a cell cannot be {:.4g} mm", s.cell_mm), "give 8 to 60 mm");
  if (s.rows < 0 || s.rows > 40 || s.copies < 0 || s.copies > 40)
    return refuse("the number of rows or copies is out of range", "give 0 to 40");
  if (s.layout == Layout::practice && !s.whole_page) {
    const Size size = size_of(s);
    const double depth = (s.vertical ? size.width : size.height - kHeader_mm - kFooter_mm) - 2 * kMargin_mm;
    const double model = std::clamp(s.cell_mm * 1.6, kSmallestModel_mm, kLargestModel_mm);
    // Thirty steps take three rows at most on any paper but the narrowest.
    if (model + kGap_mm + s.rows * s.cell_mm + (s.steps ? 4 * std::min(s.cell_mm, kLargestStep_mm) : 0) >
        depth)
      return refuse(fmt::format("{} rows of {:.4g} mm do not fit on a page", s.rows, s.cell_mm),
                    "take fewer rows or smaller cells");
  }
  return {};
}

}  // namespace

base::Result<std::string> worksheet_pdf(const std::vector<SheetCharacter>& characters,
                                        const SheetSettings& settings, const base::Progress& progress) {
  if (auto fine = check(characters, settings); !fine) return tl::unexpected(std::move(fine.error()));
  auto fonts = Fonts::installed();
  if (!fonts) return tl::unexpected(std::move(fonts.error()));
  Sheets sheets(characters, settings, *std::move(fonts));
  if (auto drawn = sheets.draw(progress); !drawn) return tl::unexpected(std::move(drawn.error()));
  return sheets.file();
}

}  // namespace nazori::print
