// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>

#include "nazori/practice/memory_stage.h"
#include "nazori/practice/stage_feedback.h"

namespace nazori::ui {

/// The sentences of the practice stages, in the language of the interface. They are short, kind and exact.
class StageWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::StageWords)
 public:
  /// The sentence for the feedback of a stage; empty if it needs none.
  /// @param memory  the stage whose grade is meant, for StageEvent::judged and mistakes; else nullptr.
  [[nodiscard]] static QString sentence(const practice::StageFeedback& feedback,
                                        const practice::MemoryStage* memory = nullptr);
  /// The same of what is written from memory stroke by stroke. @param grade  of it.
  [[nodiscard]] static QString of_strokes(const practice::StageFeedback& feedback,
                                          const writing::Grade& grade);

  /// What is said in a session when all strokes were shown. @param strokes  of the character.
  [[nodiscard]] static QString watched_in_session(int strokes);

  /// "That is 大; 日 was asked." @param asked  0: not to be named yet.
  [[nodiscard]] static QString other_character(char32_t written, char32_t asked);

 private:
  [[nodiscard]] static QString watching(const practice::StageFeedback& feedback);
  [[nodiscard]] static QString tracing(const practice::StageFeedback& feedback);
  [[nodiscard]] static QString switches(const practice::StageFeedback& feedback);
  [[nodiscard]] static QString guiding(const practice::StageFeedback& feedback);
  [[nodiscard]] static QString invitation(const practice::StageFeedback& feedback);
  [[nodiscard]] static QString writing(const practice::StageFeedback& feedback,
                                       const practice::MemoryStage& memory);
  [[nodiscard]] static QString invitation_to_write(int strokes, const practice::MemoryStage& memory);
  [[nodiscard]] static QString mistake(const practice::StageFeedback& feedback, const writing::Grade& grade);
  [[nodiscard]] static QString judgement(const practice::MemoryStage& memory);
};

}  // namespace nazori::ui
