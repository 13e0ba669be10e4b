// SPDX-License-Identifier: Apache-2.0
// What is spoken, by which voice, and what is said where nothing can speak. Stand-ins take the place of the
// programs that speak.
#include <QSettings>

#include "characters/characters.h"
#include "nazori/widgets/page/window_parts.h"
#include "stand_in_voices.h"
#include "window_under_test.h"

namespace nazori::ui {
namespace {

/// Sets a variable of the environment for as long as it lives.
class WithVariable {
 public:
  WithVariable(const char* name, const QByteArray& value) : name_(name), before_(qgetenv(name)) {
    qputenv(name, value);
  }
  ~WithVariable() {
    if (before_.isNull())
      qunsetenv(name_);
    else
      qputenv(name_, before_);
  }
  WithVariable(const WithVariable&) = delete;
  WithVariable& operator=(const WithVariable&) = delete;

 private:
  const char* name_;
  QByteArray before_;
};

class SpokenReading : public WindowTest {
 protected:
  SpokenReading() {
    pages_ = {
        [](WindowParts& parts) -> std::unique_ptr<Page> { return std::make_unique<Characters>(parts); }};
    std::filesystem::create_symlink("/bin/cat", voices_.path("bin/cat"));
  }
  void SetUp() override {
    install_language(QStringLiteral("en"));
    open_window(U'休');
  }
  bool says(const char* sentence) {
    return QTest::qWaitFor([&] { return feedback() == QString::fromUtf8(sentence); }, 10'000);
  }
  bool has_spoken(std::size_t times) {
    return QTest::qWaitFor([&] { return voices_.runs().size() == times; }, 10'000);
  }
  speech::StandInVoices voices_;
  WithVariable path_{"PATH", QByteArray::fromStdString(voices_.path("bin").string())};
  WithVariable data_{"XDG_DATA_HOME", QByteArray::fromStdString(voices_.path("data").string())};
  WithVariable sound_card_{"SDL_AUDIODRIVER", "dummy"};
};

TEST_F(SpokenReading, WhatIsMissingIsSaidWithWhatToInstall) {
  action("speak")->trigger();
  EXPECT_TRUE(says("No Japanese voice is installed. Install the package espeak-ng."))
      << feedback().toStdString();
  const std::pair<const char*, const char*> all[] = {
      {"voice_espeak", "eSpeak NG cannot speak: something is missing (install the package espeak-ng)."},
      {"voice_dispatcher",
       "Speech Dispatcher cannot speak: something is missing (install the package speech-dispatcher)."},
      {"voice_open_jtalk", "Open JTalk cannot speak: something is missing (install the package open-jtalk)."},
      {"voice_automatic", "No Japanese voice is installed. Install the package espeak-ng."}};
  EXPECT_TRUE(action("voice_automatic")->isChecked());
  for (const auto& [voice, sentence] : all) {
    action(voice)->trigger();
    EXPECT_TRUE(says(sentence)) << feedback().toStdString();
    for (const auto& [other, words] : all)
      EXPECT_EQ(action(other)->isChecked(), QLatin1String(other) == QLatin1String(voice)) << voice << other;
  }
}

TEST_F(SpokenReading, TheChosenVoiceReadsTheCharacterAndIsKept) {
  voices_.add_espeak();
  action("voice_espeak")->trigger();
  ASSERT_TRUE(says("Voice: eSpeak NG.")) << feedback().toStdString();
  action("speak")->trigger();
  ASSERT_TRUE(has_spoken(1));
  EXPECT_NE(voices_.runs()[0].find("やすむ"), std::string::npos) << voices_.runs()[0];
  window_->close();
  open_window(U'休');
  EXPECT_TRUE(action("voice_espeak")->isChecked());
  show(U'A');
  action("speak")->trigger();
  EXPECT_TRUE(says("There is no reading to speak.")) << feedback().toStdString();
}

TEST_F(SpokenReading, TheAnswerIsReadByItselfUnlessThatIsSwitchedOff) {
  voices_.add_espeak();
  EXPECT_TRUE(action("speaks_itself")->isChecked());
  action("memory")->trigger();
  action("give_up")->trigger();
  ASSERT_TRUE(has_spoken(1));
  action("speaks_itself")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("Readings are not spoken. V: speak one."));
  show(U'人');
  action("give_up")->trigger();
  show(U'日');
  action("speak")->trigger();
  ASSERT_TRUE(has_spoken(2));
  EXPECT_EQ(voices_.runs()[1].find("ひと"), std::string::npos) << "that was the answer before";
  window_->close();
  open_window(U'休');
  EXPECT_FALSE(action("speaks_itself")->isChecked());
  action("speaks_itself")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("Readings are spoken."));
}

TEST_F(SpokenReading, WithoutASoundCardThatIsSaidToWhoAskedAndNothingSpeaksByItself) {
  voices_.add_espeak();
  const WithVariable none("SDL_AUDIODRIVER", "none that exists");
  action("speak")->trigger();
  ASSERT_TRUE(has_spoken(1));
  EXPECT_TRUE(QTest::qWaitFor([&] { return feedback().contains(QStringLiteral("ound")); }, 10'000))
      << feedback().toStdString();
  action("memory")->trigger();
  action("give_up")->trigger();
  show(U'日');
  action("speak")->trigger();
  ASSERT_TRUE(has_spoken(2));
}

}  // namespace
}  // namespace nazori::ui
