// SPDX-License-Identifier: Apache-2.0
#include "characters/character_actions.h"

namespace nazori::ui {

CharacterActions::CharacterActions(QWidget* window) : ActionSet(window) {
  find = make("find", tr("&Find a character"), tr("Go to the search box"), {QStringLiteral("Ctrl+F")});
  next_character = make("next_character", tr("&Next in the list"), tr("The next character of the list"),
                        {QStringLiteral("Ctrl+PgDown"), QStringLiteral("PgDown")});
  previous_character =
      make("previous_character", tr("&Previous in the list"), tr("The character before in the list"),
           {QStringLiteral("Ctrl+PgUp"), QStringLiteral("PgUp")});
  back = make("back", tr("&Back"), tr("Back to the character before"), {QStringLiteral("Alt+Left")});
  forward = make("forward", tr("For&ward"), tr("Forward again"), {QStringLiteral("Alt+Right")});

  next_stroke = make("next_stroke", tr("&Next stroke"), tr("Show the next stroke alone; after the last, all"),
                     {QStringLiteral(".")});
  previous_stroke = make("previous_stroke", tr("&Previous stroke"),
                         tr("Show the stroke before alone; before the first, all"), {QStringLiteral(",")});
  all_strokes =
      make("all_strokes", tr("&All strokes"), tr("Show all strokes at once"), {QStringLiteral("0")});
  strokes = make("strokes", tr("&Strokes"), tr("Show or hide the strokes"), {QStringLiteral("S")}, true);
  numbers = make("numbers", tr("N&umbers"), tr("Show or hide the number at each stroke's start"),
                 {QStringLiteral("N")}, true);
  arrows = make("arrows", tr("A&rrows"), tr("Show or hide the arrowheads"), {QStringLiteral("A")}, true);
  snap = make("snap", tr("S&nap"), tr("Strokes hold the stylus, while they are shown"), {QStringLiteral("F")},
              true);
  clear_ink = make("clear_ink", tr("&Clear the ink"), tr("Wipe the tablet clean to write again"),
                   {QStringLiteral("Del")});

  draw(previous_stroke, Icon::previous);
  draw(next_stroke, Icon::next);
  draw(strokes, Icon::strokes);
  draw(numbers, Icon::numbers);
  draw(arrows, Icon::arrows);
  draw(snap, Icon::snap);
  draw(clear_ink, Icon::erase);

  add_group(tr("&Character"), {find, nullptr, next_character, previous_character, nullptr, back, forward});
  add_group(tr("&Strokes"), {next_stroke, previous_stroke, all_strokes, nullptr, strokes, numbers, arrows,
                             snap, nullptr, clear_ink});
}

}  // namespace nazori::ui
