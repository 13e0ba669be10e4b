// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <QTimer>
#include <algorithm>
#include <utility>

namespace nazori::ui {
namespace {

constexpr int kSettled_ms = 10'000;

}  // namespace

Desk::Desk(QWidget& window, const std::filesystem::path& database, QString settings_file,
           const Learner::Place& learner)
    : window_(window),
      settings_file_(settings_file.isEmpty() ? Preferences::default_file() : std::move(settings_file)),
      preferences_(Preferences::load(settings_file_)),
      library_(inbox(), database),
      judge_(inbox(), database),
      recording_(controller_.stylus(), settings_file_),
      learner_(learner) {
  controller_.set_style(preferences_.style);
  connect(this, &Desk::character_shown, this, &Desk::note_opened);
  QTimer::singleShot(kSettled_ms, this, &Desk::note_opened);
  connect(&learner_, &Learner::said, this, &Desk::tell);
  connect(&session_, &StudySession::said, this, &Desk::say);
  session_.set_asks_by_words(preferences_.asks_by_words);
  connect(&learner_, &Learner::profile_changed, this, [this] {
    preferences_.profile = learner_.profile();
    save_later();
  });
  if (!learner_.switch_profile(preferences_.profile) && learner_.profile().isEmpty())
    learner_.switch_profile(Preferences().profile);
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
