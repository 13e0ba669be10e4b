// SPDX-License-Identifier: Apache-2.0
// Characters that people made: studied, judged, searched and carved like any other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "nazori/author/collection.h"
#include "nazori/base/file.h"
#include "nazori/practice/character_library.h"
#include "nazori/practice/tablet_workshop.h"
#include "nazori/practice/worksheet_maker.h"
#include "nazori/practice/writing_judge.h"
#include "session_under_test.h"

namespace nazori::practice {
namespace {

using std::chrono::days;
using study::Stage;
using testing::Contains;
using testing::ElementsAre;
using testing::Not;
using State = StudySession::State;

/// An arch over a slanting bar that gets deeper: nothing in the database looks like it.
author::OwnCharacter arch() {
  author::OwnCharacter sign;
  sign.facts.name = "our arch";
  sign.facts.readings = {"あーち"};
  sign.facts.meanings = {"club house"};
  author::OwnStroke bow;
  for (int i = 0; i <= 12; ++i) {
    const double t = M_PI * i / 12;
    bow.points.push_back({{54.5 - 40 * std::cos(t), 70 - 50 * std::sin(t)}, 3, 1});
  }
  sign.strokes = {bow, {{{{30, 95}, 2, 0.4}, {{80, 80}, 4, 1}}, kanji::StrokeEnding::stop, {}}};
  return sign;
}

writing::WrittenCharacter written(const author::OwnCharacter& sign, std::vector<std::size_t> strokes) {
  writing::WrittenCharacter ink;
  const kanji::Character character = author::kanji_character(sign, kanji::kFirstOwn);
  for (const std::size_t stroke : strokes) {
    ink.strokes.emplace_back();
    for (const auto& p : character.strokes[stroke].line.points)
      ink.strokes.back().push_back({{p.x / 109 * 0.8 + 0.1, p.y / 109 * 0.8 + 0.1}});
  }
  return ink;
}

class OwnCharactersStudied : public SessionTest {
 protected:
  [[nodiscard]] author::Collection collection() const { return author::Collection(own_characters()); }
  [[nodiscard]] CharacterSource source() const { return {kanji_db(), own_characters()}; }
  char32_t keep(const author::OwnCharacter& sign, std::optional<char32_t> as = {}) {
    const auto kept = collection().keep(sign, as);
    EXPECT_TRUE(kept);
    learner_->renew_characters();
    return kept.value_or(0);
  }
  /// All that is due on a day, and right. @param asked  gets the day for each character asked from memory.
  void study(int day, std::map<char32_t, std::vector<int>>& asked) {
    if (!session_->start()) return;
    int steps = 0;
    while (session_->is_running() && ++steps < 60) {
      clock_.advance(std::chrono::seconds(20));
      if (session_->stage() == Stage::memory) {
        asked[session_->character()].push_back(day);
        write(true);
      } else {
        session_->finish_stage(session_->stage(), {});
      }
      session_->go_on();
    }
  }
};

TEST_F(OwnCharactersStudied, MakeAListThatCanBeLearned) {
  EXPECT_THAT(*learner_->lists()->members("own", learner_->store()), testing::IsEmpty());
  int changes = 0;
  learner_->changed.connect([&changes] { ++changes; });
  const char32_t sign = keep(arch());
  EXPECT_EQ(changes, 1);
  EXPECT_THAT(*learner_->lists()->members("own", learner_->store()), ElementsAre(sign));
  const auto* facts = learner_->lists()->facts(sign);
  ASSERT_NE(facts, nullptr);
  EXPECT_EQ(facts->strokes, 2);
  learner_->renew_characters();
  EXPECT_EQ(changes, 1) << "nothing has changed";
  ASSERT_TRUE(collection().remove(sign));
  learner_->renew_characters();
  EXPECT_THAT(*learner_->lists()->members("own", learner_->store()), testing::IsEmpty());
}

TEST_F(OwnCharactersStudied, ComeBackWithinAWeekLikeAnyOther) {
  const char32_t sign = keep(arch());
  ASSERT_TRUE(learner_->store().save_list({"few", {U'一', U'二'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"own", "list:few"};
  settings.new_order = study::NewOrder::own;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  learner_->renew_order();
  const study::Time first = clock_.calendar();
  std::map<char32_t, std::vector<int>> asked;
  for (int day = 0; day < 7; ++day) {
    clock_.set_calendar(first + days(day));
    open();
    ASSERT_TRUE(learner_->database()->find(sign)) << "after the program was started again";
    study(day, asked);
  }
  ASSERT_GE(asked[sign].size(), 3U);
  EXPECT_EQ(asked[sign], asked[U'一']) << "FSRS knows no difference";
}

TEST_F(OwnCharactersStudied, AreJudgedByTheirOwnStrokes) {
  const char32_t sign = keep(arch());
  WritingJudge judge(inbox_, source());
  std::optional<writing::Grade> grade;
  judge.judged.connect([&grade](std::uint64_t, const writing::Grade& one) { grade = one; });
  const auto judged = [&](std::vector<std::size_t> strokes) {
    grade.reset();
    JudgeRequest request;
    request.character = sign;
    request.ink = written(arch(), std::move(strokes));
    request.finished = true;
    judge.judge(request);
    inbox_.run_until([&grade] { return grade.has_value(); });
    return grade->accepted;
  };
  EXPECT_TRUE(judged({0, 1}));
  EXPECT_FALSE(judged({1, 0}));
  EXPECT_FALSE(judged({0}));
  // What is changed is judged as it is now.
  author::OwnCharacter turned = arch();
  std::swap(turned.strokes[0], turned.strokes[1]);
  EXPECT_EQ(keep(turned, sign), sign);
  EXPECT_TRUE(judged({1, 0}));
  EXPECT_FALSE(judged({0, 1}));
}

TEST_F(OwnCharactersStudied, AreFoundByDrawing) {
  WritingJudge judge(inbox_, source());
  std::vector<char32_t> found;
  bool answered = false;
  judge.recognised.connect([&](std::uint64_t, const std::vector<FoundCharacter>& candidates) {
    found.clear();
    for (const auto& one : candidates) found.push_back(one.character);
    answered = true;
  });
  const auto draw = [&] {
    answered = false;
    judge.recognise(written(arch(), {0, 1}), 10);
    inbox_.run_until([&answered] { return answered; });
    return found;
  };
  EXPECT_THAT(draw(), Not(Contains(testing::Truly(kanji::is_own))));
  const char32_t sign = keep(arch());
  ASSERT_FALSE(draw().empty());
  EXPECT_EQ(found.front(), sign);
}

TEST_F(OwnCharactersStudied, AreFoundAndShownByTheLibrary) {
  CharacterLibrary library(inbox_, source());
  std::vector<char32_t> found;
  bool answered = false;
  library.found.connect([&](const std::string&, const std::shared_ptr<const SearchAnswer>& answer) {
    found.clear();
    for (const auto& row : answer->rows) found.push_back(row.character.code_point);
    answered = true;
  });
  const auto search = [&](const std::string& text) {
    answered = false;
    library.request_search(text);
    inbox_.run_until([&answered] { return answered; });
    return found;
  };
  EXPECT_THAT(search("club house"), Not(Contains(testing::Truly(kanji::is_own))));
  const char32_t sign = keep(arch());
  EXPECT_THAT(search("club house"), Contains(sign));
  EXPECT_THAT(search("あーち"), Contains(sign));
  EXPECT_THAT(search("our arch"), Contains(sign));
  std::shared_ptr<const CharacterSheet> sheet;
  library.sheet_ready.connect([&sheet](const std::shared_ptr<const CharacterSheet>& one) { sheet = one; });
  library.request_sheet(sign);
  inbox_.run_until([&sheet] { return sheet != nullptr; });
  EXPECT_EQ(sheet->character.strokes.size(), 2U);
  EXPECT_EQ(sheet->character.entry.meanings.front().text, "club house");
}

// The width, the depth and the layer of the hand are not those of a brush.
TEST_F(OwnCharactersStudied, AreCarvedAsTheyWereMade) {
  author::OwnCharacter sign = arch();
  sign.hand.size = 64;
  sign.hand.heights.assign(64 * 64, 0.0F);
  sign.hand.heights[0] = -0.5F;
  const char32_t code_point = keep(sign);
  TabletWorkshop workshop(inbox_, own_characters());
  Tablet carved;
  workshop.carved.connect([&carved](char32_t, const Tablet& one) { carved = one; });
  const auto carve = [&] {
    carved.reset();
    workshop.carve(*learner_->database()->find(code_point));
    inbox_.run_until([&carved] { return carved != nullptr; });
    return carved->height_map();
  };
  const auto samples = [](const surface::HeightMap& map) {
    return std::vector<float>(map.samples().begin(), map.samples().end());
  };
  EXPECT_EQ(samples(carve()), samples(*author::carve(sign, TabletWorkshop::kSize)));
  sign.strokes.pop_back();
  EXPECT_EQ(keep(sign, code_point), code_point);
  EXPECT_EQ(samples(carve()), samples(*author::carve(sign, TabletWorkshop::kSize)));
}

// 一 as somebody teaches it: an arch over a bar.
author::OwnCharacter form_of_one() {
  author::OwnCharacter form = arch();
  form.facts.name = "一";
  form.facts.instead_of = U'一';
  return form;
}

TEST_F(OwnCharactersStudied, InThePlaceOfAPublishedOneAreJudgedAndCarvedUnderItsCodePoint) {
  WritingJudge judge(inbox_, source());
  std::optional<writing::Grade> grade;
  judge.judged.connect([&grade](std::uint64_t, const writing::Grade& one) { grade = one; });
  const auto judged = [&](std::vector<std::size_t> strokes) {
    grade.reset();
    JudgeRequest request;
    request.character = U'一';
    request.ink = written(arch(), std::move(strokes));
    request.finished = true;
    judge.judge(request);
    inbox_.run_until([&grade] { return grade.has_value(); });
    return grade->accepted;
  };
  TabletWorkshop workshop(inbox_, own_characters());
  Tablet carved;
  char32_t carved_as = 0;
  workshop.carved.connect([&](char32_t one, const Tablet& tablet) {
    carved_as = one;
    carved = tablet;
  });
  const auto carve = [&] {
    carved.reset();
    workshop.carve(*learner_->database()->find(U'一'));
    inbox_.run_until([&carved] { return carved != nullptr; });
    return carved->height_map();
  };
  const auto published = carve();
  EXPECT_FALSE(judged({0, 1}));
  const char32_t form = keep(form_of_one());
  EXPECT_TRUE(judged({0, 1}));
  EXPECT_FALSE(judged({1, 0}));
  EXPECT_EQ(carve(), *author::carve(form_of_one(), TabletWorkshop::kSize));
  EXPECT_EQ(carved_as, U'一');
  EXPECT_EQ(carved->lines().size(), 2U);
  ASSERT_TRUE(collection().remove(form));
  learner_->renew_characters();
  EXPECT_FALSE(judged({0, 1}));
  EXPECT_EQ(carve(), published);
}

TEST_F(OwnCharactersStudied, InThePlaceOfAPublishedOneGoOnWithItsHistory) {
  ASSERT_TRUE(learner_->store().save_list({"few", {U'一', U'二'}}));
  auto settings = learner_->store().settings();
  settings.new_lists = {"list:few"};
  settings.new_order = study::NewOrder::own;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  learner_->renew_order();
  const study::Time first = clock_.calendar();
  std::map<char32_t, std::vector<int>> asked;
  for (int day = 0; day < 6; ++day) {
    clock_.set_calendar(first + days(day));
    open();
    if (day == 2) (void)keep(form_of_one());
    EXPECT_EQ(learner_->lists()->facts(U'一')->strokes, day < 2 ? 1 : 2);
    study(day, asked);
  }
  EXPECT_GE(asked[U'一'].size(), 3U);
  EXPECT_EQ(asked[U'一'], asked[U'二']) << "as if nothing had happened";
  EXPECT_EQ(asked.size(), 2U) << "it is one character, not two";
  EXPECT_THAT(*learner_->lists()->members("own", learner_->store()), ElementsAre(U'一'));
}

TEST_F(OwnCharactersStudied, InThePlaceOfAPublishedOneAreFoundByDrawing) {
  WritingJudge judge(inbox_, source());
  std::vector<char32_t> found;
  bool answered = false;
  judge.recognised.connect([&](std::uint64_t, const std::vector<FoundCharacter>& candidates) {
    found.clear();
    for (const auto& one : candidates) found.push_back(one.character);
    answered = true;
  });
  (void)keep(form_of_one());
  judge.recognise(written(arch(), {0, 1}), 10);
  inbox_.run_until([&answered] { return answered; });
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), U'一');
}

TEST_F(OwnCharactersStudied, ArePrintedOnWorksheets) {
  const char32_t sign = keep(arch());
  WorksheetMaker maker(inbox_, source());
  std::optional<WorksheetView> shown;
  maker.shown.connect([&shown](const WorksheetView& view) { shown = view; });
  std::string refused;
  maker.refused.connect(
      [&refused](const base::Error& error, std::size_t) { refused = base::to_line(error); });
  WorksheetRequest request;
  request.characters = {sign};
  request.choice.source = WorksheetSource::list;
  maker.show(request, 0);
  inbox_.run_until([&] { return shown.has_value() || !refused.empty(); });
  ASSERT_EQ(refused, "");
  EXPECT_EQ(shown->characters, 1U);
  EXPECT_THAT(shown->missing, testing::IsEmpty());
}

TEST_F(OwnCharactersStudied, DoNotKeepTheOthersFromBeingRead) {
  std::filesystem::create_directories(own_characters());
  (void)base::write_file(own_characters() / "U+F0001.nazori", "damaged");
  const char32_t sign = keep(arch());
  EXPECT_TRUE(learner_->database()->find(sign));
  EXPECT_TRUE(learner_->database()->find(U'休'));
}

}  // namespace
}  // namespace nazori::practice
