// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace nazori::cli::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

/// A computer with one voice: a stand-in for eSpeak NG that notes its arguments and gives 0.1 s of 8,000 Hz.
class Speak : public testing::Test {
 protected:
  Speak() {
    std::filesystem::create_directories(folder_ / "bin");
    std::filesystem::create_directories(folder_ / "data/nazori/sounds");
    write(folder_ / "tone.wav", wav(800));
    program("espeak-ng",
            "printf '%s|' \"$@\" > '" + folder_ / "arguments" + "'; cat '" + folder_ / "tone.wav" + "'");
  }
  void program(const std::string& name, const std::string& script) const {
    const std::string path = folder_ / ("bin/" + name);
    write(path, "#!/bin/sh\n" + script + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }
  /// 16 bits of 8,000 Hz: a square wave of a quarter of the greatest amplitude.
  static std::string wav(std::uint32_t samples) {
    const auto number = [](std::uint32_t value, int bytes) {
      std::string text;
      for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i));
      return text;
    };
    std::string bytes = "RIFF" + number(36 + 2 * samples, 4) + "WAVEfmt " + number(16, 4) + number(1, 2) +
                        number(1, 2) + number(8000, 4) + number(16000, 4) + number(2, 2) + number(16, 2) +
                        "data" + number(2 * samples, 4);
    for (std::uint32_t i = 0; i < samples; ++i) bytes += number(i % 20 < 10 ? 8192 : 65536 - 8192, 2);
    return bytes;
  }
  [[nodiscard]] Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "speak");
    return nazori_cli(arguments, {"PATH=" + (folder_ / "bin") + ":/usr/bin:/bin",
                                  "XDG_DATA_HOME=" + (folder_ / "data"), "SDL_AUDIODRIVER=dummy"});
  }
  [[nodiscard]] std::string arguments() const {
    const auto bytes = bytes_of(folder_ / "arguments");
    return {bytes.begin(), bytes.end()};
  }
  TemporaryFolder folder_;
};

TEST_F(Speak, WritesTheSoundThatTheVoiceGaveForTheKana) {
  const Outcome run = this->run({"カナ", "--voice", "espeak-ng", "--output", folder_ / "a.wav", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(arguments(), testing::EndsWith("|--|かな|")) << "the right kana";
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["kana"], "かな");
  EXPECT_EQ(json["source"], "espeak-ng");
  EXPECT_EQ(json["file"], folder_ / "a.wav");
  EXPECT_EQ(json["rate_hz"], 8000);
  EXPECT_NEAR(json["duration_s"].get<double>(), 0.1, 1e-3);
  EXPECT_NEAR(json["loudness"].get<double>(), 0.25, 1e-3);
  EXPECT_EQ(bytes_of(folder_ / "a.wav").size(), 44U + 1600U);
}

TEST_F(Speak, PlaysWithoutAFileAndPausesBetweenSeveral) {
  const Outcome run = this->run({"か", "き", "--voice", "espeak-ng"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "か、き  espeak-ng\n");
}

TEST_F(Speak, ForPeopleNamesTheFileTheSourceAndTheTime) {
  write(folder_ / "tone.wav", wav(4000));
  const Outcome run = this->run({"カ", "--voice", "espeak-ng", "--output", folder_ / "a.wav"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "か  " + (folder_ / "a.wav") + "  espeak-ng  0.50 s\n");
  const Outcome piped = this->run({"カ", "--voice", "espeak-ng", "--output", "-"});
  EXPECT_EQ(piped.code, 0) << piped.err;
  const auto bytes = bytes_of(folder_ / "a.wav");
  EXPECT_EQ(piped.out, std::string(bytes.begin(), bytes.end()));
  const Json json = Json::parse(this->run({"カ", "--voice", "espeak-ng", "--json"}).out);
  EXPECT_EQ(json["file"], nullptr);
  expect_one_line(this->run({"カ", "--output", "-", "--json"}), 2, {"--output", "JSON"});
}

TEST_F(Speak, RecordingsOfAnotherFolderAreTaken) {
  std::filesystem::create_directories(folder_ / "mine");
  write(folder_ / "mine/か.wav", wav(1600));
  const Outcome run = this->run({"か", "--recordings", folder_ / "mine", "-o", folder_ / "b.wav"});
  EXPECT_EQ(run.out, "か  " + (folder_ / "b.wav") + "  recording  0.20 s\n");
}

TEST_F(Speak, ARecordingComesFirst) {
  write(folder_ / "data/nazori/sounds/か.wav", wav(4000));
  const Outcome run = this->run({"か", "-o", folder_ / "b.wav", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(Json::parse(run.out)["source"], "recording");
  EXPECT_NEAR(Json::parse(run.out)["duration_s"].get<double>(), 0.5, 1e-3);
}

TEST_F(Speak, RefusesInOneLine) {
  expect_one_line(run({"休日"}), 2, {"休日", "only kana can be spoken", "give hiragana"});
  expect_one_line(run({}), 2, {"nothing to speak", "--voices"});
  expect_one_line(run({"か", "--output", folder_ / "a.mp3"}), 2, {".wav"});
  expect_one_line(run({"か", "--voice", "robot"}), 2, {"--voice"});
  expect_one_line(run({"か", "--voice", "open-jtalk", "--voice-file", "/nowhere.htsvoice"}), 2, {"not"});
  program("espeak-ng", "echo broken >&2; exit 1");
  expect_one_line(run({"か", "--voice", "espeak-ng"}), 2, {"espeak-ng", "broken"});
}

TEST_F(Speak, ListsTheVoicesAndSaysWhatTheOthersNeed) {
  const Outcome run = this->run({"--voices", "--voice", "espeak-ng", "--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const Json json = Json::parse(run.out);
  ASSERT_EQ(json.size(), 3U);
  EXPECT_EQ(json[0]["voice"], "open-jtalk");
  EXPECT_EQ(json[2]["voice"], "espeak-ng");
  EXPECT_EQ(json[2]["usable"], true);
  EXPECT_EQ(json[2]["used"], true);
  EXPECT_EQ(json[2]["problem"], nullptr);
  for (const Json& one : json) EXPECT_EQ(one["usable"].get<bool>(), one["problem"].is_null());
  EXPECT_THAT(this->run({"--voices", "--voice", "espeak-ng"}).out, HasSubstr("eSpeak NG, speaks now"));
}

}  // namespace
}  // namespace nazori::cli::test
