// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "nazori/base/result.h"
#include "nazori/speech/voice.h"

namespace nazori::speech {

/// A voice that was found, ready to speak.
struct Engine {
  VoiceKind kind = VoiceKind::espeak_ng;
  std::string name;           ///< for people
  bool plays_itself = false;  ///< gives no sound
  /// Speaks hiragana; null for a voice that plays by itself.
  std::function<base::Result<std::shared_ptr<const Sound>>(const std::string& kana,
                                                           const Voices::Wanted& is_wanted)>
      speak;
};

// Each looks for what it needs. @return Errc::not_found with what to install.
[[nodiscard]] base::Result<Engine> find_open_jtalk(const SpeechPlaces& places, const VoiceChoice& choice);
[[nodiscard]] base::Result<Engine> find_speech_dispatcher(const SpeechPlaces& places);
/// A Japanese voice that Speech Dispatcher has besides eSpeak NG; asks its service, which may take seconds.
[[nodiscard]] base::Result<Engine> find_dispatcher_beyond_espeak(const SpeechPlaces& places);
[[nodiscard]] base::Result<Engine> find_espeak_ng(const SpeechPlaces& places);
/// @param kind  automatic: Open JTalk, a voice of Speech Dispatcher besides eSpeak NG, eSpeak NG, or what
/// Speech Dispatcher has, whichever comes first.
[[nodiscard]] base::Result<Engine> find_engine(VoiceKind kind, const SpeechPlaces& places,
                                               const VoiceChoice& choice);

/// A program in the first of the folders that has it; empty where none has.
[[nodiscard]] std::filesystem::path find_program(const SpeechPlaces& places, const char* name);

}  // namespace nazori::speech
