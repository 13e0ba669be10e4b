// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QString>

#include "nazori/practice/hard_characters.h"

namespace nazori::ui {

/// Sentences about the hardest stroke of a character.
class TroubleWords {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::TroubleWords)
 public:
  /// "Stroke 3 of 語 is often left out."; without a stroke: "語 is often forgotten."
  [[nodiscard]] static QString often(const practice::HardCharacter& hard);
  /// "Stroke 3 was left out in 6 of 28 writings."
  [[nodiscard]] static QString counted(const practice::StrokeTrouble& trouble);
};

}  // namespace nazori::ui
