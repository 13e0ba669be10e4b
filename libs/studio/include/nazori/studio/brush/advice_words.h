// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>
#include <span>

#include "nazori/calligraphy/advice.h"

namespace nazori::ui {

/// What is said about one written character, a sentence each: mistakes, then advice by kind with the numbers
/// of the strokes, then what is very good. Empty where nothing is written in its square.
[[nodiscard]] QStringList advice_words(const calligraphy::CharacterAdvice& advice);
/// The same for a sheet. Where several characters are written, each begins with itself.
[[nodiscard]] QStringList advice_words(std::span<const calligraphy::CharacterAdvice> sheet);

}  // namespace nazori::ui
