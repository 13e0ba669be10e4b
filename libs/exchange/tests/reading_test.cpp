// SPDX-License-Identifier: Apache-2.0
// Events, grades and cards are read back as they were written. The documents in tests/fixtures/documents are
// answers of the program to real writing, one to a line.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "nazori/exchange/cards.h"
#include "nazori/exchange/grades.h"
#include "nazori/exchange/practice_events.h"
#include "nazori/practice/event_names.h"
#include "test_paths.h"

namespace nazori::exchange {
namespace {

using json::to_line;

/// The documents of a file, without their version.
std::vector<Value> documents(const char* file) {
  std::ifstream in(std::string(nazori::test_paths::kFixtures) + "/documents/" + file);
  std::vector<Value> all;
  for (std::string line; std::getline(in, line);) {
    all.push_back(*json::parse(line));
    all.back().erase("version");
  }
  EXPECT_FALSE(all.empty()) << file;
  return all;
}

template <class Read>
std::string where_wrong(const Read& read, const char* document) {
  const Value value = *json::parse(document);
  const auto result = read(value);
  return result ? "read" : result.error().where;
}

/// The document with one of its members set, or removed.
Value with(Value document, const char* member, Value value) {
  document[member] = std::move(value);
  return document;
}
Value without(Value document, const char* member) {
  document.erase(member);
  return document;
}

TEST(ReadPracticeEvents, ThoseOfALessonAndASessionComeBackAsTheyWere) {
  std::set<std::size_t> kinds;
  for (const auto& document : documents("events.jsonl")) {
    const auto event = read_practice_event(document);
    ASSERT_TRUE(event) << document << ": " << base::to_line(event.error());
    EXPECT_EQ(to_line(to_json(*event)), to_line(document));
    kinds.insert(event->index());
  }
  EXPECT_EQ(kinds.size(), std::variant_size_v<PracticeEvent> - 1) << "each but the failure";
}

TEST(ReadPracticeEvents, EveryEventOfAStageComesBack) {
  for (int i = 0; i <= static_cast<int>(practice::StageEvent::judges_at_end); ++i) {
    StageReport report{"memory", {}, {}};
    auto& what = report.feedback;
    what.event = static_cast<practice::StageEvent>(i);
    what.tone = static_cast<practice::Tone>(i % 4);
    what.stroke = i + 1;
    what.other = i + 2;
    what.count = i + 3;
    if (what.event == practice::StageEvent::speed_changed) what.value = 0.25;
    if (what.event == practice::StageEvent::stroke_watched) {
      what.type = "㇏";
      what.ending = kanji::StrokeEnding::taper;
    }
    what.leading = static_cast<practice::Leading>(i % 3);
    if (i % 2 == 0) what.more = practice::MistakeHelp::hint;
    if (i % 3 == 0) what.mistake.emplace().kind = kanji::MistakeKind::joined;
    if (i % 5 == 0) what.error = base::Error{base::Errc::io, "cannot be read", "kanji.db", "build it"};
    const Value document = to_json(report);
    const auto event = read_practice_event(document);
    ASSERT_TRUE(event) << base::to_line(event.error());
    const auto& read = std::get<StageReport>(*event);
    EXPECT_EQ(read.feedback.event, what.event);
    EXPECT_EQ(read.feedback.tone, what.tone);
    EXPECT_EQ(read.feedback.stroke, what.stroke);
    EXPECT_EQ(read.feedback.leading, what.leading);
    EXPECT_EQ(to_json(*event), document);
  }
}

TEST(ReadPracticeEvents, WhatOnlyOneStageReportsComesBackWithItsDetails) {
  StageReport report{"dictation", {}, {}};
  report.feedback.event = practice::StageEvent::own;
  report.feedback.own = "word_judged";
  report.details = {{"accepted", true}, {"score", 87}, {"words", std::vector<std::string>{"休日", "休み"}}};
  report.details.push_back(
      {"characters", std::vector<practice::StageDetails>{{{"char", std::string("休")}}, {}}});
  const Value document = to_json(report);
  const auto event = read_practice_event(document);
  ASSERT_TRUE(event);
  EXPECT_EQ(std::get<StageReport>(*event).feedback.event, practice::StageEvent::own);
  EXPECT_EQ(std::get<StageReport>(*event).feedback.own, "word_judged");
  EXPECT_EQ(std::get<StageReport>(*event).details.size(), 4U);
  EXPECT_EQ(to_line(to_json(*event)), to_line(document));
}

TEST(ReadPracticeEvents, EveryAnnouncementOfASessionAndAFailureComeBack) {
  for (int i = 0; i <= static_cast<int>(practice::SessionFeedback::Kind::reset); ++i) {
    practice::SessionFeedback feedback;
    feedback.kind = static_cast<practice::SessionFeedback::Kind>(i);
    feedback.characters = {U'休'};
    feedback.rating = study::Rating::hard;
    if (i % 2 == 0) feedback.error = {base::Errc::io, "the disk is full", "a.db", ""};
    const Value document = to_json(feedback);
    const auto event = read_practice_event(document);
    ASSERT_TRUE(event) << base::to_line(event.error());
    EXPECT_EQ(std::get<practice::SessionFeedback>(*event).kind, feedback.kind);
    EXPECT_EQ(to_json(*event), document);
  }
  const Value failure = error_event({base::Errc::io, "cannot be read", "kanji.db", ""});
  const auto event = read_practice_event(failure);
  ASSERT_TRUE(event);
  EXPECT_EQ(std::get<FailureEvent>(*event).line, "kanji.db: cannot be read");
  EXPECT_EQ(to_json(*event), failure);
}

TEST(ReadPracticeEvents, NumbersAreUpToAMillion) {
  const auto with_numbers = [](const char* stroke, const char* extra) {
    const std::string document =
        std::string(R"({"event":"feedback","stage":"guided","what":"mistake","tone":"wrong","stroke":)") +
        stroke + R"(,"extra":)" + extra + "}";
    return where_wrong(read_practice_event, document.c_str());
  };
  EXPECT_EQ(with_numbers("1000000", "1000000"), "read");
  EXPECT_EQ(with_numbers("1", "-1000000"), "read");
  EXPECT_EQ(with_numbers("1000001", "1"), "line 1, stroke");
  EXPECT_EQ(with_numbers("1", "1000001"), "line 1, what");
  EXPECT_EQ(with_numbers("1", "-1000001"), "line 1, what");
}

TEST(ReadPracticeEvents, WhatIsNoneSaysWhere) {
  const auto wrong = [](const char* document) { return where_wrong(read_practice_event, document); };
  EXPECT_EQ(wrong("[]"), "line 1");
  EXPECT_EQ(wrong("{}"), "line 1, event");
  EXPECT_EQ(wrong(R"({"event":"party"})"), "line 1, event");
  EXPECT_EQ(wrong(R"({"event":"character","char":"休み","strokes":6,"stage":"watch"})"), "line 1, char");
  EXPECT_EQ(wrong(R"({"event":"character","char":"休","strokes":-6,"stage":"watch"})"), "line 1, strokes");
  EXPECT_EQ(wrong(R"({"event":"finished"})"), "line 1, stage");
  EXPECT_EQ(wrong(R"({"event":"error","error":7})"), "line 1, error");
  const std::string report = R"({"event":"feedback","stage":"guided","what":"mistake","tone":"wrong")";
  EXPECT_EQ(wrong((report + "}").c_str()), "read");
  EXPECT_EQ(wrong((report + R"(,"stroke":0})").c_str()), "line 1, stroke");
  EXPECT_EQ(wrong((report + R"(,"leading":"away"})").c_str()), "line 1, leading");
  EXPECT_EQ(wrong((report + R"(,"help":"much"})").c_str()), "line 1, help");
  EXPECT_EQ(wrong((report + R"(,"mistake":"sloth"})").c_str()), "line 1, mistake");
  EXPECT_EQ(wrong((report + R"(,"extra":null})").c_str()), "line 1, what");
  EXPECT_EQ(wrong((report + R"(,"extra":[1]})").c_str()), "line 1, what");
  EXPECT_EQ(wrong(R"({"event":"feedback","stage":"watch","what":"speed_changed","tone":"hint"})"),
            "line 1, speed");
  EXPECT_EQ(wrong(R"({"event":"feedback","stage":"watch","what":"all_watched","tone":"loud"})"),
            "line 1, tone");
  EXPECT_EQ(wrong(R"({"event":"session","state":"asleep"})"), "line 1, state");
  EXPECT_EQ(wrong(R"({"event":"session","state":"doing","char":"休","stage":"memory","done":1})"),
            "line 1, total");
  EXPECT_EQ(wrong(R"({"event":"announced","what":"rated","char":"休"})"), "line 1, rating");
  EXPECT_EQ(wrong(R"({"event":"announced","what":"sung"})"), "line 1, what");
}

TEST(ReadGrades, ThoseOfRealWritingComeBackAsTheyWere) {
  std::set<std::string> kinds;
  for (const auto& document : documents("grades.jsonl")) {
    const auto answer = read_grade(document);
    ASSERT_TRUE(answer) << document << ": " << base::to_line(answer.error());
    EXPECT_EQ(to_line(to_json(*answer)), to_line(document));
    for (const auto& mistake : answer->grade.mistakes)
      kinds.insert(std::string(kanji::name_of(mistake.kind)));
  }
  EXPECT_TRUE(kinds.contains("order") && kinds.contains("reversed") && kinds.contains("missing") &&
              kinds.contains("split") && kinds.contains("joined"));
}

TEST(ReadGrades, EveryMistakeComesBackWithAllThatItHolds) {
  GradeAnswer answer;
  answer.character = U'土';
  answer.grade.accepted = true;
  answer.grade.score = 91;
  answer.grade.form = 4;
  answer.grade.probability = 0.875;
  answer.grade.variant = "Kaisho";
  answer.grade.alternative.emplace().source = "a book";
  answer.grade.parts = {0.5, 0.25, 1, 0.75, 0.125};
  writing::StrokeVerdict verdict;
  verdict.ok = true;
  verdict.matched = 2;
  verdict.reversed = true;
  verdict.offset_x = -0.25;
  verdict.offset_y = 0.5;
  verdict.size = 1.5;
  verdict.angle_rad = -0.75;
  verdict.shape = 0.125;
  verdict.deviation = 0.875;
  answer.grade.strokes = {verdict, {}};
  for (int i = 0; i <= static_cast<int>(kanji::MistakeKind::ending); ++i) {
    writing::Mistake mistake;
    mistake.kind = static_cast<kanji::MistakeKind>(i);
    mistake.stroke = i;
    mistake.second = i + 1;
    mistake.model = {i, i + 2};
    mistake.deviation = static_cast<writing::Deviation>(i % 5);
    if (mistake.kind == kanji::MistakeKind::other) mistake.character = U'士';
    (i % 2 == 0 ? answer.grade.mistakes : answer.grade.advice).push_back(mistake);
  }
  writing::PenMotion motion;
  motion.duration_s = 0.5;
  motion.pause_before_s = 0.25;
  motion.speed_peaks = 2;
  motion.speed_at_end = 1.25;
  motion.pauses.resize(3);
  motion.pressure = 0.5;
  motion.pressure_at_end = 0.25;
  motion.lift = writing::PenLift::swept;
  answer.motion = {motion, {}};
  answer.motion[1].lift = writing::PenLift::stopped;
  answer.explanation = GradeExplanation{{"a", "b"}, {"c"}, {"d"}};
  const auto read = read_grade(to_json(answer));
  ASSERT_TRUE(read) << base::to_line(read.error());
  EXPECT_EQ(read->grade.mistakes, answer.grade.mistakes);
  EXPECT_EQ(read->grade.advice, answer.grade.advice);
  EXPECT_EQ(read->motion[0].pauses.size(), 3U);
  EXPECT_EQ(read->motion[1].lift, writing::PenLift::stopped);
  EXPECT_EQ(to_line(to_json(*read)), to_line(to_json(answer)));
}

TEST(ReadGrades, WhatIsNoneSaysWhere) {
  const auto wrong = [](const Value& document) {
    const auto result = read_grade(document);
    return result ? "read" : result.error().where;
  };
  GradeAnswer answer;
  answer.character = U'一';
  answer.grade.strokes = {{}};
  answer.grade.mistakes = {{}};
  const Value fine = to_json(answer);
  EXPECT_EQ(wrong(fine), "read");
  for (const char* member :
       {"char", "accepted", "strokes", "errors", "advice", "score", "probability", "parts"})
    EXPECT_EQ(wrong(without(fine, member)), std::string("line 1, ") + member);
  EXPECT_EQ(wrong(with(fine, "score", 101)), "line 1, score");
  EXPECT_EQ(wrong(with(fine, "form", 6)), "line 1, form");
  EXPECT_EQ(wrong(with(fine, "probability", 1.5)), "line 1, probability");
  Value other = fine;
  other["strokes"][0]["offset"] = Value::array({1});
  EXPECT_EQ(wrong(other), "line 1, strokes/0/offset");
  other = fine;
  other["errors"][0]["kind"] = "sloth";
  EXPECT_EQ(wrong(other), "line 1, errors/0/kind");
  other = fine;
  other["errors"][0]["model"] = Value::array({-1});
  EXPECT_EQ(wrong(other), "line 1, errors/0/model");
  other = fine;
  other["parts"]["shape"] = 2;
  EXPECT_EQ(wrong(other), "line 1, parts/shape");
  EXPECT_EQ(wrong(with(fine, "explanation", Value::array({7}))), "line 1, explanation");
}

TEST(ReadCards, ThoseOfALearnerComeBackAsTheyWere) {
  const auto learner = study::LearnerStore::in_memory();
  ASSERT_TRUE(learner);
  std::set<study::Phase> phases;
  for (const auto& document : documents("cards.jsonl")) {
    const auto read = read_card(document);
    ASSERT_TRUE(read) << document << ": " << base::to_line(read.error());
    EXPECT_EQ(read->retrievability, document["retrievability"].get<double>());
    // The chance of recall is that of another day.
    EXPECT_EQ(to_line(with(to_json(read->card, *learner), "retrievability", document["retrievability"])),
              to_line(document));
    phases.insert(read->card.memory.phase);
  }
  EXPECT_GE(phases.size(), 2U);
}

TEST(ReadCards, WhatIsNoneSaysWhere) {
  const Value fine = documents("cards.jsonl").front();
  const auto wrong = [](const Value& document) {
    const auto result = read_card(document);
    return result ? "read" : result.error().where;
  };
  EXPECT_EQ(wrong(fine), "read");
  for (const auto& [member, value] : fine.items()) {
    // Of a new card, and of one written before there were reviews with the brush.
    const bool may_be_missing = member == "due" || member == "brush";
    EXPECT_EQ(wrong(without(fine, member.c_str())), may_be_missing ? "read" : "line 1, " + member);
  }
  EXPECT_EQ(wrong(with(fine, "state", "asleep")), "line 1, state");
  EXPECT_EQ(wrong(with(fine, "stability", 0)), "line 1, stability") << "only of a new card";
  EXPECT_EQ(wrong(with(fine, "due", "soon")), "line 1, due");
  EXPECT_EQ(wrong(with(fine, "due_day", "soon")), "line 1, due_day");
  EXPECT_EQ(wrong(with(fine, "help", 1.5)), "line 1, help");
  EXPECT_EQ(wrong(with(fine, "reps", 1.5)), "line 1, reps");
  for (const auto& [member, value] : fine["brush"].items()) {
    EXPECT_EQ(wrong(with(fine, "brush", without(fine["brush"], member.c_str()))), "line 1, brush/" + member);
    EXPECT_EQ(wrong(with(fine, "brush", with(fine["brush"], member.c_str(), -1))), "line 1, brush/" + member);
  }
}

}  // namespace
}  // namespace nazori::exchange
