// SPDX-License-Identifier: Apache-2.0
// How well strokes are recovered from carved characters of kanji.db.
//   nazori_author_figures KANJI.DB [EVERY [known|unknown|moved [CHARACTER]]]
// carves every EVERYth character at 512 x 512, traces the map and compares the strokes with KanjiVG's.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "line_comparison.h"
#include "moved_model.h"
#include "nazori/author/trace.h"
#include "nazori/base/utf8.h"
#include "nazori/carving/carve.h"
#include "nazori/kanji/kanji_database.h"

namespace {

using namespace nazori;
using namespace nazori::author::test;

constexpr double kWithin = 109.0 / 128;

struct Figures {
  int characters = 0;
  int failed = 0;
  int strokes = 0;
  int found = 0;  // as many as there are
  int mean = 0;
  int most_of_95 = 0;
  int most = 0;
  int ending = 0;
  int both = 0;
  int direction = 0;
  int right_count = 0;
  double seconds = 0;
  double slowest = 0;
};

void print(const char* name, const Figures& f) {
  const auto share = [&](int n) { return 100.0 * n / std::max(1, f.strokes); };
  std::printf(
      "%s: %d characters (%d refused), %d strokes; within %.2f units: mean %.2f %%, 95th percentile %.2f %%, "
      "maximum %.2f %%; ending of the ink %.2f %%; mean and ending %.2f %%; direction %.2f %%; characters "
      "with "
      "the right number of strokes %.1f %%; %.1f ms a character, %.0f ms the slowest\n",
      name, f.characters, f.failed, f.strokes, kWithin, share(f.mean), share(f.most_of_95), share(f.most),
      share(f.ending), share(f.both), share(f.direction), 100.0 * f.right_count / std::max(1, f.characters),
      1000 * f.seconds / std::max(1, f.characters), 1000 * f.slowest);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "";
  const int every = argc > 2 ? std::atoi(argv[2]) : 1;
  const std::string what = argc > 3 ? argv[3] : "";
  const std::string only = argc > 4 ? argv[4] : "";
  auto database = kanji::KanjiDatabase::open(path);
  if (!database) {
    std::fprintf(stderr, "%s\n", base::to_line(database.error()).c_str());
    return 1;
  }
  for (const std::string mode : {"known", "moved", "unknown"}) {
    if (!what.empty() && what != mode) continue;
    Figures f;
    int number = 0;
    for (const kanji::Summary& summary : database->list(kanji::List::all)) {
      if (number++ % every != 0 && only.empty()) continue;
      if (!only.empty() && base::encode_utf8(summary.code_point) != only) continue;
      const auto character = database->find(summary.code_point);
      if (!character) continue;
      std::vector<kanji::StrokeLine> truth;
      std::vector<GlyphLine> lines;
      for (const kanji::Stroke& s : character->strokes) {
        truth.push_back(s.line);
        lines.push_back(s.line.points);
      }
      const auto map = carving::carve(truth, 512);
      ++f.characters;
      f.strokes += static_cast<int>(truth.size());
      const auto start = std::chrono::steady_clock::now();
      std::vector<author::OwnStroke> found;
      std::vector<kanji::StrokeEnding> endings;
      bool failed = false;
      if (mode == "unknown") {
        auto strokes = author::trace(*map);
        failed = !strokes;
        if (strokes) found = *std::move(strokes);
        for (const auto& s : found) endings.push_back(s.ending);
      } else {
        const auto model = mode == "moved" ? moved(truth, summary.code_point) : truth;
        auto strokes = author::trace_as(*map, model);
        failed = !strokes;
        if (strokes)
          for (auto& s : *strokes) {
            endings.push_back(s.ending_of_ink);
            found.push_back(std::move(s.stroke));
          }
      }
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
      f.seconds += took.count();
      f.slowest = std::max(f.slowest, took.count());
      if (failed) {
        ++f.failed;
        continue;
      }
      if (found.size() == truth.size()) ++f.right_count;
      std::vector<GlyphLine> found_lines;
      for (const auto& s : found) found_lines.push_back(line_of(s));
      std::vector<std::ptrdiff_t> match;
      if (mode == "unknown") {
        match = matched(lines, found_lines);
      } else {
        for (std::size_t t = 0; t < lines.size(); ++t) match.push_back(static_cast<std::ptrdiff_t>(t));
      }
      for (std::size_t t = 0; t < lines.size(); ++t) {
        if (match[t] < 0) {
          if (!only.empty()) std::printf("%zu: none\n", t + 1);
          continue;
        }
        const auto k = static_cast<std::size_t>(match[t]);
        const LineDistance d = distance_of(lines[t], found_lines[k]);
        const bool is_ending =
            endings[k] == truth[t].ending ||
            (endings[k] == kanji::StrokeEnding::stop && truth[t].ending == kanji::StrokeEnding::either);
        const GlyphPoint way = lines[t].back() - lines[t].front();
        const GlyphPoint own = found_lines[k].back() - found_lines[k].front();
        f.mean += d.mean <= kWithin ? 1 : 0;
        f.most_of_95 += d.most_of_95 <= kWithin ? 1 : 0;
        f.most += d.most <= kWithin ? 1 : 0;
        f.ending += is_ending ? 1 : 0;
        f.both += d.mean <= kWithin && is_ending ? 1 : 0;
        f.direction += geometry::dot(way, own) > 0 ? 1 : 0;
        if (!only.empty() || std::getenv("VERBOSE") != nullptr)
          if (!only.empty() || d.most_of_95 > kWithin || !is_ending)
            std::printf(
                "%s %zu: mean %.2f, 95 %% %.2f, most %.2f; ending %d, is %d; (%.0f,%.0f)-(%.0f,%.0f) is "
                "(%.0f,%.0f)-(%.0f,%.0f)\n",
                base::encode_utf8(summary.code_point).c_str(), t + 1, d.mean, d.most_of_95, d.most,
                static_cast<int>(endings[k]), static_cast<int>(truth[t].ending), found_lines[k].front().x,
                found_lines[k].front().y, found_lines[k].back().x, found_lines[k].back().y,
                lines[t].front().x, lines[t].front().y, lines[t].back().x, lines[t].back().y);
      }
    }
    print(mode.c_str(), f);
  }
  return 0;
}
