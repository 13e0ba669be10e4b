// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/trace.h"

#include <string>
#include <utility>

#include "gaps.h"
#include "groove_line.h"
#include "ink_graph.h"
#include "ink_map.h"
#include "junctions.h"
#include "model_fit.h"
#include "nazori/scan/paper_alone.h"
#include "stroke_guess.h"

namespace nazori::author {
namespace {

base::Result<std::vector<OwnStroke>> strokes_of(const InkMap& map) {
  const InkGraph graph = divided_at_gaps(middle_lines(map), map);
  const Arms arms = arms_of(graph, map, map.is_groove ? kGrooveReach : kInkReach);
  std::vector<GridLine> lines = divided(joined(arms), map);
  if (lines.size() > kMostTracedStrokes) {
    return base::fail(
        base::Errc::bad_argument,
        "there are " + std::to_string(lines.size()) + " separate lines, too many for one character", {},
        "cut the picture to one character, without patterns and noise");
  }
  std::vector<OwnStroke> strokes;
  for (GridLine& line : lines) {
    const bool is_closed = line.front() == line.back();
    centre_ends(line, map, !is_closed, !is_closed);
    OwnStroke stroke = groove_along(line, map);
    lengthen_tips(stroke);
    direct(stroke);
    stroke.ending = ending_of_ink(stroke);
    strokes.push_back(std::move(stroke));
  }
  put_in_order(strokes);
  return strokes;
}

template <class Picture>
base::Result<std::vector<FittedStroke>> fitted_to(const Picture& picture,
                                                  std::span<const kanji::StrokeLine> character) {
  if (auto fine = check_known(character); !fine) return tl::unexpected(fine.error());
  const auto ink = ink_of(picture);
  if (!ink) return tl::unexpected(ink.error());
  return fitted(*ink, character);
}

}  // namespace

base::Result<std::vector<OwnStroke>> trace(const surface::HeightMap& map) {
  const auto ink = ink_of(map);
  if (!ink) return tl::unexpected(ink.error());
  return strokes_of(*ink);
}

base::Result<std::vector<OwnStroke>> trace(const scan::Photo& photo) {
  const auto ink = ink_of(scan::paper_alone(photo));
  if (!ink) return tl::unexpected(ink.error());
  return strokes_of(*ink);
}

base::Result<std::vector<FittedStroke>> trace_as(const surface::HeightMap& map,
                                                 std::span<const kanji::StrokeLine> character) {
  return fitted_to(map, character);
}

base::Result<std::vector<FittedStroke>> trace_as(const scan::Photo& photo,
                                                 std::span<const kanji::StrokeLine> character) {
  return fitted_to(scan::paper_alone(photo), character);
}

}  // namespace nazori::author
