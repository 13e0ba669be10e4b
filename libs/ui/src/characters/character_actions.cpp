// SPDX-License-Identifier: Apache-2.0
#include "characters/character_actions.h"

#include "characters/stage_table.h"

namespace nazori::ui {

CharacterActions::CharacterActions(QWidget* window) : ActionSet(window) {
  find = make("find", tr("&Find a character"), tr("Go to the search box"), {QStringLiteral("Ctrl+F")});
  next_character = make("next_character", tr("&Next in the list"), tr("Go to the next character in the list"),
                        {QStringLiteral("Ctrl+PgDown"), QStringLiteral("PgDown")});
  previous_character =
      make("previous_character", tr("&Previous in the list"), tr("Go to the previous character in the list"),
           {QStringLiteral("Ctrl+PgUp"), QStringLiteral("PgUp")});
  back = make("back", tr("&Back"), tr("Go back to the character you viewed before"),
              {QStringLiteral("Alt+Left")});
  forward = make("forward", tr("For&ward"), tr("Go forward again to the character you came back from"),
                 {QStringLiteral("Alt+Right")});

  next_stroke = make("next_stroke", tr("&Next stroke"),
                     tr("Show only the next stroke; after the last one, show all"), {QStringLiteral(".")});
  previous_stroke =
      make("previous_stroke", tr("&Previous stroke"),
           tr("Show only the previous stroke; before the first one, show all"), {QStringLiteral(",")});
  all_strokes =
      make("all_strokes", tr("&All strokes"), tr("Show all strokes at once"), {QStringLiteral("0")});
  strokes = make("strokes", tr("&Strokes"), tr("Show or hide the strokes"), {QStringLiteral("S")}, true);
  numbers = make("numbers", tr("N&umbers"), tr("Show or hide the number at each stroke's start"),
                 {QStringLiteral("N")}, true);
  arrows = make("arrows", tr("A&rrows"), tr("Show or hide the arrowheads"), {QStringLiteral("A")}, true);
  snap = make("snap", tr("S&nap"), tr("Strokes attract the stylus while they are visible"),
              {QStringLiteral("F")}, true);
  clear_ink = make("clear_ink", tr("&Clear ink"), tr("Clear the tablet so that you can write again"),
                   {QStringLiteral("Del")});

  draw_to_find = make("draw_to_find", tr("&Draw to find"), tr("Find a character by drawing it"),
                      {QStringLiteral("Ctrl+D")}, true);

  for (const auto& row : stage_rows()) {
    stages.append(make(row.id.data(), tr(row.name), tr(row.purpose), {QString::fromLatin1(row.key)}, true));
    draw(stages.back(), row.drawing);
  }

  play = make("play", tr("&Play"), tr("Play or pause"), {QStringLiteral("Space")}, true);
  step_back = make("step_back", tr("One stroke &back"), tr("Go back to the start of the stroke"),
                   {QStringLiteral("Left")});
  step_on = make("step_on", tr("One stroke f&orward"), tr("Go forward to the end of the stroke"),
                 {QStringLiteral("Right")});
  slower = make("slower", tr("&Slower"), tr("Play more slowly"), {QStringLiteral("[")});
  faster = make("faster", tr("&Faster"), tr("Play faster"), {QStringLiteral("]")});
  loop = make("loop", tr("&Loop"), tr("Start again after the last stroke"), {QStringLiteral("L")}, true);

  by_groove = make("by_groove", tr("G&roove only"), tr("Follow the groove without lines"),
                   {QStringLiteral("Ctrl+Alt+G")}, true);
  by_starts = make("by_starts", tr("&Starting points only"), tr("Numbers show where each stroke starts"),
                   {QStringLiteral("Ctrl+Alt+P")}, true);
  lead_hand = make("lead_hand", tr("&Lead the hand"),
                   tr("A force-feedback device leads your hand along the strokes; with other devices, "
                      "strokes attract the stylus"),
                   {QStringLiteral("Ctrl+Alt+D")}, true);

  undo_stroke = make("undo_stroke", tr("&Undo stroke"), tr("Undo the last stroke"),
                     {QStringLiteral("Ctrl+Z"), QStringLiteral("Backspace")});
  done = make("done", tr("&Finish"), tr("Check what you wrote"),
              {QStringLiteral("Return"), QStringLiteral("Enter")});
  hint = make("hint", tr("&Hint"), tr("Show the next stroke; press again to show all of them"),
              {QStringLiteral("H")});
  give_up =
      make("give_up", tr("Show a&nswer"), tr("Show how the character is written"), {QStringLiteral("G")});
  judge_each =
      make("judge_each", tr("Chec&k each stroke"),
           tr("Check each stroke as you finish it, or everything at the end"), {QStringLiteral("J")}, true);
  groove_hidden = make("groove_hidden", tr("Tablet: &blank"), tr("Hide the grooves"),
                       {QStringLiteral("Ctrl+Alt+H")}, true);
  groove_shown = make("groove_shown", tr("Tablet: with groo&ves"), tr("Show the grooves"),
                      {QStringLiteral("Ctrl+Alt+S")}, true);
  groove_appears = make("groove_appears", tr("Tablet: groove &after each correct stroke"),
                        tr("The groove of a stroke appears once you write it correctly"),
                        {QStringLiteral("Ctrl+Alt+A")}, true);
  more_lenient = make("more_lenient", tr("&More lenient"), tr("Check a little more leniently"),
                      {QStringLiteral("Ctrl+[")});
  more_strict =
      make("more_strict", tr("More str&ict"), tr("Check a little more strictly"), {QStringLiteral("Ctrl+]")});
  lenient = make("lenient", tr("L&enient"), tr("Check leniently"), {QStringLiteral("Ctrl+Alt+L")}, true);
  normal = make("normal", tr("N&ormal"), tr("Check about as strictly as a teacher would"),
                {QStringLiteral("Ctrl+Alt+N")}, true);
  strict = make("strict", tr("St&rict"), tr("Check strictly"), {QStringLiteral("Ctrl+Alt+T")}, true);
  compare_over = make("compare_over", tr("Model o&ver your writing"), tr("Lay the model over your writing"),
                      {QStringLiteral("O")}, true);
  compare_beside =
      make("compare_beside", tr("Your writing beside the &model"),
           tr("Show your writing and the model side by side and replay both"), {QStringLiteral("B")}, true);

  make_sound();

  make_exclusive(stages);
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
  add_group(tr("&Practice"), stages + QList<QAction*>{nullptr, play, step_back, step_on, slower, faster, loop,
                                                      nullptr, by_groove, by_starts, lead_hand});
  practice_ = groups().size() - 1;
  add_group(tr("&Writing"), {undo_stroke, done, hint, give_up, nullptr, compare_over, compare_beside, nullptr,
                             judge_each, groove_hidden, groove_shown, groove_appears, nullptr, more_lenient,
                             more_strict, lenient, normal, strict});
  add_group(tr("S&peech"), {speak, speaks_itself, nullptr, voice_automatic, voice_open_jtalk,
                            voice_dispatcher, voice_espeak, nullptr, voice_file});
}

void CharacterActions::make_sound() {
  speak = make("speak", tr("&Speak"), tr("Speak the reading or the word"), {QStringLiteral("V")});
  speaks_itself = make("speaks_itself", tr("Speak &readings"),
                       tr("Speak kana and words when they are asked for, and readings after the answer"),
                       {QStringLiteral("Shift+V")}, true);
  voice_automatic = make("voice_automatic", tr("&Best voice"), tr("Use the best voice that is installed"),
                         {QStringLiteral("Alt+Shift+B")}, true);
  voice_open_jtalk = make("voice_open_jtalk", tr("&Open JTalk"), tr("Speak with Open JTalk"),
                          {QStringLiteral("Alt+Shift+J")}, true);
  voice_dispatcher = make("voice_dispatcher", tr("Speech &Dispatcher"),
                          tr("Speak with the voice of the desktop, as a screen reader does"),
                          {QStringLiteral("Alt+Shift+D")}, true);
  voice_espeak = make("voice_espeak", tr("&eSpeak NG"), tr("Speak with eSpeak NG, plainly"),
                      {QStringLiteral("Alt+Shift+E")}, true);
  voice_file = make("voice_file", tr("&Voice file…"), tr("Choose a voice for Open JTalk (.htsvoice)"),
                    {QStringLiteral("Alt+Shift+V")});
  make_exclusive({voice_automatic, voice_open_jtalk, voice_dispatcher, voice_espeak});
  draw(speak, Icon::sound);
}

QAction* CharacterActions::add_practice(const char* name, const QString& text, const QString& tip,
                                        const QString& key, Icon drawing) {
  auto* action = make(name, text, tip, {key});
  draw(action, drawing);
  // Apart from those above.
  if (groups()[practice_].actions.back() == lead_hand) add_to_group(practice_, nullptr);
  add_to_group(practice_, action);
  return action;
}

}  // namespace nazori::ui
