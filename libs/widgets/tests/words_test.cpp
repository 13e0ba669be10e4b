// SPDX-License-Identifier: Apache-2.0
// Sentences about study, entry by entry. Without a translation installed they are those of the sources.
#include <gtest/gtest.h>

#include <QLocale>
#include <set>

#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/learner_words.h"
#include "nazori/widgets/words/session_words.h"
#include "nazori/widgets/words/study_words.h"
#include "nazori/widgets/words/trouble_words.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

using std::chrono::minutes;

QString words(const char* text) { return QString::fromUtf8(text); }

class WordsOfStudy : public testing::Test {
 protected:
  WordsOfStudy() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
  ~WordsOfStudy() override { QLocale::setDefault(before_); }
  WordsOfStudy(const WordsOfStudy&) = delete;
  WordsOfStudy& operator=(const WordsOfStudy&) = delete;
  QLocale before_;
};

TEST_F(WordsOfStudy, EachRatingItsReasonAndEachStageHasItsOwn) {
  using study::Rating;
  using study::Stage;
  using Reason = study::RatingReason;
  for (const auto& [rating, name] : {std::pair(Rating::again, "Again"),
                                     {Rating::hard, "Hard"},
                                     {Rating::good, "Good"},
                                     {Rating::easy, "Easy"}})
    EXPECT_EQ(StudyWords::rating(rating), words(name));
  for (const auto& [stage, name] : {std::pair(Stage::watch, "Watch"),
                                    {Stage::trace, "Trace"},
                                    {Stage::guided, "Guided"},
                                    {Stage::memory, "Memory"},
                                    {Stage::brush, "Brush"}})
    EXPECT_EQ(StudyWords::stage(stage), words(name));
  for (const auto& [reason, name] : {std::pair(Reason::not_accepted, "not written correctly"),
                                     {Reason::strokes_shown, "strokes were shown"},
                                     {Reason::many_hints, "several hints"},
                                     {Reason::much_help, "written with help"},
                                     {Reason::some_help, "written with help"},
                                     {Reason::hint, "with a hint"},
                                     {Reason::missed_strokes, "a stroke was wrong at first"},
                                     {Reason::mistake, "correct, with a mistake"},
                                     {Reason::form, "correct, but the form is poor"},
                                     {Reason::slow, "correct, but slower than usual"},
                                     {Reason::quick, "no mistakes, and quick"},
                                     {Reason::usual, "correct"}})
    EXPECT_EQ(StudyWords::reason(reason), words(name));
}

TEST_F(WordsOfStudy, AKanaIsAskedByItsSoundAndHowItIsTyped) {
  using kanji::Script;
  EXPECT_EQ(StudyWords::kana_asked({"shi", "", false}, Script::hiragana), words("hiragana: shi"));
  EXPECT_EQ(StudyWords::kana_asked({"ji", "di", false}, Script::katakana), words("katakana: ji (typed di)"));
  EXPECT_EQ(StudyWords::kana_asked({"a", "xa", true}, Script::katakana), words("katakana: small a"));
  EXPECT_EQ(StudyWords::kana_asked({"-", "", false}, Script::katakana),
            words("katakana: the long vowel mark"));
}

TEST_F(WordsOfStudy, WhenACardComesAgainIsSaidLongAndShort) {
  using Unit = study::ReviewDelay::Unit;
  const std::tuple<study::ReviewDelay, const char*, const char*> all[] = {
      {{Unit::minutes, 7}, "in 7 minutes", "7 min"},  {{Unit::days, 1}, "tomorrow", "1 d"},
      {{Unit::days, 2}, "in 2 days", "2 d"},          {{Unit::months, 3}, "in 3 months", "3 mo"},
      {{Unit::years, 1.26}, "in 1.3 years", "1.3 y"}, {{Unit::years, 2.06}, "in 2.1 years", "2.1 y"}};
  for (const auto& [delay, far, near] : all) {
    EXPECT_EQ(StudyWords::comes_again(delay), words(far));
    EXPECT_EQ(StudyWords::comes_again_short(delay), words(near));
  }
}

TEST_F(WordsOfStudy, TimesAreRoundedToMinutesAndHours) {
  using std::chrono::milliseconds;
  EXPECT_EQ(StudyWords::about(milliseconds(29'999)), words("less than a minute"));
  EXPECT_EQ(StudyWords::about(milliseconds(90'001)), words("about 2 minutes"));
  EXPECT_EQ(StudyCharts::duration(milliseconds(29'999)), words("0 min"));
  EXPECT_EQ(StudyCharts::duration(minutes(59)), words("59 min"));
  EXPECT_EQ(StudyCharts::duration(minutes(60)), words("1 h 0 min"));
  EXPECT_EQ(StudyCharts::duration(minutes(1500)), words("25 h 0 min"));
  EXPECT_EQ(StudyCharts::duration(minutes(135)), words("2 h 15 min"));
  EXPECT_EQ(StudyCharts::percent(0.126), words("13%"));
  EXPECT_EQ(StudyCharts::percent(1), words("100%"));
  const auto calendar = study::Calendar::create("Asia/Tokyo");
  ASSERT_TRUE(calendar);
  EXPECT_EQ(StudyWords::minute(*study::parse_time("2026-11-22T00:05:00Z"), *calendar), words("9:05"));
}

TEST_F(WordsOfStudy, DaysAreNamedAsTheLanguageDoes) {
  const auto day = *study::parse_day("2026-11-22");
  EXPECT_EQ(StudyWords::day(day), words("Sunday 22 November"));
  EXPECT_EQ(StudyWords::short_day(day), words("22 Nov 2026"));
  EXPECT_EQ(StudyCharts::date(day), words("22 Nov 2026"));
  QLocale::setDefault(QLocale(QLocale::Japanese));
  EXPECT_EQ(StudyWords::day(day), words("11月22日（日）"));
  EXPECT_EQ(StudyWords::short_day(day), words("2026/11/22"));
  EXPECT_EQ(StudyCharts::date(day), words("2026年11月22日"));
}

TEST_F(WordsOfStudy, EachMistakeOfAStrokeIsSaidAsOftenAndCounted) {
  using Kind = kanji::MistakeKind;
  const std::tuple<Kind, const char*, const char*> all[] = {
      {Kind::order, "Stroke 3 of 語 is often out of order.",
       "Stroke 3 was out of order in 6 of 28 writings."},
      {Kind::reversed, "Stroke 3 of 語 is often written backwards.",
       "Stroke 3 was written backwards in 6 of 28 writings."},
      {Kind::missing, "Stroke 3 of 語 is often left out.", "Stroke 3 was left out in 6 of 28 writings."},
      {Kind::joined, "Stroke 3 of 語 is often joined to another one.",
       "Stroke 3 was joined to another one in 6 of 28 writings."},
      {Kind::split, "Stroke 3 of 語 is often written in pieces.",
       "Stroke 3 was written in pieces in 6 of 28 writings."},
      {Kind::extra, "語 often gets one stroke too many.", "Stroke 3 was one too many in 6 of 28 writings."},
      {Kind::other, "語 is often mistaken for another character.",
       "Stroke 3 belonged to another character in 6 of 28 writings."},
      {Kind::ending, "Stroke 3 of 語 often has the wrong shape or position.",
       "Stroke 3 ended wrongly in 6 of 28 writings."},
      {Kind::wrong, "Stroke 3 of 語 often has the wrong shape or position.",
       "Stroke 3 had the wrong shape or position in 6 of 28 writings."}};
  for (const auto& [kind, often, counted] : all) {
    const practice::StrokeTrouble trouble{2, kind, 6, 28};
    EXPECT_EQ(TroubleWords::often({U'語', 2, trouble}), words(often));
    EXPECT_EQ(TroubleWords::counted(trouble), words(counted));
  }
  EXPECT_EQ(TroubleWords::often({U'語', 2, {}}), words("語 is often forgotten."));
}

TEST_F(WordsOfStudy, TroubleWithALearnersFileIsSaidWithItsCause) {
  using Kind = practice::LearnerEvent::Kind;
  using Cause = practice::LearnerEvent::Cause;
  practice::LearnerEvent event;
  event.profile = "Mari";
  event.error = {base::Errc::not_found, "", "the place", ""};
  event.folder = "/data";
  const std::tuple<Kind, Feedback, const char*> all[] = {
      {Kind::no_folder, Feedback::wrong,
       "There is no folder for study data: set NAZORI_LEARNERS. Nothing will be saved."},
      {Kind::no_file, Feedback::wrong, "it does not exist"},
      {Kind::in_use, Feedback::wrong,
       "“Mari” is open in another Nazori window. Close it there; until then nothing is saved here."},
      {Kind::newer, Feedback::wrong,
       "The study data of Mari was written by a newer Nazori or by another program: the place. Nothing was "
       "changed, and nothing will be saved."},
      {Kind::damaged, Feedback::wrong,
       "The study data of Mari is damaged: the place. Nothing was changed. You can restore a backup."},
      {Kind::not_writable, Feedback::wrong,
       "The study data of Mari cannot be saved: it does not exist. Nothing will be saved."},
      {Kind::changing_settings, Feedback::wrong,
       "Every character of Mari is being worked out anew. Nothing is kept until that is done."},
      {Kind::replacing, Feedback::wrong,
       "The study data of Mari is being replaced. Nothing is saved until this is done."},
      {Kind::name_refused, Feedback::wrong,
       "“Mari” cannot be a learner name: use at most 60 letters (20 in Japanese), no “/”, and no dot at the "
       "start."},
      {Kind::opened_again, Feedback::good, "“Mari” is now open here. Everything is saved again."},
      {Kind::not_saved, Feedback::wrong, "Could not save: it does not exist."},
      {Kind::unread, Feedback::wrong, "The study data cannot be read: it does not exist."},
      {Kind::backup_failed, Feedback::advice,
       "Today's backup failed: it does not exist. You can still study."}};
  for (const auto& [kind, feedback, sentence] : all) {
    event.kind = kind;
    EXPECT_EQ(LearnerWords::sentence(event), words(sentence));
    EXPECT_EQ(LearnerWords::kind(event), feedback) << sentence;
  }
  event.kind = Kind::not_saved;
  event.cause = Cause::disk_full;
  EXPECT_EQ(LearnerWords::sentence(event),
            words("Could not save: the disk is full. Free up some space; everything saved before is safe."));
  event.cause = Cause::not_allowed;
  EXPECT_EQ(LearnerWords::sentence(event), words("Could not save: there is no permission to write to /data. "
                                                 "Check the permissions of the folder."));
  EXPECT_EQ(LearnerWords::sentence(std::optional<practice::LearnerEvent>()), QString());
}

TEST_F(WordsOfStudy, WhatASessionDoesIsSaidWithItsWeight) {
  using Kind = practice::SessionFeedback::Kind;
  practice::SessionFeedback feedback;
  feedback.characters = {U'休'};
  feedback.rating = study::Rating::hard;
  feedback.error = {base::Errc::io, "no disk", "learner.db", ""};
  feedback.trouble = practice::LearnerEvent();
  feedback.today = *study::parse_day("2026-11-22");
  feedback.card.memory.phase = study::Phase::review;
  feedback.card.due_day = feedback.today + std::chrono::days(12);
  const QString line = QString::fromStdString(base::to_line(feedback.error));
  const std::tuple<Kind, Feedback, QString> all[] = {
      {Kind::not_writable, Feedback::wrong, LearnerWords::sentence(*feedback.trouble)},
      {Kind::no_plan, Feedback::wrong, words("Today's study could not be prepared: %1.").arg(line)},
      {Kind::plan_lost, Feedback::wrong, line},
      {Kind::nothing_due, Feedback::hint, words("Nothing is due now.")},
      {Kind::nothing_to_undo, Feedback::hint, words("Nothing to undo.")},
      {Kind::all_done, Feedback::good, words("All done for now. Everything is saved.")},
      {Kind::ended, Feedback::hint, words("Session ended. Everything you rated is saved.")},
      {Kind::rated, Feedback::good, words("Saved: 休, Hard. Next review in 12 days.")},
      {Kind::set_apart, Feedback::advice,
       words("休 was forgotten too often and taken out of reviews. Relearn it from Home.")},
      {Kind::undone, Feedback::hint, words("Undone: the last entry for 休.")},
      {Kind::postponed, Feedback::hint, words("Postponed 休 to tomorrow. Ctrl+Shift+Z: undo.")},
      {Kind::paused, Feedback::hint, words("Suspended 休 until you resume it. Ctrl+Shift+Z: undo.")},
      {Kind::reset, Feedback::hint, words("Started 休 over as a new character. Ctrl+Shift+Z: undo.")}};
  for (const auto& [kind, weight, sentence] : all) {
    feedback.kind = kind;
    EXPECT_EQ(SessionWords::sentence(feedback), sentence);
    EXPECT_EQ(SessionWords::kind(feedback), weight) << sentence.toStdString();
  }
  EXPECT_EQ(SessionWords::sentence(std::optional<practice::SessionFeedback>()), QString());
  feedback.stage = study::Stage::brush;
  feedback.kind = Kind::nothing_due;
  EXPECT_EQ(SessionWords::sentence(feedback), words("No character is due with the brush now."));
  feedback.kind = Kind::all_done;
  EXPECT_EQ(SessionWords::sentence(feedback),
            words("All done with the brush for now. Every rating is saved."));
  feedback.kind = Kind::rated;
  EXPECT_TRUE(SessionWords::sentence(feedback).startsWith(
      words("Saved: 休 with the brush, Hard. Next time with the brush ")));
}

TEST_F(WordsOfStudy, WhatIsUndoneIsNamedUpToTwentyOneCharacters) {
  using study::EntryKind;
  practice::SessionFeedback feedback;
  feedback.kind = practice::SessionFeedback::Kind::undone;
  feedback.characters = {U'休', U'木'};
  const std::pair<EntryKind, const char*> all[] = {
      {EntryKind::writing, "Undone: the last entry for 休木."},
      {EntryKind::postpone, "Undone: 休木 is no longer postponed."},
      {EntryKind::pause, "Undone: 休木 is no longer suspended."},
      {EntryKind::resume, "Undone: 休木 is suspended again."},
      {EntryKind::reset, "Undone: your progress with 休木 is back."},
      {EntryKind::known, "Undone: 休木 is no longer marked as known."},
      {EntryKind::leech_met, "Undone: 休木."},
      {EntryKind::choices, "Undone: what you chose to learn, and 2 characters marked as known."}};
  for (const auto& [entry, sentence] : all) {
    feedback.entry = entry;
    EXPECT_EQ(SessionWords::sentence(feedback), words(sentence));
  }
  feedback.characters.clear();
  EXPECT_EQ(SessionWords::sentence(feedback), words("Undone: what you chose to learn."));
  feedback.entry = EntryKind::pause;
  feedback.characters.assign(21, U'木');
  EXPECT_EQ(SessionWords::sentence(feedback),
            words("Undone: %1 is no longer suspended.").arg(QString(21, QChar(u'木'))));
  feedback.characters.assign(22, U'木');
  EXPECT_EQ(SessionWords::sentence(feedback),
            words("Undone: %1… is no longer suspended.").arg(QString(21, QChar(u'木'))));
}

TEST_F(WordsOfStudy, StrengthsAndMistakesHaveWordsOfTheirOwn) {
  using study::Strength;
  using Kind = kanji::MistakeKind;
  for (const auto& [strength, name] : {std::pair(Strength::unseen, "not studied"),
                                       {Strength::learning, "learning"},
                                       {Strength::young, "recently learned"},
                                       {Strength::mature, "well known"},
                                       {Strength::leech, "difficult"},
                                       {Strength::paused, "suspended"}})
    EXPECT_EQ(StudyCharts::strength(strength), words(name));
  study::HardStroke stroke{U'休', 2, 11, 20, {{Kind::wrong, 4}, {Kind::order, 7}}};
  EXPECT_EQ(StudyCharts::mistakes(stroke), words("wrong order (7), wrong shape or position (4)"));
  study::Statistics statistics;
  statistics.hard_strokes = {stroke};
  const auto numbers = StudyCharts::hard_strokes(statistics);
  EXPECT_EQ(numbers.head, (QStringList{words("Character"), words("Stroke"), words("Times wrong"),
                                       words("Times written"), words("Mistakes")}));
  ASSERT_EQ(numbers.rows.size(), 1);
  EXPECT_EQ(numbers.rows[0], (QStringList{words("休"), words("3"), words("11"), words("20"),
                                          words("wrong order (7), wrong shape or position (4)")}));
  const std::pair<Kind, const char*> kinds[] = {{Kind::order, "wrong order"},
                                                {Kind::reversed, "drawn backwards"},
                                                {Kind::missing, "missing"},
                                                {Kind::extra, "extra stroke"},
                                                {Kind::joined, "joined to another stroke"},
                                                {Kind::split, "split into pieces"},
                                                {Kind::wrong, "wrong shape or position"},
                                                {Kind::other, "stroke of another character"},
                                                {Kind::ending, "wrong ending"}};
  for (const auto& [kind, name] : kinds) EXPECT_EQ(StudyCharts::mistake(kind), words(name));
}

}  // namespace
}  // namespace nazori::ui
