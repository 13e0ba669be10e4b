// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <cstdint>
#include <optional>
#include <utility>

#include "nazori/audio/voice_sound.h"
#include "nazori/practice/practice_speech.h"
#include "nazori/speech/speaker.h"

class QAction;

namespace nazori::ui {

class CharacterActions;
class WindowParts;

/// Speaks readings and words in the window: by itself while that is switched on, and when the learner asks
/// for it. What is to be spoken, and when, is decided by practice::PracticeSpeech. Thread: interface.
class SpokenReadings final : public QObject {
  Q_OBJECT
 public:
  SpokenReadings(WindowParts& parts, CharacterActions& actions, QObject* parent);
  ~SpokenReadings() override;

 private:
  void connect_actions();
  void connect_speaker();
  void hear(const std::string& kana, practice::PracticeSpeech::Cause cause);
  void use(std::uint64_t number, const speech::Spoken& spoken);
  void refuse(std::uint64_t number, const base::Error& error);
  void choose(speech::VoiceKind kind);
  void ask_for_voice_file();
  void show_choice();
  [[nodiscard]] speech::VoiceChoice choice() const;
  /// The sentence for an error of a voice.
  [[nodiscard]] static QString why_silent(const base::Error& error);

  WindowParts& parts_;
  CharacterActions& actions_;
  QList<std::pair<QAction*, speech::VoiceKind>> voices_;
  std::uint64_t awaited_ = 0;  ///< the request that the learner made by key: its failure is announced
  bool has_no_card_ = false;   ///< the sound card refused: only a key tries it again
  practice::PracticeSpeech readings_;
  audio::VoiceSound sound_;
  speech::Speaker speaker_;
};

}  // namespace nazori::ui
