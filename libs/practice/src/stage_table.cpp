// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/stage_table.h"

#include <algorithm>
#include <array>

#include "nazori/practice/dictation_stage.h"
#include "nazori/practice/guided_stage.h"
#include "nazori/practice/memory_stage.h"
#include "nazori/practice/trace_stage.h"
#include "nazori/practice/watch_stage.h"

namespace nazori::practice {
namespace {

using study::Stage;
using Made = std::unique_ptr<PracticeStage>;
using Parts = StageParts;

constexpr std::array kKinds{
    StageKind{WatchStage::kId, Stage::watch,
              [](const Parts& p) -> Made { return std::make_unique<WatchStage>(p.tablet, p.clock); }},
    StageKind{TraceStage::kId, Stage::trace,
              [](const Parts& p) -> Made { return std::make_unique<TraceStage>(p.tablet); }},
    StageKind{GuidedStage::kId, Stage::guided,
              [](const Parts& p) -> Made { return std::make_unique<GuidedStage>(p.tablet); }},
    StageKind{
        MemoryStage::kId, Stage::memory,
        [](const Parts& p) -> Made { return std::make_unique<MemoryStage>(p.inbox, p.tablet, p.judge); }},
    StageKind{DictationStage::kId, std::nullopt,
              [](const Parts& p) -> Made { return std::make_unique<DictationStage>(p); }},
};

}  // namespace

std::span<const StageKind> stage_kinds() { return kKinds; }

const StageKind* stage_kind(std::string_view id) {
  const auto* const found =
      std::find_if(kKinds.begin(), kKinds.end(), [id](const StageKind& kind) { return kind.id == id; });
  return found == kKinds.end() ? nullptr : found;
}

std::string stage_names() {
  std::string names;
  for (const auto& kind : kKinds) {
    if (&kind != &kKinds.front()) names += &kind == &kKinds.back() ? " or " : ", ";
    names += kind.id;
  }
  return names;
}

}  // namespace nazori::practice
