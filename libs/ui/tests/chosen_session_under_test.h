// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "session_under_test.h"
#include "window/language.h"

namespace nazori::ui {

/// A session of characters that the test chooses.
class ChosenSessionTest : public SessionTest {
 protected:
  void SetUp() override { install_language(QStringLiteral("en")); }

  /// New characters are only these, in this order, two a day.
  void learn_from(std::vector<char32_t> characters) {
    ASSERT_TRUE(learner_->store().save_list({"few", std::move(characters)}));
    auto settings = learner_->store().settings();
    settings.new_lists = {"list:few"};
    settings.new_order = study::NewOrder::own;
    ASSERT_TRUE(learner_->store().change_settings(settings));
    learner_->renew_order();
  }
  /// Adds one writing from memory, and moves the clock to the day after the character is due again.
  void know(char32_t character, study::Rating rating = study::Rating::easy,
            const study::WritingResult& result = {}) {
    study::Writing writing;
    writing.rating = rating;
    writing.result = result;
    ASSERT_TRUE(learner_->store().add_writing(character, 1, writing));
    pass_until_due(character);
  }
  void pass_until_due(char32_t character) {
    const auto& store = learner_->store();
    now_ += store.card(character).due_day.value_or(store.today()) - store.today() + std::chrono::days(1);
  }
  [[nodiscard]] std::shared_ptr<practice::CharacterSheet> sheet() const {
    auto made = std::make_shared<practice::CharacterSheet>();
    made->character = *kanji::KanjiDatabase::open(kanji_db())->find(session_->character());
    return made;
  }
  /// The same without the entry of a dictionary.
  [[nodiscard]] std::shared_ptr<practice::CharacterSheet> bare_sheet() const {
    auto made = sheet();
    made->character.entry = {};
    return made;
  }
};

}  // namespace nazori::ui
