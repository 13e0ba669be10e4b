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

  draw_to_find = make("draw_to_find", tr("&Draw to find"), tr("Find a character by drawing it"),
                      {QStringLiteral("Ctrl+D")}, true);

  watch = make("watch", tr("&Watch"), tr("A brush writes the character stroke by stroke"),
               {QStringLiteral("F5")}, true);
  trace = make("trace", tr("&Trace"), tr("Trace the grooves, with lines and numbers"), {QStringLiteral("F6")},
               true);
  guided = make("guided", tr("&Guided"),
                tr("Only the groove, or only where strokes start; strokes hold the stylus"),
                {QStringLiteral("F7")}, true);
  memory = make("memory", tr("&Memory"), tr("Write on a blank tablet, and be judged"), {QStringLiteral("F8")},
                true);

  play = make("play", tr("&Play"), tr("Play or pause"), {QStringLiteral("Space")}, true);
  step_back =
      make("step_back", tr("Stroke &back"), tr("Back to the start of the stroke"), {QStringLiteral("Left")});
  step_on = make("step_on", tr("Stroke &on"), tr("On to the end of the stroke"), {QStringLiteral("Right")});
  slower = make("slower", tr("&Slower"), tr("Slower"), {QStringLiteral("[")});
  faster = make("faster", tr("&Faster"), tr("Faster"), {QStringLiteral("]")});
  loop = make("loop", tr("&Loop"), tr("Begin again at the end"), {QStringLiteral("L")}, true);

  by_groove = make("by_groove", tr("Only the g&roove"), tr("The groove leads, without lines"),
                   {QStringLiteral("Ctrl+Alt+G")}, true);
  by_starts = make("by_starts", tr("Only the &starts"), tr("Numbers say where strokes start"),
                   {QStringLiteral("Ctrl+Alt+P")}, true);
  lead_hand = make("lead_hand", tr("&Lead the hand"),
                   tr("A device with force takes the hand along; else strokes hold it"),
                   {QStringLiteral("Ctrl+Alt+D")}, true);

  undo_stroke = make("undo_stroke", tr("&Undo the stroke"), tr("Take back the last stroke"),
                     {QStringLiteral("Ctrl+Z"), QStringLiteral("Backspace")});
  done = make("done", tr("&Done"), tr("Judge what is written"),
              {QStringLiteral("Return"), QStringLiteral("Enter")});
  hint =
      make("hint", tr("&Hint"), tr("Show the next stroke; asked again, all of them"), {QStringLiteral("H")});
  give_up = make("give_up", tr("Gi&ve up"), tr("Show the character"), {QStringLiteral("G")});
  judge_each = make("judge_each", tr("&Judge each stroke"),
                    tr("Judge every stroke as it ends, or all at the end"), {QStringLiteral("J")}, true);
  groove_hidden = make("groove_hidden", tr("Tablet: &blank"), tr("No groove is shown"),
                       {QStringLiteral("Ctrl+Alt+H")}, true);
  groove_shown = make("groove_shown", tr("Tablet: groo&ve"), tr("The groove is shown"),
                      {QStringLiteral("Ctrl+Alt+S")}, true);
  groove_appears = make("groove_appears", tr("Tablet: groove &after each stroke"),
                        tr("The groove of each stroke appears when it is written right"),
                        {QStringLiteral("Ctrl+Alt+A")}, true);
  more_lenient = make("more_lenient", tr("&More leniently"), tr("Judge a little more leniently"),
                      {QStringLiteral("Ctrl+[")});
  more_strict = make("more_strict", tr("More str&ictly"), tr("Judge a little more strictly"),
                     {QStringLiteral("Ctrl+]")});
  lenient = make("lenient", tr("L&enient"), tr("Judge leniently"), {QStringLiteral("Ctrl+Alt+L")}, true);
  normal = make("normal", tr("N&ormal"), tr("Judge as a teacher does"), {QStringLiteral("Ctrl+Alt+N")}, true);
  strict = make("strict", tr("St&rict"), tr("Judge strictly"), {QStringLiteral("Ctrl+Alt+T")}, true);
  compare_over = make("compare_over", tr("Model o&ver the writing"), tr("Lay the model over what is written"),
                      {QStringLiteral("O")}, true);
  compare_beside =
      make("compare_beside", tr("Writing beside the &model"),
           tr("Show writing and model side by side, and replay both"), {QStringLiteral("B")}, true);

  make_exclusive({watch, trace, guided, memory});
  make_exclusive({by_groove, by_starts});
  make_exclusive({groove_hidden, groove_shown, groove_appears});
  make_exclusive({lenient, normal, strict});

  draw(previous_stroke, Icon::previous);
  draw(next_stroke, Icon::next);
  draw(strokes, Icon::strokes);
  draw(numbers, Icon::numbers);
  draw(arrows, Icon::arrows);
  draw(snap, Icon::snap);
  draw(clear_ink, Icon::erase);
  draw(watch, Icon::watch);
  draw(trace, Icon::trace);
  draw(guided, Icon::guided);
  draw(memory, Icon::memory);
  draw(play, Icon::play);
  draw(step_back, Icon::previous);
  draw(step_on, Icon::next);
  draw(slower, Icon::slower);
  draw(faster, Icon::faster);
  draw(loop, Icon::loop);
  draw(undo_stroke, Icon::undo);
  draw(done, Icon::tick);
  draw(hint, Icon::hint_lamp);
  draw(give_up, Icon::eye);
  draw(compare_over, Icon::overlaid);
  draw(compare_beside, Icon::beside);
  draw(draw_to_find, Icon::pen);
  draw(by_groove, Icon::strokes);
  draw(by_starts, Icon::numbers);
  draw(lead_hand, Icon::device);

  add_group(tr("&Character"),
            {find, draw_to_find, nullptr, next_character, previous_character, nullptr, back, forward});
  add_group(tr("&Strokes"), {next_stroke, previous_stroke, all_strokes, nullptr, strokes, numbers, arrows,
                             snap, nullptr, clear_ink});
  add_group(tr("&Practice"), {watch, trace, guided, memory, nullptr, play, step_back, step_on, slower, faster,
                              loop, nullptr, by_groove, by_starts, lead_hand});
  add_group(tr("&Writing"), {undo_stroke, done, hint, give_up, nullptr, compare_over, compare_beside, nullptr,
                             judge_each, groove_hidden, groove_shown, groove_appears, nullptr, more_lenient,
                             more_strict, lenient, normal, strict});
}

}  // namespace nazori::ui
