// SPDX-License-Identifier: Apache-2.0
#include "characters/spoken_readings.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QSignalBlocker>

#include "characters/character_actions.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

using Cause = practice::PracticeSpeech::Cause;
using speech::VoiceKind;

SpokenReadings::SpokenReadings(WindowParts& parts, CharacterActions& actions, QObject* parent)
    : QObject(parent),
      parts_(parts),
      actions_(actions),
      voices_({{actions.voice_automatic, VoiceKind::automatic},
               {actions.voice_open_jtalk, VoiceKind::open_jtalk},
               {actions.voice_dispatcher, VoiceKind::speech_dispatcher},
               {actions.voice_espeak, VoiceKind::espeak_ng}}),
      readings_(parts.practice(), parts.session()),
      speaker_(parts.inbox(), speech::SpeechPlaces::of_system()) {
  speaker_.choose(choice());
  show_choice();
  connect_actions();
  connect_speaker();
}

SpokenReadings::~SpokenReadings() = default;

speech::VoiceChoice SpokenReadings::choice() const {
  const auto& preferences = parts_.preferences();
  speech::VoiceChoice choice;
  choice.kind = speech::voice_named(preferences.voice.toStdString()).value_or(VoiceKind::automatic);
  choice.open_jtalk_voice = preferences.voice_file.toStdString();
  return choice;
}

void SpokenReadings::show_choice() {
  actions_.speaks_itself->setChecked(parts_.preferences().speaks);
  for (const auto& [action, kind] : voices_) action->setChecked(kind == speaker_.choice().kind);
}

void SpokenReadings::connect_actions() {
  connect(actions_.speak, &QAction::triggered, this, [this] {
    if (!readings_.speak()) parts_.announce(Feedback::advice, tr("There is no reading to speak."));
  });
  connect(actions_.speaks_itself, &QAction::triggered, this, [this](bool on) {
    parts_.preferences().speaks = on;
    parts_.save_later();
    if (!on) {
      speaker_.stop();
      sound_.close();
    }
    parts_.announce(Feedback::hint,
                    on ? tr("Readings are spoken.") : tr("Readings are not spoken. V: speak one."));
  });
  for (const auto& [action, kind] : voices_)
    connect(action, &QAction::triggered, this, [this, kind = kind] { choose(kind); });
  connect(actions_.voice_file, &QAction::triggered, this, [this] { ask_for_voice_file(); });
}

void SpokenReadings::connect_speaker() {
  subscribe(readings_.wanted, this, [this](const std::string& kana, Cause cause) { hear(kana, cause); });
  subscribe(speaker_.spoken, this,
            [this](std::uint64_t number, const speech::Spoken& spoken) { use(number, spoken); });
  subscribe(speaker_.failed, this,
            [this](std::uint64_t number, const base::Error& error) { refuse(number, error); });
  subscribe(speaker_.voice_found, this, [this](const base::Result<speech::VoiceState>& voice) {
    if (voice)
      parts_.announce(Feedback::good, tr("Voice: %1.").arg(to_text(voice->name)));
    else
      parts_.announce(Feedback::advice, why_silent(voice.error()));
  });
}

void SpokenReadings::hear(const std::string& kana, Cause cause) {
  const bool by_key = cause == Cause::wanted;
  if (!by_key && (!parts_.preferences().speaks || has_no_card_)) return;
  const auto number = speaker_.speak(kana);
  if (by_key) awaited_ = number;
}

void SpokenReadings::use(std::uint64_t number, const speech::Spoken& spoken) {
  if (!spoken.sound) return;  // the voice has played it itself
  sound_.set_volume(parts_.preferences().sound_volume);
  const auto played = sound_.play(*spoken.sound);
  has_no_card_ = !played;
  if (!played && number == awaited_) parts_.announce(Feedback::advice, no_sound(played.error()));
}

void SpokenReadings::refuse(std::uint64_t number, const base::Error& error) {
  // What speaks by itself is silent without a voice; the learner who asks for it is told why.
  if (number == awaited_) parts_.announce(Feedback::advice, why_silent(error));
}

QString SpokenReadings::why_silent(const base::Error& error) {
  if (error.code == base::Errc::not_found && error.where == "speech")
    return tr("No Japanese voice is installed. Install the package espeak-ng.");
  if (error.code == base::Errc::not_found)
    return tr("%1 cannot speak: something is missing (%2).").arg(to_text(error.where), to_text(error.remedy));
  return tr("Cannot speak: %1.").arg(reason(error));
}

void SpokenReadings::choose(VoiceKind kind) {
  parts_.preferences().voice = to_text(speech::name_of(kind));
  parts_.save_later();
  speaker_.choose(choice());
  show_choice();
  speaker_.find_voice();
}

void SpokenReadings::ask_for_voice_file() {
  const QString file =
      QFileDialog::getOpenFileName(&parts_.window(), tr("Voice for Open JTalk"),
                                   parts_.preferences().voice_file, tr("Voices (*.htsvoice)"));
  if (file.isEmpty()) return;
  parts_.preferences().voice_file = file;
  choose(VoiceKind::open_jtalk);
}

}  // namespace nazori::ui
