// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/line_stretch.h"

#include <QFontInfo>
#include <QTextLayout>
#include <algorithm>

#include "nazori/widgets/words/error_text.h"

namespace nazori::ui {

double line_stretch(const QFont& font) {
  constexpr double kUsual_em = 1.2;
  // The letters may be those of another font, which only a laid out line knows.
  QTextLayout layout(is_english() ? QStringLiteral("Ag") : QStringLiteral("Ag漢あ"), font);
  layout.beginLayout();
  QTextLine line = layout.createLine();
  line.setNumColumns(static_cast<int>(layout.text().size()));
  layout.endLayout();
  const double height = line.height();
  return std::max(1.0, height / (kUsual_em * QFontInfo(font).pixelSize()));
}

}  // namespace nazori::ui
