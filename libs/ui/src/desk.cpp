// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "kanji_text.h"
#include "signals.h"
#include "stored_settings.h"
#include "study/learner_words.h"
#include "study/session_words.h"

namespace nazori::ui {
namespace {

constexpr int kSettled_ms = 10'000;
constexpr int kLookAtTheDay_ms = 60'000;

}  // namespace

Desk::Desk(QWidget& window, const std::filesystem::path& database, QString settings_file,
           const practice::Learner::Place& learner)
    : window_(window),
      settings_file_(settings_file.isEmpty() ? Preferences::default_file() : std::move(settings_file)),
      preferences_(Preferences::load(settings_file_)),
      library_(inbox(), database),
      judge_(inbox(), database),
      recording_(inbox(), tablet_.device(), unfinished_recordings(settings_file_)),
      learner_(inbox(), learner),
      practice_({inbox(), clock_, tablet_, library_, workshop_, judge_, session_}) {
  tablet_.set_style(preferences_.style);
  connect(this, &Desk::character_shown, this, &Desk::note_opened);
  QTimer::singleShot(kSettled_ms, this, &Desk::note_opened);
  subscribe(learner_.announced, this, [this](const practice::LearnerEvent& event) {
    tell(LearnerWords::kind(event), LearnerWords::sentence(event));
  });
  connect(&day_timer_, &QTimer::timeout, this, [this] { learner_.tick(); });
  day_timer_.start(kLookAtTheDay_ms);
  subscribe(session_.announced, this, [this](const practice::SessionFeedback& feedback) {
    say(SessionWords::kind(feedback), SessionWords::sentence(feedback));
  });
  session_.set_asks_by_words(preferences_.asks_by_words);
  subscribe(learner_.profile_changed, this, [this] {
    preferences_.profile = to_text(learner_.profile());
    save_later();
  });
  if (!learner_.switch_profile(preferences_.profile.toStdString()) && learner_.profile().empty())
    learner_.switch_profile(Preferences().profile.toStdString());
}

Desk::~Desk() = default;

void Desk::say(Feedback kind, const QString& sentence) {
  if (!sentence.isEmpty()) emit said(kind, sentence);
}

void Desk::tell(Feedback kind, const QString& sentence) {
  if (settled_)
    say(kind, sentence);
  else
    news_.append({kind, sentence});
}

void Desk::note_opened() {
  if (std::exchange(settled_, true)) return;
  // There is one line: the first of what is gravest.
  const auto news = std::exchange(news_, {});
  const auto gravest = std::max_element(news.begin(), news.end(),
                                        [](const auto& a, const auto& b) { return a.first < b.first; });
  if (gravest != news.end()) say(gravest->first, gravest->second);
  emit opened();
}

}  // namespace nazori::ui
