// SPDX-License-Identifier: Apache-2.0
#include "study/home_words.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "nazori/kanji/kana_sound.h"
#include "nazori/kanji/kun_reading.h"
#include "nazori/kanji/meanings.h"
#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/study_words.h"

namespace nazori::ui {
namespace {

constexpr std::size_t kMostShown = 12;  ///< characters in a sentence
constexpr int kDaysForWeeks = 14;
constexpr int kDaysForMonths = 60;
constexpr int kDaysForYears = 730;
constexpr double kDaysOfMonth = 30.44;
constexpr double kDaysOfYear = 365.25;

}  // namespace

QString HomeWords::greeting(practice::PartOfDay part) {
  switch (part) {
    case practice::PartOfDay::morning:
      return tr("Good morning");
    case practice::PartOfDay::afternoon:
      return tr("Good afternoon");
    case practice::PartOfDay::evening:
      break;
  }
  return tr("Good evening");
}

QString HomeWords::streak(const study::Streak& streak) {
  return streak.days == 0 ? QString() : tr("%n days in a row", nullptr, streak.days);
}

QString HomeWords::work(int reviews, int fresh) {
  const QString old = tr("%n reviews", nullptr, reviews);
  const QString news = tr("%n new characters", nullptr, fresh);
  if (fresh == 0) return old;
  return reviews == 0 ? news : tr("%1 and %2", "reviews and new characters").arg(old, news);
}

QString HomeWords::minutes(std::chrono::milliseconds time) {
  return tr("%1 min").arg(std::max<std::int64_t>(1, std::chrono::round<std::chrono::minutes>(time).count()));
}

QString HomeWords::list(const practice::Milestone& milestone) {
  return milestone.list == practice::kSchoolKanji ? tr("All school kanji")
                                                  : ListChoice::name_of(to_text(milestone.list));
}

QString HomeWords::count(const practice::Milestone& milestone) {
  const QLocale locale;
  return tr("%1 of %2", "learned, of all")
      .arg(locale.toString(milestone.learned), locale.toString(milestone.size));
}

QString HomeWords::done(const practice::Milestone& milestone) {
  if (milestone.size > 0 && milestone.learned == milestone.size) return tr("Done.");
  return milestone.days_left ? tr("Done in %1 at this pace.").arg(about_days(*milestone.days_left))
                             : QString();
}

QString HomeWords::about_days(int days) {
  const auto rounded = [days](double unit) { return static_cast<int>(std::lround(days / unit)); };
  if (days < kDaysForWeeks) return tr("about %n days", nullptr, std::max(1, days));
  if (days < kDaysForMonths) return tr("about %n weeks", nullptr, rounded(7));
  if (days < kDaysForYears) return tr("about %n months", nullptr, rounded(kDaysOfMonth));
  return tr("about %n years", nullptr, rounded(kDaysOfYear));
}

QString HomeWords::written(const practice::WritingRecord& record) {
  const QString count = tr("%1 written, %2 right").arg(record.writings.size()).arg(record.right());
  if (record.time.count() == 0) return count;
  return tr("%1 · %2", "written and right, time").arg(count, StudyWords::about(record.time));
}

QString HomeWords::outlook(const practice::DayOutlook& outlook, const study::Calendar& calendar) {
  using Kind = practice::DayOutlook::Kind;
  switch (outlook.kind) {
    case Kind::later_today:
      return tr("Done for now. %n characters come back today, the first at %1.", nullptr, outlook.characters)
          .arg(StudyWords::minute(outlook.first, calendar));
    case Kind::limit_reached:
      return tr("Done for today: you have reached your daily limit. %n reviews will wait until tomorrow.",
                nullptr, outlook.characters);
    case Kind::nothing_to_learn:
      return tr(
          "Nothing to learn yet. In the study settings, choose lists and how many new characters you want "
          "per day.");
    case Kind::reviews_tomorrow:
      return tr("Done for today. %n reviews are due tomorrow.", nullptr, outlook.characters);
    case Kind::new_tomorrow:
      return tr("Done for today. Tomorrow: new characters, no reviews.");
    case Kind::nothing_tomorrow:
      return tr("Done for today. Nothing is due tomorrow.");
  }
  return {};
}

QString HomeWords::advice(const study::DayPlan& plan, bool is_newcomer) {
  QStringList said;
  if (plan.gentle) {
    said.append(
        tr("%n reviews are waiting. No hurry: do %1 today, starting with the characters you know best.",
           nullptr, plan.gentle->overdue)
            .arg(plan.gentle->per_day));
    said.append(
        tr("You will catch up in %n days, on %1. No new characters until then.", nullptr, plan.gentle->days)
            .arg(StudyWords::day(plan.gentle->last_day)));
  } else if (plan.held_back > 0) {
    said.append(tr("%n more reviews will wait for another day because of your daily limit.", nullptr,
                   plan.held_back));
  }
  if (is_newcomer)
    said.append(
        tr("You first watch each new character, then trace it, then write it with less and less help, and "
           "finally from memory. It comes back just before you would forget it."));
  return said.join(QLatin1Char('\n'));
}

QString HomeWords::in_a_row(const std::vector<char32_t>& characters) {
  QString text;
  for (std::size_t i = 0; i < characters.size() && i < kMostShown; ++i) text += to_text(characters[i]);
  return characters.size() > kMostShown ? text + QStringLiteral("…") : text;
}

QString HomeWords::caption(const kanji::KanjiDatabase* database, char32_t character) {
  if (const auto sound = kanji::kana_sound(character)) return to_text(sound->romaji);
  if (database == nullptr) return {};
  const auto found = database->find(character);
  if (!found) return {};
  const bool english = QLocale().language() == QLocale::English;
  const auto own =
      kanji::meanings_in(QLocale().name().section(QLatin1Char('_'), 0, 0).toStdString(), found->entry);
  if (!own.empty()) return to_text(own.front());
  if (!english && !found->entry.kun_readings.empty())
    return kun_plain(kanji::split_kun(found->entry.kun_readings.front()));
  if (!english && !found->entry.on_readings.empty()) return to_text(found->entry.on_readings.front());
  const auto meanings = kanji::meanings_in("en", found->entry);
  return meanings.empty() ? QString() : to_text(meanings.front());
}

}  // namespace nazori::ui
