// SPDX-License-Identifier: Apache-2.0
// What is shown while data are exported, imported and backed up, and the sentence of every way in which that
// ends.
#include <QLabel>
#include <QProgressDialog>
#include <QPushButton>
#include <QTest>

#include "learners/exchange_progress.h"
#include "nazori/widgets/words/error_text.h"
#include "session_under_test.h"
#include "study/settings_progress.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

using Work = practice::LearnerExchange::Work;
using Kind = practice::ExchangeEvent::Kind;

class ExchangeSentences : public SessionTest {
 protected:
  ExchangeSentences() {
    install_language(QStringLiteral("en"));
    QObject::connect(&progress_, &ExchangeProgress::announced, &window_,
                     [this](Feedback kind, const QString& sentence) {
                       told_ = {kind, sentence.toStdString()};
                     });
  }
  QProgressDialog* dialog() { return window_.findChild<QProgressDialog*>(); }
  QWidget window_;
  practice::LearnerExchange exchange_{inbox_.inbox(), *learner_};
  ExchangeProgress progress_{exchange_, &window_};
  std::pair<Feedback, std::string> told_;
};

TEST_F(ExchangeSentences, EachKindOfWorkHasItsDialogWhileItLasts) {
  const std::pair<Work, const char*> all[] = {{Work::write, "Exporting a.json…"},
                                              {Work::read, "Importing a.json…"},
                                              {Work::back_up, "Making a backup…"},
                                              {Work::restore, "Restoring the backup…"}};
  for (const auto& [work, words] : all) {
    ASSERT_EQ(dialog(), nullptr);
    exchange_.started(work, "/some/where/a.json");
    ASSERT_NE(dialog(), nullptr);
    EXPECT_EQ(dialog()->objectName(), QStringLiteral("exchange_progress"));
    EXPECT_EQ(dialog()->labelText().toStdString(), words);
    EXPECT_EQ(dialog()->findChild<QPushButton*>()->text(), QStringLiteral("Stop"));
    exchange_.progressed()(37);
    EXPECT_EQ(dialog()->value(), 37);
    exchange_.finished();
    exchange_.progressed()(99);
    EXPECT_EQ(dialog()->value(), 37) << "it is on its way out";
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_F(ExchangeSentences, EveryEndHasItsSentenceAndItsSign) {
  practice::ExchangeEvent event;
  event.file = "/some/where/a.json";
  event.profile = "Mari";
  event.characters = 1234;
  event.error = {base::Errc::io, "it is full", "", ""};
  const std::string why = reason(event.error).toStdString();
  const std::tuple<Kind, Feedback, std::string> all[] = {
      {Kind::busy, Feedback::advice,
       "An export, import or backup is already running. Wait for it or stop it."},
      {Kind::nothing_to_back_up, Feedback::advice, "Nothing studied yet, so there is nothing to back up."},
      {Kind::no_store, Feedback::wrong, ""},
      {Kind::saved, Feedback::good, "Saved as /some/where/a.json."},
      {Kind::imported, Feedback::good, "Imported 1,234 characters for Mari. Now studying as Mari."},
      {Kind::backed_up, Feedback::good, "Backed up as a.json."},
      {Kind::restored, Feedback::good, "Backup restored. Your previous data was backed up."},
      {Kind::stopped, Feedback::hint, "Stopped. Nothing was changed."},
      {Kind::exchange_failed, Feedback::wrong, "a.json: " + why + ". Nothing was changed."},
      {Kind::backup_failed, Feedback::wrong, "Backup failed: " + why + "."},
      {Kind::restore_failed, Feedback::wrong,
       "The backup could not be restored: " + why + ". Nothing was changed."}};
  for (const auto& [kind, sign, sentence] : all) {
    event.kind = kind;
    exchange_.announced(event);
    EXPECT_EQ(told_.first, sign) << sentence;
    EXPECT_EQ(told_.second, sentence);
  }
}

TEST_F(ExchangeSentences, AChangeOfTheSettingsIsShownAndItsEndIsToldOnce) {
  practice::SettingsChange change(inbox_.inbox(), *learner_);
  const std::tuple<base::Result<void>, Feedback, std::string> all[] = {
      {base::Result<void>(), Feedback::good, "Settings saved."},
      {tl::unexpected(base::Error{base::Errc::cancelled, "stopped", "", ""}), Feedback::hint,
       "Stopped. The study settings are as they were."},
      {tl::unexpected(base::Error{base::Errc::io, "it is full", "", ""}), Feedback::wrong,
       "The study settings were not kept: " + reason({base::Errc::io, "it is full", "", ""}).toStdString() +
           ". They are as they were."}};
  for (const auto& [changed, sign, sentence] : all) {
    int told = 0;
    const study::Settings wanted = learner_->store().settings();
    QPointer<SettingsProgress> shown = new SettingsProgress(change, wanted, &window_);
    QObject::connect(shown.data(), &SettingsProgress::announced, &window_,
                     [&](Feedback kind, const QString& words) {
                       ++told;
                       told_ = {kind, words.toStdString()};
                     });
    auto* dialog = window_.findChild<QProgressDialog*>();
    ASSERT_NE(dialog, nullptr);
    EXPECT_EQ(dialog->objectName(), QStringLiteral("settings_progress"));
    EXPECT_EQ(dialog->labelText(), QStringLiteral("Working out every character anew…"));
    EXPECT_EQ(dialog->findChild<QPushButton*>()->text(), QStringLiteral("Stop"));
    change.progressed()(41);
    EXPECT_EQ(dialog->value(), 41);
    // The work itself ends, too, but this one has gone by then.
    change.finished(changed);
    EXPECT_EQ(told, 1);
    EXPECT_EQ(told_.first, sign) << sentence;
    EXPECT_EQ(told_.second, sentence);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_TRUE(shown.isNull());
    EXPECT_EQ(window_.findChild<QProgressDialog*>(), nullptr);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !change.is_busy(); }, 20'000));
  }
}

}  // namespace
}  // namespace nazori::ui
