// SPDX-License-Identifier: Apache-2.0
// The study settings as they are shown, bounded and taken.
#include "study/study_settings_dialog.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTimer>

#include "nazori/practice/list_members.h"
#include "nazori/study/statistics.h"
#include "nazori/widgets/controls/list_choice.h"
#include "session_under_test.h"
#include "study/known_dialog.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

class SettingsDialog : public SessionTest {
 protected:
  void SetUp() override {
    install_language(QStringLiteral("en"));
    ASSERT_TRUE(learner_->store().save_list({"few", {U'一', U'二', U'雨'}}));
    const std::vector<std::string> tags{"exam"};
    ASSERT_TRUE(learner_->store().set_tags(U'一', tags));
    change([](study::Settings& to) { to.new_lists = {"list:few", "grade-1"}; });
  }
  void change(const std::function<void(study::Settings&)>& what) {
    auto settings = learner_->store().settings();
    what(settings);
    ASSERT_TRUE(learner_->store().change_settings(settings));
  }
  StudySettingsDialog& open() {
    dialog_ = std::make_unique<StudySettingsDialog>(*learner_, preferences_, nullptr);
    return *dialog_;
  }
  template <class T>
  T* part(const char* name) {
    return dialog_->findChild<T*>(QString::fromLatin1(name));
  }
  QString choice() { return part<QLabel>("study_choice")->text(); }
  void press(const char* name) { part<QPushButton>(name)->click(); }
  QListWidget* lists() { return part<QListWidget>("study_lists"); }
  void choose(const char* id) {
    for (int row = 0; row < lists()->count(); ++row)
      if (lists()->item(row)->data(Qt::UserRole).toString() == QString::fromUtf8(id))
        lists()->setCurrentRow(row);
  }
  QStringList ids(int most = 1000) {
    QStringList all;
    for (int row = 0; row < lists()->count() && row < most; ++row)
      all.append(lists()->item(row)->data(Qt::UserRole).toString());
    return all;
  }
  /// Does something with the dialog that opens next.
  template <class Dialog>
  void then(std::function<void(Dialog*)> what) {
    QTimer::singleShot(0, dialog_.get(), [what] {
      auto* opened = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      ASSERT_NE(opened, nullptr);
      what(opened);
    });
  }

  Preferences preferences_;
  std::unique_ptr<StudySettingsDialog> dialog_;
};

TEST_F(SettingsDialog, WhatIsNotTouchedStaysAsItWas) {
  change([](study::Settings& to) {
    to.fsrs.desired_retention = 0.87;
    to.new_per_day = 7;
    to.reviews_per_day = 321;
    to.day_starts_at = 5;
    to.new_order = study::NewOrder::components;
    to.leech_lapses = 9;
    to.fuzz = true;
    to.load_balance = true;
    to.lesson.hint_after_misses = 3;
    to.lesson.show_after_misses = 6;
    to.time_zone = "Asia/Tokyo";
  });
  EXPECT_EQ(open().settings(), learner_->store().settings());
  change([](study::Settings& to) {
    to.fuzz = false;
    to.time_zone.clear();
    to.new_order = study::NewOrder::own;
  });
  EXPECT_EQ(open().settings(), learner_->store().settings());
  change([](study::Settings& to) { to.load_balance = false; });
  EXPECT_EQ(open().settings(), learner_->store().settings());
  change([](study::Settings& to) { to.time_zone = "UTC"; });
  EXPECT_EQ(open().settings().time_zone, "UTC") << "a zone without a slash is there where it is in use";
}

TEST_F(SettingsDialog, EveryFieldHasItsPlaceItsBoundsAndItsName) {
  open();
  const struct {
    const char* object;
    const char* name;
    int low, high;
    int study::Settings::*value;
  } spins[] = {
      {"study_new", "New characters per day (maximum)", 0, 1000, &study::Settings::new_per_day},
      {"study_reviews", "Reviews per day (maximum)", 1, 10'000, &study::Settings::reviews_per_day},
      {"study_day_starts", "A study day starts at (hour)", 0, 12, &study::Settings::day_starts_at},
      {"study_leech", "Lapses before a character must be relearned", 2, 100, &study::Settings::leech_lapses}};
  for (const auto& one : spins) {
    auto* spin = part<QSpinBox>(one.object);
    EXPECT_EQ(spin->minimum(), one.low) << one.object;
    EXPECT_EQ(spin->maximum(), one.high) << one.object;
    EXPECT_EQ(spin->accessibleName().toStdString(), one.name);
    for (const int value : {one.low, one.high}) {
      spin->setValue(value);
      EXPECT_EQ(dialog_->settings().*one.value, value) << one.object;
      EXPECT_TRUE(study::check(dialog_->settings())) << one.object;
    }
  }
  part<QSpinBox>("study_hint_after")->setValue(20);
  part<QSpinBox>("study_show_after")->setValue(1);
  EXPECT_EQ(dialog_->settings().lesson.hint_after_misses, 20);
  EXPECT_EQ(dialog_->settings().lesson.show_after_misses, 20) << "not before the hint";
  part<QSpinBox>("study_hint_after")->setValue(0);
  EXPECT_EQ(dialog_->settings().lesson.hint_after_misses, 1);
  part<QCheckBox>("study_fuzz")->setChecked(true);
  EXPECT_TRUE(dialog_->settings().fuzz);
  EXPECT_FALSE(dialog_->settings().load_balance);
  part<QCheckBox>("study_balance")->setChecked(true);
  EXPECT_TRUE(dialog_->settings().load_balance);
  auto* retention = part<QSlider>("study_retention");
  retention->setValue(retention->minimum());
  EXPECT_DOUBLE_EQ(dialog_->settings().fsrs.desired_retention, study::kLowestRetention);
  retention->setValue(retention->maximum());
  EXPECT_DOUBLE_EQ(dialog_->settings().fsrs.desired_retention, study::kHighestRetention);
}

TEST_F(SettingsDialog, TheOrderOfNewCharactersIsOneOfFive) {
  open();
  auto* order = part<QComboBox>("study_order");
  const std::pair<const char*, study::NewOrder> all[] = {{"by school grade", study::NewOrder::grade},
                                                         {"most common first", study::NewOrder::frequency},
                                                         {"fewest strokes first", study::NewOrder::strokes},
                                                         {"simple parts first", study::NewOrder::components},
                                                         {"in list order", study::NewOrder::own}};
  ASSERT_EQ(order->count(), 5);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(order->itemText(i).toStdString(), all[i].first);
    order->setCurrentIndex(i);
    EXPECT_EQ(dialog_->settings().new_order, all[i].second);
  }
  QStringList pages;
  auto* tabs = part<QTabWidget>("study_settings_tabs");
  for (int i = 0; i < tabs->count(); ++i) pages.append(tabs->tabText(i));
  EXPECT_EQ(pages, (QStringList{QStringLiteral("Daily goal"), QStringLiteral("Lists"),
                                QStringLiteral("Review"), QStringLiteral("Window")}));
}

TEST_F(SettingsDialog, TheWindowsPartGoesToThePreferences) {
  for (const bool on : {true, false})
    for (const OneHand hand : {OneHand::none, OneHand::left, OneHand::right}) {
      preferences_.begin_at_home = on;
      preferences_.asks_by_words = !on;
      preferences_.left_handed = on;
      preferences_.one_hand = hand;
      open();
      Preferences to;
      dialog_->fill(to);
      EXPECT_EQ(to.begin_at_home, on);
      EXPECT_EQ(to.asks_by_words, !on);
      EXPECT_EQ(to.left_handed, on);
      EXPECT_EQ(to.one_hand, hand);
    }
  part<QComboBox>("study_one_hand")->setCurrentIndex(1);
  part<QCheckBox>("study_at_home")->setChecked(true);
  Preferences to;
  dialog_->fill(to);
  EXPECT_EQ(to.one_hand, OneHand::left);
  EXPECT_TRUE(to.begin_at_home);
}

TEST_F(SettingsDialog, WhatIsExpectedFollowsRetentionAndNumber) {
  open();
  const auto expected = [this] { return part<QLabel>("study_workload")->text(); };
  part<QSpinBox>("study_new")->setValue(4);
  EXPECT_TRUE(expected().startsWith(QStringLiteral("With 4 new characters a day: about ")))
      << expected().toStdString();
  const auto workload =
      study::expected_workload(dialog_->settings().fsrs, 4, *study::pace_of(learner_->store()));
  const QLocale locale;
  EXPECT_TRUE(expected().contains(QStringLiteral("about %1 reviews and %2 minute")
                                      .arg(locale.toString(std::lround(workload->reviews_per_day)),
                                           QString::number(std::lround(workload->minutes_per_day)))));
  EXPECT_TRUE(expected().contains(QStringLiteral("about %1 characters known after a year")
                                      .arg(locale.toString(std::lround(workload->known)))));
  const QString before = expected();
  auto* retention = part<QSlider>("study_retention");
  retention->setValue(retention->maximum());
  EXPECT_NE(expected(), before);
  part<QSpinBox>("study_new")->setValue(500);
  EXPECT_TRUE(expected().startsWith(QStringLiteral("With 100 new characters a day")));
}

TEST_F(SettingsDialog, ChosenListsStandFirstAndMove) {
  open();
  EXPECT_EQ(ids(2), (QStringList{QStringLiteral("list:few"), QStringLiteral("grade-1")}));
  EXPECT_EQ(ids().size(), static_cast<qsizetype>(study::ready_lists().size()) + 2);
  EXPECT_TRUE(ids().contains(QStringLiteral("tag:exam")));
  EXPECT_EQ(lists()->currentRow(), 0);
  EXPECT_EQ(choice(), QStringLiteral("80 characters selected, 0 of them already studied."));
  press("list_up");
  EXPECT_EQ(lists()->currentRow(), 0);
  press("list_down");
  EXPECT_EQ(ids(2), (QStringList{QStringLiteral("grade-1"), QStringLiteral("list:few")}));
  EXPECT_EQ(lists()->currentRow(), 1);
  EXPECT_EQ(dialog_->settings().new_lists, (std::vector<std::string>{"grade-1", "list:few"}));
  press("list_up");
  EXPECT_EQ(lists()->currentRow(), 0);
  lists()->setCurrentRow(lists()->count() - 1);
  const QStringList all = ids();
  press("list_down");
  EXPECT_EQ(ids(), all);
  choose("grade-1");
  lists()->currentItem()->setCheckState(Qt::Unchecked);
  EXPECT_EQ(choice(), QStringLiteral("3 characters selected, 0 of them already studied."));
  choose("list:few");
  lists()->currentItem()->setCheckState(Qt::Unchecked);
  EXPECT_EQ(choice(), QStringLiteral("No list is selected, so no new characters will come up."));
  EXPECT_TRUE(dialog_->settings().new_lists.empty());
}

TEST_F(SettingsDialog, AWholeListIsPausedResumedPostponedAndReset) {
  study::Writing writing;
  ASSERT_TRUE(learner_->store().add_writing(U'一', 1, writing));
  open();
  EXPECT_EQ(choice(), QStringLiteral("80 characters selected, 1 of them already studied."));
  choose("list:few");
  const auto card = [this](char32_t one) { return learner_->store().card(one); };
  press("list_pause");
  EXPECT_EQ(choice(), QStringLiteral("3 characters suspended. Ctrl+Shift+Z: undo."));
  EXPECT_TRUE(card(U'一').paused && card(U'二').paused && card(U'雨').paused);
  press("list_resume");
  EXPECT_EQ(choice(), QStringLiteral("3 characters resumed. Ctrl+Shift+Z: undo."));
  EXPECT_FALSE(card(U'雨').paused);
  then<QInputDialog>([](QInputDialog* days) {
    EXPECT_EQ(days->intValue(), 7);
    EXPECT_EQ(days->intMinimum(), 1);
    EXPECT_EQ(days->intMaximum(), 3650);
    days->setIntValue(3);
    days->accept();
  });
  press("list_postpone");
  EXPECT_EQ(choice(), QStringLiteral("3 characters postponed. Ctrl+Shift+Z: undo."));
  EXPECT_EQ(card(U'二').postponed_until, learner_->store().today() + std::chrono::days(3));
  then<QInputDialog>([](QInputDialog* days) { days->reject(); });
  press("list_postpone");
  EXPECT_EQ(card(U'二').postponed_until, learner_->store().today() + std::chrono::days(3));
  press("list_reset");
  EXPECT_EQ(choice(), QStringLiteral("3 characters started over as new. Ctrl+Shift+Z: undo."));
  EXPECT_EQ(card(U'一').memory.reps, 0);
  ASSERT_TRUE(learner_->store().save_list({"none", {}}));
  open();
  choose("list:none");
  press("list_pause");
  EXPECT_EQ(choice(), QStringLiteral("This list is empty."));
}

TEST_F(SettingsDialog, APastedTextIsMarkedAsKnownWithOneUndo) {
  open();
  then<KnownDialog>([](KnownDialog* known) {
    auto* mark = known->findChild<QPushButton*>("known_mark");
    auto* text = known->findChild<QPlainTextEdit*>("known_text");
    const auto found = [known] { return known->findChild<QLabel*>("known_found")->text(); };
    EXPECT_FALSE(mark->isEnabled());
    text->setPlainText(QStringLiteral("nothing here"));
    EXPECT_FALSE(mark->isEnabled());
    text->setPlainText(QStringLiteral("一\t二,一 の"));
    EXPECT_EQ(found(),
              QStringLiteral("3 characters will be marked as known. What you have studied stays as it is."));
    mark->click();
  });
  press("list_know");
  EXPECT_TRUE(choice().endsWith(QStringLiteral("3 characters marked as known. Ctrl+Shift+Z: undo.")))
      << choice().toStdString();
  EXPECT_TRUE(learner_->store().card(U'二').introduced);
  then<KnownDialog>([](KnownDialog* known) {
    known->findChild<QPlainTextEdit*>("known_text")->setPlainText(QStringLiteral("二"));
    EXPECT_FALSE(known->findChild<QPushButton*>("known_mark")->isEnabled()) << "it is studied already";
    known->reject();
  });
  press("list_know");
  ASSERT_TRUE(learner_->store().undo());
  EXPECT_FALSE(learner_->store().card(U'二').introduced);
  EXPECT_FALSE(learner_->store().card(U'の').introduced);
}

TEST_F(SettingsDialog, OnlyOwnListsAreRemovedAndOnlyAfterAQuestion) {
  open();
  choose("grade-2");
  press("list_remove");
  EXPECT_EQ(choice(), QStringLiteral("Only your own lists can be removed."));
  choose("list:few");
  for (const auto answer : {QMessageBox::Cancel, QMessageBox::Ok}) {
    EXPECT_TRUE(ids().contains(QStringLiteral("list:few")));
    then<QMessageBox>([answer](QMessageBox* box) {
      EXPECT_EQ(box->objectName(), QStringLiteral("remove_list_box"));
      EXPECT_EQ(box->text(), QStringLiteral("Remove “few”? Your progress with its characters is kept."));
      box->button(answer)->click();
    });
    press("list_remove");
  }
  EXPECT_FALSE(ids().contains(QStringLiteral("list:few")));
  EXPECT_TRUE(learner_->store().lists()->empty());
  EXPECT_EQ(dialog_->settings().new_lists, std::vector<std::string>{"grade-1"});
}

TEST_F(SettingsDialog, WeightsAreTakenWhereTheyAreWeights) {
  open();
  const auto said = [this] { return part<QLabel>("study_weights")->text(); };
  EXPECT_EQ(said(), QStringLiteral("FSRS-6 with default parameters."));
  const auto type = [this](const QString& text, bool taken) {
    then<QInputDialog>([text, taken](QInputDialog* asked) {
      EXPECT_EQ(asked->textValue().split(QStringLiteral(", ")).size(), 21);
      asked->setTextValue(text);
      taken ? asked->accept() : asked->reject();
    });
    press("weights_import");
  };
  type(QStringLiteral("1, 2"), true);
  EXPECT_TRUE(said().startsWith(QStringLiteral("These parameters cannot be used: "))) << said().toStdString();
  QStringList own;
  auto weights = study::kDefaultWeights;
  weights.front() = 0.5;
  for (const double weight : weights) own.append(QString::number(weight));
  type(own.join(QLatin1Char(' ')), false);
  EXPECT_EQ(dialog_->settings().fsrs.weights, study::kDefaultWeights);
  type(own.join(QStringLiteral(", ")), true);
  EXPECT_EQ(said(), QStringLiteral("FSRS-6 with custom parameters (the first is 0.5000)."));
  EXPECT_DOUBLE_EQ(dialog_->settings().fsrs.weights.front(), 0.5);
  press("weights_default");
  EXPECT_EQ(said(), QStringLiteral("FSRS-6 with default parameters."));
  EXPECT_EQ(dialog_->settings().fsrs.weights, study::kDefaultWeights);
}

TEST_F(SettingsDialog, WithoutAStoreToWriteNothingCanBeAccepted) {
  learner_->let_go(practice::LearnerEvent::Kind::replacing);
  open();
  const auto* buttons = part<QDialogButtonBox>("study_settings_buttons");
  EXPECT_FALSE(buttons->button(QDialogButtonBox::Ok)->isEnabled());
  EXPECT_TRUE(buttons->button(QDialogButtonBox::Cancel)->isEnabled());
  EXPECT_EQ(part<QLabel>("study_settings_trouble")->text(), replaced());
  for (const char* name : {"list_new", "list_remove", "list_up", "list_postpone", "list_pause", "list_reset"})
    EXPECT_FALSE(part<QPushButton>(name)->isEnabled()) << name;
}

TEST_F(SettingsDialog, EveryKindOfListHasAName) {
  const std::pair<const char*, const char*> names[] = {{"grade-3", "Grade 3"},
                                                       {"secondary", "Secondary school"},
                                                       {"jinmeiyou", "Kanji for names"},
                                                       {"hiragana", "Hiragana"},
                                                       {"katakana", "Katakana"},
                                                       {"old-jlpt-2", "Old JLPT level 2 (before 2010)"},
                                                       {"list:week", "My list: week"},
                                                       {"tag:exam", "Tag: exam"},
                                                       {"other", "other"}};
  for (const auto& [id, name] : names)
    EXPECT_EQ(ListChoice::name_of(QString::fromLatin1(id)).toStdString(), name);
  ListChoice lists;
  EXPECT_EQ(lists.count(), 1);
  lists.fill(learner_->store());
  EXPECT_EQ(lists.itemText(0), QStringLiteral("Studied so far"));
  EXPECT_EQ(lists.count(), static_cast<int>(study::ready_lists().size()) + 3);
  lists.set_list(QStringLiteral("tag:exam"));
  EXPECT_EQ(lists.list(), QStringLiteral("tag:exam"));
  lists.fill(learner_->store());
  EXPECT_EQ(lists.list(), QStringLiteral("tag:exam")) << "it stays chosen";
  lists.set_list(QStringLiteral("list:gone"));
  EXPECT_EQ(lists.list(), QString());
  EXPECT_FALSE(practice::list_members("grade-1", nullptr, learner_->store()));
  EXPECT_EQ(practice::list_members("list:few", learner_->lists(), learner_->store())->size(), 3U);
}

}  // namespace
}  // namespace nazori::ui
