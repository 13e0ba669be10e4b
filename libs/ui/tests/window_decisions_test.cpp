// SPDX-License-Identifier: Apache-2.0
// What a learner decides about the character that is shown: lists, tags, a lesson, a drill; and the way from
// one character to the next.
#include <QInputDialog>
#include <QListView>
#include <QTimer>

#include "characters/character_list_model.h"
#include "characters/drill_dialog.h"
#include "study_under_test.h"

namespace nazori::ui {
namespace {

class Decisions : public StudyTest {
 protected:
  void SetUp() override {
    StudyTest::SetUp();
    show(U'人');
  }
  /// Does something with the dialog that the action opens.
  template <class Dialog>
  void in_dialog(const char* name, const std::function<void(Dialog*)>& what) {
    bool seen = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, [&] {
      auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr || seen) return;
      seen = true;
      what(dialog);
    });
    look.start(5);
    action(name)->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return seen && QApplication::activeModalWidget() == nullptr; }, 20'000))
        << name;
  }
  void type(const char* name, const QString& text) {
    in_dialog<QInputDialog>(name, [&](QInputDialog* dialog) {
      dialog->setTextValue(text);
      dialog->accept();
    });
  }
  std::vector<char32_t> list(const char* name) {
    const auto all = store().lists();
    for (const auto& one : *all)
      if (one.name == name) return one.characters;
    return {};
  }
};

TEST_F(Decisions, ACharacterGoesIntoAListThatIsChosenOrNamedAndOutOfIt) {
  in_dialog<QInputDialog>("add_to_list", [](QInputDialog* dialog) {
    EXPECT_EQ(dialog->windowTitle(), QStringLiteral("Add to list"));
    EXPECT_EQ(dialog->labelText(),
              QStringLiteral("List for 人. Choose one, or type a new name; ✓: it is in the list already."));
    EXPECT_EQ(dialog->comboBoxItems(), QStringList{QStringLiteral("few ✓")});
    EXPECT_TRUE(dialog->isComboBoxEditable());
    dialog->reject();
  });
  type("add_to_list", QStringLiteral("   "));
  EXPECT_EQ(store().lists()->size(), 1U);
  type("add_to_list", QStringLiteral(" mine "));
  EXPECT_EQ(feedback(), QStringLiteral("Added 人 to the list “mine”."));
  EXPECT_EQ(list("mine"), std::vector<char32_t>{U'人'});
  show(U'二');
  type("add_to_list", QStringLiteral("mine"));
  EXPECT_EQ(list("mine"), (std::vector<char32_t>{U'人', U'二'}));
  type("add_to_list", QStringLiteral("few ✓"));
  EXPECT_EQ(feedback(), QStringLiteral("Took 二 out of the list “few”."));
  EXPECT_EQ(list("few"), (std::vector<char32_t>{U'一', U'十', U'人', U'八', U'入', U'丁'}));
}

TEST_F(Decisions, TagsAreWordsBetweenCommasOfAnyKind) {
  in_dialog<QInputDialog>("study_tags", [](QInputDialog* dialog) {
    EXPECT_EQ(dialog->windowTitle(), QStringLiteral("Tags"));
    EXPECT_EQ(dialog->labelText(), QStringLiteral("Tags for 人, separated by commas:"));
    EXPECT_EQ(dialog->textValue(), QString());
    dialog->setTextValue(QStringLiteral(" exam, 夏、 ，b c ,"));
    dialog->accept();
  });
  auto tags = *store().tags_of(U'人');
  std::sort(tags.begin(), tags.end());
  EXPECT_EQ(tags, (std::vector<std::string>{"b c", "exam", "夏"}));
  in_dialog<QInputDialog>("study_tags", [](QInputDialog* dialog) {
    EXPECT_EQ(dialog->textValue().split(QStringLiteral(", ")).size(), 3);
    dialog->setTextValue(QStringLiteral("other"));
    dialog->reject();
  });
  EXPECT_EQ(store().tags_of(U'人')->size(), 3U);
  type("study_tags", QString());
  EXPECT_TRUE(store().tags_of(U'人')->empty());
}

TEST_F(Decisions, StudyingThisEndsWhatIsStudiedAndBeginsWithIt) {
  action("study_this")->trigger();
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'人');
  EXPECT_EQ(session().total(), 1);
  show(U'雨');
  action("study_this")->trigger();
  ASSERT_TRUE(session().is_running());
  EXPECT_EQ(session().character(), U'雨');
  session().end();
  show(U'雨');
  action("know_this")->trigger();
  EXPECT_TRUE(store().card(U'雨').introduced);
  EXPECT_TRUE(feedback().startsWith(QStringLiteral("雨 is marked as known. It comes in a review in ")))
      << feedback().toStdString();
  EXPECT_TRUE(feedback().endsWith(QStringLiteral(" days. Ctrl+Shift+Z: undo."))) << feedback().toStdString();
  action("study_undo")->trigger();
  EXPECT_FALSE(store().card(U'雨').introduced);
}

TEST_F(Decisions, ConfusableCharactersAreToldApartAndThenWritten) {
  ASSERT_TRUE(action("tell_apart")->isEnabled()) << "人 is confused with 入";
  int choices = 0;
  const auto answer_all = [&](DrillDialog* dialog) {
    auto* write = dialog->findChild<QPushButton*>(QStringLiteral("drill_write"));
    choices = 0;
    for (const auto* one : dialog->findChildren<QPushButton*>())
      choices += one->objectName().startsWith(QStringLiteral("drill_choice_")) ? 1 : 0;
    for (int i = 0; i < 200 && !write->isEnabled(); ++i)
      dialog->findChild<QPushButton*>(QStringLiteral("drill_choice_1"))->click();
    EXPECT_TRUE(write->isEnabled());
    EXPECT_TRUE(write->isDefault());
    return write;
  };
  in_dialog<DrillDialog>("tell_apart", [&](DrillDialog* dialog) {
    answer_all(dialog);
    dialog->findChild<QPushButton*>(QStringLiteral("drill_close"))->click();
  });
  EXPECT_FALSE(session().is_running());
  in_dialog<DrillDialog>("tell_apart", [&](DrillDialog* dialog) { answer_all(dialog)->click(); });
  ASSERT_TRUE(session().is_running());
  EXPECT_GE(choices, 2);
  EXPECT_EQ(session().total(), choices);
}

TEST_F(Decisions, TheListIsWalkedAndTheWayBackIsKept) {
  const auto* model = qobject_cast<const CharacterListModel*>(find<QListView>("character_grid")->model());
  ASSERT_TRUE(QTest::qWaitFor([&] { return model->rowCount() > 10; }, 20'000));
  const auto go = [&](const char* name) {
    shown_character_ = 0;
    action(name)->trigger();
    EXPECT_TRUE(QTest::qWaitFor([&] { return shown_character_ != 0; }, 20'000)) << name;
    return shown_character_;
  };
  show(model->at(3));
  EXPECT_EQ(go("next_character"), model->at(4));
  EXPECT_EQ(go("next_character"), model->at(5));
  EXPECT_EQ(go("previous_character"), model->at(4));
  EXPECT_EQ(go("back"), model->at(5));
  EXPECT_EQ(go("back"), model->at(4));
  EXPECT_EQ(go("back"), model->at(3));
  EXPECT_EQ(go("forward"), model->at(4));
  show(model->at(0));
  action("previous_character")->trigger();
  EXPECT_EQ(go("next_character"), model->at(1)) << "before the first there is none";
  show(U'鬱');
  EXPECT_EQ(go("next_character"), model->at(0)) << "of a character that is not in the list";
}

}  // namespace
}  // namespace nazori::ui
