// SPDX-License-Identifier: Apache-2.0
#include "nazori/speech/voice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "recordings.h"
#include "stand_in_voices.h"

namespace nazori::speech {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

VoiceChoice choice_of(VoiceKind kind) {
  VoiceChoice choice;
  choice.kind = kind;
  return choice;
}

TEST(VoiceNames, AreThoseOfSettingsAndLeadBack) {
  for (const VoiceKind kind : kVoiceKinds) EXPECT_EQ(voice_named(name_of(kind)), kind);
  EXPECT_EQ(name_of(VoiceKind::open_jtalk), "open-jtalk");
  EXPECT_EQ(name_of(static_cast<VoiceKind>(9)), "");
  EXPECT_EQ(voice_named("espeak"), std::nullopt);
}

TEST(Voices, WithoutAnyVoiceSayWhatToInstall) {
  const StandInVoices installed;
  Voices voices(installed.places());
  const auto spoken = voices.speak("か");
  ASSERT_FALSE(spoken);
  EXPECT_EQ(spoken.error().code, base::Errc::not_found);
  EXPECT_THAT(spoken.error().remedy, HasSubstr("espeak-ng"));
  EXPECT_FALSE(voices.voice());
  const auto states = voices.find();
  ASSERT_THAT(states, SizeIs(3));
  for (const auto& state : states) {
    ASSERT_TRUE(state.error) << state.name;
    EXPECT_EQ(state.error->code, base::Errc::not_found);
    EXPECT_FALSE(state.error->remedy.empty());
  }
}

TEST(Voices, EspeakIsGivenTheKanaInHiraganaWithTheJapaneseVoice) {
  const StandInVoices installed;
  installed.add_espeak();
  Voices voices(installed.places());
  const auto spoken = voices.speak("キュウジツ");
  ASSERT_TRUE(spoken) << base::to_line(spoken.error());
  EXPECT_EQ(spoken->kana, "きゅうじつ");
  EXPECT_EQ(spoken->source, "espeak-ng");
  ASSERT_TRUE(spoken->sound);
  EXPECT_NEAR(spoken->sound->duration_s(), 0.4, 1e-3);
  EXPECT_NEAR(loudness(*spoken->sound), 0.5 / std::sqrt(2), 1e-3);
  ASSERT_THAT(installed.runs(), SizeIs(1));
  EXPECT_THAT(installed.runs().front(), HasSubstr("-v|ja|"));
  EXPECT_THAT(installed.runs().front(), testing::EndsWith("|--|きゅうじつ|"));
}

TEST(Voices, OpenJtalkIsGivenKatakanaSoThatHaIsNotReadAsAParticle) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_open_jtalk();
  Voices voices(installed.places());
  ASSERT_TRUE(voices.voice());
  EXPECT_EQ(voices.voice()->kind, VoiceKind::open_jtalk) << "better than eSpeak NG";
  EXPECT_EQ(voices.voice()->name, "Open JTalk (mei)");
  const auto spoken = voices.speak("は");
  ASSERT_TRUE(spoken) << base::to_line(spoken.error());
  EXPECT_EQ(spoken->source, "open-jtalk");
  EXPECT_EQ(installed.input(), "ハ\n");
  EXPECT_EQ(installed.runs().front(), "-x|" + installed.path("dictionary").string() + "|-m|" +
                                          installed.path("voices/a/b/mei.htsvoice").string() +
                                          "|-ow|/dev/stdout|");
}

TEST(Voices, OpenJtalkUsesTheVoiceThatTheLearnerPointsTo) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_open_jtalk();
  installed.add_file("own.htsvoice");
  VoiceChoice choice;
  choice.open_jtalk_voice = installed.path("own.htsvoice");
  Voices voices(installed.places(), choice);
  ASSERT_TRUE(voices.speak("か"));
  EXPECT_THAT(installed.runs().front(), HasSubstr("|" + choice.open_jtalk_voice.string() + "|"));
  choice.open_jtalk_voice = installed.path("gone.htsvoice");
  voices.choose(choice);
  const auto spoken = voices.speak("か");
  ASSERT_FALSE(spoken) << "another voice would not be what was asked for";
  EXPECT_EQ(spoken.error().where, choice.open_jtalk_voice.string());
}

TEST(Voices, OpenJtalkNeedsItsDictionaryAndAVoice) {
  const StandInVoices installed;
  installed.add_open_jtalk();
  const auto why = [&] { return Voices(installed.places(), choice_of(VoiceKind::open_jtalk)).voice(); };
  ASSERT_TRUE(why());
  std::filesystem::remove(installed.path("voices/a/b/mei.htsvoice"));
  ASSERT_FALSE(why());
  EXPECT_THAT(why().error().remedy, HasSubstr(".htsvoice"));
  std::filesystem::remove(installed.path("dictionary/sys.dic"));
  EXPECT_THAT(why().error().remedy, HasSubstr("naist-jdic"));
  std::filesystem::remove(installed.path("bin/open_jtalk"));
  EXPECT_THAT(why().error().remedy, testing::EndsWith("open-jtalk"));
}

TEST(Voices, SpeechDispatcherComesBeforeEspeakOnlyWithAVoiceOfItsOwn) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_dispatcher("");
  EXPECT_EQ(Voices(installed.places()).voice()->kind, VoiceKind::espeak_ng);
  installed.add_dispatcher("kaori");
  Voices voices(installed.places());
  EXPECT_EQ(voices.voice()->kind, VoiceKind::speech_dispatcher);
  EXPECT_EQ(voices.voice()->name, "Speech Dispatcher (kaori)");
  const auto spoken = voices.speak("いぬ");
  ASSERT_TRUE(spoken) << base::to_line(spoken.error());
  EXPECT_FALSE(spoken->sound) << "it plays the sound itself";
  EXPECT_THAT(installed.runs().back(), HasSubstr("|--language|ja|"));
  EXPECT_THAT(installed.runs().back(), testing::EndsWith("|--output-module|kaori|--|いぬ|"));
  ASSERT_TRUE(voices.speak("いぬ"));
  EXPECT_THAT(installed.runs(), SizeIs(2)) << "what it played cannot be kept";
  const auto for_a_file = voices.speak("いぬ", true);
  ASSERT_TRUE(for_a_file);
  EXPECT_TRUE(for_a_file->sound);
  EXPECT_EQ(for_a_file->source, "espeak-ng");
}

TEST(Voices, SpeechDispatcherIsTheLastResortAndCanBeChosen) {
  const StandInVoices installed;
  installed.add_dispatcher("");
  EXPECT_EQ(Voices(installed.places()).voice()->kind, VoiceKind::speech_dispatcher);
  installed.add_espeak();
  EXPECT_EQ(Voices(installed.places()).voice()->kind, VoiceKind::espeak_ng);
  EXPECT_EQ(Voices(installed.places(), choice_of(VoiceKind::speech_dispatcher)).voice()->kind,
            VoiceKind::speech_dispatcher);
}

TEST(Voices, KeepWhatTheySpokeUntilAnotherVoiceIsChosen) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_open_jtalk();
  Voices voices(installed.places(), choice_of(VoiceKind::espeak_ng));
  EXPECT_FALSE(voices.speak("か")->is_cached);
  const auto again = voices.speak("カ");
  EXPECT_TRUE(again->is_cached);
  EXPECT_TRUE(again->sound);
  EXPECT_THAT(installed.runs(), SizeIs(1)) << "the same sound in either syllabary";
  voices.choose(choice_of(VoiceKind::espeak_ng));
  EXPECT_TRUE(voices.speak("か")->is_cached);
  voices.choose(choice_of(VoiceKind::open_jtalk));
  const auto other = voices.speak("か");
  EXPECT_FALSE(other->is_cached);
  EXPECT_EQ(other->source, "open-jtalk");
}

TEST(Voices, KeepNoMoreThanTheirLimit) {
  const StandInVoices installed;
  installed.add_recording("long.wav", StandInVoices::tone(15, 96'000));
  installed.add_program("espeak-ng", "echo >> '" + installed.path("arguments").string() + "'\ncat '" +
                                         installed.path("sounds/long.wav").string() + "'");
  Voices voices(installed.places());
  const std::size_t each = voices.speak("あ")->sound->samples.size() * sizeof(float);
  const std::size_t fit = Voices::kMostKept_bytes / each;
  ASSERT_EQ(fit, 2U);
  ASSERT_TRUE(voices.speak("い"));
  EXPECT_TRUE(voices.speak("あ")->is_cached);
  ASSERT_TRUE(voices.speak("う"));
  EXPECT_TRUE(voices.speak("あ")->is_cached) << "used after い";
  EXPECT_FALSE(voices.speak("い")->is_cached) << "the one that was not used for longest is forgotten";
}

TEST(Voices, ARecordingIsHeardInPlaceOfAVoice) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_recording("か.wav", StandInVoices::tone(0.25));
  Voices voices(installed.places());
  const auto spoken = voices.speak("カ");
  ASSERT_TRUE(spoken);
  EXPECT_EQ(spoken->source, "recording");
  EXPECT_NEAR(spoken->sound->duration_s(), 0.25, 1e-3);
  EXPECT_THAT(installed.runs(), SizeIs(0));
  EXPECT_TRUE(voices.speak("か")->is_cached);
  EXPECT_EQ(voices.speak("き")->source, "espeak-ng");
}

TEST(Voices, ARecordingThatChangedIsReadAgain) {
  const StandInVoices installed;
  installed.add_recording("か.wav", StandInVoices::tone(0.25));
  Voices voices(installed.places());
  ASSERT_TRUE(voices.speak("か"));
  installed.add_recording("か.wav", StandInVoices::tone(0.5));
  const auto file = installed.path("sounds/か.wav");
  std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + std::chrono::seconds(2));
  const auto spoken = voices.speak("か");
  EXPECT_FALSE(spoken->is_cached);
  EXPECT_NEAR(spoken->sound->duration_s(), 0.5, 1e-3);
}

TEST(Voices, ARecordingThatCannotBeReadIsNamed) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_file("sounds/か.ogg");
  Voices voices(installed.places());
  const auto spoken = voices.speak("か");
  ASSERT_FALSE(spoken);
  EXPECT_EQ(spoken.error().code, base::Errc::parse);
  EXPECT_EQ(spoken.error().where, installed.path("sounds/か.ogg").string());
}

TEST(Voices, AnotherFolderOfRecordingsCanBeChosen) {
  const StandInVoices installed;
  installed.add_recording("か.wav", StandInVoices::tone(0.25));
  VoiceChoice choice;
  choice.recordings = installed.path("voices");
  Voices voices(installed.places(), choice);
  EXPECT_FALSE(voices.speak("か")) << "the usual folder is not used";
}

TEST(Recordings, AreNamedInEitherSyllabaryAndWithSoundMarksApart) {
  const StandInVoices installed;
  const auto folder = installed.path("sounds");
  EXPECT_EQ(recording_of(folder, "が"), "");
  EXPECT_EQ(recording_of({}, "が"), "");
  for (const char* file : {"が.mp3", "ガ.flac", "か\u3099.wav", "は\u309Aん.opus", "う\u3099.ogg"})
    installed.add_file("sounds/" + std::string(file));
  EXPECT_EQ(recording_of(folder, "が"), folder / "が.mp3");
  std::filesystem::remove(folder / "が.mp3");
  EXPECT_EQ(recording_of(folder, "が"), folder / "ガ.flac");
  std::filesystem::remove(folder / "ガ.flac");
  EXPECT_EQ(recording_of(folder, "が"), folder / "か\u3099.wav");
  EXPECT_EQ(recording_of(folder, "ぱん"), folder / "は\u309Aん.opus");
  EXPECT_EQ(recording_of(folder, "ゔ"), folder / "う\u3099.ogg");
}

TEST(Voices, SayWhyAVoiceFails) {
  const StandInVoices installed;
  installed.add_program("espeak-ng", "echo 'no voice ja' >&2; echo more >&2; exit 3");
  Voices voices(installed.places());
  const auto spoken = voices.speak("か");
  ASSERT_FALSE(spoken);
  EXPECT_EQ(spoken.error().code, base::Errc::io);
  EXPECT_EQ(spoken.error().what, "no voice ja");
  EXPECT_EQ(spoken.error().where, installed.path("bin/espeak-ng").string());
  installed.add_program("espeak-ng", "echo noise");
  const auto noise = voices.speak("か");
  ASSERT_FALSE(noise);
  EXPECT_EQ(noise.error().code, base::Errc::parse);
  EXPECT_EQ(noise.error().where, installed.path("bin/espeak-ng").string());
}

TEST(Voices, RefuseWhatIsNotKanaBeforeAnyProgramRuns) {
  const StandInVoices installed;
  installed.add_espeak();
  Voices voices(installed.places());
  EXPECT_EQ(voices.speak("休日").error().code, base::Errc::bad_argument);
  EXPECT_THAT(installed.runs(), SizeIs(0));
}

// Listens to the real eSpeak NG where it is installed.
TEST(EspeakNg, SpeaksEveryKanaOfTheTableAudibly) {
  const SpeechPlaces system = SpeechPlaces::of_system();
  SpeechPlaces places;
  places.programs = system.programs;
  Voices voices(places, choice_of(VoiceKind::espeak_ng));
  if (!voices.voice()) GTEST_SKIP() << "espeak-ng is not installed";
  double one_kana_s = 0;
  for (const char* kana :
       {"あ", "か", "し", "つ", "ふ", "ん", "を", "が", "ぱ", "きゃ", "っ", "ー", "ゃ", "ヴ"}) {
    const auto spoken = voices.speak(kana);
    ASSERT_TRUE(spoken) << kana << ": " << base::to_line(spoken.error());
    EXPECT_GT(spoken->sound->duration_s(), 0.1) << kana;
    EXPECT_LT(spoken->sound->duration_s(), 3) << kana;
    EXPECT_GT(loudness(*spoken->sound), 0.01) << kana;
    if (std::string(kana) == "か") one_kana_s = spoken->sound->duration_s();
  }
  const auto word = voices.speak("きゅうじつ");
  ASSERT_TRUE(word);
  EXPECT_GT(word->sound->duration_s(), 1.3 * one_kana_s);
  EXPECT_NE(*voices.speak("あ")->sound, *voices.speak("い")->sound);
}

}  // namespace
}  // namespace nazori::speech
