// SPDX-License-Identifier: Apache-2.0
// The panel beside the tablet during a session, without a window around it.
#include "study/session_panel.h"

#include <QLabel>
#include <QWidget>

#include "chosen_session_under_test.h"
#include "study/ink_gallery.h"

namespace nazori::ui {
namespace {

using study::Rating;
using study::Stage;

class SessionPanelTest : public ChosenSessionTest {
 protected:
  QString shown(const char* name) {
    const auto* label = window_.findChild<QLabel*>(QString::fromLatin1(name));
    return label->isHidden() ? QStringLiteral("(hidden)") : label->text();
  }
  QWidget window_;
};

TEST_F(SessionPanelTest, SaysWhyACharacterComes) {
  know(U'八');
  learn_from({U'一'});
  ASSERT_TRUE(session_->start());
  SessionPanel panel(*session_, *learner_, &window_);
  panel.show_state(nullptr);
  EXPECT_EQ(shown("session_kind"), QStringLiteral("Review"));
  EXPECT_EQ(shown("session_history"), QStringLiteral("Written from memory: once"));
  bring(U'八');
  write(true);
  session_->rate(Rating::good);
  panel.show_state(nullptr);
  EXPECT_EQ(shown("session_kind"), QStringLiteral("New"));
  EXPECT_EQ(shown("session_history"), QStringLiteral("Not yet written from memory."));
  bring(session_->character());
  learn();
  session_->rate(Rating::again);
  while (session_->state() != practice::StudySession::State::doing || session_->stage() != Stage::memory) {
    if (session_->state() == practice::StudySession::State::doing)
      session_->finish_stage(session_->stage(), {});
    session_->go_on();
    ASSERT_TRUE(session_->is_running());
  }
  panel.show_state(nullptr);
  EXPECT_EQ(shown("session_kind"), QStringLiteral("Again today"));
}

TEST_F(SessionPanelTest, TellsWhatWasForgottenAndWhichThreeStrokesWentWrongMost) {
  study::WritingResult result;
  using kanji::MistakeKind;
  result.mistakes = {{MistakeKind::wrong, 0},
                     {MistakeKind::order, 1},
                     {MistakeKind::wrong, 3},
                     {MistakeKind::wrong, 2},
                     {MistakeKind::ending, 4}};
  know(U'八', Rating::easy, result);
  result.mistakes = {{MistakeKind::wrong, 0}, {MistakeKind::wrong, 1},  {MistakeKind::wrong, 2},
                     {MistakeKind::wrong, 2}, {MistakeKind::ending, 4}, {MistakeKind::wrong, 5},
                     {MistakeKind::wrong, 5}};
  know(U'八', Rating::again, result);
  learn_from({});
  ASSERT_TRUE(session_->start());
  SessionPanel panel(*session_, *learner_, &window_);
  panel.show_state(sheet());
  if (session_->stage() == Stage::memory) {
    EXPECT_EQ(shown("session_faults"), QStringLiteral("(hidden)")) << "it would help to remember";
    bring(U'八');
    write(true);
    panel.show_state(sheet());
  }
  EXPECT_EQ(shown("session_history"), QStringLiteral("Written from memory: 2 times\nForgotten: once"));
  EXPECT_EQ(shown("session_faults"),
            QStringLiteral(
                "Stroke 3 was wrong 3 times.\nStroke 6 was wrong 2 times.\nStroke 2 was wrong 2 times."));
}

TEST_F(SessionPanelTest, NamesThePartsOfACharacterThatIsRelearnedAndOfNoOther) {
  know(U'八');
  auto settings = learner_->store().settings();
  settings.leech_lapses = 2;
  settings.new_per_day = 0;
  ASSERT_TRUE(learner_->store().change_settings(settings));
  const auto with_parts = [this] {
    auto made = sheet();
    made->parts = {{"丿", 0, "", "a slash"}, {"㇏", 0, "", ""}};
    return made;
  };
  SessionPanel panel(*session_, *learner_, &window_);
  ASSERT_TRUE(session_->start());
  panel.show_state(with_parts());
  EXPECT_EQ(shown("session_parts"), QStringLiteral("(hidden)")) << "a review";
  session_->end();
  study::Writing writing;
  while (!learner_->store().card(U'八').leech) {
    now_ += std::chrono::days(40);
    writing.rating = Rating::again;
    ASSERT_TRUE(learner_->store().add_writing(U'八', 2, writing));
    now_ += std::chrono::minutes(15);
    writing.rating = Rating::good;
    ASSERT_TRUE(learner_->store().add_writing(U'八', 2, writing));
  }
  ASSERT_TRUE(session_->start(true));
  bring(U'八');
  panel.show_state(with_parts());
  EXPECT_EQ(shown("session_kind"), QStringLiteral("Relearning: forgotten too often"));
  EXPECT_EQ(shown("session_parts"), QStringLiteral("Parts: 丿 a slash + ㇏."));
  panel.show_state(sheet());
  EXPECT_EQ(shown("session_parts"), QStringLiteral("(hidden)")) << "it has none";
}

TEST_F(SessionPanelTest, ShowsTheLastThreeWritingsFromMemoryBesideTodays) {
  const auto ink_of = [](int length) {
    study::HandwritingStroke stroke;
    for (int i = 0; i < length; ++i) stroke.push_back({{10.0 + i, 50}, i * 0.01, 0.5});
    return study::Handwriting{stroke};
  };
  study::Writing writing;
  writing.rating = Rating::easy;
  for (int i = 1; i <= 4; ++i) {
    ASSERT_TRUE(learner_->store().add_writing(U'八', 2, writing, ink_of(10 * i)));
    pass_until_due(U'八');
  }
  ASSERT_TRUE(learner_->store().add_writing(U'八', 2, writing)) << "without ink";
  writing.stage = Stage::trace;
  ASSERT_TRUE(learner_->store().add_writing(U'八', 2, writing, ink_of(60)));
  pass_until_due(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  bring(U'八');
  SessionPanel panel(*session_, *learner_, &window_);
  auto* gallery = window_.findChild<InkGallery*>(QStringLiteral("ink_gallery"));
  panel.show_state(sheet());
  EXPECT_TRUE(gallery->isHidden());
  EXPECT_EQ(shown("session_ink_heading"), QStringLiteral("(hidden)"));
  write(true);
  panel.show_state(sheet());
  ASSERT_EQ(gallery->pieces().size(), 4U);
  EXPECT_EQ(gallery->pieces()[0].words, QStringLiteral("now"));
  EXPECT_EQ(gallery->pieces()[0].ink, session_->ink());
  for (std::size_t i = 1; i < 4; ++i) {
    // As it is saved: pressures have 8 bits.
    const auto saved = study::pack(ink_of(10 * (5 - static_cast<int>(i))));
    ASSERT_TRUE(saved);
    EXPECT_TRUE(gallery->pieces()[i].ink == *study::unpack_handwriting(*saved));
    EXPECT_TRUE(gallery->pieces()[i].words.endsWith(QStringLiteral("\nEasy")));
  }
  EXPECT_EQ(shown("session_ink_heading"), QStringLiteral("Earlier writing"));
}

TEST_F(SessionPanelTest, WithNothingWrittenEarlierTodaysWritingStandsNotAlone) {
  know(U'八');
  learn_from({});
  ASSERT_TRUE(session_->start());
  bring(U'八');
  write(true);
  SessionPanel panel(*session_, *learner_, &window_);
  panel.show_state(sheet());
  EXPECT_TRUE(window_.findChild<InkGallery*>(QStringLiteral("ink_gallery"))->pieces().empty());
}

}  // namespace
}  // namespace nazori::ui
