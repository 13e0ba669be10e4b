// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nazori/base/result.h"
#include "nazori/speech/sound.h"
#include "nazori/speech/spoken_kana.h"

namespace nazori::speech {

/// What speaks. All of it is found at run time, and none is needed: without a voice only recordings are
/// heard.
enum class VoiceKind : std::uint8_t {
  automatic,          ///< the best that is installed, in the order of this list
  open_jtalk,         ///< Open JTalk with an HTS voice: natural pitch
  speech_dispatcher,  ///< the voice of the desktop, as screen readers use it; it plays the sound itself
  espeak_ng,          ///< eSpeak NG: every kana plainly, without pitch
};
inline constexpr std::array kVoiceKinds{VoiceKind::automatic, VoiceKind::open_jtalk,
                                        VoiceKind::speech_dispatcher, VoiceKind::espeak_ng};

/// "automatic", "open-jtalk", "speech-dispatcher", "espeak-ng": for settings and the command line.
[[nodiscard]] std::string_view name_of(VoiceKind kind);
[[nodiscard]] std::optional<VoiceKind> voice_named(std::string_view name);

/// What the learner chose.
struct VoiceChoice {
  VoiceKind kind = VoiceKind::automatic;
  std::filesystem::path open_jtalk_voice;  ///< an .htsvoice file; empty: the first that is installed
  std::filesystem::path recordings;        ///< folder of recorded sound; empty: the usual one

  friend bool operator==(const VoiceChoice&, const VoiceChoice&) = default;
};

/// Where voices and recordings are looked for.
struct SpeechPlaces {
  std::vector<std::filesystem::path> programs;      ///< folders of programs, in order
  std::vector<std::filesystem::path> voices;        ///< folders with HTS voices, searched to any depth
  std::vector<std::filesystem::path> dictionaries;  ///< of Open JTalk; the first that exists is used
  std::filesystem::path recordings;

  /// Those of this computer: PATH, the folders of Debian's packages, and nazori/voices and nazori/sounds in
  /// XDG_DATA_HOME.
  [[nodiscard]] static SpeechPlaces of_system();
};

/// Whether a voice can be used.
struct VoiceState {
  VoiceKind kind = VoiceKind::espeak_ng;
  std::string name;                  ///< for people: "Open JTalk (mei_normal)", "eSpeak NG"
  std::optional<base::Error> error;  ///< why it cannot be used, with what to install
};

/// What a request for speech came to.
struct Spoken {
  std::string kana;                    ///< as it was read out, hiragana
  std::shared_ptr<const Sound> sound;  ///< null: the voice has played it itself
  std::string source;      ///< "recording", or the name of the voice: "espeak-ng"; for settings and JSON
  bool is_cached = false;  ///< spoken before and kept
};

/// Speaks kana with the best there is: a recorded file, else a voice. Sounds are kept in memory, up to
/// kMostKept_bytes; recordings are read again when the file has changed. Thread: one at a time; it waits for
/// the program that speaks, so not that of a window.
class Voices {
 public:
  static constexpr std::size_t kMostKept_bytes = 16U << 20U;
  /// Whether the work is still wanted; empty: always.
  using Wanted = std::function<bool()>;

  explicit Voices(SpeechPlaces places, VoiceChoice choice = {});
  ~Voices();
  Voices(Voices&&) noexcept;
  Voices& operator=(Voices&&) noexcept;

  /// Another choice; what was kept of another voice is forgotten.
  void choose(const VoiceChoice& choice);
  /// Looks for every voice again: it may have been installed meanwhile. In the order of VoiceKind, without
  /// `automatic`.
  [[nodiscard]] std::vector<VoiceState> find() const;
  /// The voice that speaks where there is no recording.
  /// @return Errc::not_found with what to install, where the chosen voice, or any, is missing.
  [[nodiscard]] base::Result<VoiceState> voice() const;

  /// @param text  kana, as spoken_kana() takes them.
  /// @param needs_sound  a voice that plays by itself is passed over.
  /// @return the errors of spoken_kana() and voice(); Errc::parse for a recording that cannot be read, with
  /// its path; Errc::io where the voice fails; Errc::cancelled.
  [[nodiscard]] base::Result<Spoken> speak(std::string_view text, bool needs_sound = false,
                                           const Wanted& is_wanted = {});

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace nazori::speech
