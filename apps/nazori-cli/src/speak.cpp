// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "json_answers.h"
#include "nazori/audio/voice_sound.h"
#include "nazori/base/file.h"
#include "nazori/speech/voice.h"
#include "options.h"
#include "output_files.h"
#include "stop.h"
#include "verbs.h"

namespace nazori::cli {
namespace {

/// The sound card has some hundredths of a second in its buffer when the last sample was given to it.
constexpr std::chrono::milliseconds kLook{10}, kRest{120};

struct SpeakSettings {
  std::vector<std::string> kana;
  std::string output;
  std::string voice{speech::name_of(speech::VoiceKind::automatic)};
  std::string voice_file;
  std::string recordings;
  bool lists_voices = false;
  bool json = false;
};

std::vector<std::string> voice_names() {
  std::vector<std::string> names;
  for (const auto kind : speech::kVoiceKinds) names.emplace_back(speech::name_of(kind));
  return names;
}

int list_voices(Console& console, const speech::Voices& voices, const base::Result<speech::VoiceState>& used,
                bool json) {
  Json document = Json::array();
  std::string text;
  for (const auto& state : voices.find()) {
    const bool is_used = used && used->kind == state.kind;
    const std::string voice(speech::name_of(state.kind));
    const std::string name = is_used ? used->name : state.name;
    document.push_back({{"voice", voice},
                        {"name", name},
                        {"usable", !state.error},
                        {"used", is_used},
                        {"problem", state.error ? Json(base::to_line(*state.error)) : Json()}});
    text += fmt::format("{:<18} {}{}\n", voice, state.error ? base::to_line(*state.error) : name,
                        is_used ? ", speaks now" : "");
  }
  console.print(json ? to_text(document) : text);
  return used ? kDone : kNo;
}

Json spoken_json(const speech::Spoken& spoken, const std::string& file) {
  const auto* sound = spoken.sound.get();
  return {{"kana", spoken.kana},
          {"source", spoken.source},
          {"file", file.empty() ? Json() : Json(file)},
          {"rate_hz", sound != nullptr ? Json(sound->rate_hz) : Json()},
          {"duration_s", sound != nullptr ? Json(sound->duration_s()) : Json()},
          {"loudness", sound != nullptr ? Json(speech::loudness(*sound)) : Json()}};
}

base::Result<void> play(const speech::Sound& sound) {
  audio::VoiceSound loudspeakers;
  if (auto played = loudspeakers.play(sound); !played) return played;
  while (loudspeakers.is_playing() && !stop_requested()) std::this_thread::sleep_for(kLook);
  std::this_thread::sleep_for(kRest);
  return {};
}

int run(Console& console, const SpeakSettings& settings) {
  speech::VoiceChoice choice;
  choice.kind = *speech::voice_named(settings.voice);
  choice.open_jtalk_voice = settings.voice_file;
  choice.recordings = settings.recordings;
  speech::Voices voices(speech::SpeechPlaces::of_system(), choice);
  if (settings.lists_voices) return list_voices(console, voices, voices.voice(), settings.json);
  if (settings.kana.empty())
    return console.refuse({base::Errc::bad_argument, "there is nothing to speak", "kana",
                           "give kana, such as きゅうじつ, or --voices"});
  std::optional<OutputPlace> place;
  if (!settings.output.empty()) {
    auto found = output_file({"--output", settings.output, {".wav"}});
    if (!found) return console.refuse(found.error());
    if (auto fine = check_distinct(std::vector<NamedFile>{{"--output", found->name()}}, settings.json); !fine)
      return console.refuse(fine.error());
    place = std::move(*found);
  }
  std::string text;
  for (const auto& one : settings.kana) text += (text.empty() ? "" : "、") + one;
  const auto spoken = voices.speak(text, place.has_value(), [] { return !stop_requested(); });
  if (!spoken) return console.refuse(spoken.error());
  if (place) {
    const auto wav = speech::to_wav(*spoken->sound);
    if (!wav) return console.refuse(wav.error());
    if (auto written = base::write_file(place->path(), *wav); !written)
      return console.refuse(written.error());
    if (auto delivered = place->deliver(console); !delivered) return console.refuse(delivered.error());
  } else if (spoken->sound) {
    if (auto played = play(*spoken->sound); !played) return console.refuse(played.error());
  }
  if (settings.json)
    console.print(to_text(spoken_json(*spoken, place ? place->name() : std::string())));
  else if (place && !place->is_console())
    console.print(fmt::format("{}  {}  {}  {:.2f} s\n", spoken->kana, place->name(), spoken->source,
                              spoken->sound->duration_s()));
  else if (!place)
    console.print(fmt::format("{}  {}\n", spoken->kana, spoken->source));
  return kDone;
}

}  // namespace

void add_speak(CLI::App& app, Action& chosen) {
  auto settings = std::make_shared<SpeakSettings>();
  CLI::App* verb = app.add_subcommand("speak", "Speak kana, or write the sound to a file");
  verb->add_option("kana", settings->kana, "Hiragana or katakana; between several there is a pause");
  verb->add_option("-o,--output", settings->output,
                   "Write the sound to a .wav file and play nothing; - is standard output")
      ->type_name("FILE");
  verb->add_option("--voice", settings->voice, "What speaks where there is no recording")
      ->check(CLI::IsMember(voice_names()))
      ->capture_default_str()
      ->type_name("VOICE");
  verb->add_option("--voice-file", settings->voice_file, "Voice of Open JTalk (.htsvoice)")
      ->type_name("FILE");
  verb->add_option("--recordings", settings->recordings, "Folder of recorded sound")->type_name("FOLDER");
  verb->add_flag("--voices", settings->lists_voices,
                 "List the voices, which of them speaks now, and what the others need");
  verb->add_flag("--json", settings->json, "Print JSON (see docs/command-line.md)");
  verb->footer(
      "A recording of the kana (か.wav) comes before every voice; see docs/file-formats.md.\n\nExamples:\n"
      "  nazori-cli speak きゅうじつ\n  nazori-cli speak か --output か.wav --voice espeak-ng\n"
      "  nazori-cli speak --voices");
  verb->callback(
      [settings, &chosen] { chosen = [settings](Console& console) { return run(console, *settings); }; });
}

}  // namespace nazori::cli
