// SPDX-License-Identifier: Apache-2.0
// How each program is found and what it is told, word by word.
#include "engines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "child_program.h"
#include "environment_variable.h"
#include "recordings.h"
#include "stand_in_voices.h"

namespace nazori::speech {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

VoiceChoice choice_of(VoiceKind kind) {
  VoiceChoice choice;
  choice.kind = kind;
  return choice;
}

TEST(SpeechPlaces, AreThoseOfTheSystemInTheirOrder) {
  const test::EnvironmentVariable path("PATH", "/a/b::r:/c");
  const test::EnvironmentVariable data("XDG_DATA_HOME", "/home/of/data");
  const SpeechPlaces places = SpeechPlaces::of_system();
  EXPECT_THAT(places.programs, ElementsAre("/a/b", "r", "/c"));
  EXPECT_THAT(places.voices, ElementsAre("/home/of/data/nazori/voices", "/usr/local/share/hts-voice",
                                         "/usr/share/hts-voice"));
  EXPECT_EQ(places.recordings, "/home/of/data/nazori/sounds");
  EXPECT_THAT(places.dictionaries,
              ElementsAre("/var/lib/mecab/dic/open-jtalk/naist-jdic", "/usr/share/open_jtalk/dic",
                          "/usr/local/share/open_jtalk/dic"));
}

TEST(SpeechPlaces, WithoutAPathThereAreNoPrograms) {
  const test::EnvironmentVariable path("PATH", "");
  EXPECT_THAT(SpeechPlaces::of_system().programs, IsEmpty());
}

TEST(Programs, AreThoseThatMayBeRunInTheFirstFolderThatHasThem) {
  const StandInVoices installed;
  const SpeechPlaces places = installed.places();
  EXPECT_EQ(find_program(places, "espeak-ng"), "");
  installed.add_file("bin/espeak-ng");
  EXPECT_EQ(find_program(places, "espeak-ng"), "") << "it may not be run";
  installed.add_espeak();
  EXPECT_EQ(find_program(places, "espeak-ng"), installed.path("bin/espeak-ng"));
  std::filesystem::create_directories(installed.path("nowhere/espeak-ng"));
  EXPECT_EQ(find_program(places, "espeak-ng"), installed.path("bin/espeak-ng")) << "a folder is none";
  std::filesystem::remove(installed.path("nowhere/espeak-ng"));
  std::filesystem::copy(installed.path("bin/espeak-ng"), installed.path("nowhere/espeak-ng"));
  EXPECT_EQ(find_program(places, "espeak-ng"), installed.path("nowhere/espeak-ng"));
}

TEST(Engines, EachIsToldTheSameWordsEachTime) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_open_jtalk();
  installed.add_dispatcher("kaori");
  const auto told = [&](VoiceKind kind) {
    const auto spoken = Voices(installed.places(), choice_of(kind)).speak("イヌ");
    EXPECT_TRUE(spoken) << base::to_line(spoken.error());
    return installed.runs().back();
  };
  EXPECT_EQ(told(VoiceKind::espeak_ng), "-v|ja|-s|130|-b|1|-w|/dev/stdout|--|いぬ|");
  EXPECT_EQ(told(VoiceKind::speech_dispatcher),
            "--application-name|Nazori|--language|ja|--priority|message|--rate|-20|--|いぬ|");
  EXPECT_EQ(told(VoiceKind::open_jtalk), "-x|" + installed.path("dictionary").string() + "|-m|" +
                                             installed.path("voices/a/b/mei.htsvoice").string() +
                                             "|-ow|/dev/stdout|");
  EXPECT_EQ(installed.input(), "イヌ\n");
  (void)Voices(installed.places(), choice_of(VoiceKind::open_jtalk)).speak("こーひー、");
  EXPECT_EQ(installed.input(), "コーヒー\n") << "a mark of both syllabaries stays";
  std::filesystem::remove(installed.path("bin/open_jtalk"));
  EXPECT_EQ(
      told(VoiceKind::automatic),
      "--application-name|Nazori|--language|ja|--priority|message|--rate|-20|--output-module|kaori|--|いぬ|");
}

TEST(Engines, EachHasItsNameItsKindAndItsSourceOrSaysWhatIsMissing) {
  const StandInVoices installed;
  const auto states = [&] { return Voices(installed.places()).find(); };
  const std::vector<std::tuple<VoiceKind, std::string, std::string, std::string>> all{
      {VoiceKind::open_jtalk, "open-jtalk", "Open JTalk", "install the package open-jtalk"},
      {VoiceKind::speech_dispatcher, "speech-dispatcher", "Speech Dispatcher",
       "install the package speech-dispatcher"},
      {VoiceKind::espeak_ng, "espeak-ng", "eSpeak NG", "install the package espeak-ng"}};
  const auto missing = states();
  ASSERT_THAT(missing, SizeIs(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [kind, name, what, remedy] = all[i];
    EXPECT_EQ(missing[i].kind, kind);
    EXPECT_EQ(missing[i].name, name);
    ASSERT_TRUE(missing[i].error);
    EXPECT_EQ(missing[i].error->where, what);
    EXPECT_EQ(missing[i].error->what, "is not installed");
    EXPECT_EQ(missing[i].error->remedy, remedy);
  }
  installed.add_espeak();
  installed.add_open_jtalk();
  installed.add_dispatcher("");
  const auto found = states();
  ASSERT_THAT(found, SizeIs(3));
  EXPECT_EQ(found[0].name, "Open JTalk (mei)");
  EXPECT_EQ(found[1].name, "Speech Dispatcher");
  EXPECT_EQ(found[2].name, "eSpeak NG");
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].kind, std::get<0>(all[i]));
    EXPECT_FALSE(found[i].error);
    EXPECT_EQ(Voices(installed.places(), choice_of(found[i].kind)).speak("か")->source, std::get<1>(all[i]));
  }
  EXPECT_EQ(voice_named("automatic"), VoiceKind::automatic);
  EXPECT_EQ(name_of(static_cast<VoiceKind>(kVoiceKinds.size())), "");
}

TEST(OpenJtalk, TakesTheFirstVoiceByNameAndTheFirstDictionaryThatIsOne) {
  const StandInVoices installed;
  installed.add_open_jtalk();
  installed.add_file("voices/a/zoe.htsvoice");
  installed.add_file("voices/a/b/anna.txt");
  std::filesystem::create_directories(installed.path("voices/a/a.htsvoice"));
  SpeechPlaces places = installed.places();
  places.voices.insert(places.voices.begin(), installed.path("sounds"));  // a folder without voices
  places.dictionaries = {installed.path("voices"), installed.path("dictionary"), installed.path("sounds")};
  installed.add_file("sounds/sys.dic");
  EXPECT_EQ(find_open_jtalk(places, {})->name, "Open JTalk (mei)");
  installed.add_file("voices/a/anna.htsvoice");
  EXPECT_EQ(find_open_jtalk(places, {})->name, "Open JTalk (anna)");
  Voices voices(places, choice_of(VoiceKind::open_jtalk));
  ASSERT_TRUE(voices.speak("か"));
  EXPECT_EQ(installed.runs().front(), "-x|" + installed.path("dictionary").string() + "|-m|" +
                                          installed.path("voices/a/anna.htsvoice").string() +
                                          "|-ow|/dev/stdout|");
  installed.add_file("sounds/late.htsvoice");
  EXPECT_EQ(find_open_jtalk(places, {})->name, "Open JTalk (late)") << "the first folder with a voice";
}

TEST(OpenJtalk, AVoiceThatIsGoneIsNotReplacedBySpeechOfAnotherKind) {
  const StandInVoices installed;
  installed.add_espeak();
  VoiceChoice choice;
  choice.open_jtalk_voice = installed.path("own.htsvoice");
  EXPECT_EQ(find_engine(VoiceKind::automatic, installed.places(), choice).error().where, "Open JTalk");
  installed.add_open_jtalk();
  const auto gone = find_engine(VoiceKind::automatic, installed.places(), choice);
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().what, "does not exist");
  EXPECT_EQ(gone.error().where, choice.open_jtalk_voice.string());
}

/// A spd-say whose modules have voices of these languages.
void add_modules(const StandInVoices& installed,
                 const std::vector<std::pair<std::string, std::string>>& modules) {
  std::string list, voices;
  for (const auto& [module, language] : modules) {
    list += module + "\\n";
    voices += "  *'--output-module " + module + " --list-synthesis-voices') printf 'NAME LANGUAGE\\nx " +
              language + " none\\n';;\n";
  }
  installed.add_program("spd-say", "case \"$*\" in\n  --list-output-modules) printf 'OUTPUT MODULES\\n" +
                                       list + "';;\n" + voices + "  *) exit 1;;\nesac");
}

TEST(SpeechDispatcher, IsAskedForAJapaneseVoiceOfAnyModuleButEspeak) {
  const auto found = [](const std::vector<std::pair<std::string, std::string>>& modules) {
    const StandInVoices installed;
    add_modules(installed, modules);
    const auto engine = find_dispatcher_beyond_espeak(installed.places());
    return engine ? engine->name : "none: " + engine.error().where;
  };
  EXPECT_EQ(found({{"festival", "ja"}}), "Speech Dispatcher (festival)");
  EXPECT_EQ(found({{"festival", "ja-JP"}}), "Speech Dispatcher (festival)");
  const std::string none = "none: Japanese voice of Speech Dispatcher";
  EXPECT_EQ(found({}), none);
  EXPECT_EQ(found({{"festival", "jav"}}), none);
  EXPECT_EQ(found({{"espeak-ng", "ja"}, {"espeak-ng-mbrola", "ja"}, {"dummy", "ja"}}), none);
  EXPECT_EQ(found({{"OUTPUT", "ja"}, {"MODULES", "ja"}}), none) << "they are the heading";
  EXPECT_EQ(found({{"dummy", "ja"}, {"festival", "de"}, {"open", "ja"}, {"late", "ja"}}),
            "Speech Dispatcher (open)");
  const StandInVoices silent;
  silent.add_program("spd-say", "exit 1");
  EXPECT_FALSE(find_dispatcher_beyond_espeak(silent.places()));
  EXPECT_EQ(find_dispatcher_beyond_espeak({}).error().where, "Speech Dispatcher");
}

TEST(Voices, ThatWriteMoreThanASoundFileMayHoldAreEnded) {
  const StandInVoices installed;
  installed.add_program("espeak-ng", "head -c " + std::to_string(kMostSoundBytes + 1) + " /dev/zero");
  EXPECT_EQ(Voices(installed.places()).speak("か").error().what, "writes too much");
  installed.add_program("espeak-ng", "echo noise");
  EXPECT_EQ(Voices(installed.places()).speak("か").error().what, "gave no sound that can be read");
}

TEST(Voices, StopWhenNobodyWantsTheSound) {
  const StandInVoices installed;
  installed.add_program("espeak-ng", "sleep 1000");
  installed.add_open_jtalk();
  for (const VoiceKind kind : {VoiceKind::espeak_ng, VoiceKind::open_jtalk}) {
    if (kind == VoiceKind::open_jtalk) installed.add_program("open_jtalk", "sleep 1000");
    const auto spoken = Voices(installed.places(), choice_of(kind)).speak("か", false, [] { return false; });
    ASSERT_FALSE(spoken);
    EXPECT_EQ(spoken.error().code, base::Errc::cancelled);
  }
  installed.add_program("spd-say", "sleep 1000");
  EXPECT_EQ(Voices(installed.places(), choice_of(VoiceKind::speech_dispatcher))
                .speak("か", false, [] { return false; })
                .error()
                .code,
            base::Errc::cancelled);
}

TEST(Voices, ASoundThatAnotherVoiceGaveForAFileIsNotKept) {
  const StandInVoices installed;
  installed.add_dispatcher("kaori");
  Voices voices(installed.places());
  const auto none = voices.speak("いぬ", true);
  ASSERT_FALSE(none) << "nothing gives a sound";
  EXPECT_EQ(none.error().where, "eSpeak NG");
  installed.add_espeak();
  EXPECT_EQ(voices.speak("いぬ", true)->source, "espeak-ng");
  const auto spoken = voices.speak("いぬ");
  EXPECT_EQ(spoken->source, "speech-dispatcher");
  EXPECT_FALSE(spoken->is_cached);
}

TEST(Voices, AVoiceThatGivesASoundGivesItForAFileToo) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_open_jtalk();
  EXPECT_EQ(Voices(installed.places()).speak("いぬ", true)->source, "open-jtalk");
}

TEST(Voices, ARecordingAndAVoiceOfTheSameKanaAreKeptApart) {
  const StandInVoices installed;
  installed.add_espeak();
  Voices voices(installed.places());
  EXPECT_EQ(voices.speak("ッ")->kana, "ちいさい、つ");
  installed.add_recording("っ.wav", StandInVoices::tone(0.25));
  const auto recorded = voices.speak("ッ");
  EXPECT_EQ(recorded->source, "recording");
  EXPECT_EQ(recorded->kana, "っ");
  EXPECT_FALSE(recorded->is_cached);
  std::filesystem::remove(installed.path("sounds/っ.wav"));
  const auto voice = voices.speak("ッ");
  EXPECT_EQ(voice->source, "espeak-ng");
  EXPECT_TRUE(voice->is_cached);
}

// Three sounds of 5.8 MB do not fit into 16 MiB.
TEST(Voices, WhatIsForgottenOrReplacedTakesNoRoom) {
  const StandInVoices installed;
  const Sound tone = StandInVoices::tone(15, 96'000);
  installed.add_recording("long.wav", tone);
  const std::string speaks = "cat '" + installed.path("sounds/long.wav").string() + "'";
  installed.add_program("espeak-ng", speaks);
  installed.add_open_jtalk();
  installed.add_program("open_jtalk", speaks);
  Voices voices(installed.places(), choice_of(VoiceKind::espeak_ng));
  ASSERT_TRUE(voices.speak("あ"));
  ASSERT_TRUE(voices.speak("い"));
  voices.choose(choice_of(VoiceKind::open_jtalk));
  ASSERT_TRUE(voices.speak("あ"));
  ASSERT_TRUE(voices.speak("い"));
  EXPECT_TRUE(voices.speak("あ")->is_cached);
  EXPECT_TRUE(voices.speak("い")->is_cached);

  const auto file = installed.path("sounds/う.wav");
  voices.choose(choice_of(VoiceKind::espeak_ng));
  ASSERT_TRUE(voices.speak("あ"));
  std::filesystem::copy(installed.path("sounds/long.wav"), file);
  for (int i = 0; i < 3; ++i) {
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(2));
    EXPECT_FALSE(voices.speak("う")->is_cached);
  }
  EXPECT_TRUE(voices.speak("あ")->is_cached);
}

TEST(Recordings, AreLookedForInTheOrderOfTheirEndingsAndAreFiles) {
  const StandInVoices installed;
  const auto folder = installed.path("sounds");
  std::filesystem::create_directories(folder / "か.wav");
  EXPECT_EQ(recording_of(folder, "か"), "");
  for (const char* ending : {".mp3", ".opus", ".ogg", ".flac"}) {
    installed.add_file("sounds/か" + std::string(ending));
    EXPECT_EQ(recording_of(folder, "か"), folder / ("か" + std::string(ending)));
  }
  EXPECT_EQ(recording_of(folder, "\xE3\x81"), "") << "not UTF-8";
  // A kana whose neighbour has a mark, and one with either.
  installed.add_file("sounds/き\u3099く.wav");
  installed.add_file("sounds/ひ\u3099.wav");
  installed.add_file("sounds/ひ\u309A.wav");
  installed.add_file("sounds/コーヒー.wav");
  EXPECT_EQ(recording_of(folder, "こーひー"), folder / "コーヒー.wav");
  EXPECT_EQ(recording_of(folder, "ぎく"), folder / "き\u3099く.wav");
  EXPECT_EQ(recording_of(folder, "び"), folder / "ひ\u3099.wav");
  EXPECT_EQ(recording_of(folder, "ぴ"), folder / "ひ\u309A.wav");
}

TEST(ChildProgram, QuotesAtMostFourHundredBytesOfAComplaint) {
  ChildProgram child;
  child.program = "/bin/sh";
  child.arguments = {"-c", "head -c 500 /dev/zero | tr '\\0' x >&2; exit 1"};
  EXPECT_EQ(run(child).error().what, std::string(400, 'x'));
  child.arguments = {"-c", "echo complaint >&2; exit 0"};
  EXPECT_TRUE(run(child)) << "who complains and succeeds has succeeded";
}

TEST(ChildProgram, HasAGroupOfItsOwnAndDiesOfAClosedPipe) {
  ChildProgram child;
  child.program = "/bin/sh";
  child.most_output = 100;
  // The fields of a process: its number, its name, its state, its parent, its group.
  child.arguments = {"-c",
                     "read number name state parent group rest < /proc/$$/stat; "
                     "[ $group = $$ ] && printf own"};
  const auto group = run(child);
  ASSERT_TRUE(group);
  EXPECT_EQ(std::string(group->begin(), group->end()), "own");
  auto* const before = std::signal(SIGPIPE, SIG_IGN);
  child.arguments = {"-c", "grep SigIgn /proc/self/status"};
  const auto ignored = run(child);
  std::signal(SIGPIPE, before);
  ASSERT_TRUE(ignored);
  const auto bits = std::stoull(std::string(ignored->begin() + 8, ignored->end()), nullptr, 16);
  EXPECT_EQ(bits & (1ULL << (SIGPIPE - 1)), 0U);
}

TEST(ChildProgram, IsWaitedForWhileItWorks) {
  ChildProgram child;
  child.program = "/bin/sh";
  child.most_output = 200'000;
  child.input = std::string(150'000, 'x');
  child.arguments = {"-c", "sleep 0.05; cat"};
  const auto output = run(child);
  ASSERT_TRUE(output);
  EXPECT_EQ(std::string(output->begin(), output->end()), child.input);
}

TEST(ChildProgram, LeavesNoFileOpen) {
  const auto open_files = [] {
    const std::filesystem::directory_iterator files("/proc/self/fd");
    return std::distance(begin(files), end(files));
  };
  ChildProgram child;
  child.program = "/bin/true";
  const auto before = open_files();
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(run(child));
  child.program = "/no such program";
  EXPECT_FALSE(run(child));
  EXPECT_EQ(open_files(), before);
}

TEST(Sounds, LongerThanABlockKeepTheirOrder) {
  Sound ramp;
  ramp.rate_hz = 8000;
  for (int i = 0; i < 10'000; ++i) ramp.samples.push_back(static_cast<float>(i) / 16'384);
  const auto back = decode_sound(*to_wav(ramp));
  ASSERT_TRUE(back);
  ASSERT_EQ(back->samples.size(), ramp.samples.size());
  for (std::size_t i = 0; i < ramp.samples.size(); ++i)
    ASSERT_NEAR(back->samples[i], ramp.samples[i], 1e-4) << i;
}

}  // namespace
}  // namespace nazori::speech
