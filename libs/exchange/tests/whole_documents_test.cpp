// SPDX-License-Identifier: Apache-2.0
// Documents with every member set to a value of its own, compared whole: docs/schemas names the members.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "nazori/exchange/cards.h"
#include "nazori/exchange/characters.h"
#include "nazori/exchange/databases.h"
#include "nazori/exchange/plots.h"
#include "nazori/exchange/samples.h"
#include "nazori/exchange/statistics.h"
#include "nazori/recording/sample_csv.h"

namespace nazori::exchange {
namespace {

using json::to_line;
using std::chrono::milliseconds;

study::Day day(const char* text) { return *study::parse_day(text); }
study::Time at(const char* text) { return *study::parse_time(text); }

TEST(WholeDocument, OfACharacter) {
  kanji::Character character;
  character.code_point = U'休';
  character.variant = "Kaisho";
  character.own_form = 0xF0007;
  kanji::Stroke stroke;
  stroke.type = "㇒";
  stroke.path = "M1,2L3,4";
  stroke.line.ending = kanji::StrokeEnding::hook;
  stroke.line.number_position = geometry::GlyphPoint{5, 6};
  character.strokes = {stroke};
  character.alternative_orders = {{{2, 1}, "a book"}};
  character.variants = {"HzFst"};
  character.components.element = "休";
  kanji::Component part;
  part.element = "亻";
  part.original = "人";
  part.position = "left";
  part.radical = "general";
  part.phon = "木";
  part.part = 7;
  part.number = 8;
  part.variant = true;
  part.strokes = {3, 4};
  character.components.children = {part};
  character.entry.on_readings = {"キュウ"};
  character.entry.kun_readings = {"やす.む"};
  character.entry.nanori = {"やす"};
  character.entry.grade = 1;
  character.entry.frequency = 642;
  character.entry.old_jlpt_level = 4;
  character.entry.stroke_counts = {6, 5};
  character.entry.codes = {{"skip", "1-2-4"}};
  const kanji::Radical radical{9, "人", {"亻", "𠆢"}, {"ひと"}, "person", 2};
  const std::vector<kanji::Word> words{{"休日", "きゅうじつ", {"holiday"}, {1}, "n", true, false}};
  EXPECT_EQ(
      to_line(to_json(character, radical, words)),
      R"({"character":"休","code_point":"U+4F11","variant":"Kaisho","own_form":"U+F0007",)"
      R"("stroke_count":1,)"
      R"("dictionary_stroke_counts":[6,5],"grade":1,"frequency":642,"old_jlpt_level":4,)"
      R"("radical":{"number":9,"form":"人","variant_forms":["亻","𠆢"],"japanese_names":["ひと"],)"
      R"("english_name":"person","strokes":2},)"
      R"("readings":{"on":["キュウ"],"kun":["やす.む"],"nanori":["やす"]},"meanings":{},)"
      R"("strokes":[{"number":1,"type":"㇒","ending":"hook","path":"M1,2L3,4","number_position":[5.0,6.0]}],)"
      R"("alternative_orders":[{"order":[2,1],"source":"a book"}],"variants":["HzFst"],)"
      R"("components":{"element":"休","original":"","position":"","radical":"","phon":"","part":null,)"
      R"("number":null,"variant":false,"partial":false,"trad_form":false,"radical_form":false,"strokes":[],)"
      R"("children":[{"element":"亻","original":"人","position":"left","radical":"general","phon":"木","part":7,)"
      R"("number":8,"variant":true,"partial":false,"trad_form":false,"radical_form":false,"strokes":[4,5],)"
      R"("children":[]}]},"codes":[{"system":"skip","value":"1-2-4"}],)"
      R"("words":[{"text":"休日","reading":"きゅうじつ","glosses":["holiday"],"senses":[1],)"
      R"("parts_of_speech":"n","common":true}]})");
}

TEST(WholeDocument, EachMarkOfAComponentIsItsOwn) {
  const auto marks = [](bool kanji::Component::*mark) {
    kanji::Character character;
    character.components.*mark = true;
    std::vector<std::string> set;
    const Value json = to_json(character, std::nullopt, {});
    for (const auto& [name, value] : json["components"].items())
      if (value == true) set.push_back(name);
    return set;
  };
  EXPECT_EQ(marks(&kanji::Component::variant), std::vector<std::string>{"variant"});
  EXPECT_EQ(marks(&kanji::Component::partial), std::vector<std::string>{"partial"});
  EXPECT_EQ(marks(&kanji::Component::trad_form), std::vector<std::string>{"trad_form"});
  EXPECT_EQ(marks(&kanji::Component::radical_form), std::vector<std::string>{"radical_form"});
}

TEST(WholeDocument, EachEndingHasItsName) {
  EXPECT_EQ(name_of(kanji::StrokeEnding::stop), "stop");
  EXPECT_EQ(name_of(kanji::StrokeEnding::hook), "hook");
  EXPECT_EQ(name_of(kanji::StrokeEnding::taper), "taper");
  EXPECT_EQ(name_of(kanji::StrokeEnding::either), "either");
}

TEST(WholeDocument, OfACard) {
  const auto learner = study::LearnerStore::in_memory([] { return at("2026-02-01T12:00:00Z"); });
  ASSERT_TRUE(learner);
  study::Card card;
  card.character = U'休';
  card.memory.phase = study::Phase::review;
  card.memory.stability = 12.5;
  card.memory.difficulty = 6.25;
  card.memory.scheduled_days = 13;
  card.memory.reps = 5;
  card.memory.lapses = 2;
  card.memory.due = at("2026-02-03T04:05:06Z");
  card.memory.last_review = at("2026-01-21T04:05:06Z");
  card.last_day = day("2026-01-21");
  card.due_day = day("2026-02-04");
  card.introduced = day("2026-01-02");
  card.postponed_until = day("2026-02-05");
  card.paused = true;
  card.next_stage = study::Stage::guided;
  card.help = 0.5;
  Value json = to_json(card, *learner);
  EXPECT_GT(json["retrievability"], 0.5);
  EXPECT_LT(json["retrievability"], 1);
  json["retrievability"] = 0.75;
  const std::string line = to_line(json);
  EXPECT_EQ(line, R"({"character":"休","state":"review","stability":12.5,"difficulty":6.25,)"
                  R"("retrievability":0.75,"scheduled_days":13,"due":"2026-02-03T04:05:06.000Z",)"
                  R"("due_day":"2026-02-04","reps":5,"lapses":2,"introduced":"2026-01-02",)"
                  R"("postponed_until":"2026-02-05","paused":true,"leech":false,"next_stage":"guided",)"
                  R"("help":0.5,"brush":null})");
  card.brush.memory = card.memory;
  card.brush.memory.stability = 3.5;
  card.brush.memory.reps = 2;
  card.brush.memory.lapses = 1;
  card.brush.last_day = day("2026-01-30");
  card.brush.due_day = day("2026-02-06");
  json = to_json(card, *learner);
  EXPECT_EQ(to_line(json["brush"]),
            R"({"stability":3.5,"difficulty":6.25,"scheduled_days":13,"last_day":"2026-01-30",)"
            R"("due_day":"2026-02-06","reps":2,"lapses":1})");
  const auto read = read_card(json);
  ASSERT_TRUE(read) << base::to_line(read.error());
  EXPECT_EQ(read->card.brush.memory.phase, study::Phase::review);
  EXPECT_EQ(read->card.brush.memory.stability, 3.5);
  EXPECT_EQ(read->card.brush.memory.reps, 2);
  EXPECT_EQ(read->card.brush.last_day, card.brush.last_day);
  EXPECT_EQ(read->card.brush.due_day, card.brush.due_day);
  EXPECT_EQ(read->card.due_day, card.due_day);
  EXPECT_EQ(read->card.introduced, card.introduced);
  EXPECT_EQ(read->card.postponed_until, card.postponed_until);
  EXPECT_EQ(read->card.memory.due, card.memory.due);
  EXPECT_EQ(read->card.memory.lapses, 2);
  EXPECT_TRUE(read->card.paused);
  EXPECT_FALSE(read->card.leech);

  study::Writing writing;
  writing.rating = study::Rating::hard;
  writing.proposed = study::Rating::good;
  const Value answer = reviewed(card, writing, *learner);
  EXPECT_EQ(answer["rating"], "hard");
  EXPECT_EQ(answer["proposed"], "good");
  EXPECT_EQ(answer["entry"], learner->last_entry());
  EXPECT_EQ(answer["character"], "休");
}

TEST(WholeDocument, ACardIsReadUpToTheBoundsOfEachNumber) {
  const auto learner = study::LearnerStore::in_memory([] { return at("2026-02-01T12:00:00Z"); });
  study::Card card;
  card.character = U'休';
  card.memory.phase = study::Phase::review;
  card.memory.stability = 1;
  card.memory.difficulty = 5;
  const Value known = to_json(card, *learner);
  card.memory = {};
  const Value fresh = to_json(card, *learner);
  const auto reads = [](Value json, const char* member, const Value& value) {
    json[member] = value;
    return read_card(json).has_value();
  };
  struct Bound {
    const char* member;
    Value lowest, below, highest, above;
  };
  const std::vector<Bound> bounds{{"stability", 1e-4, 0.99e-4, 1e9, 1.01e9},
                                  {"difficulty", 1, 0.99, 10, 10.01},
                                  {"retrievability", 0, -0.01, 1, 1.01},
                                  {"scheduled_days", 0, -1, 1'000'000'000, 1'000'000'001},
                                  {"reps", 0, -1, 1'000'000'000, 1'000'000'001},
                                  {"lapses", 0, -1, 1'000'000'000, 1'000'000'001},
                                  {"help", 0, -0.01, 1, 1.01}};
  for (const Bound& bound : bounds) {
    EXPECT_TRUE(reads(known, bound.member, bound.lowest)) << bound.member;
    EXPECT_FALSE(reads(known, bound.member, bound.below)) << bound.member;
    EXPECT_TRUE(reads(known, bound.member, bound.highest)) << bound.member;
    EXPECT_FALSE(reads(known, bound.member, bound.above)) << bound.member;
  }
  for (const char* member : {"stability", "difficulty"}) {
    EXPECT_TRUE(reads(fresh, member, 0)) << member << " of a new card";
    EXPECT_FALSE(reads(fresh, member, -0.01)) << member;
    EXPECT_FALSE(reads(known, member, 0)) << member;
  }
}

TEST(WholeDocument, OfAPlan) {
  study::DayPlan plan;
  plan.day = day("2026-02-01");
  study::StudyTask step, review, fresh;
  step.kind = study::TaskKind::step;
  step.character = U'一';
  step.due = at("2026-02-01T10:11:12Z");
  step.retrievability = 0.5;
  review.kind = study::TaskKind::review;
  review.character = U'二';
  fresh.kind = study::TaskKind::fresh;
  fresh.character = U'三';
  fresh.stage = study::Stage::watch;
  plan.now = {step, review, review, fresh, fresh, fresh};
  plan.later_today = {step};
  plan.leeches = {U'鬱'};
  plan.reviews_done = 4;
  plan.new_done = 5;
  plan.brush_done = 1;
  plan.brush = {U'永', U'水'};
  plan.held_back = 6;
  plan.estimate = milliseconds(7000);
  plan.gentle = study::GentlePlan{9, 8, 10, day("2026-02-11")};
  const std::string a_step =
      R"({"character":"一","kind":"step","stage":"memory","due":"2026-02-01T10:11:12.000Z","retrievability":0.5})";
  const std::string a_review =
      R"({"character":"二","kind":"review","stage":"memory","due":"1970-01-01T00:00:00.000Z","retrievability":0.0})";
  const std::string a_fresh =
      R"({"character":"三","kind":"new","stage":"watch","due":"1970-01-01T00:00:00.000Z","retrievability":0.0})";
  EXPECT_EQ(
      to_line(to_json(plan)),
      R"({"day":"2026-02-01","steps":1,"reviews":2,"new":3,"held_back":6,"reviews_done":4,"new_done":5,)"
      R"("brush_done":1,)"
      R"("estimate_ms":7000,"gentle_plan":{"overdue":9,"per_day":8,"days":10,"last_day":"2026-02-11"},)"
      R"("brush":["永","水"],"leeches":["鬱"],"now":[)" +
          a_step + "," + a_review + "," + a_review + "," + a_fresh + "," + a_fresh + "," + a_fresh +
          R"(],"later_today":[)" + a_step + "]}");
}

TEST(WholeDocument, OfStatistics) {
  study::Statistics all;
  all.today = day("2026-02-01");
  all.days = {{day("2026-01-30"), 1, 2, 3, milliseconds(4)}};
  all.forecast = {{day("2026-02-02"), 5}};
  all.retention = {8, 6, 0.875};
  all.last_30_days = {4, 1, 0.5};
  all.retention_days = {{day("2026-01-31"), {2, 2, 0.25}}};
  all.streak = {3, 9, true, false};
  all.characters = {{U'休', study::Strength::mature, 0.625}};
  all.hard_strokes = {{U'体', 4, 2, 7, {{kanji::MistakeKind::reversed, 2}}}};
  all.motion = {{day("2026-01-29"), 11, 12.5, -1.5}};
  all.pace = {milliseconds(21), milliseconds(22), milliseconds(23), 9, 10, 11};
  all.reviews = 31;
  all.time = milliseconds(32);
  EXPECT_EQ(
      to_line(to_json(all)),
      R"({"today":"2026-02-01","reviews":31,"time_ms":32,)"
      R"("streak":{"days":3,"longest":9,"today_done":true,"day_off_used":false},)"
      R"("retention":{"reviews":8,"recalled":6,"actual":0.75,"predicted":0.875},)"
      R"("retention_30_days":{"reviews":4,"recalled":1,"actual":0.25,"predicted":0.5},)"
      R"("pace":{"recalled":{"time_ms":21,"days":9,"own":false},"failed":{"time_ms":22,"days":10,"own":true},)"
      R"("introduced":{"time_ms":23,"days":11,"own":true}},)"
      R"("retention_days":[{"reviews":2,"recalled":2,"actual":1.0,"predicted":0.25,"day":"2026-01-31"}],)"
      R"("days":[{"day":"2026-01-30","reviews":1,"practices":2,"introduced":3,"time_ms":4}],)"
      R"("forecast":[{"day":"2026-02-02","reviews":5}],)"
      R"("characters":[{"character":"休","strength":"mature","retrievability":0.625}],)"
      R"("hard_strokes":[{"character":"体","stroke":5,"faults":2,"writings":7,"kinds":{"reversed":2}}],)"
      R"("motion":[{"day":"2026-01-29","writings":11,"speed":12.5,"smoothness":-1.5}]})");
  EXPECT_EQ(to_line(to_json(0.9, study::Workload{1.5, 2.5, 3.5})),
            R"({"desired_retention":0.9,"reviews_per_day":1.5,"minutes_per_day":2.5,"known":3.5})");
}

TEST(WholeDocument, OfAReplayCheck) {
  const study::ReplayDifferences none{};
  study::ReplayDifferences some = none;
  some.steps = 1;
  some.stability = 0.5;
  some.difficulty = 0.25;
  some.retrievability = 0.125;
  some.scheduled_days = 4;
  some.due_s = 6;
  some.states = 5;
  const Value json = to_json(some);
  EXPECT_EQ(json["steps"], 1);
  EXPECT_EQ(json["stability"], 0.5);
  EXPECT_EQ(json["difficulty"], 0.25);
  EXPECT_EQ(json["retrievability"], 0.125);
  EXPECT_EQ(json["scheduled_days"], 4);
  EXPECT_EQ(json["due_s"], 6);
  EXPECT_EQ(json["states"], 5);
}

TEST(WholeDocument, OfADatabase) {
  EXPECT_EQ(to_line(database_path("a.db")), R"({"path":"a.db"})");
  EXPECT_EQ(to_line(to_json("a.db", std::nullopt)), R"({"path":"a.db","built":false})");
  const std::vector<std::pair<std::string_view, std::int64_t>> counts{{"characters", 3}, {"words", 4}};
  EXPECT_EQ(to_line(to_json("a.db", BuiltDatabase{5, 0.5, counts, {"edict:24"}})),
            R"({"path":"a.db","built":true,"bytes":5,"took_s":0.5,"characters":3,"words":4,)"
            R"("left_out":["edict:24"]})");
  const std::vector<kanji::Source> sources{{"KanjiVG", "r1", "abc", "CC BY-SA 3.0"}};
  EXPECT_EQ(to_line(checked_database("a.db", 7, counts, sources)),
            R"({"path":"a.db","bytes":7,"characters":3,"words":4,"sources":[)"
            R"({"name":"KanjiVG","version":"r1","sha256":"abc","licence":"CC BY-SA 3.0"}]})");
}

TEST(WholeDocument, OfSamplesHasSharesOfTheTicks) {
  recording::SampleStatistics samples;
  samples.samples = 8;
  samples.touching = 2;
  samples.held = 4;
  samples.peak_force_n = 1.5;
  samples.max_depth_m = 0.25;
  samples.longest_period_s = 0.125;
  samples.events[0] = 3;
  const Value json = to_json(samples);
  EXPECT_EQ(json["ticks"], 8);
  EXPECT_EQ(json["contact_share"], 0.25);
  EXPECT_EQ(json["stroke_share"], 0.5);
  EXPECT_EQ(json["peak_force_n"], 1.5);
  EXPECT_EQ(json["max_penetration_m"], 0.25);
  EXPECT_EQ(json["longest_period_s"], 0.125);
  EXPECT_EQ(json["events"][std::string(recording::event_name(0))], 3);
}

/// The document of a small plot, with these points.
Value plot_document(const char* expression, const std::vector<functions::PointOfInterest>& points) {
  const auto plot = functions::parse(expression);
  functions::PlateSettings settings;
  settings.size = 32;
  const auto picture = functions::draw(*plot, {-2, 3, -4, 6}, settings);
  return to_json(*plot, *picture, points, {1.5, 2.5}, functions::Language::english);
}

TEST(WholeDocument, OfAPlotNamesItsWindowStatementsAndTimes) {
  const Value json = plot_document("y = x; y = 2", {});
  EXPECT_EQ(json["kind"], "multi");
  EXPECT_EQ(to_line(json["window"]), "[-2.0,3.0,-4.0,6.0]");
  EXPECT_EQ(to_line(json["tick_step"]), "[0.5,1.0]");
  EXPECT_EQ(json["size"], 32);
  ASSERT_EQ(json["statements"].size(), 2U);
  EXPECT_EQ(json["statements"][1]["canonical"], "y = 2");
  EXPECT_EQ(json["statements"][0]["kind"], plot_document("y = x", {})["kind"])
      << "of one statement it is the plot's";
  EXPECT_FALSE(json["statements"][0]["words"].get<std::string>().empty());
  EXPECT_FALSE(json["summary"].get<std::string>().empty());
  EXPECT_EQ(json["pieces"], 2);
  EXPECT_EQ(to_line(json["timings_ms"]), R"({"draw":1.5,"points":2.5})");
  EXPECT_FALSE(json.contains("z")) << "only of a surface";
  const Value surface = plot_document("z = 1 + x^2", {});
  ASSERT_TRUE(surface.contains("z"));
  EXPECT_NEAR(surface["z"][0].get<double>(), 1, 0.2);
  EXPECT_NEAR(surface["z"][1].get<double>(), 10, 0.2);
}

TEST(WholeDocument, OfAPlotCountsTheElementsOfAListFromOne) {
  const Value json = plot_document("y = [1, 2] x; y = 2", {});
  ASSERT_EQ(json["statements"].size(), 3U);
  EXPECT_EQ(json["statements"][0]["element"], 1);
  EXPECT_EQ(json["statements"][1]["element"], 2);
  EXPECT_FALSE(json["statements"][2].contains("element"));
}

TEST(WholeDocument, OfAPlotTellsTheSizeOfAnAreaOnly) {
  const Value json = plot_document("area(x^3, -1, 2); area(1/x, -1, 1); y = x", {});
  const Value& area = json["statements"][0]["area"];
  EXPECT_NEAR(area["integral"].get<double>(), 3.75, 1e-13);
  EXPECT_EQ(area["integral_name"], "15/4");
  EXPECT_NEAR(area["area"].get<double>(), 4.25, 1e-13);
  EXPECT_EQ(area["area_name"], "17/4");
  ASSERT_TRUE(json["statements"][1].contains("area"));
  EXPECT_TRUE(json["statements"][1]["area"].is_null()) << "across a pole it is not defined";
  EXPECT_FALSE(json["statements"][2].contains("area"));
}

TEST(WholeDocument, OfAPlotHasForEachPointWhatItsKindHas) {
  functions::PointOfInterest crossing;
  crossing.kind = functions::PointKind::crossing;
  crossing.statement = 0;
  crossing.other = 1;
  crossing.x = 0.5;
  crossing.y = 2;
  crossing.x_name = "1/2";
  functions::PointOfInterest zero;
  zero.kind = functions::PointKind::zero;
  zero.statement = 1;
  zero.x = 0.25;
  zero.y = std::nan("");
  zero.slope = 7;
  functions::PointOfInterest asymptote = zero;
  asymptote.kind = functions::PointKind::slanted_asymptote;
  asymptote.intercept = 8;
  asymptote.side = -1;
  functions::PointOfInterest jump = zero;
  jump.jump = functions::Jump{};
  jump.jump->x_before = 1;
  jump.jump->y_before = 2;
  jump.jump->x_after = 3;
  jump.jump->y_after = std::nan("");
  jump.jump->y_at = 5;
  functions::PointOfInterest loop = zero;
  loop.kind = functions::PointKind::self_crossing;
  Value points = plot_document("y = x; y = 2", {crossing, zero, asymptote, jump, loop})["points"];
  for (Value& point : points) {
    EXPECT_FALSE(point["words"].get<std::string>().empty());
    point.erase("words");
  }
  EXPECT_EQ(
      to_line(points[0]),
      R"({"kind":"crossing","statement":1,"other_statement":2,"x":0.5,"y":2.0,"x_name":"1/2","y_name":null})");
  EXPECT_EQ(to_line(points[1]),
            R"({"kind":"zero","statement":2,"x":0.25,"y":null,"x_name":null,"y_name":null})");
  EXPECT_EQ(to_line(points[2]),
            R"({"kind":"slanted_asymptote","statement":2,"x":0.25,"y":null,"x_name":null,"y_name":null,)"
            R"("slope":7.0,"intercept":8.0,"side":-1})");
  EXPECT_EQ(to_line(points[3]),
            R"({"kind":"zero","statement":2,"x":0.25,"y":null,"x_name":null,"y_name":null,)"
            R"("before":[1.0,2.0],"after":[3.0,null],"y_at":5.0})");
  EXPECT_EQ(to_line(points[4]),
            R"({"kind":"self_crossing","statement":2,"x":0.25,"y":null,"x_name":null,"y_name":null})");
}

}  // namespace
}  // namespace nazori::exchange
