// SPDX-License-Identifier: Apache-2.0
// The files of the page for characters: tablets and stroke orders, models to touch.
#include <QFileInfo>
#include <algorithm>

#include "characters/characters.h"
#include "nazori/author/collection.h"
#include "nazori/studio/print/solid_dialog.h"
#include "nazori/widgets/dialogs/file_exchange.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

bool Characters::opens(const QStringList& paths) const {
  return std::all_of(paths.begin(), paths.end(), [](const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix == QLatin1String("raw") || suffix == QLatin1String("png") || suffix == QLatin1String("str");
  });
}

void Characters::open_files(const QStringList& paths) {
  if (files_->open(paths, practice_.own())) practice_.expect_files();
}

void Characters::ask_and_open() {
  if (files_->ask_and_open(practice_.own())) practice_.expect_files();
}

void Characters::ask_and_save() {
  const auto& own = practice_.own();
  const QString file_name =
      own.tablet ? to_text(own.name).section(QLatin1Char('.'), 0, 0) : to_text(parts().preferences().kanji);
  files_->ask_and_save(practice_.tablet(), own, file_name);
}

void Characters::ask_model() {
  // What the learner is asked to write from memory must not be shown.
  if (practice_.current_stage().hides_character())
    return parts().announce(Feedback::advice, tr("Finish this character first: a model would show it."));
  const auto& own = practice_.own();
  if (own.tablet) {
    std::vector<kanji::StrokeLine> strokes = tablet::stroke_lines(own.tablet->lines());
    auto label = practice::touch_label(std::filesystem::path(own.name).stem().string(), strokes.size());
    return ask_solid(
        parts(),
        {to_text(own.name), {{{std::move(strokes), own.tablet->height_map()}, std::move(label)}}, {}});
  }
  const auto& sheet = practice_.sheet();
  if (!sheet || sheet->character.strokes.empty())
    return parts().announce(Feedback::advice, tr("There is no tablet to make a model of yet."));
  practice::SolidTablet tablet{sheet->character.lines(), {}};
  // What somebody made has a relief of its own.
  if (author::kept_form_of(sheet->character) && practice_.tablet())
    tablet.relief = practice_.tablet()->height_map();
  ask_solid(parts(), {to_text(sheet->character.code_point),
                      {{std::move(tablet), practice::touch_label(sheet->character)}},
                      {}});
}

}  // namespace nazori::ui
