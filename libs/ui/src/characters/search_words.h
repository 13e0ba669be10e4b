// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>

#include "nazori/practice/search_answer.h"

namespace nazori::ui {

/// Words for the rows of the answer to a search.
class SearchWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::SearchWords)
 public:
  /// What the row shows large: "休", "休日".
  [[nodiscard]] static QString head(const practice::SearchRow& row);
  /// Why it is found, in two parts: "やす・む · rest", "きゅうじつ · holiday; day off", "in names: のぶ ·
  /// rest".
  [[nodiscard]] static QString why(const practice::SearchRow& row);
};

}  // namespace nazori::ui
