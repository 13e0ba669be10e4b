// SPDX-License-Identifier: Apache-2.0
#include "nazori/speech/sound.h"

#include <gtest/gtest.h>
#include <sndfile.h>

#include <cmath>
#include <cstring>

#include "stand_in_voices.h"

namespace nazori::speech {
namespace {

TEST(Sound, KnowsItsLengthAndHowLoudItIs) {
  const Sound tone = StandInVoices::tone(0.5);
  EXPECT_DOUBLE_EQ(tone.duration_s(), 0.5);
  EXPECT_NEAR(loudness(tone), 0.5 / std::sqrt(2.0), 1e-4);
  EXPECT_EQ(loudness({}), 0);
  EXPECT_EQ(Sound{}.duration_s(), 0);
}

TEST(SoundFile, KeepsTheSoundInSixteenBits) {
  const Sound tone = StandInVoices::tone(0.1, 22'050);
  const auto wav = to_wav(tone);
  ASSERT_TRUE(wav);
  EXPECT_EQ(wav->size(), 44 + 2 * tone.samples.size());
  std::uint32_t length = 0;
  std::memcpy(&length, wav->data() + 40, 4);
  EXPECT_EQ(length, 2 * tone.samples.size()) << "the head is finished when the file is closed";
  const auto back = decode_sound(*wav);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->rate_hz, 22'050);
  ASSERT_EQ(back->samples.size(), tone.samples.size());
  for (std::size_t i = 0; i < tone.samples.size(); ++i)
    ASSERT_NEAR(back->samples[i], tone.samples[i], 1.0 / 32'767);
}

TEST(SoundFile, LimitsWhatIsTooLoudAndHasNothingOfNothing) {
  const auto wav = to_wav({8000, {2.0F, -3.0F}});
  ASSERT_TRUE(wav);
  const auto back = decode_sound(*wav);
  ASSERT_TRUE(back);
  EXPECT_NEAR(back->samples[0], 1, 1e-3);
  EXPECT_NEAR(back->samples[1], -1, 1e-3);
  EXPECT_FALSE(to_wav({8000, {}}));
  EXPECT_FALSE(to_wav({0, {1.0F}}));
  EXPECT_TRUE(to_wav({1, {1.0F}}));
}

/// Writes a sound file of 8,000 frames a second. @param format  as in libsndfile.
void write_frames(const std::string& file, int format, int channels, const std::vector<float>& frames) {
  SF_INFO info{};
  info.samplerate = 8000;
  info.channels = channels;
  info.format = format;
  SNDFILE* out = sf_open(file.c_str(), SFM_WRITE, &info);
  ASSERT_NE(out, nullptr);
  sf_writef_float(out, frames.data(), static_cast<sf_count_t>(frames.size()) / channels);
  sf_close(out);
}

TEST(SoundFile, WhatIsNoNumberIsSilentAndWhatIsBeyondTheRangeIsLimited) {
  const StandInVoices folder;
  const std::string file = folder.path("float.wav").string();
  write_frames(file, SF_FORMAT_WAV | SF_FORMAT_FLOAT, 1, {NAN, 1.3F, -1.3F, INFINITY, 0.25F});
  const auto sound = read_sound(file);
  ASSERT_TRUE(sound) << base::to_line(sound.error());
  EXPECT_EQ(sound->samples, (std::vector<float>{0, 1, -1, 0, 0.25F}));
}

TEST(SoundFile, LastsAtMostTwentySeconds) { EXPECT_EQ(kMostSound_s, 20); }

TEST(SoundFile, MixesTwoChannelsIntoOne) {
  const StandInVoices folder;
  const std::string file = folder.path("stereo.ogg").string();
  std::vector<float> frames;
  for (int i = 0; i < 4000; ++i) {
    frames.push_back(0.6F * std::sin(0.3F * static_cast<float>(i)));
    frames.push_back(0.2F * std::sin(0.3F * static_cast<float>(i)));
  }
  write_frames(file, SF_FORMAT_OGG | SF_FORMAT_VORBIS, 2, frames);
  const auto sound = read_sound(file);
  ASSERT_TRUE(sound) << base::to_line(sound.error());
  EXPECT_EQ(sound->samples.size(), 4000U);
  EXPECT_NEAR(loudness(*sound), 0.4 / std::sqrt(2.0), 0.02);
}

TEST(SoundFile, IsReadToItsEndWhateverLengthItsHeadNames) {
  auto wav = *to_wav(StandInVoices::tone(0.2));
  const std::uint32_t unknown = 0x7FFFF000;
  std::memcpy(wav.data() + 4, &unknown, 4);
  std::memcpy(wav.data() + 40, &unknown, 4);
  const auto sound = decode_sound(wav);
  ASSERT_TRUE(sound) << base::to_line(sound.error());
  EXPECT_NEAR(sound->duration_s(), 0.2, 1e-3);
}

TEST(SoundFile, IsRefusedWhereItIsNoneIsEmptyOrLastsTooLong) {
  EXPECT_EQ(decode_sound({}).error().code, base::Errc::parse);
  const std::vector<std::uint8_t> text{'R', 'I', 'F', 'F', 'x'};
  EXPECT_EQ(decode_sound(text).error().code, base::Errc::parse);
  EXPECT_EQ(decode_sound(text).error().what, "is no sound file that can be read");
  auto empty = *to_wav({8000, {0.5F}});
  empty.resize(44);
  EXPECT_EQ(decode_sound(empty).error().what, "has no sound in it");
  EXPECT_TRUE(decode_sound(*to_wav(StandInVoices::tone(kMostSound_s, 8000))));
  EXPECT_EQ(decode_sound(*to_wav(StandInVoices::tone(kMostSound_s + 0.1, 8000))).error().what,
            "lasts too long");
  const auto missing = read_sound("/no such folder/か.wav");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, base::Errc::not_found);
}

}  // namespace
}  // namespace nazori::speech
