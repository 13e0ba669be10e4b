// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/document.h"

#include <gtest/gtest.h>

#include "nazori/exchange/candidates.h"
#include "nazori/exchange/cards.h"
#include "nazori/exchange/characters.h"
#include "nazori/exchange/grades.h"
#include "nazori/exchange/samples.h"
#include "nazori/exchange/statistics.h"

namespace nazori::exchange {
namespace {

using json::to_line;

TEST(Document, HasItsVersionInFront) {
  EXPECT_EQ(exchange::to_line({{"b", 1}, {"a", {{"c", 2}}}}), "{\"version\":1,\"b\":1,\"a\":{\"c\":2}}\n");
  EXPECT_EQ(to_text({{"b", 1}}), "{\n  \"version\": 1,\n  \"b\": 1\n}\n");
  EXPECT_EQ(to_line(versioned(Value::object())), R"({"version":1})");
}

TEST(Document, OfAnArrayEachObjectHasTheVersion) {
  const Value list = Value::array({{{"a", 1}}, {{"b", Value::array({Value::object()})}}, "text", 7, nullptr});
  EXPECT_EQ(to_line(versioned(list)), R"([{"version":1,"a":1},{"version":1,"b":[{}]},"text",7,null])");
  EXPECT_EQ(to_line(versioned(Value::array())), "[]");
  EXPECT_EQ(to_line(versioned(nullptr)), "null");
}

TEST(Document, AVersionThatIsThereIsKept) {
  EXPECT_EQ(to_line(versioned({{"a", 1}, {"version", 3}})), R"({"a":1,"version":3})");
}

TEST(CharacterDocument, HoldsWhatIsKnownWithStrokesFromOne) {
  kanji::Character character;
  character.code_point = U'休';
  character.entry.grade = 1;
  character.entry.meanings = {{"en", "rest"}, {"fr", "repos"}, {"en", "sleep"}};
  kanji::Stroke stroke;
  stroke.type = "㇒";
  stroke.line.ending = kanji::StrokeEnding::taper;
  character.strokes = {stroke, stroke};
  character.components.strokes = {0, 1};
  const Value json = to_json(character, std::nullopt, {});
  EXPECT_EQ(json["character"], "休");
  EXPECT_EQ(json["code_point"], "U+4F11");
  EXPECT_EQ(json["grade"], 1);
  EXPECT_EQ(json["frequency"], nullptr);
  EXPECT_EQ(json["radical"], nullptr);
  EXPECT_EQ(to_line(json["meanings"]), R"({"en":["rest","sleep"],"fr":["repos"]})");
  EXPECT_EQ(json["strokes"][1]["number"], 2);
  EXPECT_EQ(json["strokes"][1]["ending"], "taper");
  EXPECT_EQ(json["strokes"][1]["number_position"], nullptr);
  EXPECT_EQ(to_line(json["components"]["strokes"]), "[1,2]");
}

TEST(CharacterDocument, OfASearchNamesTheCharacter) {
  kanji::Summary summary;
  summary.code_point = U'木';
  summary.meaning = "tree";
  summary.reading = "き";
  summary.strokes = 4;
  EXPECT_EQ(
      to_line(to_json(summary)),
      R"({"character":"木","code_point":"U+6728","meaning":"tree","reading":"き","stroke_count":4,"grade":null})");
}

TEST(GradeDocument, NamesMistakesAndRoundsNumbers) {
  GradeAnswer answer;
  answer.character = U'土';
  writing::StrokeVerdict verdict;
  verdict.matched = 2;
  verdict.offset_x = 0.123456;
  answer.grade.strokes = {verdict, {}};
  writing::Mistake split;
  split.kind = kanji::MistakeKind::split;
  split.stroke = 1;
  split.second = 2;
  split.model = {0};
  writing::Mistake other;
  other.kind = kanji::MistakeKind::other;
  other.character = U'士';
  answer.grade.mistakes = {split, other};
  const Value json = to_json(answer);
  EXPECT_EQ(json["char"], "土");
  EXPECT_EQ(json["strokes"][0]["matched"], 2);
  EXPECT_EQ(to_line(json["strokes"][0]["offset"]), "[0.1235,0.0]");
  EXPECT_EQ(json["strokes"][1]["matched"], nullptr);
  EXPECT_EQ(to_line(json["errors"]), R"([{"kind":"extra","stroke":1,"second":2,"model":[0],"split":true},)"
                                     R"({"kind":"wrong","stroke":0,"resembles":"士"}])");
  for (const char* absent : {"motion", "explanation", "score_explanation", "motion_explanation", "variant"})
    EXPECT_FALSE(json.contains(absent)) << absent;
}

TEST(GradeDocument, ExplainsTheMotionOnlyWhereItIsKnown) {
  GradeAnswer answer;
  answer.explanation = GradeExplanation{{"a"}, {"b"}, {"c"}};
  EXPECT_EQ(to_line(to_json(answer)["score_explanation"]), R"(["b"])");
  EXPECT_FALSE(to_json(answer).contains("motion_explanation"));
  writing::PenMotion motion;
  motion.duration_s = 0.5;
  motion.lift = writing::PenLift::swept;
  answer.motion = {motion};
  EXPECT_EQ(to_line(to_json(answer)["motion_explanation"]), R"(["c"])");
  EXPECT_EQ(
      to_line(to_json(answer)["motion"]),
      R"([{"duration_s":0.5,"pause_before_s":0.0,"speed_peaks":0,"speed_at_end":0.0,"pauses":0,"lift":"swept"}])");
}

TEST(GradeRequestDocument, AsksForOneCharacterAndItsStrokes) {
  const auto read = [](const char* text) { return read_grade_request(json::parse(text).value()); };
  const auto asked = read(R"({"char": "一", "strokes": [[[0.1, 0.5], [0.9, 0.5]]]})");
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->character, U'一');
  EXPECT_EQ(asked->ink.strokes.size(), 1U);
  for (const char* wrong : {R"({"strokes": []})", R"({"char": 1, "strokes": []})",
                            R"({"char": "", "strokes": []})", R"({"char": "一二", "strokes": []})"})
    EXPECT_EQ(read(wrong).error().where, "char") << wrong;
  EXPECT_EQ(read(R"({"char": "一"})").error().where, "strokes");
}

TEST(CandidatesDocument, StandsBestFirst) {
  const std::vector<writing::Candidate> two{{U'休', 0.98765}, {U'体', 0.5}};
  EXPECT_EQ(to_line(to_json(two)), R"({"candidates":["休","体"],"likeness":[0.9877,0.5]})");
  EXPECT_EQ(to_line(refused_candidates()), R"({"candidates":[]})");
}

TEST(CardDocument, OfANewCharacterHasNoDates) {
  const auto learner = study::LearnerStore::in_memory([] { return study::Time{}; });
  ASSERT_TRUE(learner);
  study::Card card;
  card.character = U'休';
  const Value json = to_json(card, *learner);
  EXPECT_EQ(json["character"], "休");
  for (const char* none : {"due", "due_day", "introduced", "postponed_until"})
    EXPECT_EQ(json[none], nullptr) << none;
  card.memory.phase = study::Phase::review;
  card.due_day = study::Day{};
  EXPECT_EQ(to_json(card, *learner)["due_day"], "1970-01-01");
  EXPECT_TRUE(to_json(card, *learner)["due"].is_string());
}

TEST(CardDocument, OfATaskTellsWhatEachRatingWouldDo) {
  study::StudyTask task;
  task.kind = study::TaskKind::fresh;
  task.character = U'休';
  study::Card later;
  later.due_day = study::Day{};
  const std::pair<study::Rating, study::Card> after[] = {{study::Rating::again, {}},
                                                         {study::Rating::easy, later}};
  const Value json = next_task(task, after);
  EXPECT_EQ(json["kind"], "new");
  EXPECT_EQ(json["ratings"]["again"]["due_day"], nullptr);
  EXPECT_EQ(json["ratings"]["easy"]["due_day"], "1970-01-01");
}

TEST(PlanDocument, CountsWhatIsDueByKind) {
  study::DayPlan plan;
  study::StudyTask step, fresh;
  step.kind = study::TaskKind::step;
  fresh.kind = study::TaskKind::fresh;
  plan.now = {step, fresh, fresh};
  plan.leeches = {U'鬱'};
  Value json = to_json(plan);
  EXPECT_EQ(json["steps"], 1);
  EXPECT_EQ(json["reviews"], 0);
  EXPECT_EQ(json["new"], 2);
  EXPECT_EQ(json["gentle_plan"], nullptr);
  EXPECT_EQ(to_line(json["leeches"]), R"(["鬱"])");
  plan.gentle = study::GentlePlan{9, 3, 4, study::Day{}};
  json = to_json(plan);
  EXPECT_EQ(json["gentle_plan"]["per_day"], 3);
}

TEST(StatisticsDocument, HasEveryListAlsoWhereItIsEmpty) {
  const Value json = to_json(study::Statistics{});
  for (const char* list : {"days", "retention_days", "characters", "hard_strokes", "motion", "forecast"})
    EXPECT_EQ(to_line(json[list]), "[]") << list;
  EXPECT_EQ(json["retention"]["actual"], nullptr) << "without reviews there is none";
}

TEST(ReplayCheckDocument, NamesTheFirstThatDiffersOrNothing) {
  study::ReplayDifferences differences;
  EXPECT_EQ(to_json(differences)["first"], nullptr);
  differences.first = "case 1, step 2";
  EXPECT_EQ(to_json(differences)["first"], "case 1, step 2");
}

TEST(SamplesDocument, CountsEveryEventByName) {
  const Value json = to_json(recording::SampleStatistics{});
  EXPECT_EQ(json["contact_share"], 0) << "without samples no division";
  EXPECT_EQ(json["events"]["touch"], 0);
  EXPECT_EQ(json["events"].size(), 11U);
}

}  // namespace
}  // namespace nazori::exchange
