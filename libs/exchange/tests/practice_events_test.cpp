// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/practice_events.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace nazori::exchange {
namespace {

using json::to_line;
using practice::SessionFeedback;
using practice::StageEvent;
using study::Stage;

TEST(PracticeEvents, NameEveryThingThatAStageReports) {
  std::set<std::string> names;
  for (int i = 0; i <= static_cast<int>(StageEvent::judges_at_end); ++i) {
    StageReport report;
    report.feedback.event = static_cast<StageEvent>(i);
    const Value json = to_json(report);
    EXPECT_EQ(json["event"], "feedback");
    EXPECT_NE(json["what"], "") << i;
    names.insert(json["what"].get<std::string>());
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(StageEvent::judges_at_end) + 1) << "two have one name";
}

TEST(PracticeEvents, HoldOnlyTheNumbersThatAreSet) {
  StageReport report{"trace", {}, {}};
  report.feedback.event = StageEvent::too_early;
  report.feedback.tone = practice::Tone::wrong;
  report.feedback.stroke = 1;
  report.feedback.other = 2;
  EXPECT_EQ(to_line(to_json(report)),
            R"({"event":"feedback","stage":"trace","what":"too_early","tone":"wrong","stroke":1,"other":2})");
}

TEST(PracticeEvents, TellTheMistakeWhatHelpsAndHowTheHandIsLed) {
  StageReport report{"memory", {}, {}};
  report.feedback.event = StageEvent::mistake;
  report.feedback.mistake.emplace().kind = kanji::MistakeKind::reversed;
  report.feedback.more = practice::MistakeHelp::hint;
  Value json = to_json(report);
  EXPECT_EQ(json["mistake"], "reversed");
  EXPECT_EQ(json["help"], "hint");
  EXPECT_FALSE(json.contains("leading"));
  report.feedback = {.event = StageEvent::follow_hidden, .leading = practice::Leading::missing};
  EXPECT_EQ(to_json(report)["leading"], "missing");
  report.feedback.leading = practice::Leading::leading;
  EXPECT_EQ(to_json(report)["leading"], "leading");
  report.feedback = {.event = StageEvent::speed_changed, .value = 0.5};
  EXPECT_EQ(to_json(report)["speed"], 0.5);
  report.feedback = {.event = StageEvent::stroke_watched, .type = "㇏", .ending = kanji::StrokeEnding::taper};
  EXPECT_EQ(to_json(report)["type"], "㇏");
  EXPECT_EQ(to_json(report)["ending"], "taper");
}

TEST(PracticeEvents, HaveTheDetailsOfTheirStageInOrder) {
  StageReport report{"memory", {}, {}};
  report.feedback.event = StageEvent::judged;
  report.details = {{"accepted", true}, {"score", 87}, {"word", std::string("休日")}};
  report.details.push_back(
      {"characters", std::vector<practice::StageDetails>{{{"char", std::string("休")}}, {}}});
  EXPECT_EQ(
      to_line(to_json(report)),
      R"({"event":"feedback","stage":"memory","what":"judged","tone":"hint","accepted":true,"score":87,)"
      R"("word":"休日","characters":[{"char":"休"},{}]})");
}

TEST(PracticeEvents, ThatOnlyOneStageHasGoByTheNameItGivesThem) {
  StageReport report{"dictation", {}, {}};
  report.feedback.event = StageEvent::own;
  report.feedback.own = "word_asked";
  EXPECT_EQ(to_json(report)["what"], "word_asked");
}

TEST(PracticeEvents, OfASessionTellItsTaskWhileItRuns) {
  SessionProgress progress;
  EXPECT_EQ(to_line(to_json(progress)), R"({"event":"session","state":"idle"})");
  progress.state = practice::SessionState::judged;
  progress.task = {U'休', Stage::memory, 3, 7};
  progress.proposed = study::Rating::hard;
  EXPECT_EQ(
      to_line(to_json(progress)),
      R"({"event":"session","state":"judged","char":"休","stage":"memory","done":3,"total":7,"proposed":"hard"})");
}

TEST(PracticeEvents, TheRatingIsThatOfARatedCharacter) {
  SessionFeedback feedback;
  feedback.characters = {U'休', U'木'};
  feedback.kind = SessionFeedback::Kind::paused;
  EXPECT_EQ(to_line(to_json(feedback)), R"({"event":"announced","what":"paused","char":"休"})");
  feedback.kind = SessionFeedback::Kind::rated;
  feedback.rating = study::Rating::easy;
  EXPECT_EQ(to_json(feedback)["rating"], "easy");
  feedback.error = {base::Errc::io, "the disk is full", "a.db", ""};
  EXPECT_EQ(to_json(feedback)["error"], "a.db: the disk is full");
}

TEST(PracticeEvents, StandInALineWithTheVersion) {
  Value events = Value::array();
  events.push_back(to_json(CharacterShown{U'一', 1, "watch"}));
  events.push_back(to_json(StageFinished{"watch"}));
  events.push_back(error_event({base::Errc::io, "cannot be read", "kanji.db", ""}));
  EXPECT_EQ(exchange::to_line(events_document(std::move(events))),
            R"({"version":1,"events":[{"event":"character","char":"一","strokes":1,"stage":"watch"},)"
            R"({"event":"finished","stage":"watch"},{"event":"error","error":"kanji.db: cannot be read"}]})"
            "\n");
}

}  // namespace
}  // namespace nazori::exchange
