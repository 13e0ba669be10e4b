// SPDX-License-Identifier: Apache-2.0
// The sentences of Home in both languages, and the picture of a week.
#include "study/home_words.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <vector>

#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/trouble_words.h"
#include "session_under_test.h"
#include "study/home.h"
#include "study/home_view.h"
#include "study/period_picture.h"
#include "window/language.h"

namespace nazori::ui {
namespace {

TEST(HomeWords, TimesAreToldInTheUnitInWhichPeopleThink) {
  install_language(QStringLiteral("en"));
  const std::pair<int, const char*> all[] = {
      {0, "about a day"},    {1, "about a day"},     {13, "about 13 days"},    {14, "about 2 weeks"},
      {59, "about 8 weeks"}, {60, "about 2 months"}, {729, "about 24 months"}, {730, "about 2 years"}};
  for (const auto& [number, words] : all)
    EXPECT_EQ(HomeWords::about_days(number), QString::fromLatin1(words)) << number;
}

TEST(HomeWords, OfManyCharactersTheFirstTwelveAreShown) {
  install_language(QStringLiteral("en"));
  std::vector<char32_t> all;
  EXPECT_EQ(HomeWords::in_a_row(all), QString());
  for (const char32_t one : U"一二三四五六七八九十百千") {
    if (one != 0) all.push_back(one);
  }
  EXPECT_EQ(HomeWords::in_a_row({U'一'}), QStringLiteral("一"));
  EXPECT_EQ(HomeWords::in_a_row(all), QStringLiteral("一二三四五六七八九十百千"));
  all.push_back(U'万');
  EXPECT_EQ(HomeWords::in_a_row(all), QStringLiteral("一二三四五六七八九十百千…"));
}

TEST(HomeWords, WorkTimeAndMilestonesAreSaidInFewWords) {
  install_language(QStringLiteral("en"));
  using practice::PartOfDay;
  EXPECT_EQ(HomeWords::greeting(PartOfDay::morning), QStringLiteral("Good morning"));
  EXPECT_EQ(HomeWords::greeting(PartOfDay::afternoon), QStringLiteral("Good afternoon"));
  EXPECT_EQ(HomeWords::greeting(PartOfDay::evening), QStringLiteral("Good evening"));
  EXPECT_EQ(HomeWords::work(3, 0), QStringLiteral("3 reviews"));
  EXPECT_EQ(HomeWords::work(0, 1), QStringLiteral("1 new character"));
  EXPECT_EQ(HomeWords::work(1, 2), QStringLiteral("1 review and 2 new characters"));
  using std::chrono::seconds;
  EXPECT_EQ(HomeWords::minutes(seconds(1)), QStringLiteral("1 min"));
  EXPECT_EQ(HomeWords::minutes(seconds(91)), QStringLiteral("2 min"));
  practice::Milestone milestone;
  milestone.list = "grade-2";
  milestone.size = 160;
  milestone.learned = 159;
  EXPECT_EQ(HomeWords::list(milestone), QStringLiteral("Grade 2"));
  EXPECT_EQ(HomeWords::count(milestone), QStringLiteral("159 of 160"));
  EXPECT_EQ(HomeWords::done(milestone), QString());
  milestone.days_left = 20;
  EXPECT_EQ(HomeWords::done(milestone), QStringLiteral("Done in about 3 weeks at this pace."));
  milestone.learned = 160;
  EXPECT_EQ(HomeWords::done(milestone), QStringLiteral("Done."));
  milestone.size = milestone.learned = 0;
  milestone.days_left.reset();
  EXPECT_EQ(HomeWords::done(milestone), QString()) << "an empty list is not done";
  EXPECT_EQ(HomeWords::streak({}), QString());
}

TEST(TroubleWords, EveryKindOfMistakeHasASentence) {
  install_language(QStringLiteral("en"));
  practice::HardCharacter hard{U'語', 2, std::nullopt};
  EXPECT_EQ(TroubleWords::often(hard), QStringLiteral("語 is often forgotten."));
  QStringList often;
  QStringList counted;
  using Kind = kanji::MistakeKind;
  for (const Kind kind : {Kind::order, Kind::reversed, Kind::missing, Kind::extra, Kind::joined, Kind::split,
                          Kind::wrong, Kind::other}) {
    hard.stroke = practice::StrokeTrouble{2, kind, 6, 28};
    often.append(TroubleWords::often(hard));
    counted.append(TroubleWords::counted(*hard.stroke));
    EXPECT_TRUE(often.back().contains(QStringLiteral("語"))) << often.back().toStdString();
    EXPECT_TRUE(counted.back().endsWith(QStringLiteral("in 6 of 28 writings.")))
        << counted.back().toStdString();
  }
  EXPECT_EQ(often.removeDuplicates(), 0);
  EXPECT_EQ(counted.removeDuplicates(), 0);
  EXPECT_EQ(often[2], QStringLiteral("Stroke 3 of 語 is often left out."));
}

class HomeOfALearner : public SessionTest {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }
};

TEST_F(HomeOfALearner, SpeaksJapanese) {
  ASSERT_TRUE(learner_->store().save_list({"few", {U'休', U'駅'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"list:few"};
  ASSERT_TRUE(learner_->store().change_settings(settings));
  learner_->renew_order();
  study::Writing writing;
  writing.rating = study::Rating::again;
  writing.result.accepted = false;
  writing.result.duration = std::chrono::seconds(20);
  ASSERT_TRUE(learner_->store().add_writing(U'休', 6, writing));
  install_language(QStringLiteral("ja"));
  QWidget window;
  const HomeActions actions(&window);
  HomeView view(*learner_, *session_, actions);
  view.refresh();
  EXPECT_EQ(view.findChild<QLabel*>(QStringLiteral("home_greeting"))->text(),
            QStringLiteral("おはようございます"));
  EXPECT_EQ(view.findChild<QPushButton*>(QStringLiteral("home_start"))->accessibleName(),
            QStringLiteral("始める：新しい字1字・約3分"));
  EXPECT_EQ(view.findChild<QLabel*>(QStringLiteral("home_written"))->text(),
            QStringLiteral("1回書いて、0回正解・1分未満"));
  install_language(QStringLiteral("en"));
}

TEST_F(HomeOfALearner, APictureOfTheWeekShowsTheInkAndIsWrittenBesideAndRenamed) {
  const auto& store = learner_->store();
  const auto week = practice::week_of(store.today());
  ASSERT_TRUE(PeriodPicture::draw(store, week));
  EXPECT_TRUE(PeriodPicture::draw(store, week)->isNull()) << "nothing was written";
  study::Writing writing;
  writing.result.duration = std::chrono::seconds(20);
  ASSERT_TRUE(
      learner_->store().add_writing(U'一', 1, writing, {{{{10, 50}, 0.0, 0.5}, {{90, 50}, 0.5, 0.5}}}));
  const auto picture = PeriodPicture::draw(store, week);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width(), PeriodPicture::kWidth);
  EXPECT_EQ(picture->pixelColor(2, 2), light_colours().paper);
  int inked = 0;
  for (int y = 250; y < picture->height() - 120; ++y)
    for (int x = 0; x < picture->width(); ++x)
      inked += picture->pixelColor(x, y) == light_colours().ink ? 1 : 0;
  EXPECT_GT(inked, 200);
  EXPECT_EQ(PeriodPicture::file_name(week), QStringLiteral("nazori-2026-03-02.png"));
  EXPECT_EQ(PeriodPicture::file_name(practice::month_of(store.today())),
            QStringLiteral("nazori-2026-03.png"));
  const QString file = folder_.filePath(QStringLiteral("week.png"));
  ASSERT_TRUE(PeriodPicture::save(*picture, file.toStdString()));
  EXPECT_EQ(QImage(file).size(), picture->size());
  const auto refused =
      PeriodPicture::save(*picture, folder_.filePath(QStringLiteral("none/week.png")).toStdString());
  EXPECT_FALSE(refused);
  EXPECT_TRUE(QFile::exists(file));
}

}  // namespace
}  // namespace nazori::ui
