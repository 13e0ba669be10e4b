// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "nazori/base/file.h"
#include "nazori/speech/voice.h"

namespace nazori::speech {

/// A folder with stand-ins for the programs that speak. Each writes what it was given into a file and gives a
/// tone as long as its name says; none needs the real ones.
class StandInVoices {
 public:
  StandInVoices() {
    std::string name = (std::filesystem::temp_directory_path() / "nazori_speech_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    for (const char* one : {"bin", "voices/a/b", "dictionary", "sounds"})
      std::filesystem::create_directories(folder_ / one);
    write(folder_ / "tone.wav", *to_wav(tone(0.4)));
  }
  ~StandInVoices() { std::filesystem::remove_all(folder_); }
  StandInVoices(const StandInVoices&) = delete;
  StandInVoices& operator=(const StandInVoices&) = delete;

  /// A sine of 440 Hz and 0.5; its loudness is 0.5 / sqrt(2).
  static Sound tone(double seconds, int rate_hz = 16'000) {
    Sound sound;
    sound.rate_hz = rate_hz;
    sound.samples.resize(static_cast<std::size_t>(seconds * rate_hz));
    for (std::size_t i = 0; i < sound.samples.size(); ++i)
      sound.samples[i] =
          static_cast<float>(0.5 * std::sin(2 * 3.14159265358979 * 440 * static_cast<double>(i) / rate_hz));
    return sound;
  }

  [[nodiscard]] SpeechPlaces places() const {
    SpeechPlaces places;
    places.programs = {folder_ / "nowhere", folder_ / "bin"};
    places.voices = {folder_ / "voices"};
    places.dictionaries = {folder_ / "nowhere", folder_ / "dictionary"};
    places.recordings = folder_ / "sounds";
    return places;
  }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

  void add_program(const std::string& name, const std::string& script) const {
    const auto file = folder_ / "bin" / name;
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  void add_espeak() const {
    add_program("espeak-ng", note_arguments() + "cat '" + path("tone.wav").string() + "'");
  }
  void add_open_jtalk() const {
    add_program("open_jtalk", note_arguments() + "cat > '" + path("input").string() + "'\ncat '" +
                                  path("tone.wav").string() + "'");
    add_file("dictionary/sys.dic");
    add_file("voices/a/b/mei.htsvoice");
  }
  /// @param module  that it has besides eSpeak NG; empty: none.
  void add_dispatcher(const std::string& module) const {
    add_program("spd-say",
                "case \"$*\" in\n"
                "  *--list-output-modules*) printf 'OUTPUT MODULES\\nespeak-ng\\n%s\\n' '" +
                    module +
                    "';;\n"
                    "  *--list-synthesis-voices*) printf 'NAME LANGUAGE VARIANT\\nKaori ja none\\n';;\n"
                    "  *) " +
                    note_arguments() + ";;\nesac");
  }
  void add_file(const std::string& name) const { std::ofstream(folder_ / name) << "x"; }
  void add_recording(const std::string& name, const Sound& sound) const {
    write(folder_ / "sounds" / name, *to_wav(sound));
  }

  /// The arguments of each run of a program, with | between them.
  [[nodiscard]] std::vector<std::string> runs() const {
    std::ifstream in(path("arguments"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }
  [[nodiscard]] std::string input() const {
    std::ifstream in(path("input"));
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

 private:
  [[nodiscard]] std::string note_arguments() const {
    return "{ printf '%s|' \"$@\"; echo; } >> '" + path("arguments").string() + "'\n";
  }
  static void write(const std::filesystem::path& to, const std::vector<std::uint8_t>& bytes) {
    ASSERT_TRUE(base::write_file(to, bytes));
  }

  std::filesystem::path folder_;
};

}  // namespace nazori::speech
