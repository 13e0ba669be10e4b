// SPDX-License-Identifier: Apache-2.0
#include "endings.h"

namespace nazori::writing {

std::vector<Fault> ending_faults(std::span<const Shape> drawn, const Alignment& alignment, const Form& form) {
  std::vector<Fault> faults;
  for (const auto& link : alignment.links) {
    if (link.drawn_count != 1 || link.model_count != 1 || link.difference.reversed) continue;
    const auto j = static_cast<std::size_t>(link.model);
    if (form.free_ending[j] != 0) continue;
    const bool kick = drawn[static_cast<std::size_t>(link.drawn)].kicked;
    const auto& model = form.shapes[j];
    const auto ending = form.endings[j];
    // A kick is asked for only where the model's own line has one; a bend that looks like one is no kick.
    const bool missing = ending == kanji::StrokeEnding::hook && model.kicked && !kick;
    const bool needless = ending == kanji::StrokeEnding::stop && !model.kicked && kick;
    if (!missing && !needless) continue;
    Fault fault{FaultKind::ending, link.drawn, {}, {link.model}};
    fault.expected = ending;
    faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace nazori::writing
