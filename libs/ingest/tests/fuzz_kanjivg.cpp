// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "nazori/ingest/kanjivg.h"

/// Any bytes are either refused or give strokes that belong to groups, all within or near the box.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto form = nazori::ingest::parse_kanjivg_svg(
      {U'休', {}}, std::span<const char>(reinterpret_cast<const char*>(data), size));
  if (!form) return 0;
  if (form->strokes.empty() || form->components.strokes.size() != form->strokes.size()) std::abort();
  for (const auto& stroke : form->strokes) {
    if (stroke.line.points.empty()) std::abort();
    for (const auto p : stroke.line.points) {
      if (!(p.x >= -200 && p.x <= 400 && p.y >= -200 && p.y <= 400)) std::abort();
    }
  }
  return 0;
}
