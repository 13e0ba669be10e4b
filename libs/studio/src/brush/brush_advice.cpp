// SPDX-License-Identifier: Apache-2.0
// Advice on what is written.
#include <QAction>

#include "nazori/studio/brush/advice_words.h"
#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/studio/brush/tools_panel.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

void BrushPage::request_advice() {
  if (awaits_models() && !choice_.font.empty()) {
    advises_later_ = true;
    return;
  }
  writing_->advise(sheet_models(), {.traced = choice_.place == ModelPlace::beneath});
  wake();
}

void BrushPage::show_advice(const std::vector<calligraphy::CharacterAdvice>& advice) {
  // Something may have taken the advice away while it was worked out.
  if (!actions_->advice->isChecked()) return;
  QStringList sentences = advice_words(advice);
  if (sentences.isEmpty()) {
    clear_advice();
    parts().respond(Feedback::hint, writing_->state().strokes == 0
                                        ? tr("Write a character first. Then J gives advice.")
                                        : tr("There are no strokes in the squares of the model."));
    return;
  }
  std::vector<calligraphy::CorrectionMark> marks;
  for (const auto& one : advice) marks.insert(marks.end(), one.marks.begin(), one.marks.end());
  paper_->show_marks(std::move(marks));
  panel_->show_advice(sentences);
  parts().respond(Feedback::advice, tr("Advice: %1").arg(sentences.join(QLatin1Char(' '))));
  judge(advice.front());
}

void BrushPage::clear_advice() {
  advises_later_ = false;
  parts().brush_session().reopen();
  if (!actions_->advice->isChecked()) return;
  actions_->advice->setChecked(false);
  paper_->show_marks({});
  panel_->show_advice({});
}

}  // namespace nazori::ui
