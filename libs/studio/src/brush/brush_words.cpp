// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/brush_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::BrushWords)
};

using calligraphy::Edit;

int percent(double share) { return static_cast<int>(std::lround(share * 100)); }

QString strokes_words(int strokes) { return Words::tr("%n strokes", nullptr, strokes); }

}  // namespace

QString paper_name(std::string_view paper) {
  if (paper == "hanshi") return Words::tr("Hanshi (practice paper)");
  if (paper == "gasenshi") return Words::tr("Gasenshi (bleeds fast)");
  if (paper == "gasenshi-slow") return Words::tr("Gasenshi (bleeds slowly)");
  if (paper == "board") return Words::tr("Board (hardly bleeds)");
  if (paper == "water") return Words::tr("Water paper (fades as it dries)");
  return QString::fromUtf8(paper.data(), static_cast<qsizetype>(paper.size()));
}

QString ink_name(std::string_view ink) {
  if (ink == "sumi") return Words::tr("Sumi, black");
  if (ink == "sumi-blue") return Words::tr("Sumi, bluish");
  if (ink == "sumi-brown") return Words::tr("Sumi, brownish");
  if (ink == "vermilion") return Words::tr("Vermilion");
  if (ink == "water") return Words::tr("Water only");
  return QString::fromUtf8(ink.data(), static_cast<qsizetype>(ink.size()));
}

QString hair_name(brush::Hair hair) {
  switch (hair) {
    case brush::Hair::goat:
      return Words::tr("Goat (soft)");
    case brush::Hair::mixed:
      return Words::tr("Mixed");
    case brush::Hair::weasel:
      return Words::tr("Weasel (stiff)");
  }
  return {};
}

QString brush_size_name(calligraphy::BrushSize size) {
  switch (size) {
    case calligraphy::BrushSize::large:
      return Words::tr("Large");
    case calligraphy::BrushSize::medium:
      return Words::tr("Medium");
    case calligraphy::BrushSize::small:
      return Words::tr("Small");
    case calligraphy::BrushSize::fine:
      return Words::tr("Fine");
  }
  return {};
}

QString ruling_name(int characters) {
  return characters == 0 ? Words::tr("No ruling") : Words::tr("%n characters", nullptr, characters);
}

QString font_name(std::string_view family) {
  return family.empty() ? Words::tr("Printed lines")
                        : QString::fromUtf8(family.data(), static_cast<qsizetype>(family.size()));
}

QString font_packages_words(std::span<const author::BrushFont> installed) {
  QStringList packages;
  for (const author::BrushFont& font : author::brush_fonts()) {
    const auto is_it = [&font](const author::BrushFont& one) { return one.family == font.family; };
    if (std::any_of(installed.begin(), installed.end(), is_it)) continue;
    const QString name =
        QString::fromLatin1(font.package.data(), static_cast<qsizetype>(font.package.size()));
    if (!packages.contains(name)) packages.append(name);
  }
  if (packages.isEmpty()) return {};
  return Words::tr("For more fonts, install %1 and start Nazori again.")
      .arg(packages.join(QStringLiteral(", ")));
}

QString brush_words(const calligraphy::SheetState& state) {
  constexpr double kEmpty = 0.005;
  if (state.fullness < kEmpty) return Words::tr("The brush is empty.");
  if (state.strength < kEmpty) return Words::tr("Brush: %1% full, water only.").arg(percent(state.fullness));
  return Words::tr("Brush: %1% full, ink %2%.").arg(percent(state.fullness)).arg(percent(state.strength));
}

QString paper_words(const calligraphy::SheetState& state) {
  if (state.strokes == 0 && !state.is_wet) return Words::tr("Nothing is written yet.");
  const QString strokes = strokes_words(state.strokes);
  return state.is_wet ? Words::tr("%1, wet.").arg(strokes) : Words::tr("%1, dry.").arg(strokes);
}

practice::BrushModel brush_model_of(ModelPlace place) {
  switch (place) {
    case ModelPlace::none:
      return practice::BrushModel::none;
    case ModelPlace::beneath:
      return practice::BrushModel::beneath;
    case ModelPlace::beside:
      return practice::BrushModel::beside;
  }
  return practice::BrushModel::none;
}

QString undo_words(Edit edit, int strokes) {
  switch (edit) {
    case Edit::none:
      return Words::tr("There is nothing to undo.");
    case Edit::stroke:
      return Words::tr("Stroke %1 undone.").arg(strokes + 1);
    case Edit::drying:
      return Words::tr("Drying undone: the sheet is wet again.");
    case Edit::new_sheet:
      return Words::tr("The sheet before is back: %1.").arg(strokes_words(strokes));
  }
  return {};
}

QString redo_words(Edit edit, int strokes) {
  switch (edit) {
    case Edit::none:
      return Words::tr("There is nothing to redo.");
    case Edit::stroke:
      return Words::tr("Stroke %1 redone.").arg(strokes);
    case Edit::drying:
      return Words::tr("The sheet is dry again.");
    case Edit::new_sheet:
      return Words::tr("The next sheet is back: %1.").arg(strokes_words(strokes));
  }
  return {};
}

}  // namespace nazori::ui
