// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/cards.h"

#include <array>
#include <string>

#include "nazori/base/utf8.h"
#include "reading.h"

namespace nazori::exchange {
namespace {

Value day_or_null(const std::optional<study::Day>& day) {
  return day ? Value(study::to_text(*day)) : Value();
}

Value to_json(const study::StudyTask& task) {
  constexpr std::array<const char*, 3> kKinds{"step", "review", "new"};
  return {{"character", base::encode_utf8(task.character)},
          {"kind", kKinds[static_cast<std::size_t>(task.kind)]},
          {"stage", study::name_of(task.stage)},
          {"due", study::to_text(task.due)},
          {"retrievability", task.retrievability}};
}

/// null before the first review with the brush.
Value to_json(const study::BrushReviews& brush) {
  const study::Memory& memory = brush.memory;
  if (memory.reps == 0) return {};
  return {{"stability", memory.stability},
          {"difficulty", memory.difficulty},
          {"scheduled_days", memory.scheduled_days},
          {"last_day", day_or_null(brush.last_day)},
          {"due_day", day_or_null(brush.due_day)},
          {"reps", memory.reps},
          {"lapses", memory.lapses}};
}

}  // namespace

Value to_json(const study::Card& card, const study::LearnerStore& learner) {
  const study::Memory& memory = card.memory;
  const auto fsrs = study::Fsrs::create(learner.settings().fsrs);
  return {{"character", base::encode_utf8(card.character)},
          {"state", study::name_of(memory.phase)},
          {"stability", memory.stability},
          {"difficulty", memory.difficulty},
          {"retrievability", fsrs ? study::retrievability_now(card, *fsrs, learner.today()) : 0},
          {"scheduled_days", memory.scheduled_days},
          {"due", memory.phase == study::Phase::fresh ? Value() : Value(study::to_text(memory.due))},
          {"due_day", day_or_null(card.due_day)},
          {"reps", memory.reps},
          {"lapses", memory.lapses},
          {"introduced", day_or_null(card.introduced)},
          {"postponed_until", day_or_null(card.postponed_until)},
          {"paused", card.paused},
          {"leech", card.leech},
          {"next_stage", study::name_of(card.next_stage)},
          {"help", card.help},
          {"brush", to_json(card.brush)}};
}

namespace {

void read_brush(JsonObject& from, study::BrushReviews& brush) {
  constexpr int kMost = 1'000'000'000;
  brush.memory.phase = study::Phase::review;
  brush.memory.stability = from.number("stability", 1e-4, 1e9);
  brush.memory.difficulty = from.number("difficulty", 1, 10);
  brush.memory.scheduled_days = static_cast<int>(from.whole("scheduled_days", 0, kMost));
  brush.last_day = read_day(from, "last_day");
  brush.due_day = read_day(from, "due_day");
  brush.memory.reps = static_cast<int>(from.whole("reps", 0, kMost));
  brush.memory.lapses = static_cast<int>(from.whole("lapses", 0, kMost));
}

}  // namespace

base::Result<ReadCard> read_card(const Value& document) {
  constexpr double kShortest = 1e-4;  // days of stability
  constexpr double kLongest = 1e9;
  constexpr int kMost = 1'000'000'000;
  json::Reader reader("");
  auto from = reader.root(document);
  ReadCard read;
  study::Card& card = read.card;
  study::Memory& memory = card.memory;
  card.character = read_character(from, "character");
  memory.phase = read_name(from, "state", study::phase_named);
  const bool is_fresh = memory.phase == study::Phase::fresh;
  memory.stability = from.number("stability", is_fresh ? 0 : kShortest, kLongest);
  memory.difficulty = from.number("difficulty", is_fresh ? 0 : 1, 10);
  read.retrievability = from.number("retrievability", 0, 1);
  memory.scheduled_days = static_cast<int>(from.whole("scheduled_days", 0, kMost));
  if (from.has("due")) {
    const auto due = study::parse_time(from.text("due"));
    if (!due) from.refuse("due", "is not a time", "give one like 2026-01-31T09:00:00Z");
    if (due) memory.due = *due;
  }
  card.due_day = read_day(from, "due_day");
  memory.reps = static_cast<int>(from.whole("reps", 0, kMost));
  memory.lapses = static_cast<int>(from.whole("lapses", 0, kMost));
  card.introduced = read_day(from, "introduced");
  card.postponed_until = read_day(from, "postponed_until");
  card.paused = from.truth("paused");
  card.leech = from.truth("leech");
  card.next_stage = read_name(from, "next_stage", study::stage_named);
  card.help = from.number("help", 0, 1);
  if (from.has("brush")) {
    auto brush = from.object("brush");
    read_brush(brush, card.brush);
  }
  if (!reader.ok()) return tl::unexpected(reader.error());
  return read;
}

Value reviewed(const study::Card& card, const study::Writing& writing, const study::LearnerStore& learner) {
  Value json = to_json(card, learner);
  json["entry"] = learner.last_entry();
  json["rating"] = study::name_of(writing.rating);
  json["proposed"] = study::name_of(writing.proposed);
  return json;
}

Value to_json(const study::DayPlan& plan) {
  Value now = Value::array();
  for (const auto& task : plan.now) now.push_back(to_json(task));
  Value later = Value::array();
  for (const auto& task : plan.later_today) later.push_back(to_json(task));
  Value brush = Value::array();
  for (const char32_t one : plan.brush) brush.push_back(base::encode_utf8(one));
  Value leeches = Value::array();
  for (const char32_t one : plan.leeches) leeches.push_back(base::encode_utf8(one));
  Value gentle;
  if (plan.gentle) {
    gentle = {{"overdue", plan.gentle->overdue},
              {"per_day", plan.gentle->per_day},
              {"days", plan.gentle->days},
              {"last_day", study::to_text(plan.gentle->last_day)}};
  }
  return {{"day", study::to_text(plan.day)},
          {"steps", plan.count(study::TaskKind::step)},
          {"reviews", plan.count(study::TaskKind::review)},
          {"new", plan.count(study::TaskKind::fresh)},
          {"held_back", plan.held_back},
          {"reviews_done", plan.reviews_done},
          {"new_done", plan.new_done},
          {"brush_done", plan.brush_done},
          {"estimate_ms", plan.estimate.count()},
          {"gentle_plan", std::move(gentle)},
          {"brush", std::move(brush)},
          {"leeches", std::move(leeches)},
          {"now", std::move(now)},
          {"later_today", std::move(later)}};
}

Value next_task(const study::StudyTask& task, std::span<const std::pair<study::Rating, study::Card>> after) {
  Value ratings = Value::object();
  for (const auto& [rating, card] : after)
    ratings[std::string(study::name_of(rating))] = {{"due", study::to_text(card.memory.due)},
                                                    {"due_day", day_or_null(card.due_day)}};
  Value json = to_json(task);
  json["ratings"] = std::move(ratings);
  return json;
}

Value to_json(const study::ReplayDifferences& differences) {
  return {{"steps", differences.steps},
          {"stability", differences.stability},
          {"difficulty", differences.difficulty},
          {"retrievability", differences.retrievability},
          {"scheduled_days", differences.scheduled_days},
          {"due_s", differences.due_s},
          {"states", differences.states},
          {"first", differences.first.empty() ? Value() : Value(differences.first)}};
}

}  // namespace nazori::exchange
