// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/page/window_parts.h"

#include <QTimer>
#include <algorithm>
#include <utility>

#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/learner_words.h"
#include "nazori/widgets/words/session_words.h"

namespace nazori::ui {
namespace {

constexpr int kOpenedAtLatest_ms = 10'000;
constexpr int kLookAtTheDay_ms = 60'000;

}  // namespace

WindowParts::WindowParts(QWidget& window, QString settings_file, const practice::Learner::Place& learner)
    : window_(window),
      settings_file_(settings_file.isEmpty() ? Preferences::default_file() : std::move(settings_file)),
      preferences_(Preferences::load(settings_file_)),
      library_(inbox(), learner.characters),
      workshop_(inbox(), learner.characters.own),
      judge_(inbox(), learner.characters),
      recording_(inbox(), tablet_.device(), unfinished_recordings(settings_file_)),
      learner_(inbox(), learner),
      practice_({inbox(), clock_, tablet_, library_, workshop_, judge_, session_}) {
  tablet_.set_style(preferences_.style);
  connect(this, &WindowParts::character_shown, this, &WindowParts::note_opened);
  connect(this, &WindowParts::own_characters_changed, this, [this] { learner_.renew_characters(); });
  QTimer::singleShot(kOpenedAtLatest_ms, this, &WindowParts::note_opened);
  subscribe(learner_.announced, this, [this](const practice::LearnerEvent& event) {
    announce_when_open(LearnerWords::kind(event), LearnerWords::sentence(event));
  });
  connect(&day_timer_, &QTimer::timeout, this, [this] { learner_.tick(); });
  day_timer_.start(kLookAtTheDay_ms);
  const auto announce_feedback = [this](const practice::SessionFeedback& feedback) {
    announce(SessionWords::kind(feedback), SessionWords::sentence(feedback));
  };
  subscribe(session_.announced, this, announce_feedback);
  subscribe(brush_session_.announced, this, announce_feedback);
  session_.set_asks_by_words(preferences_.asks_by_words);
  subscribe(learner_.profile_changed, this, [this] {
    preferences_.profile = to_text(learner_.profile());
    save_later();
  });
  if (!learner_.switch_profile(preferences_.profile.toStdString()) && learner_.profile().empty())
    learner_.switch_profile(Preferences().profile.toStdString());
}

WindowParts::~WindowParts() = default;

void WindowParts::announce(Feedback kind, const QString& sentence) {
  if (!sentence.isEmpty()) emit announced(kind, sentence);
}

void WindowParts::announce_when_open(Feedback kind, const QString& sentence) {
  if (is_open_)
    announce(kind, sentence);
  else
    waiting_.append({kind, sentence});
}

void WindowParts::note_opened() {
  if (std::exchange(is_open_, true)) return;
  // There is only one line, so only the most serious sentence is announced; of equals, the first.
  const auto waiting = std::exchange(waiting_, {});
  const auto most_serious = std::max_element(waiting.begin(), waiting.end(),
                                             [](const auto& a, const auto& b) { return a.first < b.first; });
  if (most_serious != waiting.end()) announce(most_serious->first, most_serious->second);
  emit opened();
}

}  // namespace nazori::ui
