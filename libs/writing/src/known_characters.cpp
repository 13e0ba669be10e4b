// SPDX-License-Identifier: Apache-2.0
#include "known_characters.h"

#include <algorithm>
#include <map>
#include <string>

#include "handwritten_forms.h"
#include "ink_moments.h"
#include "nazori/base/utf8.h"

namespace nazori::writing {
namespace {

/// A few points of each curve are enough, because they are resampled for comparison.
template <class Take>
void points_of(const geometry::BezierPath& path, Take&& take) {
  auto from = path.start;
  take(from);
  for (const auto& piece : path.pieces) {
    for (const double t : {0.25, 0.5, 0.75}) {
      const double s = 1 - t;
      take(from * (s * s * s) + piece[0] * (3 * s * s * t) + piece[1] * (3 * s * t * t) +
           piece[2] * (t * t * t));
    }
    take(piece[2]);
    from = piece[2];
  }
}

}  // namespace

std::vector<FlatLine> KnownCharacters::lines_of(const Known& known) const {
  std::vector<FlatLine> result;
  for (std::size_t k = 0; k < known.strokes; ++k) result.push_back(line(known.first_stroke + k));
  return result;
}

void KnownCharacters::begin_character(char32_t code_point, int place) {
  characters_.push_back({code_point, place, points_.size(), 0, 0});
}

void KnownCharacters::add_point(geometry::GlyphPoint p) {
  lines_.push_back(static_cast<float>(p.x));
  lines_.push_back(static_cast<float>(p.y));
}

void KnownCharacters::end_stroke() {
  const std::size_t start = starts_.empty() ? 0 : starts_.back();
  if (starts_.empty()) starts_.push_back(0);
  starts_.push_back(lines_.size());
  points_.push_back(three_points(FlatLine(lines_).subspan(start)));
  ++characters_.back().strokes;
}

void KnownCharacters::add_path(const geometry::BezierPath& path) {
  points_of(path, [this](geometry::GlyphPoint p) { add_point(p); });
  end_stroke();
}

void KnownCharacters::add_form(std::size_t character, std::span<const FlatLine> lines) {
  forms_.push_back({character, embed(trained_weights(), make_field(lines)), ink_points(lines)});
}

InkDistance KnownCharacters::ink_distance(const InkPoints& drawn, std::size_t character) const {
  auto least = writing::ink_distance(drawn, forms_[character].points);
  for (std::size_t i = characters_.size(); i < forms_.size(); ++i) {
    if (forms_[i].character != character) continue;
    const auto other = writing::ink_distance(drawn, forms_[i].points);
    if (other.drawn + other.model < least.drawn + least.model) least = other;
  }
  return least;
}

void KnownCharacters::add_handwritten_forms() {
  std::map<char32_t, std::size_t> index;
  for (std::size_t i = 0; i < characters_.size(); ++i) index.emplace(characters_[i].code_point, i);
  for (const auto& form : handwritten_forms()) {
    const auto known = index.find(form.character);
    if (known == index.end()) continue;
    std::vector<std::vector<float>> lines;
    std::string_view rest = form.strokes;
    while (!rest.empty()) {
      const auto end = std::min(rest.find('|'), rest.size());
      auto& line = lines.emplace_back();
      if (const auto path = geometry::parse_svg_path(std::string(rest.substr(0, end))))
        points_of(*path, [&line](geometry::GlyphPoint p) {
          line.push_back(static_cast<float>(p.x));
          line.push_back(static_cast<float>(p.y));
        });
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    add_form(known->second, std::vector<FlatLine>(lines.begin(), lines.end()));
  }
}

void KnownCharacters::finish() {
  std::erase_if(characters_, [](const Known& k) { return k.strokes == 0; });
  std::stable_sort(characters_.begin(), characters_.end(),
                   [](const Known& a, const Known& b) { return a.place < b.place; });
  pictures_.reserve(characters_.size());
  forms_.reserve(characters_.size() + handwritten_forms().size());
  for (auto& k : characters_) {
    const auto lines = lines_of(k);
    pictures_.push_back(make_picture(lines));
    add_form(forms_.size(), lines);
    k.extent = extent_of(lines);
  }
  add_handwritten_forms();
}

Form KnownCharacters::form(const Known& known) const {
  Form form;
  form.shapes.reserve(known.strokes);
  std::vector<double> xs;
  std::vector<double> ys;
  for (std::size_t k = 0; k < known.strokes; ++k) {
    const auto points = line(known.first_stroke + k);
    xs.clear();
    ys.clear();
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
      xs.push_back(static_cast<double>(points[i]));
      ys.push_back(static_cast<double>(points[i + 1]));
    }
    form.shapes.push_back(make_shape(xs, ys));
  }
  return form;
}

base::Result<KnownCharacters> KnownCharacters::load(const kanji::KanjiDatabase& database) {
  KnownCharacters all;
  char32_t current = 0;
  char32_t damaged = 0;
  database.for_each_stroke([&](const kanji::StrokePath& stroke) {
    const auto path = geometry::parse_svg_path(stroke.path);
    if (!path) damaged = stroke.code_point;
    if (!path) return;
    if (all.characters_.empty() || stroke.code_point != current)
      all.begin_character(stroke.code_point, stroke.place);
    current = stroke.code_point;
    all.add_path(*path);
  });
  if (database.trouble()) return tl::unexpected(*database.trouble());
  if (damaged != 0)
    return base::fail(base::Errc::schema, "A stroke of this character is no path.",
                      base::encode_utf8(damaged), "build it again: nazori-cli database build");
  all.finish();
  if (all.characters_.empty())
    return base::fail(base::Errc::not_found, "the database has no characters with strokes", {},
                      "build it again: nazori-cli database build");
  return all;
}

base::Result<KnownCharacters> KnownCharacters::load(const std::vector<kanji::Character>& characters) {
  KnownCharacters all;
  int place = 0;
  for (const auto& c : characters) {
    all.begin_character(c.code_point, place++);
    for (const auto& s : c.strokes) {
      if (s.line.points.empty()) continue;
      for (const auto& p : s.line.points) all.add_point(p);
      all.end_stroke();
    }
  }
  all.finish();
  if (all.characters_.empty()) return base::fail(base::Errc::not_found, "none of the characters has strokes");
  return all;
}

}  // namespace nazori::writing
