// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/study_words.h"

#include <QDateTime>
#include <QLocale>
#include <QTimeZone>

#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

using std::chrono::minutes;
using Unit = study::ReviewDelay::Unit;

QDate date_of(study::Day day) { return QDate(1970, 1, 1).addDays(day.time_since_epoch().count()); }

}  // namespace

QString StudyWords::rating(study::Rating rating) {
  switch (rating) {
    case study::Rating::again:
      return tr("Again");
    case study::Rating::hard:
      return tr("Hard");
    case study::Rating::good:
      return tr("Good");
    case study::Rating::easy:
      return tr("Easy");
  }
  return {};
}

QString StudyWords::reason(study::RatingReason reason) {
  using Reason = study::RatingReason;
  switch (reason) {
    case Reason::not_accepted:
      return tr("not written correctly");
    case Reason::strokes_shown:
      return tr("strokes were shown");
    case Reason::many_hints:
      return tr("several hints");
    case Reason::much_help:
    case Reason::some_help:
      return tr("written with help");
    case Reason::hint:
      return tr("with a hint");
    case Reason::missed_strokes:
      return tr("a stroke was wrong at first");
    case Reason::mistake:
      return tr("correct, with a mistake");
    case Reason::form:
      return tr("correct, but the form is poor");
    case Reason::slow:
      return tr("correct, but slower than usual");
    case Reason::quick:
      return tr("no mistakes, and quick");
    case Reason::usual:
      break;
  }
  return tr("correct");
}

QString StudyWords::kana_asked(const kanji::KanaSound& sound, kanji::Script script) {
  const QString romaji = to_text(sound.romaji);
  const QString plain = sound.romaji == "-"    ? tr("the long vowel mark")
                        : sound.is_small       ? tr("small %1").arg(romaji)
                        : !sound.typed.empty() ? tr("%1 (typed %2)").arg(romaji, to_text(sound.typed))
                                               : romaji;
  return script == kanji::Script::hiragana ? tr("hiragana: %1").arg(plain) : tr("katakana: %1").arg(plain);
}

QString StudyWords::stage(study::Stage stage) {
  switch (stage) {
    case study::Stage::watch:
      return tr("Watch");
    case study::Stage::trace:
      return tr("Trace");
    case study::Stage::guided:
      return tr("Guided");
    case study::Stage::memory:
      return tr("Memory");
    case study::Stage::brush:
      return tr("Brush");
  }
  return {};
}

QString StudyWords::comes_again(const study::Card& card, study::Time now, study::Day today) {
  return comes_again(study::review_delay(card, now, today));
}

QString StudyWords::comes_again(const study::ReviewDelay& delay) {
  const int amount = static_cast<int>(delay.amount);
  switch (delay.unit) {
    case Unit::minutes:
      return tr("in %n minutes", nullptr, amount);
    case Unit::days:
      return amount == 1 ? tr("tomorrow") : tr("in %n days", nullptr, amount);
    case Unit::months:
      return tr("in %n months", nullptr, amount);
    case Unit::years:
      return tr("in %1 years").arg(QLocale().toString(delay.amount, 'f', 1));
  }
  return {};
}

QString StudyWords::comes_again_short(const study::Card& card, study::Time now, study::Day today) {
  return comes_again_short(study::review_delay(card, now, today));
}

QString StudyWords::comes_again_short(const study::ReviewDelay& delay) {
  switch (delay.unit) {
    case Unit::minutes:
      return tr("%1 min").arg(delay.amount);
    case Unit::days:
      return tr("%1 d").arg(delay.amount);
    case Unit::months:
      return tr("%1 mo").arg(delay.amount);
    case Unit::years:
      return tr("%1 y").arg(QLocale().toString(delay.amount, 'f', 1));
  }
  return {};
}

QString StudyWords::about(std::chrono::milliseconds time) {
  const auto whole = std::chrono::round<minutes>(time).count();
  return whole < 1 ? tr("less than a minute") : tr("about %n minutes", nullptr, static_cast<int>(whole));
}

QString StudyWords::day(study::Day day) {
  const QLocale locale;
  return locale.toString(date_of(day), locale.language() == QLocale::Japanese
                                           ? QStringLiteral("M月d日（ddd）")
                                           : QStringLiteral("dddd d MMMM"));
}

QString StudyWords::short_day(study::Day day) {
  const QLocale locale;
  return locale.toString(date_of(day), locale.language() == QLocale::Japanese ? QStringLiteral("yyyy/M/d")
                                                                              : QStringLiteral("d MMM yyyy"));
}

QString StudyWords::minute(study::Time time, const study::Calendar& calendar) {
  const QTimeZone zone(QByteArray::fromStdString(calendar.zone()));
  const auto at = QDateTime::fromMSecsSinceEpoch(time.time_since_epoch().count(), Qt::UTC);
  return QLocale().toString((zone.isValid() ? at.toTimeZone(zone) : at.toLocalTime()).time(),
                            QStringLiteral("H:mm"));
}

}  // namespace nazori::ui
