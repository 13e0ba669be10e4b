// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <utility>

#include "nazori/exchange/document.h"
#include "nazori/study/day_plan.h"
#include "nazori/study/learner_store.h"
#include "nazori/study/replay.h"

namespace nazori::exchange {

/// A card as it is today for a learner (docs/schemas/study.json, card).
[[nodiscard]] Value to_json(const study::Card& card, const study::LearnerStore& learner);
/// A card that was read: what the document holds of it. What it does not hold (learning steps, practices) is
/// as in a new card.
struct ReadCard {
  study::Card card;
  double retrievability = 0;  ///< on the day of the document
};
/// Reads docs/schemas/study.json, card. @return Errc::parse with the member in Error::where.
[[nodiscard]] base::Result<ReadCard> read_card(const Value& document);
/// What was written, and the card after it (docs/schemas/study.json, review).
[[nodiscard]] Value reviewed(const study::Card& card, const study::Writing& writing,
                             const study::LearnerStore& learner);
/// What today holds (docs/schemas/study.json, due).
[[nodiscard]] Value to_json(const study::DayPlan& plan);
/// One thing to do, and when each rating would bring it back (docs/schemas/study.json, next).
[[nodiscard]] Value next_task(const study::StudyTask& task,
                              std::span<const std::pair<study::Rating, study::Card>> after);
/// How far the numbers of a file of histories differ (docs/schemas/study.json, replay_check).
[[nodiscard]] Value to_json(const study::ReplayDifferences& differences);

}  // namespace nazori::exchange
