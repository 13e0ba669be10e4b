// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>
#include <chrono>
#include <vector>

#include "nazori/kanji/kanji_database.h"
#include "nazori/practice/day_outlook.h"
#include "nazori/practice/day_record.h"
#include "nazori/practice/milestones.h"

namespace nazori::ui {

/// Sentences about a learner's day and progress. Pure: no widget.
class HomeWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::HomeWords)
 public:
  [[nodiscard]] static QString greeting(practice::PartOfDay part);
  /// "12 days in a row"; empty without one. A break is not mentioned.
  [[nodiscard]] static QString streak(const study::Streak& streak);
  /// "12 reviews and 5 new characters".
  [[nodiscard]] static QString work(int reviews, int fresh);
  /// "8 min".
  [[nodiscard]] static QString minutes(std::chrono::milliseconds time);
  /// "Grade 3", "All school kanji".
  [[nodiscard]] static QString list(const practice::Milestone& milestone);
  /// "180 of 200".
  [[nodiscard]] static QString count(const practice::Milestone& milestone);
  /// "Done in about 2 weeks at this pace.", "Done."; empty where nothing is foretold.
  [[nodiscard]] static QString done(const practice::Milestone& milestone);
  /// "about 2 weeks", "about 4 years".
  [[nodiscard]] static QString about_days(int days);
  /// "14 written, 12 right".
  [[nodiscard]] static QString written(const practice::WritingRecord& record);
  /// What comes when nothing is due now.
  [[nodiscard]] static QString outlook(const practice::DayOutlook& outlook, const study::Calendar& calendar);
  /// A backlog, a limit, and for a newcomer how a character is learned; empty where there is nothing to say.
  [[nodiscard]] static QString advice(const study::DayPlan& plan, bool is_newcomer);
  /// The characters one after another, at most twelve and then "…".
  [[nodiscard]] static QString in_a_row(const std::vector<char32_t>& characters);
  /// What is written below a new character: its first meaning in the language of the interface; where the
  /// dictionary has none its first reading, of a kana its sound, and in English its English meaning.
  [[nodiscard]] static QString caption(const kanji::KanjiDatabase* database, char32_t character);
};

}  // namespace nazori::ui
