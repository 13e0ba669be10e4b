// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>
#include <chrono>

#include "nazori/kanji/kana.h"
#include "nazori/kanji/kana_sound.h"
#include "nazori/study/card.h"
#include "nazori/study/learner_store.h"

namespace nazori::ui {

/// Words for the numbers and terms of study.
class StudyWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::StudyWords)
 public:
  [[nodiscard]] static QString rating(study::Rating rating);        ///< "Good"
  [[nodiscard]] static QString reason(study::RatingReason reason);  ///< "you asked for a hint"
  /// A kana by its sound: "hiragana: ji (typed di)", "katakana: small tsu".
  [[nodiscard]] static QString kana_asked(const kanji::KanaSound& sound, kanji::Script script);
  [[nodiscard]] static QString stage(study::Stage stage);  ///< "Trace"
  /// When a card comes again: "in 10 minutes", "tomorrow", "in 4 days", "in 3 months".
  [[nodiscard]] static QString comes_again(const study::Card& card, study::Time now, study::Day today);
  [[nodiscard]] static QString comes_again(const study::ReviewDelay& delay);
  /// The same where there is little room: "10 min", "1 d", "4 d", "3 mo".
  [[nodiscard]] static QString comes_again_short(const study::Card& card, study::Time now, study::Day today);
  [[nodiscard]] static QString comes_again_short(const study::ReviewDelay& delay);
  /// "about 4 minutes", "about half a minute".
  [[nodiscard]] static QString about(std::chrono::milliseconds time);
  /// A day by the language of the interface: "Tuesday 24 November".
  [[nodiscard]] static QString day(study::Day day);
  /// "24 Nov 2026".
  [[nodiscard]] static QString short_day(study::Day day);
  /// The minute on the learner's clock: "14:20".
  [[nodiscard]] static QString minute(study::Time time, const study::Calendar& calendar);
};

}  // namespace nazori::ui
