// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

#include "nazori/practice/helpful_words.h"

namespace nazori::ui {

/// A word with its reading and meanings. Each kanji in it can be opened.
class WordLabel final : public QLabel {
  Q_OBJECT
 public:
  /// @param is_narrow  long words of a meaning may be broken.
  WordLabel(const practice::HelpfulWord& word, bool is_narrow, QWidget* parent);

 signals:
  void character_chosen(char32_t code_point);

 protected:
  bool focusNextPrevChild(bool next) override;
};

}  // namespace nazori::ui
