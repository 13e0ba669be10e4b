// SPDX-License-Identifier: Apache-2.0
#include "functions/function_sound.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

namespace nazori::ui {
namespace {

/// Sets the environment variable by which SDL chooses its audio driver.
class WithDriver {
 public:
  explicit WithDriver(const char* name) : before_(qgetenv("SDL_AUDIODRIVER")) {
    qputenv("SDL_AUDIODRIVER", name);
  }
  ~WithDriver() {
    if (before_.isNull())
      qunsetenv("SDL_AUDIODRIVER");
    else
      qputenv("SDL_AUDIODRIVER", before_);
  }
  WithDriver(const WithDriver&) = delete;
  WithDriver& operator=(const WithDriver&) = delete;

 private:
  QByteArray before_;
};

functions::Sound half_a_second() {
  functions::Sound sound;
  sound.samples.assign(44'100, 0.1F);
  return sound;
}

TEST(FunctionSound, WithoutASoundCardOneMessageIsGivenAndAllElseGoesOn) {
  const WithDriver none("no such driver");
  FunctionSound sound;
  QSignalSpy said(&sound, &FunctionSound::unavailable);
  sound.play(half_a_second());
  sound.sign(functions::PointKind::zero, 0);
  sound.touch({440, 0, 0, 1});
  sound.play(half_a_second());
  EXPECT_EQ(said.count(), 1);
  EXPECT_FALSE(sound.is_playing());
  sound.stop();
}

TEST(FunctionSound, AHandThatTouchesTakesOverFromABriefToneWhoseEndNoLongerMatters) {
  const WithDriver dummy("dummy");
  FunctionSound sound;
  sound.touch_briefly({440, 0, 0, 1});
  EXPECT_TRUE(sound.is_playing());
  sound.touch({330, 0, 0, 1});
  EXPECT_FALSE(sound.is_playing()) << "its end would silence the tone under the hand";
  sound.touch_briefly({440, 0, 0, 1});
  sound.touch({});
  EXPECT_FALSE(sound.is_playing());
}

TEST(FunctionSound, ABriefToneEndsByItself) {
  const WithDriver dummy("dummy");
  FunctionSound sound;
  sound.touch_briefly({440, 0, 0, 1});
  EXPECT_TRUE(QTest::qWaitFor([&sound] { return !sound.is_playing(); }, 20000));
}

}  // namespace
}  // namespace nazori::ui
