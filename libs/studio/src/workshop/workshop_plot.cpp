// SPDX-License-Identifier: Apache-2.0
// A function plot as the relief of a new character.
#include <QSettings>

#include "nazori/studio/workshop/plot_dialog.h"
#include "nazori/studio/workshop/workshop_page.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"

namespace nazori::ui {
namespace {

/// A text cut so that it can be the name of a character.
std::string as_name(const QString& text) {
  QString name = text.simplified();
  while (name.toUtf8().size() > static_cast<qsizetype>(author::kLongestName)) {
    // Both halves of a surrogate pair go together.
    const bool is_pair = name.size() > 1 && name.back().isLowSurrogate();
    name.chop(is_pair ? 2 : 1);
  }
  return name.toStdString();
}

}  // namespace

void WorkshopPage::ask_plot() {
  // What the page for functions shows is proposed, with its range.
  QSettings stored(parts().settings_file(), QSettings::IniFormat);
  stored.beginGroup(QStringLiteral("functions"));
  functions::PlotModel model;
  model.load(read_settings(stored));
  const QString expression =
      stored.value(QStringLiteral("expression"), QStringLiteral("y = sin x")).toString();
  PlotDialog dialog(parts().inbox(), std::move(model), expression, author::kMapSize, &parts().window());
  if (dialog.exec() == QDialog::Accepted && may_replace()) {
    author::OwnCharacter character = author::from_height_map(*dialog.relief());
    character.facts.name = as_name(dialog.expression());
    begin(std::move(character), tr("The relief is the plot of %1.").arg(dialog.expression().simplified()));
  }
  parts().focus_tablet();
}

}  // namespace nazori::ui
