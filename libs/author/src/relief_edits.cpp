// SPDX-License-Identifier: Apache-2.0
/// The edits of the relief by hand; those of strokes are in character_editor.cpp.
#include <cstddef>
#include <string>
#include <utility>

#include "change.h"
#include "hand_layer.h"
#include "nazori/author/character_editor.h"

namespace nazori::author {
namespace {

using carving::GridBox;

tl::unexpected<base::Error> refuse(std::string what, std::string remedy = {}) {
  return base::fail(base::Errc::bad_argument, std::move(what), "map", std::move(remedy));
}

EditKind kind_of(ReliefTool tool) {
  switch (tool) {
    case ReliefTool::groove:
      return EditKind::groove;
    case ReliefTool::raise:
      return EditKind::raise;
    case ReliefTool::smooth:
      return EditKind::smooth;
    case ReliefTool::erase:
      return EditKind::erase;
  }
  return EditKind::none;
}

/// The change from one layer to another that differs in a box.
Change layer_change(EditKind kind, const HandLayer& before, HandLayer after, const GridBox& box) {
  Change change{.kind = kind};
  if (before.is_untouched() || before.size == after.size)
    change.patch = Change::Patch{box, after.size, cut_out(after, box)};
  else
    change.layer = std::move(after);
  return change;
}

}  // namespace

CharacterEditor::Touched CharacterEditor::use_tool(ReliefTool tool, const ToolSettings& settings,
                                                   const geometry::WrittenStroke<geometry::GlyphFrame>& pen) {
  HandLayer hand = resampled(character_.hand, map_.size());
  auto box = author::use_tool(tool, settings, pen, map_, hand);
  if (!box || box->is_empty()) return box;
  return apply(layer_change(kind_of(tool), character_.hand, std::move(hand), *box));
}

CharacterEditor::Touched CharacterEditor::press_stamp(const surface::HeightMap& stamp,
                                                      const StampSettings& settings,
                                                      geometry::GlyphPoint at) {
  HandLayer hand = resampled(character_.hand, map_.size());
  auto box = author::press_stamp(stamp, settings, at, map_, hand);
  if (!box || box->is_empty()) return box;
  return apply(layer_change(EditKind::stamp, character_.hand, std::move(hand), *box));
}

CharacterEditor::Touched CharacterEditor::load_relief(const surface::HeightMap& map) {
  if (!map.is_loaded()) return refuse("is empty");
  if (map.size() > map_.size())
    return refuse("has more samples than the tablet",
                  "give at most " + std::to_string(map_.size()) + " a side");
  const auto strokes = carving::carve_grooves(grooves_of(character_.strokes), map.size());
  if (!strokes) return tl::unexpected(strokes.error());
  HandLayer layer{map.size(), {}};
  layer.heights.reserve(map.samples().size());
  for (std::size_t i = 0; i < map.samples().size(); ++i)
    layer.heights.push_back(map.samples()[i] - strokes->samples()[i]);
  return apply({.kind = EditKind::load_relief, .layer = std::move(layer)});
}

CharacterEditor::Touched CharacterEditor::clear_relief() {
  if (character_.hand.is_untouched()) return GridBox{};
  return apply({.kind = EditKind::clear_relief, .layer = HandLayer{}});
}

}  // namespace nazori::author
