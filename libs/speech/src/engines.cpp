// SPDX-License-Identifier: Apache-2.0
#include "engines.h"

#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <system_error>
#include <utility>

#include "child_program.h"
#include "nazori/base/utf8.h"
#include "nazori/kanji/kana.h"

namespace nazori::speech {
namespace {

namespace fs = std::filesystem;

/// Words per minute: slower than speech, so that a learner hears every kana.
constexpr const char* kEspeakPace = "130";
/// For speech-dispatcher, -100 to 100 about its own pace.
constexpr const char* kDispatcherPace = "-20";
constexpr std::size_t kMostAnswer = 1U << 20U;
constexpr std::chrono::milliseconds kLongestAnswer{3000};
/// Where a program writes the sound that is read from its standard output. A name, because both programs go
/// back in the file to put the length into its head.
constexpr const char* kOutput = "/dev/stdout";

tl::unexpected<base::Error> missing(const char* what, const char* remedy) {
  return base::fail(base::Errc::not_found, "is not installed", what, remedy);
}

base::Result<std::shared_ptr<const Sound>> sound_of(const ChildProgram& child,
                                                    const Voices::Wanted& is_wanted) {
  const auto output = run(child, is_wanted);
  if (!output) return tl::unexpected(output.error());
  auto sound = decode_sound(*output);
  if (!sound) {
    base::Error error = sound.error();
    error.where = child.program.string();
    error.what = "gave no sound that can be read";
    return tl::unexpected(error);
  }
  return std::make_shared<const Sound>(std::move(*sound));
}

/// Open JTalk reads は alone as the particle わ; in katakana every kana has its own sound.
std::string in_katakana(const std::string& hiragana) {
  std::u32string text = *base::decode_utf8(hiragana);
  for (char32_t& c : text)
    if (const char32_t other = kanji::in_other_syllabary(c); other != 0) c = other;
  return base::encode_utf8(std::u32string_view(text));
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

/// The first voice by name, so that the same one is found each time.
fs::path first_voice_in(const fs::path& folder) {
  std::error_code error;
  fs::path first;
  fs::recursive_directory_iterator entries(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entries != fs::recursive_directory_iterator(); entries.increment(error)) {
    const fs::path& path = entries->path();
    if (path.extension() == ".htsvoice" && is_file(path) && (first.empty() || path < first)) first = path;
  }
  return first;
}

/// What a program says; empty where it fails.
std::string answer_of(const fs::path& program, std::vector<std::string> arguments) {
  ChildProgram child;
  child.program = program;
  child.arguments = std::move(arguments);
  child.most_output = kMostAnswer;
  child.most_time = kLongestAnswer;
  const auto answer = run(child);
  return answer ? std::string(answer->begin(), answer->end()) : std::string();
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()};
}

/// @param module  of Speech Dispatcher; empty: the one that the desktop has set.
Engine dispatcher(const fs::path& program, const std::string& module) {
  Engine engine;
  engine.kind = VoiceKind::speech_dispatcher;
  engine.name = module.empty() ? "Speech Dispatcher" : "Speech Dispatcher (" + module + ")";
  engine.plays_itself = true;
  engine.speak = [program, module](
                     const std::string& kana,
                     const Voices::Wanted& is_wanted) -> base::Result<std::shared_ptr<const Sound>> {
    ChildProgram child;
    child.program = program;
    // Not --wait: without a sound card it would wait for ever. A "message" does not cut off a screen reader.
    child.arguments = {"--application-name", "Nazori",  "--language", "ja",
                       "--priority",         "message", "--rate",     kDispatcherPace};
    if (!module.empty()) child.arguments.insert(child.arguments.end(), {"--output-module", module});
    child.arguments.insert(child.arguments.end(), {"--", kana});
    const auto done = run(child, is_wanted);
    if (!done) return tl::unexpected(done.error());
    return std::shared_ptr<const Sound>();
  };
  return engine;
}

}  // namespace

fs::path find_program(const SpeechPlaces& places, const char* name) {
  for (const auto& folder : places.programs) {
    const fs::path path = folder / name;
    if (is_file(path) && ::access(path.c_str(), X_OK) == 0) return path;
  }
  return {};
}

base::Result<Engine> find_open_jtalk(const SpeechPlaces& places, const VoiceChoice& choice) {
  const fs::path program = find_program(places, "open_jtalk");
  if (program.empty()) return missing("Open JTalk", "install the package open-jtalk");
  const auto dictionary = std::find_if(places.dictionaries.begin(), places.dictionaries.end(),
                                       [](const fs::path& folder) { return is_file(folder / "sys.dic"); });
  if (dictionary == places.dictionaries.end())
    return missing("dictionary of Open JTalk", "install the package open-jtalk-mecab-naist-jdic");
  fs::path voice = choice.open_jtalk_voice;
  if (!voice.empty() && !is_file(voice))
    return base::fail(base::Errc::not_found, "does not exist", voice.string(), "choose an .htsvoice file");
  for (auto folder = places.voices.begin(); voice.empty() && folder != places.voices.end(); ++folder)
    voice = first_voice_in(*folder);
  if (voice.empty())
    return missing("voice of Open JTalk", "choose an .htsvoice file, or put one into nazori/voices");
  Engine engine;
  engine.kind = VoiceKind::open_jtalk;
  engine.name = "Open JTalk (" + voice.stem().string() + ")";
  engine.speak = [program, dictionary = dictionary->string(), voice = voice.string()](
                     const std::string& kana, const Voices::Wanted& is_wanted) {
    ChildProgram child;
    child.program = program;
    child.arguments = {"-x", dictionary, "-m", voice, "-ow", kOutput};
    child.input = in_katakana(kana) + "\n";
    child.most_output = kMostSoundBytes;
    return sound_of(child, is_wanted);
  };
  return engine;
}

base::Result<Engine> find_speech_dispatcher(const SpeechPlaces& places) {
  const fs::path program = find_program(places, "spd-say");
  if (program.empty()) return missing("Speech Dispatcher", "install the package speech-dispatcher");
  return dispatcher(program, {});
}

base::Result<Engine> find_dispatcher_beyond_espeak(const SpeechPlaces& places) {
  const fs::path program = find_program(places, "spd-say");
  if (program.empty()) return missing("Speech Dispatcher", "install the package speech-dispatcher");
  for (const std::string& module : words_of(answer_of(program, {"--list-output-modules"}))) {
    // The heading "OUTPUT MODULES" is in capitals; names of modules are not.
    if (module.starts_with("espeak") || module == "dummy" || module == "OUTPUT" || module == "MODULES")
      continue;
    const auto voices = words_of(answer_of(program, {"--output-module", module, "--list-synthesis-voices"}));
    if (std::any_of(voices.begin(), voices.end(),
                    [](const std::string& word) { return word == "ja" || word.starts_with("ja-"); }))
      return dispatcher(program, module);
  }
  return missing("Japanese voice of Speech Dispatcher", "eSpeak NG speaks without it");
}

base::Result<Engine> find_espeak_ng(const SpeechPlaces& places) {
  const fs::path program = find_program(places, "espeak-ng");
  if (program.empty()) return missing("eSpeak NG", "install the package espeak-ng");
  Engine engine;
  engine.kind = VoiceKind::espeak_ng;
  engine.name = "eSpeak NG";
  engine.speak = [program](const std::string& kana, const Voices::Wanted& is_wanted) {
    ChildProgram child;
    child.program = program;
    child.arguments = {"-v", "ja", "-s", kEspeakPace, "-b", "1", "-w", kOutput, "--", kana};
    child.most_output = kMostSoundBytes;
    return sound_of(child, is_wanted);
  };
  return engine;
}

base::Result<Engine> find_engine(VoiceKind kind, const SpeechPlaces& places, const VoiceChoice& choice) {
  switch (kind) {
    case VoiceKind::open_jtalk:
      return find_open_jtalk(places, choice);
    case VoiceKind::speech_dispatcher:
      return find_speech_dispatcher(places);
    case VoiceKind::espeak_ng:
      return find_espeak_ng(places);
    case VoiceKind::automatic:
      break;
  }
  auto best = find_open_jtalk(places, choice);
  // A voice that the learner pointed to is not silently replaced.
  if (best || !choice.open_jtalk_voice.empty()) return best;
  best = find_dispatcher_beyond_espeak(places);
  if (!best) best = find_espeak_ng(places);
  if (!best) best = find_speech_dispatcher(places);
  if (best) return best;
  return base::fail(base::Errc::not_found, "no Japanese voice is installed", "speech",
                    "install the package espeak-ng");
}

}  // namespace nazori::speech
