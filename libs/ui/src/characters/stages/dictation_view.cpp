// SPDX-License-Identifier: Apache-2.0
// The view of the stage "Dictation": the word above the tablet, its actions, and its sentences.
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "characters/stage_table.h"
#include "characters/stage_view.h"
#include "characters/strictness_slider.h"
#include "characters/word_boxes.h"
#include "characters/writing_panel.h"
#include "nazori/practice/dictation_stage.h"
#include "nazori/practice/model_fit.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/writing_language.h"
#include "nazori/writing/explanation.h"

namespace nazori::ui {

using practice::DictationStage;

namespace {

constexpr double kLargeReading = 1.25;  ///< of the size of other letters
constexpr int kMostMeanings = 3;

class DictationView final : public StageView {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::DictationView)
 public:
  DictationView(DictationStage& stage, const StageViewParts& parts);

  [[nodiscard]] QList<QAction*> own_actions() const override {
    return {next_word_,     actions().undo_stroke, actions().clear_ink,
            actions().done, actions().hint,        actions().give_up};
  }
  [[nodiscard]] QList<Tool> tools() const override {
    return {{actions().undo_stroke}, {actions().clear_ink},  {}, {actions().hint, true},
            {actions().give_up},     {actions().done, true}, {}, {next_word_, true}};
  }
  [[nodiscard]] QWidget* above_tablet() const override { return strip_; }
  [[nodiscard]] QString sentence(const practice::StageFeedback& feedback) const override;
  [[nodiscard]] QString why_unavailable() const override;

 protected:
  void refresh() override;

 private:
  void make_strip();
  void refresh_strip();
  [[nodiscard]] QString reading() const { return to_text(dictation_.word()->prompt()); }
  [[nodiscard]] QString meaning() const;
  /// What is to be written now.
  [[nodiscard]] QString task() const;
  /// What was found in a character, in a line: "休: ...".
  [[nodiscard]] QString found_in(const DictationStage::Box& box) const;
  [[nodiscard]] QString verdict() const;

  DictationStage& dictation_;
  QAction* next_word_;
  QWidget* strip_;
  WordBoxes* boxes_;
  QLabel* reading_;
  QLabel* meaning_;
  QLabel* verdict_;
};

DictationView::DictationView(DictationStage& stage, const StageViewParts& parts)
    : StageView(stage, parts.window_parts, parts.actions),
      dictation_(stage),
      next_word_(parts.actions.add_practice(
          "next_word", tr("Ne&xt word"), tr("Write another word that has the character"), "W", Icon::next)),
      strip_(new QWidget(&parts.window_parts.window())) {
  make_strip();
  on(next_word_, [this] { dictation_.next_word(); });
  on(actions().undo_stroke, [this] { dictation_.undo(); });
  on(actions().clear_ink, [this] { dictation_.start_over(); });
  on(actions().done, [this] { dictation_.finish_writing(); });
  on(actions().hint, [this] { dictation_.give_hint(); });
  on(actions().give_up, [this] { dictation_.show_answer(); });
  // The strictness of writing from memory holds here, too.
  const auto& slider = parts.writing_panel->strictness();
  dictation_.set_strictness(slider.strictness());
  connect(&slider, &StrictnessSlider::moved, this,
          [this, &slider] { dictation_.set_strictness(slider.strictness()); });
}

void DictationView::make_strip() {
  strip_->setObjectName(QStringLiteral("dictation_strip"));
  strip_->setAccessibleName(tr("The word to write"));
  boxes_ = new WordBoxes(strip_);
  reading_ = sentence_label("dictation_reading", strip_, "title");
  meaning_ = sentence_label("dictation_meaning", strip_);
  verdict_ = sentence_label("dictation_verdict", strip_);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  for (auto* label : {reading_, meaning_, verdict_}) words->addWidget(label);
  words->addStretch(1);
  auto* row = new QHBoxLayout(strip_);
  row->setContentsMargins(12, 8, 12, 8);
  row->setSpacing(12);
  row->addWidget(boxes_, 0, Qt::AlignTop);
  row->addLayout(words, 1);
  strip_->hide();
}

void DictationView::refresh() {
  using State = DictationStage::State;
  const auto state = dictation_.state();
  const bool writes = is_entered() && state == State::writing;
  const bool is_over = is_entered() && state == State::judged;
  if (is_entered()) {
    for (auto* action : {actions().hint, actions().give_up}) action->setEnabled(writes);
    for (auto* action : {actions().undo_stroke, actions().clear_ink, actions().done})
      action->setEnabled(writes || is_over);
  }
  next_word_->setEnabled(writes || is_over);
  refresh_strip();
}

void DictationView::refresh_strip() {
  strip_->setVisible(is_entered() && dictation_.word() != nullptr);
  if (!is_entered() || dictation_.word() == nullptr) return;
  const bool is_over = dictation_.state() == DictationStage::State::judged;
  QFont large = textbook_font(strip_->font().pointSizeF() * kLargeReading, QFont::DemiBold);
  reading_->setFont(large);
  reading_->setText(is_over ? tr("%1 (%2)").arg(to_text(dictation_.word()->word.text), reading())
                            : reading());
  meaning_->setText(meaning());
  verdict_->setText(is_over ? verdict() : QString());
  verdict_->setVisible(is_over);
  std::vector<WordBoxes::Box> boxes;
  for (std::size_t i = 0; i < dictation_.boxes().size(); ++i) {
    const auto& from = dictation_.boxes()[i];
    auto& box = boxes.emplace_back();
    box.is_current = !is_over && i == dictation_.position();
    box.is_finished = from.is_finished;
    box.is_right = from.is_accepted();
    if (!from.is_finished) continue;
    box.strokes = from.writing.strokes;
    box.verdicts = practice::verdicts(from.writing.grade, box.strokes.size());
  }
  boxes_->show_boxes(std::move(boxes));
}

QString DictationView::meaning() const {
  if (dictation_.word()->is_syllable) return tr("one syllable of two kana");
  return joined(dictation_.word()->word.glosses, QStringLiteral(", "), kMostMeanings);
}

QString DictationView::task() const {
  return tr("Character %1 of %2. H: hint. Enter: finish.")
      .arg(dictation_.position() + 1)
      .arg(dictation_.boxes().size());
}

QString DictationView::found_in(const DictationStage::Box& box) const {
  const QString character = to_text(box.character);
  if (box.was_shown) return tr("%1: shown, not written from memory.").arg(character);
  if (box.other != 0) return StageWords::other_character(box.other, box.character);
  const auto language = writing_language();
  return tr("%1: %2").arg(character,
                          joined(writing::explain(box.writing.grade, language), between_sentences()));
}

QString DictationView::verdict() const {
  QStringList lines;
  // A refused word shows what to mend, and no figure beside it.
  lines.append(dictation_.is_accepted() ? tr("Correct: %1/100").arg(dictation_.score()) : tr("Not quite"));
  for (const auto& box : dictation_.boxes()) lines.append(found_in(box));
  return lines.join(QLatin1Char('\n'));
}

QString DictationView::why_unavailable() const {
  return tr("No word of two or three characters can be asked for. Choose another character.");
}

QString DictationView::sentence(const practice::StageFeedback& feedback) const {
  if (feedback.event != practice::StageEvent::own)
    return StageWords::of_strokes(feedback, dictation_.attempt().grade());
  if (feedback.own == DictationStage::kNoWord) return why_unavailable();
  if (feedback.own == DictationStage::kWordOver)
    return tr("The word is finished. Enter: next word. Delete: write it again.");
  if (feedback.own == DictationStage::kWordAsked)
    return tr("Write the word %1 (%2). %3").arg(reading(), meaning(), task());
  if (feedback.own == DictationStage::kSpeechWanted) return tr("%1: %2").arg(reading(), meaning());
  if (feedback.own == DictationStage::kCharacterWritten)
    return tr("%1 %2").arg(found_in(dictation_.boxes()[static_cast<std::size_t>(feedback.stroke - 1)]),
                           task());
  if (feedback.own == DictationStage::kWordJudged) {
    const QString word = to_text(dictation_.word()->word.text);
    return dictation_.is_accepted()
               ? tr("%1 is right: %2 of 100 points. Enter: next word.").arg(word).arg(dictation_.score())
               : tr("%1 is not right yet. Delete: write it again. Enter: next word.").arg(word);
  }
  return {};
}

}  // namespace

StageView* make_dictation_view(practice::PracticeStage& stage, const StageViewParts& parts) {
  return new DictationView(static_cast<DictationStage&>(stage), parts);
}

}  // namespace nazori::ui
