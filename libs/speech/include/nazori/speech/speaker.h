// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "nazori/base/executor.h"
#include "nazori/base/result.h"
#include "nazori/base/signal.h"
#include "nazori/speech/voice.h"

namespace nazori::speech {

/// Voices on another thread: requests return at once, answers come as signals. Only the newest request is
/// answered; an older one is stopped. Thread: the owner of the inbox.
class Speaker {
 public:
  /// @param inbox  outlives this.
  Speaker(base::Inbox& inbox, SpeechPlaces places, VoiceChoice choice = {});
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  [[nodiscard]] const VoiceChoice& choice() const { return choice_; }
  /// Another voice, from the next request on.
  void choose(const VoiceChoice& choice);
  /// Asks for kana to be spoken; `spoken` or `failed` follows. @return a number, counted from 1.
  std::uint64_t speak(const std::string& kana);
  /// Nothing that was asked for is answered any more.
  void stop();
  /// Whether the newest request is not yet answered.
  [[nodiscard]] bool is_busy() const;
  /// Asks which voice speaks; `voice_found` follows.
  void find_voice();

  base::Signal<std::uint64_t, const Spoken&> spoken;
  base::Signal<std::uint64_t, const base::Error&> failed;
  /// The voice that speaks where there is no recording, or why there is none.
  base::Signal<const base::Result<VoiceState>&> voice_found;

 private:
  VoiceChoice choice_;
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::speech
