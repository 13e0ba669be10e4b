// SPDX-License-Identifier: Apache-2.0
// What the trees are told of each stroke, for train_stroke_trees.py:
//   nazori_stroke_features KANJI.DB < DRAWINGS > FEATURES
//   nazori_stroke_features KANJI.DB --models > DRAWINGS
// A line of DRAWINGS: the code point, 1 for a beginning and 0 for a whole, the number of strokes, and for
// each stroke the number of its points and their x and y in a box of side 1. A line of FEATURES: for each
// stroke that was matched one for one the drawn stroke, the model's, 1 if it is drawn backwards, and the
// features, all separated by spaces; nothing where another number of strokes was found than the model has.
// With --models the models themselves are printed as drawings.
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include "alignment.h"
#include "grade_shapes.h"
#include "nazori/kanji/kanji_database.h"
#include "nazori/writing/model_library.h"
#include "strangeness.h"

namespace nazori::writing::training {
namespace {

struct Task {
  char32_t character = 0;
  bool is_beginning = false;
  WrittenCharacter ink;
};

std::optional<Task> task_of(const std::string& line) {
  std::istringstream in(line);
  Task task;
  unsigned long character = 0;
  std::size_t count = 0;
  if (!(in >> character >> task.is_beginning >> count)) return {};
  task.character = static_cast<char32_t>(character);
  task.ink.box = WritingBox{};
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t points = 0;
    in >> points;
    WrittenStroke stroke(points);
    for (auto& p : stroke) in >> p.at.x >> p.at.y;
    task.ink.strokes.push_back(stroke);
  }
  return in ? std::optional(task) : std::nullopt;
}

bool is_one_for_one(const Alignment& alignment) {
  for (const auto& l : alignment.links)
    if (l.drawn_count != 1 || l.model_count != 1) return false;
  return true;
}

void print_features(const Task& task, const Form& form) {
  const auto prepared = prepare(task.ink, {});
  if (!prepared) return;
  const auto extent = task.is_beginning ? Extent::beginning : Extent::whole;
  const auto alignment = align({prepared->drawn, form.shapes, form.pairs, prepared->box, extent});
  if (!alignment.extra.empty() || (!task.is_beginning && !alignment.missing.empty()) ||
      !is_one_for_one(alignment))
    return;
  const auto strokes = judged_strokes(alignment, prepared->drawn, form);
  const auto features = stroke_features(strokes, form.shapes.size(), alignment.map);
  for (std::size_t k = 0; k < features.size(); ++k) {
    const auto& link = alignment.links[k];
    std::printf("%d %d %d ", link.drawn, link.model, int{link.difference.reversed});
    for (const float value : features[k]) std::printf("%.6g ", static_cast<double>(value));
  }
}

int print_models(const kanji::KanjiDatabase& database) {
  for (const auto& summary : database.list(kanji::List::all)) {
    const auto character = database.find(summary.code_point);
    std::printf("%lu 0 %zu", static_cast<unsigned long>(summary.code_point), character->strokes.size());
    for (const auto& stroke : character->strokes) {
      std::printf(" %zu", stroke.line.points.size());
      for (const auto& p : stroke.line.points)
        std::printf(" %.5f %.5f", p.x / geometry::kGlyphSide, p.y / geometry::kGlyphSide);
    }
    std::puts("");
  }
  return 0;
}

int print_all_features(const kanji::KanjiDatabase& database) {
  ModelLibrary library(database);
  for (std::string line; std::getline(std::cin, line);) {
    const auto task = task_of(line);
    if (!task) {
      std::fputs("a line is no drawing\n", stderr);
      return 2;
    }
    if (const auto entry = library.find(task->character))
      print_features(*task, (*entry)->model.inside().main);
    std::puts("");
  }
  return 0;
}

}  // namespace
}  // namespace nazori::writing::training

int main(int argc, char** argv) {
  using namespace nazori;
  const bool models = argc == 3 && argv[2] == std::string_view("--models");
  if (argc != 2 && !models) {
    std::fputs("usage: nazori_stroke_features KANJI.DB [--models] < DRAWINGS > FEATURES\n", stderr);
    return 2;
  }
  const auto database = kanji::KanjiDatabase::open(argv[1]);
  if (!database) {
    std::fprintf(stderr, "%s: no database of kanji\n", argv[1]);
    return 2;
  }
  return models ? writing::training::print_models(*database)
                : writing::training::print_all_features(*database);
}
