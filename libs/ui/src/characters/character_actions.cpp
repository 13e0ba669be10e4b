// SPDX-License-Identifier: Apache-2.0
#include "characters/character_actions.h"

#include "characters/stage_table.h"

namespace nazori::ui {

CharacterActions::CharacterActions(QWidget* window) : ActionSet(window) {
  find = make("find", tr("&Find a character"), tr("Go to the search box"), "Ctrl+F");
  next_character = make("next_character", tr("&Next in the list"), tr("Go to the next character in the list"),
                        "Ctrl+PgDown PgDown");
  previous_character = make("previous_character", tr("&Previous in the list"),
                            tr("Go to the previous character in the list"), "Ctrl+PgUp PgUp");
  back = make("back", tr("&Back"), tr("Go back to the character you viewed before"), "Alt+Left");
  forward = make("forward", tr("For&ward"), tr("Go forward again to the character you came back from"),
                 "Alt+Right");

  next_stroke = make("next_stroke", tr("&Next stroke"),
                     tr("Show only the next stroke; after the last one, show all"), ".", Icon::next);
  previous_stroke =
      make("previous_stroke", tr("&Previous stroke"),
           tr("Show only the previous stroke; before the first one, show all"), ",", Icon::previous);
  all_strokes = make("all_strokes", tr("&All strokes"), tr("Show all strokes at once"), "0");
  strokes = make("strokes", tr("&Strokes"), tr("Show or hide the strokes"), "S", true, Icon::strokes);
  numbers = make("numbers", tr("N&umbers"), tr("Show or hide the number at each stroke's start"), "N", true,
                 Icon::numbers);
  arrows = make("arrows", tr("A&rrows"), tr("Show or hide the arrowheads"), "A", true, Icon::arrows);
  snap = make("snap", tr("S&nap"), tr("Strokes attract the stylus while they are visible"), "F", true,
              Icon::snap);
  clear_ink = make("clear_ink", tr("&Clear ink"), tr("Clear the tablet so that you can write again"), "Del",
                   Icon::erase);

  draw_to_find = make("draw_to_find", tr("&Draw to find"), tr("Find a character by drawing it"), "Ctrl+D",
                      true, Icon::pen);

  find_by_parts = make("find_by_parts", tr("Find by p&arts"),
                       tr("Find a character by the parts it is made of"), "Ctrl+J", true);
  find_by_radical =
      make("find_by_radical", tr("Find by &radical"), tr("Find a character by its radical"), "Ctrl+K", true);
  tell_apart = make("tell_apart", tr("&Tell apart"),
                    tr("A short drill with the characters it is confused with"), "Ctrl+Shift+D");

  make_model = make("make_model", tr("&Make a model to touch…"),
                    tr("A solid with raised lines or grooves, for a 3D printer"), "Ctrl+Shift+F");

  for (const auto& row : stage_rows()) {
    stages.append(make(row.id.data(), tr(row.name), tr(row.purpose), row.key, true, row.drawing));
  }

  play = make("play", tr("&Play"), tr("Play or pause"), "Space", true, Icon::play);
  step_back = make("step_back", tr("One stroke &back"), tr("Go back to the start of the stroke"), "Left",
                   Icon::previous);
  step_on = make("step_on", tr("One stroke f&orward"), tr("Go forward to the end of the stroke"), "Right",
                 Icon::next);
  slower = make("slower", tr("&Slower"), tr("Play more slowly"), "[", Icon::slower);
  faster = make("faster", tr("&Faster"), tr("Play faster"), "]", Icon::faster);
  loop = make("loop", tr("&Loop"), tr("Start again after the last stroke"), "L", true, Icon::loop);

  by_groove = make("by_groove", tr("G&roove only"), tr("Follow the groove without lines"), "Ctrl+Alt+G", true,
                   Icon::strokes);
  by_starts = make("by_starts", tr("&Starting points only"), tr("Numbers show where each stroke starts"),
                   "Ctrl+Alt+P", true, Icon::numbers);
  lead_hand = make("lead_hand", tr("&Lead the hand"),
                   tr("A force-feedback device leads your hand along the strokes; with other devices, "
                      "strokes attract the stylus"),
                   "Ctrl+Alt+D", true, Icon::device);

  undo_stroke =
      make("undo_stroke", tr("&Undo stroke"), tr("Undo the last stroke"), "Ctrl+Z Backspace", Icon::undo);
  done = make("done", tr("&Finish"), tr("Check what you wrote"), "Return Enter", Icon::tick);
  hint = make("hint", tr("&Hint"), tr("Show the next stroke; press again to show all of them"), "H",
              Icon::hint_lamp);
  give_up = make("give_up", tr("Show a&nswer"), tr("Show how the character is written"), "G", Icon::eye);
  judge_each = make("judge_each", tr("Chec&k each stroke"),
                    tr("Check each stroke as you finish it, or everything at the end"), "J", true);
  groove_hidden = make("groove_hidden", tr("Tablet: &blank"), tr("Hide the grooves"), "Ctrl+Alt+H", true);
  groove_shown =
      make("groove_shown", tr("Tablet: with groo&ves"), tr("Show the grooves"), "Ctrl+Alt+S", true);
  groove_appears = make("groove_appears", tr("Tablet: groove &after each correct stroke"),
                        tr("The groove of a stroke appears once you write it correctly"), "Ctrl+Alt+A", true);
  more_lenient = make("more_lenient", tr("&More lenient"), tr("Check a little more leniently"), "Ctrl+[");
  more_strict = make("more_strict", tr("More str&ict"), tr("Check a little more strictly"), "Ctrl+]");
  lenient = make("lenient", tr("L&enient"), tr("Check leniently"), "Ctrl+Alt+L", true);
  normal =
      make("normal", tr("N&ormal"), tr("Check about as strictly as a teacher would"), "Ctrl+Alt+N", true);
  strict = make("strict", tr("St&rict"), tr("Check strictly"), "Ctrl+Alt+T", true);
  compare_over = make("compare_over", tr("Model o&ver your writing"), tr("Lay the model over your writing"),
                      "O", true, Icon::overlaid);
  compare_beside =
      make("compare_beside", tr("Your writing beside the &model"),
           tr("Show your writing and the model side by side and replay both"), "B", true, Icon::beside);
  show_right =
      make("show_right", tr("Sho&w"), tr("Draw the right strokes over your writing"), "D", Icon::overlaid);
  writing_cross = make("writing_cross", tr("&Writing cross"), tr("Thin lines on the tablet: 十, 田 or none"),
                       "C", Icon::beside);

  make_key_pen();
  make_sound();

  make_exclusive(stages);
  make_exclusive({by_groove, by_starts});
  make_exclusive({groove_hidden, groove_shown, groove_appears});
  make_exclusive({lenient, normal, strict});

  add_group(tr("&Character"),
            {find, find_by_parts, find_by_radical, draw_to_find, nullptr, tell_apart, make_model, nullptr,
             next_character, previous_character, nullptr, back, forward});
  add_group(tr("&Strokes"), {next_stroke, previous_stroke, all_strokes, nullptr, strokes, numbers, arrows,
                             snap, writing_cross, nullptr, clear_ink});
  add_group(tr("&Practice"), stages + QList<QAction*>{nullptr, play, step_back, step_on, slower, faster, loop,
                                                      nullptr, by_groove, by_starts, lead_hand});
  practice_ = groups().size() - 1;
  add_group(tr("&Writing"), {undo_stroke, done, hint, give_up, nullptr, show_right, compare_over,
                             compare_beside, nullptr, judge_each, groove_hidden, groove_shown, groove_appears,
                             nullptr, more_lenient, more_strict, lenient, normal, strict});
  add_group(tr("Pen by &keys"), {key_pen, nullptr, pen_down, pen_start, pen_where});
  add_group(tr("S&peech"), {speak, speaks_itself, nullptr, voice_automatic, voice_open_jtalk,
                            voice_dispatcher, voice_espeak, nullptr, voice_file});
}

void CharacterActions::make_key_pen() {
  key_pen = make("key_pen", tr("&Move the pen by key"),
                 tr("Explore and write with the arrow keys or the number pad; Shift: fine steps"), "M", true);
  pen_down = make("pen_down", tr("Pen &down or up"), tr("Put the pen down, or lift it"), "P");
  pen_start = make("pen_start", tr("To the next &start"), tr("Go to the start of the next stroke"), "T");
  pen_where = make("pen_where", tr("&Where is the pen?"), tr("Say where the pen is"), "I");
}

void CharacterActions::make_sound() {
  speak = make("speak", tr("&Speak"), tr("Speak the reading or the word"), "V", Icon::sound);
  speaks_itself = make("speaks_itself", tr("Speak &readings"),
                       tr("Speak kana and words when they are asked for, and readings after the answer"),
                       "Shift+V", true);
  voice_automatic = make("voice_automatic", tr("&Best voice"), tr("Use the best voice that is installed"),
                         "Alt+Shift+B", true);
  voice_open_jtalk =
      make("voice_open_jtalk", tr("&Open JTalk"), tr("Speak with Open JTalk"), "Alt+Shift+J", true);
  voice_dispatcher =
      make("voice_dispatcher", tr("Speech &Dispatcher"),
           tr("Speak with the voice of the desktop, as a screen reader does"), "Alt+Shift+D", true);
  voice_espeak =
      make("voice_espeak", tr("&eSpeak NG"), tr("Speak with eSpeak NG, plainly"), "Alt+Shift+E", true);
  voice_file =
      make("voice_file", tr("&Voice file…"), tr("Choose a voice for Open JTalk (.htsvoice)"), "Alt+Shift+V");
  make_exclusive({voice_automatic, voice_open_jtalk, voice_dispatcher, voice_espeak});
}

QAction* CharacterActions::add_practice(const char* name, const QString& text, const QString& tip,
                                        const char* key, Icon drawing) {
  auto* action = make(name, text, tip, key, drawing);
  // Apart from those above.
  if (groups()[practice_].actions.back() == lead_hand) add_to_group(practice_, nullptr);
  add_to_group(practice_, action);
  return action;
}

}  // namespace nazori::ui
