// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <list>
#include <system_error>
#include <utility>

#include "engines.h"
#include "nazori/base/program_folders.h"
#include "nazori/speech/voice.h"
#include "recordings.h"

namespace nazori::speech {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, kVoiceKinds.size()> kNames{"automatic", "open-jtalk",
                                                                  "speech-dispatcher", "espeak-ng"};
constexpr const char* kRecording = "recording";

/// Folders of a list such as PATH.
std::vector<fs::path> folders_of(const char* list) {
  std::vector<fs::path> folders;
  std::string_view rest = list == nullptr ? std::string_view() : std::string_view(list);
  while (!rest.empty()) {
    const auto end = std::min(rest.find(':'), rest.size());
    // An empty entry means the working folder, from which nothing is started.
    if (end > 0) folders.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return folders;
}

/// A sound with where it came from.
struct Kept {
  std::string name;
  Spoken spoken;
  fs::file_time_type changed;  ///< of a recording
};

std::size_t bytes_of(const Kept& kept) { return kept.spoken.sound->samples.size() * sizeof(float); }

}  // namespace

std::string_view name_of(VoiceKind kind) {
  const auto at = static_cast<std::size_t>(kind);
  return at < kNames.size() ? kNames[at] : std::string_view();
}

std::optional<VoiceKind> voice_named(std::string_view name) {
  for (const VoiceKind kind : kVoiceKinds)
    if (name_of(kind) == name) return kind;
  return std::nullopt;
}

SpeechPlaces SpeechPlaces::of_system() {
  SpeechPlaces places;
  places.programs = folders_of(std::getenv("PATH"));
  const fs::path own = base::user_data_folder();
  if (!own.empty()) {
    places.voices.push_back(own / "voices");
    places.recordings = own / "sounds";
  }
  places.voices.emplace_back("/usr/local/share/hts-voice");
  places.voices.emplace_back("/usr/share/hts-voice");
  places.dictionaries = {"/var/lib/mecab/dic/open-jtalk/naist-jdic", "/usr/share/open_jtalk/dic",
                         "/usr/local/share/open_jtalk/dic"};
  return places;
}

struct Voices::Inside {
  SpeechPlaces places;
  VoiceChoice choice;
  std::optional<Engine> engine;  ///< once found
  std::list<Kept> kept;          ///< used last first
  std::size_t kept_bytes = 0;

  base::Result<const Engine*> found() {
    if (!engine) {
      auto looked = find_engine(choice.kind, places, choice);
      if (!looked) return tl::unexpected(looked.error());
      engine = std::move(*looked);
    }
    return &*engine;
  }

  /// What was kept under a name, put first; nullptr where there is none.
  const Kept* find_kept(const std::string& name, bool is_recording) {
    const auto at = std::find_if(kept.begin(), kept.end(), [&](const Kept& one) {
      return one.name == name && (one.spoken.source == kRecording) == is_recording;
    });
    if (at == kept.end()) return nullptr;
    kept.splice(kept.begin(), kept, at);
    return &kept.front();
  }

  void keep(Kept one) {
    const bool is_recording = one.spoken.source == kRecording;
    if (find_kept(one.name, is_recording) != nullptr) drop(kept.begin());
    kept_bytes += bytes_of(one);
    one.spoken.is_cached = true;
    kept.push_front(std::move(one));
    while (kept_bytes > kMostKept_bytes) drop(std::prev(kept.end()));
  }

  void drop(std::list<Kept>::iterator one) {
    kept_bytes -= bytes_of(*one);
    kept.erase(one);
  }

  /// nullopt where there is no recording.
  std::optional<base::Result<Spoken>> recording(const std::string& name) {
    const fs::path path =
        recording_of(choice.recordings.empty() ? places.recordings : choice.recordings, name);
    if (path.empty()) return std::nullopt;
    std::error_code ignored;
    const auto changed = fs::last_write_time(path, ignored);
    if (const Kept* before = find_kept(name, true); before != nullptr && before->changed == changed)
      return before->spoken;
    auto sound = read_sound(path);
    if (!sound) return tl::unexpected(sound.error());
    Spoken spoken{name, std::make_shared<const Sound>(std::move(*sound)), kRecording};
    keep({name, spoken, changed});
    return spoken;
  }
};

Voices::Voices(SpeechPlaces places, VoiceChoice choice)
    : inside_(std::make_unique<Inside>(Inside{std::move(places), std::move(choice), {}, {}})) {}
Voices::~Voices() = default;
Voices::Voices(Voices&&) noexcept = default;
Voices& Voices::operator=(Voices&&) noexcept = default;

void Voices::choose(const VoiceChoice& choice) {
  if (choice == inside_->choice) return;
  inside_->choice = choice;
  inside_->engine.reset();
  inside_->kept.clear();
  inside_->kept_bytes = 0;
}

std::vector<VoiceState> Voices::find() const {
  std::vector<VoiceState> states;
  for (const VoiceKind kind : kVoiceKinds) {
    if (kind == VoiceKind::automatic) continue;
    const auto found = find_engine(kind, inside_->places, inside_->choice);
    if (found)
      states.push_back({kind, found->name, {}});
    else
      states.push_back({kind, std::string(name_of(kind)), found.error()});
  }
  return states;
}

base::Result<VoiceState> Voices::voice() const {
  const auto found = inside_->found();
  if (!found) return tl::unexpected(found.error());
  return VoiceState{(*found)->kind, (*found)->name, {}};
}

base::Result<Spoken> Voices::speak(std::string_view text, bool needs_sound, const Wanted& is_wanted) {
  const auto kana = spoken_kana(text);
  if (!kana) return tl::unexpected(kana.error());
  if (auto recorded = inside_->recording(kana->name)) return std::move(*recorded);
  if (const Kept* before = inside_->find_kept(kana->name, false); before != nullptr) return before->spoken;
  const auto found = inside_->found();
  if (!found) return tl::unexpected(found.error());
  const Engine* engine = *found;
  std::optional<Engine> other;
  if (needs_sound && engine->plays_itself) {
    auto looked = find_espeak_ng(inside_->places);
    if (!looked) return tl::unexpected(looked.error());
    other = std::move(*looked);
    engine = &*other;
  }
  const auto sound = engine->speak(kana->said, is_wanted);
  if (!sound) return tl::unexpected(sound.error());
  Spoken spoken{kana->said, *sound, std::string(name_of(engine->kind))};
  if (spoken.sound && !other) inside_->keep({kana->name, spoken, {}});
  return spoken;
}

}  // namespace nazori::speech
