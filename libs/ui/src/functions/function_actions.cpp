// SPDX-License-Identifier: Apache-2.0
#include "functions/function_actions.h"

namespace nazori::ui {

FunctionActions::FunctionActions(QWidget* window) : ActionSet(window) {
  expression = make("plot_expression", tr("&Expression"), tr("Go to the expression box"), "Ctrl+L");
  points = make("plot_points", tr("&Points of interest"), tr("Go to the table of points"), "Ctrl+T");
  zoom_in = make("plot_zoom_in", tr("&Zoom in"), tr("Show half the range, centred on the point"), "Z",
                 Icon::search);
  zoom_out =
      make("plot_zoom_out", tr("Zoom &out"), tr("Show twice the range, centred on the point"), "Shift+Z");
  reset_window = make("plot_reset_window", tr("Reset vie&w"), tr("Go back to the original range"), "W");
  export_raw = make("plot_export_raw", tr("Save the height map as &RAW…"),
                    tr("8-bit height map without a header, as in the 2005 program"), "Ctrl+Alt+R");
  export_png = make("plot_export_png", tr("Save the height map as P&NG…"), tr("16-bit greyscale height map"),
                    "Ctrl+Alt+P");
  export_print =
      make("plot_export_print", tr("Save for &tactile paper…"),
           tr("Black and white picture with thick lines, for swell paper and for low vision"), "Ctrl+Alt+T");
  export_sound = make("plot_export_sound", tr("Save the s&ound…"), tr("Save the sound of all curves as WAV"),
                      "Ctrl+Alt+W");

  make_model =
      make("plot_make_model", tr("&Make a model to touch…"),
           tr("A solid with raised curves, axes and numbers in braille, for a 3D printer"), "Ctrl+Shift+F");

  step_on = make_on_tablet("trace_on", tr("Forward &along the curve"), tr("Move right by 1% of the range"),
                           "Right");
  step_back =
      make_on_tablet("trace_back", tr("&Back along the curve"), tr("Move left by 1% of the range"), "Left");
  tick_on = make_on_tablet("trace_tick_on", tr("To the next &tick"),
                           tr("Go along the curve to the next tick of the x axis"), "Ctrl+Right");
  tick_back = make_on_tablet("trace_tick_back", tr("To the previous tic&k"),
                             tr("Go back along the curve to the previous tick"), "Ctrl+Left");
  to_start = make_on_tablet("trace_start", tr("To the &start"),
                            tr("Go to the start of this branch of the curve"), "Home");
  to_end =
      make_on_tablet("trace_end", tr("To the &end"), tr("Go to the end of this branch of the curve"), "End");
  branch_on = make_on_tablet("trace_branch_on", tr("&Next curve or branch"),
                             tr("Go to the next curve or branch"), "Up");
  branch_back = make_on_tablet("trace_branch_back", tr("&Previous curve or branch"),
                               tr("Go to the previous curve or branch"), "Down");
  point_on = make_on_tablet("trace_point_on", tr("Next po&int"), tr("Go to the next point of interest"), "N");
  point_back = make_on_tablet("trace_point_back", tr("Previous p&oint"),
                              tr("Go to the previous point of interest"), "Shift+N");
  pan_left = make_on_tablet("plot_pan_left", tr("Pan &left"), tr("Show more on the left"), "Shift+Left");
  pan_right = make_on_tablet("plot_pan_right", tr("Pan r&ight"), tr("Show more on the right"), "Shift+Right");
  pan_up = make_on_tablet("plot_pan_up", tr("Pan &up"), tr("Show more above"), "Shift+Up");
  pan_down = make_on_tablet("plot_pan_down", tr("Pan &down"), tr("Show more below"), "Shift+Down");
  coordinates =
      make("trace_coordinates", tr("&Coordinates"), tr("Read out the coordinates of the point"), "C");
  slope = make("trace_slope", tr("S&lope"), tr("Read out the slope of the curve here"), "D");
  summary = make("trace_summary", tr("Su&mmary"), tr("Describe the plot in one sentence"), "S");
  speech = make("trace_speech", tr("Spoken &form"),
                tr("Change how expressions are read: verbose, brief, superbrief"), "Shift+S");
  beacon = make("trace_beacon", tr("A&dd a marker"), tr("Mark this place"), "B");
  next_beacon =
      make("trace_next_beacon", tr("&Go to the next marker"), tr("Go to the next marked place"), "G");
  curve_on = make("curve_on", tr("Next branch only"), tr("Only the next branch attracts the stylus"), ".",
                  Icon::next);
  curve_back = make("curve_back", tr("Previous branch only"),
                    tr("Only the previous branch attracts the stylus"), ",", Icon::previous);
  all_curves = make("all_curves", tr("All branches"), tr("All branches attract the stylus"), "0");
  alone = make("curve_alone", tr("&Only this curve"), tr("Carve and play only one curve"), "O", true);
  next_alone = make("curve_next_alone", tr("Only the next cur&ve"),
                    tr("Carve and play only the next curve; after the last one, all of them"), "Shift+O");
  snap = make("plot_snap", tr("Snap"), tr("Curves attract the stylus"), "F", true, Icon::snap);
  clear_ink = make("plot_clear_ink", tr("Clear ink"), tr("Clear the tablet"), "Del", Icon::erase);

  hear = make("sound_hear", tr("&Hear the curves"), tr("Play every curve from end to end"), "H", Icon::sound);
  stop = make_on_tablet("sound_stop", tr("&Stop"), tr("Stop all sounds and the drawing"), "Esc");
  faster = make("sound_faster", tr("&Faster"), tr("Play the curves faster"), "+");
  slower = make("sound_slower", tr("S&lower"), tr("Play the curves more slowly"), "-");
  louder = make("sound_louder", tr("L&ouder"), tr("Turn the volume up"), "V");
  quieter = make("sound_quieter", tr("&Quieter"), tr("Turn the volume down"), "Shift+V");
  mute = make("sound_mute", tr("&Mute"), tr("Turn off all sound"), "M", true);

  reference = make("sound_reference", tr("&Tone of y = 0"), tr("Play the tone of y = 0 for comparison"), "Y");

  add_group(tr("&Plot"),
            {expression, points, nullptr, zoom_in, zoom_out, pan_left, pan_right, pan_up, pan_down,
             reset_window, nullptr, export_raw, export_png, export_print, export_sound, nullptr, make_model});
  add_group(tr("T&race"), {step_on,     step_back, tick_on,    tick_back,   to_start,    to_end,   branch_on,
                           branch_back, point_on,  point_back, nullptr,     coordinates, slope,    summary,
                           speech,      nullptr,   beacon,     next_beacon, nullptr,     curve_on, curve_back,
                           all_curves,  alone,     next_alone, snap,        clear_ink});
  add_group(tr("S&ound"), {hear, stop, reference, nullptr, faster, slower, nullptr, louder, quieter, mute});
}

QAction* FunctionActions::make_on_tablet(const char* name, const QString& text, const QString& tip,
                                         const char* key) {
  auto* action = make(name, text, tip, key);
  // The menu shows the key, but it is not a shortcut: elsewhere these keys move through lists and between
  // fields.
  action->setShortcutContext(Qt::WidgetShortcut);
  on_tablet_.append(action);
  return action;
}

QAction* FunctionActions::on_tablet(QKeyCombination key) const {
  const Qt::KeyboardModifiers modifiers = key.keyboardModifiers() & ~Qt::KeypadModifier;
  const QKeySequence pressed(QKeyCombination(modifiers, key.key()));
  for (auto* action : on_tablet_)
    if (action->shortcut() == pressed) return action;
  return nullptr;
}

}  // namespace nazori::ui
