// SPDX-License-Identifier: Apache-2.0
#include "sheets.h"

#include <cstddef>
#include <deque>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "nazori/base/utf8.h"
#include "nazori/kanji/own_characters.h"
#include "nazori/kanji/search_keys.h"

namespace nazori::print {

namespace {

/// An own character as a word of one letter: no dictionary has words with it.
kanji::Word as_word(const kanji::Character& own) {
  kanji::Word word;
  word.text = base::encode_utf8(own.code_point);
  word.reading = kanji::first_reading(own.entry);
  const std::string meaning = kanji::first_meaning(own.entry);
  if (!meaning.empty()) word.glosses = {meaning};
  return word;
}

}  // namespace

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
      place_text(canvas, characters_[known->second], {box.x + inset, box.y + inset, size, size});
    }
  }
}

bool Sheets::add_to_mark(const kanji::Word& word) {
  MarkedRun run{used_depth_, 1, {}};
  for (const char32_t letter : wide(word.text))
    run.characters.push_back(index_.contains(base::encode_utf8(letter)) ? letter : 0);
  mark_->runs.push_back(std::move(run));
  if (mark_bytes(*mark_, mark_room(size_.width))) return true;
  mark_->runs.pop_back();
  return false;
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
  std::deque<kanji::Word> made;  // lines refer to them
  for (const SheetCharacter& one : characters_) {
    const Flow flow(area(), s_.vertical);
    std::span<const kanji::Word> words = one.words;
    if (words.empty() && kanji::is_own(one.character.code_point)) {
      made.push_back(as_word(one.character));
      words = {&made.back(), 1};
    }
    for (const kanji::Word& word : words) {
      const double cells = static_cast<double>(wide(word.text).size()) * s_.cell_mm;
      if (cells > flow.length() * 0.6 || !asked.insert(word.text).second) continue;
      const bool is_full = lines.empty() || used_depth_ + s_.cell_mm > flow.depth() + 1e-6;
      if (is_full || !add_to_mark(word)) {
        close();
        lines.clear();
        new_page(true);
        add_to_mark(word);
      }
      quiz_line(word, flow, used_depth_, *pages_.back(), false);
      lines.push_back({&word, used_depth_});
      used_depth_ += s_.cell_mm + kGap_mm;
      break;
    }
  }
  close();
}

}  // namespace nazori::print
