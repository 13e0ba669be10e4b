// SPDX-License-Identifier: Apache-2.0
// What the actions of Home do in the window, and what they say where there is nothing to do.
#include <QFileDialog>
#include <QImage>
#include <QTimer>

#include "study/home_parts.h"
#include "study_under_test.h"

namespace nazori::ui {
namespace {

class HomeInTheWindow : public StudyTest {
 protected:
  bool is_home() { return find("home_page")->isVisible(); }
  void add(char32_t character, study::Rating rating = study::Rating::easy) {
    study::Writing writing;
    writing.rating = rating;
    writing.result.accepted = rating != study::Rating::again;
    writing.result.duration = std::chrono::seconds(20);
    ASSERT_TRUE(the_parts->learner().report(
        store().add_writing(character, 1, writing, {{{{10, 50}, 0.0, 1.0}, {{90, 50}, 0.5, 1.0}}})));
  }
  /// Saves a picture where the dialog asks for it; an empty path: it is cancelled. @return its title.
  QString save(const char* which, const QString& path) {
    QString title;
    QTimer::singleShot(0, window_.get(), [&] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      EXPECT_EQ(dialog->objectName(), QStringLiteral("picture_dialog"));
      EXPECT_EQ(dialog->acceptMode(), QFileDialog::AcceptSave);
      EXPECT_EQ(dialog->defaultSuffix(), QStringLiteral("png"));
      EXPECT_EQ(dialog->nameFilters(), QStringList{QStringLiteral("Picture (*.png)")});
      title = dialog->windowTitle();
      if (path.isEmpty()) return dialog->reject();
      dialog->selectFile(path);
      dialog->QDialog::accept();
    });
    action(which)->trigger();
    return title;
  }
};

TEST_F(HomeInTheWindow, SaysHowToBeginAndThatEachReviewIsSaved) {
  EXPECT_EQ(feedback(), QStringLiteral("Enter: start. Each review is saved as soon as you rate it."));
  window_->go_to(QStringLiteral("characters"));
  add(U'一');
  window_->go_to(QStringLiteral("home"));
  EXPECT_EQ(feedback(), QString()) << "there is nothing to start";
  now_ += std::chrono::days(30);
  add(U'二');
  EXPECT_TRUE(find("home_start")->isVisible()) << "it follows what changes";
}

TEST_F(HomeInTheWindow, WhereThereIsNothingToDoThatIsSaid) {
  const std::pair<const char*, const char*> all[] = {
      {"home_reviews", "No reviews are due now."},
      {"home_ahead", "There is nothing to review ahead."},
      {"home_practise", "No character needs care now."},
      {"home_week", "Nothing was written from memory in this time."},
      {"home_month", "Nothing was written from memory in this time."},
      {"home_leeches_lesson", "Nothing is due now."}};
  for (const auto& [name, sentence] : all) {
    action(name)->trigger();
    EXPECT_EQ(feedback().toStdString(), sentence) << name;
    EXPECT_FALSE(session().is_running());
    EXPECT_TRUE(is_home());
  }
  for (const char32_t one : {U'一', U'二', U'十', U'人', U'八', U'入', U'丁'}) add(one);
  action("home_more")->trigger();
  EXPECT_EQ(feedback(), QStringLiteral("All characters of your lists are begun."));
}

TEST_F(HomeInTheWindow, EachActionBeginsWithItsCharactersAndOneSessionRunsAtATime) {
  add(U'二');
  const auto characters = [this](const char* name) {
    action(name)->trigger();
    EXPECT_TRUE(session().is_running()) << name;
    EXPECT_FALSE(is_home()) << name;
    const int total = session().total();
    const char32_t first = session().character();
    session().end();
    EXPECT_TRUE(is_home());
    return std::pair(total, first);
  };
  EXPECT_EQ(characters("home_more"), std::pair(5, U'一')) << "beyond the goal of one a day";
  EXPECT_EQ(characters("home_ahead"), std::pair(1, U'二'));
  now_ += std::chrono::days(9);
  EXPECT_EQ(characters("home_study").first, 2);
  EXPECT_EQ(characters("home_reviews"), std::pair(1, U'二'));
  add(U'二', study::Rating::again);
  EXPECT_EQ(characters("home_practise"), std::pair(1, U'二'));
  action("home_study")->trigger();
  ASSERT_TRUE(session().is_running());
  for (const char* name : {"home_study", "home_more", "home_leeches_lesson"}) {
    window_->go_to(QStringLiteral("home"));
    ASSERT_TRUE(is_home());
    action(name)->trigger();
    EXPECT_FALSE(is_home()) << name << " goes to the session";
  }
}

TEST_F(HomeInTheWindow, TilesAndButtonsLeadToTheirPages) {
  window_->findChild<CharacterTile*>()->click();
  EXPECT_TRUE(QTest::qWaitFor([this] { return shown_character_ == U'一'; }, 20'000));
  EXPECT_FALSE(is_home());
  window_->go_to(QStringLiteral("home"));
  action("home_choose")->trigger();
  EXPECT_FALSE(is_home());
  window_->go_to(QStringLiteral("home"));
  QSignalSpy brush(the_parts, &WindowParts::review_with_brush), pages(the_parts, &WindowParts::go_to);
  action("home_brush")->trigger();
  EXPECT_EQ(brush.count(), 1);
  action("home_choices")->trigger();
  ASSERT_EQ(pages.count(), 1);
  EXPECT_EQ(pages.at(0).at(0).toString(), QStringLiteral("start"));
  add(U'二');
  EXPECT_TRUE(store().card(U'二').introduced);
  action("home_undo")->trigger();
  EXPECT_FALSE(store().card(U'二').introduced);
  auto* row = window_->findChild<InkRow*>();
  row->show_inks(std::vector<practice::InkedWriting>(300, {U'一', true, {}}));
  const int one_row = row->heightForWidth(500);
  action("home_all_ink")->trigger();
  EXPECT_GT(row->heightForWidth(500), one_row);
  action("home_all_ink")->trigger();
  EXPECT_EQ(row->heightForWidth(500), one_row);
}

TEST_F(HomeInTheWindow, APictureIsSavedWhereTheLearnerWantsIt) {
  add(U'一');
  const QString path = folder_.filePath(QStringLiteral("week.png"));
  EXPECT_EQ(save("home_week", {}), QStringLiteral("Picture of the week"));
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_FALSE(feedback().startsWith(QStringLiteral("Saved"))) << feedback().toStdString();
  EXPECT_EQ(save("home_week", path), QStringLiteral("Picture of the week"));
  EXPECT_EQ(feedback(), QStringLiteral("Saved: %1.").arg(path));
  EXPECT_EQ(QImage(path).width(), 1200);
  EXPECT_EQ(save("home_month", folder_.filePath(QStringLiteral("none/month.png"))),
            QStringLiteral("Picture of the month"));
  EXPECT_TRUE(feedback().endsWith(QStringLiteral(". Nothing was saved."))) << feedback().toStdString();
}

}  // namespace
}  // namespace nazori::ui
