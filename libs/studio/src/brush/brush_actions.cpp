// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/brush_actions.h"

namespace nazori::ui {

BrushActions::BrushActions(QWidget* window) : ActionSet(window) {
  dip_in_ink = make("brush_ink", tr("&Ink"), tr("Dip the brush in ink"), "I", Icon::ink_stone);
  dip_in_water = make("brush_water", tr("&Water"), tr("Dip the brush in water: the ink becomes paler"), "W",
                      Icon::water);
  wipe = make("brush_wipe", tr("Wi&pe"), tr("Wipe the brush: it holds half as much ink"), "X", Icon::wipe);
  thicker = make("brush_thicker", tr("&Thicker brush"), tr("Take the next thicker brush"), "]");
  thinner = make("brush_thinner", tr("T&hinner brush"), tr("Take the next thinner brush"), "[");
  next_hair =
      make("brush_hair", tr("Other h&air"), tr("Take a brush with other hair: goat, mixed, weasel"), "H");
  next_ink =
      make("brush_ink_colour", tr("Other ink &colour"), tr("Wash the brush and take the next ink"), "C");
  guess_pressure = make("brush_guess", tr("&Guess pressure"),
                        tr("With mouse and finger: a slow stroke is thick, a fast one thin"), "G", true);
  left_hand = make("brush_left_hand", tr("&Left hand"),
                   tr("The brush leans to the left; the tilt of a pen is mirrored"), "L", true);
  strengthen = make("brush_strengthen", tr("&Strengthen the force"),
                    tr("A force-feedback device pushes four times as hard as the brush"), "Shift+F", true);
  show_brush = make("brush_shown", tr("Show the &brush"), tr("Show the brush above the paper"), "B", true);

  undo = make("brush_undo", tr("&Undo"), tr("Undo the last stroke"), "Ctrl+Z Backspace", Icon::undo);
  redo = make("brush_redo", tr("&Redo"), tr("Redo what was undone"), "Ctrl+Y Ctrl+Shift+Z", Icon::redo);
  dry = make("brush_dry", tr("&Dry now"), tr("Dry the sheet at once"), "D", Icon::dry);
  new_sheet = make("brush_new", tr("&New sheet"), tr("Take an empty sheet; undo brings this one back"),
                   "Ctrl+N", Icon::sheet);
  next_paper = make("brush_paper", tr("Other &paper"), tr("Take a new sheet of the next kind of paper"), "P");
  describe =
      make("brush_describe", tr("De&scribe the sheet"), tr("Say what is on the paper and in the brush"), "S");
  advice = make("brush_advice", tr("&Advice"),
                tr("Compare the sheet with the model: advice in words, and corrections in vermilion"), "J",
                true, Icon::advice);
  save_png = make("brush_png", tr("Save as a pictur&e…"),
                  tr("Save the sheet as a picture (PNG) or a page (PDF), or its strokes (SVG)"), "Ctrl+E");
  carve = make("brush_carve", tr("&Carve as a tablet"), tr("Carve the ink into a tablet that you can feel"),
               "Ctrl+Shift+C");
  tools = make("brush_tools", tr("&Tools beside the paper"), tr("Show or hide brush, paper and model"), "F3",
               true, Icon::information);

  model_none = make("brush_model_none", tr("&No model"), tr("Write without a model"), "1", true);
  model_beneath = make("brush_model_beneath", tr("Model &beneath"),
                       tr("Show the model faintly under the ink"), "2", true);
  model_beside =
      make("brush_model_beside", tr("Model be&side"), tr("Show the model beside the paper"), "3", true);
  next_ruling =
      make("brush_ruling", tr("Other &ruling"), tr("Rule the sheet for 0, 1, 2, 4 or 6 characters"), "R");
  next_font = make("brush_font", tr("Other f&ont"),
                   tr("Take the model from the next brush font, or as printed lines"), "F");
  model_text = make("brush_model_text", tr("Model &text…"), tr("Type what you want to write"), "T");
  next_model = make("brush_next_model", tr("Ne&xt part"), tr("Show the next part of the model text"), ".");
  previous_model =
      make("brush_previous_model", tr("Pre&vious part"), tr("Show the previous part of the model text"), ",");

  watch =
      make("brush_watch", tr("&Watch it written"),
           tr("The brush writes the model by itself, as a teacher shows it; again: stop"), "V", Icon::play);
  by_key = make("brush_by_key", tr("&Move the brush by key"),
                tr("Write with the arrow keys or the number pad; Shift: fine steps"), "M", true);
  press = make("brush_press", tr("Brush &up or down"), tr("Put the brush on the paper, or lift it"), "U");
  next_start = make("brush_start", tr("To the next &start"),
                    tr("Go to the start of the next stroke of the model"), "N");
  where = make("brush_where", tr("&Where is the brush?"), tr("Say where the brush is"), "K");
  harder = make("brush_harder", tr("Press &harder"), tr("Move by key: press the brush harder"), "+");
  softer = make("brush_softer", tr("Press s&ofter"), tr("Move by key: press the brush less"), "-");

  review = make("brush_review", tr("&Review with the brush"),
                tr("Write well known characters with the brush, as set in the study settings"), "Ctrl+Return",
                Icon::play);
  go_on = make("brush_go_on", tr("&Next"), tr("Get advice, or accept the suggested rating"), "Return Enter",
               Icon::next);
  rate = {make("brush_again", tr("&Again"), tr("Not yet: comes back soon"), "7"),
          make("brush_hard", tr("&Hard"), tr("Written with effort"), "8"),
          make("brush_good", tr("Goo&d"), tr("Written well"), "9"),
          make("brush_easy", tr("&Easy"), tr("Written well and easily"), "0")};
  skip = make("brush_skip", tr("S&kip"), tr("Leave this character out of this session; it stays due"),
              "Ctrl+Shift+P");
  undo_rating = make("brush_undo_rating", tr("Undo las&t review"),
                     tr("Undo the last saved review or change; repeat to go further back"), "Shift+Backspace",
                     Icon::undo);
  end = make("brush_end", tr("End the &session"), tr("Everything you rated is saved"), "Ctrl+Shift+E");
  show_session(false, false);

  make_exclusive({model_none, model_beneath, model_beside});
  add_group(tr("&Brush"), {dip_in_ink, dip_in_water, wipe, nullptr, thicker, thinner, next_hair, next_ink,
                           nullptr, guess_pressure, left_hand, strengthen, show_brush});
  add_group(tr("S&heet"), {undo, redo, nullptr, dry, new_sheet, next_paper, nullptr, describe, advice,
                           nullptr, save_png, carve, nullptr, tools});
  add_group(tr("&Model"), {model_none, model_beneath, model_beside, nullptr, next_ruling, next_font, nullptr,
                           model_text, next_model, previous_model, nullptr, watch});
  add_group(tr("By &key"), {by_key, nullptr, press, next_start, where, nullptr, harder, softer});
  add_group(tr("St&udy"), {review, go_on, nullptr, rate[0], rate[1], rate[2], rate[3], nullptr, undo_rating,
                           nullptr, skip, end});
}

void BrushActions::show_session(bool is_running, bool advised) {
  for (auto* one : {go_on, skip, end}) one->setEnabled(is_running);
  for (auto* one : rate) one->setEnabled(advised);
  // A session has one character on a sheet.
  for (auto* one : {next_ruling, model_text, next_model, previous_model, watch}) one->setEnabled(!is_running);
}

}  // namespace nazori::ui
