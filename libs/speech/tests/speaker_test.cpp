// SPDX-License-Identifier: Apache-2.0
#include "nazori/speech/speaker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stand_in_voices.h"

namespace nazori::speech {
namespace {

using testing::ElementsAre;

TEST(Speaker, AnswersWithTheSoundOfTheNewestRequest) {
  const StandInVoices installed;
  installed.add_espeak();
  base::Inbox inbox;
  Speaker speaker(inbox, installed.places());
  std::vector<std::string> heard;
  std::uint64_t last = 0;
  speaker.spoken.connect([&](std::uint64_t number, const Spoken& spoken) {
    heard.push_back(spoken.kana);
    last = number;
    EXPECT_TRUE(spoken.sound);
  });
  (void)speaker.speak("あ");
  (void)speaker.speak("い");
  const auto newest = speaker.speak("う");
  EXPECT_TRUE(speaker.is_busy());
  inbox.run_until([&] { return !heard.empty(); });
  EXPECT_THAT(heard, ElementsAre("う"));
  EXPECT_EQ(last, newest);
  EXPECT_FALSE(speaker.is_busy());
}

TEST(Speaker, SaysWhyNothingIsHeard) {
  const StandInVoices installed;
  base::Inbox inbox;
  Speaker speaker(inbox, installed.places());
  std::optional<base::Error> error;
  speaker.failed.connect([&](std::uint64_t, const base::Error& why) { error = why; });
  speaker.speak("か");
  inbox.run_until([&] { return error.has_value(); });
  EXPECT_EQ(error->code, base::Errc::not_found);
}

TEST(Speaker, UsesTheVoiceThatIsChosenAndNamesIt) {
  const StandInVoices installed;
  installed.add_espeak();
  installed.add_open_jtalk();
  base::Inbox inbox;
  VoiceChoice choice;
  choice.kind = VoiceKind::espeak_ng;
  Speaker speaker(inbox, installed.places(), choice);
  std::vector<std::string> sources, names;
  speaker.spoken.connect([&](std::uint64_t, const Spoken& spoken) { sources.push_back(spoken.source); });
  speaker.voice_found.connect(
      [&](const base::Result<VoiceState>& voice) { names.push_back(voice ? voice->name : "none"); });
  speaker.speak("か");
  inbox.run_until([&] { return sources.size() == 1; });
  choice.kind = VoiceKind::automatic;
  speaker.choose(choice);
  EXPECT_EQ(speaker.choice(), choice);
  speaker.find_voice();
  inbox.run_until([&] { return names.size() == 1; });
  speaker.speak("か");
  inbox.run_until([&] { return sources.size() == 2; });
  EXPECT_THAT(sources, ElementsAre("espeak-ng", "open-jtalk"));
  EXPECT_THAT(names, ElementsAre("Open JTalk (mei)"));
}

TEST(Speaker, StopsAVoiceThatIsStillAtWork) {
  const StandInVoices installed;
  installed.add_program("espeak-ng", "case \"$*\" in *あ*) sleep 1000;; esac\ncat '" +
                                         installed.path("tone.wav").string() + "'");
  base::Inbox inbox;
  std::vector<std::string> heard;
  Speaker speaker(inbox, installed.places());
  speaker.spoken.connect([&](std::uint64_t, const Spoken& spoken) { heard.push_back(spoken.kana); });
  speaker.speak("あ");
  speaker.stop();
  EXPECT_FALSE(speaker.is_busy());
  speaker.speak("い");
  inbox.run_until([&] { return !heard.empty(); });
  EXPECT_THAT(heard, ElementsAre("い"));
}

TEST(Speaker, CountsItsRequestsFromOneAndNamesThemInItsAnswers) {
  const StandInVoices installed;
  base::Inbox inbox;
  Speaker speaker(inbox, installed.places());
  std::vector<std::uint64_t> failed;
  speaker.failed.connect([&](std::uint64_t number, const base::Error&) { failed.push_back(number); });
  EXPECT_EQ(speaker.speak("か"), 1U);
  inbox.run_until([&] { return failed.size() == 1; });
  EXPECT_EQ(speaker.speak("き"), 2U);
  inbox.run_until([&] { return failed.size() == 2; });
  EXPECT_THAT(failed, ElementsAre(1U, 2U));
}

TEST(Speaker, SaysWhyThereIsNoVoice) {
  const StandInVoices installed;
  base::Inbox inbox;
  Speaker speaker(inbox, installed.places());
  std::optional<base::Errc> why;
  speaker.voice_found.connect([&](const base::Result<VoiceState>& voice) {
    if (!voice) why = voice.error().code;
  });
  speaker.find_voice();
  EXPECT_FALSE(speaker.is_busy()) << "nobody asked for speech";
  inbox.run_until([&] { return why.has_value(); });
  EXPECT_EQ(why, base::Errc::not_found);
}

}  // namespace
}  // namespace nazori::speech
