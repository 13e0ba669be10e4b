// SPDX-License-Identifier: Apache-2.0
#include "endings.h"

namespace nazori::writing {

std::vector<Mistake> ending_mistakes(std::span<const Shape> drawn, const Alignment& alignment,
                                     const Form& form) {
  std::vector<Mistake> mistakes;
  for (const auto& link : alignment.links) {
    if (link.drawn_count != 1 || link.model_count != 1 || link.difference.reversed) continue;
    const auto j = static_cast<std::size_t>(link.model);
    if (form.free_ending[j] != 0) continue;
    const bool kick = drawn[static_cast<std::size_t>(link.drawn)].kicked;
    const auto& model = form.shapes[j];
    const auto ending = form.endings[j];
    // A hook is required only where the model's own line has one; a bend that looks like one does not count.
    const bool missing = ending == kanji::StrokeEnding::hook && model.kicked && !kick;
    const bool needless = ending == kanji::StrokeEnding::stop && !model.kicked && kick;
    if (!missing && !needless) continue;
    Mistake mistake{kanji::MistakeKind::ending, link.drawn, {}, {link.model}};
    mistake.expected = ending;
    mistakes.push_back(std::move(mistake));
  }
  return mistakes;
}

}  // namespace nazori::writing
