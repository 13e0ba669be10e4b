// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/workshop_actions.h"

namespace nazori::ui {

WorkshopActions::WorkshopActions(QWidget* window) : ActionSet(window) {
  tools = {
      make("workshop_draw", tr("&Draw strokes"),
           tr("Draw strokes with pen or mouse; pressure makes them wider"), "1", true, Icon::pen),
      make("workshop_place", tr("&Place points"),
           tr("Click the start, the bends and the end of a stroke. Enter: finish it"), "2", true,
           Icon::strokes),
      make("workshop_edit", tr("&Edit strokes"), tr("Choose and move points and strokes"), "3", true,
           Icon::snap),
      make("workshop_groove", tr("&Groove"), tr("Cut a groove into the relief by hand"), "4", true,
           Icon::chisel),
      make("workshop_raise", tr("&Raise"), tr("Raise the relief by hand"), "5", true),
      make("workshop_smooth", tr("S&mooth"), tr("Even out the relief"), "6", true),
      make("workshop_erase", tr("E&rase"), tr("Take back what was cut or raised by hand; strokes stay"), "7",
           true, Icon::erase),
      make("workshop_stamp", tr("Sta&mp"), tr("Press a shape into the relief"), "8", true),
  };
  straight = make("workshop_straight", tr("Straight &lines"), tr("Every stroke becomes one straight line"),
                  "L", true);
  mirrored = make("workshop_mirrored", tr("M&irrored"),
                  tr("The tools for the relief work on both sides of the middle"), "M", true);
  wider = make("workshop_wider", tr("&Wider"), tr("Make the chosen stroke or point, or else the tool, wider"),
               "]");
  thinner = make("workshop_thinner", tr("&Thinner"),
                 tr("Make the chosen stroke or point, or else the tool, thinner"), "[");
  deeper = make("workshop_deeper", tr("Dee&per"),
                tr("Make the chosen stroke or point, or else the tool, deeper"), "PgDown");
  shallower = make("workshop_shallower", tr("S&hallower"),
                   tr("Make the chosen stroke or point, or else the tool, shallower"), "PgUp");
  next_stamp = make("workshop_next_stamp", tr("&Other stamp"), tr("Take the next shape for the stamp"), "T");

  undo = make("workshop_undo", tr("&Undo"), tr("Undo the last change"), "Ctrl+Z", Icon::undo);
  redo = make("workshop_redo", tr("&Redo"), tr("Redo what was undone"), "Ctrl+Y Ctrl+Shift+Z", Icon::redo);
  step_back = make("workshop_step_back", tr("Take the last point &back"),
                   tr("Remove the point that was placed last; without one, undo"), "Backspace");
  finish = make("workshop_finish", tr("&Finish the stroke"), tr("Make a stroke of the placed points"),
                "Return Enter");
  next_stroke = make("workshop_next_stroke", tr("&Next stroke"), tr("Choose the next stroke"), "N");
  previous_stroke =
      make("workshop_previous_stroke", tr("Pre&vious stroke"), tr("Choose the previous stroke"), "P");
  next_point = make("workshop_next_point", tr("Ne&xt point"), tr("Choose the next point of the stroke"), ".");
  previous_point = make("workshop_previous_point", tr("Previous p&oint"),
                        tr("Choose the previous point of the stroke"), ",");
  number = make("workshop_number", tr("N&umber"),
                tr("Choose the number of the stroke. Arrow keys or the mouse move it"), "U");
  place_number = make("workshop_place_number", tr("Place the number a&utomatically"),
                      tr("Let the program place the number of the stroke again"), "Shift+U");
  curve = make(
      "workshop_curve", tr("&Width and depth along the stroke"),
      tr("Change width and depth along the stroke: Left and Right choose a point, Up and Down change it"),
      "W");
  earlier = make("workshop_earlier", tr("&Earlier"), tr("Move the stroke one place forward in the order"),
                 "Ctrl+Up");
  later =
      make("workshop_later", tr("&Later"), tr("Move the stroke one place back in the order"), "Ctrl+Down");
  reverse = make("workshop_reverse", tr("Re&verse"), tr("Draw the stroke from its other end"), "R");
  ending = make("workshop_ending", tr("Other en&ding"),
                tr("Give the stroke another ending: stop, hook, sweep"), "E");
  insert = make("workshop_insert", tr("&Insert a point"),
                tr("Add a point after the chosen one. With the mouse: double-click the line"), "I");
  split = make("workshop_split", tr("&Split"), tr("Split the stroke at the chosen point"), "X");
  join = make("workshop_join", tr("&Join"), tr("Join the next stroke to the end of this one"), "J");
  remove =
      make("workshop_remove", tr("&Delete"), tr("Delete the chosen point or stroke"), "Del", Icon::cross);

  start_empty =
      make("workshop_new", tr("&New character"), tr("Begin with an empty tablet"), "Ctrl+N", Icon::sheet);
  copy = make("workshop_copy", tr("&Copy of the character shown"),
              tr("Begin with a copy of the character that was shown last"), "C", Icon::copy);
  from_picture = make("workshop_picture", tr("From a &picture…"),
                      tr("Find the strokes in a scan or photograph (PNG, JPEG)"), "Ctrl+I");
  from_font =
      make("workshop_font", tr("From a &font…"), tr("Find the strokes of a character of a font"), "F");
  from_plot = make("workshop_plot", tr("From a function p&lot…"),
                   tr("Begin with the plot of a function as the relief"), "Y");
  clear_relief = make("workshop_clear_relief", tr("Clear the &relief"),
                      tr("Take away everything that was changed by hand; strokes stay"), "Ctrl+Del");
  keep = make("workshop_keep", tr("&Keep among my characters"),
              tr("Lists, search, study and worksheets have it then like any other"), "A");
  instead = make("workshop_instead", tr("&Use instead of the published one"),
                 tr("Use this form instead of the published character of its name"), "Shift+A", true);
  remove_kept = make("workshop_remove_kept", tr("Ta&ke out of my characters"),
                     tr("Lists, search, study and worksheets no longer have it; what you learned stays"),
                     "Ctrl+Shift+Del");
  details = make("workshop_details", tr("&Name and details"), tr("Type the name, readings and licence"), "D");
  add_part =
      make("workshop_add_part", tr("&Add a part"),
           tr("Add a part of the strokes that are chosen in the list, or else of those in no part"), "G");
  remove_part = make("workshop_remove_part", tr("Rem&ove the part"),
                     tr("Remove the chosen part; strokes stay"), "Shift+G");
  check = make("workshop_check", tr("Chec&k"), tr("Look for mistakes: order, endings, depth, licence"), "K",
               true, Icon::tick);
  describe =
      make("workshop_describe", tr("De&scribe"), tr("Say what is chosen and what the character has"), "S");
  carve = make("workshop_carve", tr("&Feel it"), tr("Carve the character as the tablet that you feel"),
               "Ctrl+Shift+C");
  save_copy = make("workshop_export", tr("Save a cop&y…"),
                   tr("Save as SVG, stroke order, height map (RAW, PNG)"), "Ctrl+E");

  zoom_in = make("workshop_zoom_in", tr("Zoom &in"), tr("Show less, larger"), "+ =");
  zoom_out = make("workshop_zoom_out", tr("Zoom &out"), tr("Show more, smaller"), "-");
  zoom_whole = make("workshop_zoom_whole", tr("&Whole tablet"), tr("Show the whole tablet"), "0");
  strokes = make("workshop_strokes", tr("Show &strokes"), tr("Show the strokes over the relief"), "B", true);
  panel = make("workshop_panel", tr("&Strokes and details"), tr("Show or hide the panel"), "F3", true,
               Icon::information);

  make_exclusive({tools.begin(), tools.end()});
  QList<QAction*> tool_group(tools.begin(), tools.end());
  tool_group += {nullptr, straight, mirrored, next_stamp, nullptr, wider, thinner, deeper, shallower};
  add_group(tr("&Tool"), tool_group);
  add_group(tr("&Stroke"),
            {undo, redo, step_back, finish, nullptr, next_stroke, previous_stroke, next_point, previous_point,
             nullptr, earlier, later, reverse, ending, nullptr, insert, split, join, remove});
  for (auto* action : QList<QAction*>{nullptr, curve, number, place_number}) add_to_group(1, action);
  add_group(tr("&Character"),
            {start_empty, copy,      from_picture, from_font,   from_plot, nullptr,    clear_relief,
             nullptr,     details,   add_part,     remove_part, check,     describe,   nullptr,
             carve,       save_copy, nullptr,      keep,        instead,   remove_kept});
  add_group(tr("&Look"), {zoom_in, zoom_out, zoom_whole, nullptr, strokes, panel});
}

}  // namespace nazori::ui
