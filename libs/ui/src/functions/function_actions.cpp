// SPDX-License-Identifier: Apache-2.0
#include "functions/function_actions.h"

namespace nazori::ui {

FunctionActions::FunctionActions(QWidget* window) : ActionSet(window) {
  const auto key = [](const char* text) { return QStringList{QString::fromLatin1(text)}; };
  expression = make("plot_expression", tr("&Expression"), tr("Go to the expression box"), key("Ctrl+L"));
  points = make("plot_points", tr("&Points of interest"), tr("Go to the table of points"), key("Ctrl+T"));
  zoom_in = make("plot_zoom_in", tr("&Zoom in"), tr("Show half the range, centred on the point"), key("Z"));
  zoom_out = make("plot_zoom_out", tr("Zoom &out"), tr("Show twice the range, centred on the point"),
                  key("Shift+Z"));
  reset_window = make("plot_reset_window", tr("Reset vie&w"), tr("Go back to the original range"), key("W"));
  export_raw = make("plot_export_raw", tr("Save the height map as &RAW…"),
                    tr("8-bit height map without a header, as in the 2005 program"), key("Ctrl+Alt+R"));
  export_png = make("plot_export_png", tr("Save the height map as P&NG…"), tr("16-bit greyscale height map"),
                    key("Ctrl+Alt+P"));
  export_print = make("plot_export_print", tr("Save for &tactile paper…"),
                      tr("Black and white picture with thick lines, for swell paper and for low vision"),
                      key("Ctrl+Alt+T"));
  export_sound = make("plot_export_sound", tr("Save the s&ound…"), tr("Save the sound of all curves as WAV"),
                      key("Ctrl+Alt+W"));

  const auto at = [](const char* text) { return QString::fromLatin1(text); };
  step_on = make_on_tablet("trace_on", tr("Forward &along the curve"), tr("Move right by 1% of the range"),
                           at("Right"));
  step_back = make_on_tablet("trace_back", tr("&Back along the curve"), tr("Move left by 1% of the range"),
                             at("Left"));
  tick_on = make_on_tablet("trace_tick_on", tr("To the next &tick"),
                           tr("Go along the curve to the next tick of the x axis"), at("Ctrl+Right"));
  tick_back = make_on_tablet("trace_tick_back", tr("To the previous tic&k"),
                             tr("Go back along the curve to the previous tick"), at("Ctrl+Left"));
  to_start = make_on_tablet("trace_start", tr("To the &start"),
                            tr("Go to the start of this branch of the curve"), at("Home"));
  to_end = make_on_tablet("trace_end", tr("To the &end"), tr("Go to the end of this branch of the curve"),
                          at("End"));
  branch_on = make_on_tablet("trace_branch_on", tr("&Next curve or branch"),
                             tr("Go to the next curve or branch"), at("Up"));
  branch_back = make_on_tablet("trace_branch_back", tr("&Previous curve or branch"),
                               tr("Go to the previous curve or branch"), at("Down"));
  point_on =
      make_on_tablet("trace_point_on", tr("Next po&int"), tr("Go to the next point of interest"), at("Tab"));
  point_back = make_on_tablet("trace_point_back", tr("Previous p&oint"),
                              tr("Go to the previous point of interest"), at("Shift+Tab"));
  pan_left = make_on_tablet("plot_pan_left", tr("Pan &left"), tr("Show more on the left"), at("Shift+Left"));
  pan_right =
      make_on_tablet("plot_pan_right", tr("Pan r&ight"), tr("Show more on the right"), at("Shift+Right"));
  pan_up = make_on_tablet("plot_pan_up", tr("Pan &up"), tr("Show more above"), at("Shift+Up"));
  pan_down = make_on_tablet("plot_pan_down", tr("Pan &down"), tr("Show more below"), at("Shift+Down"));
  coordinates =
      make("trace_coordinates", tr("&Coordinates"), tr("Read out the coordinates of the point"), key("C"));
  slope = make("trace_slope", tr("S&lope"), tr("Read out the slope of the curve here"), key("D"));
  summary = make("trace_summary", tr("Su&mmary"), tr("Describe the plot in one sentence"), key("S"));
  speech = make("trace_speech", tr("Spoken &form"),
                tr("Change how expressions are read: verbose, brief, superbrief"), key("Shift+S"));
  beacon = make("trace_beacon", tr("A&dd a marker"), tr("Mark this place"), key("B"));
  next_beacon =
      make("trace_next_beacon", tr("&Go to the next marker"), tr("Go to the next marked place"), key("G"));
  curve_on =
      make("curve_on", tr("Next branch only"), tr("Only the next branch attracts the stylus"), key("."));
  curve_back = make("curve_back", tr("Previous branch only"),
                    tr("Only the previous branch attracts the stylus"), key(","));
  all_curves = make("all_curves", tr("All branches"), tr("All branches attract the stylus"), key("0"));
  alone = make("curve_alone", tr("&Only this curve"), tr("Carve and play only one curve"), key("O"), true);
  next_alone =
      make("curve_next_alone", tr("Only the next cur&ve"),
           tr("Carve and play only the next curve; after the last one, all of them"), key("Shift+O"));
  snap = make("plot_snap", tr("Snap"), tr("Curves attract the stylus"), key("F"), true);
  clear_ink = make("plot_clear_ink", tr("Clear ink"), tr("Clear the tablet"), key("Del"));

  hear = make("sound_hear", tr("&Hear the curves"), tr("Play every curve from end to end"), key("H"));
  stop = make_on_tablet("sound_stop", tr("&Stop"), tr("Stop all sounds and the drawing"), at("Esc"));
  faster = make("sound_faster", tr("&Faster"), tr("Play the curves faster"), key("+"));
  slower = make("sound_slower", tr("S&lower"), tr("Play the curves more slowly"), key("-"));
  louder = make("sound_louder", tr("L&ouder"), tr("Turn the volume up"), key("V"));
  quieter = make("sound_quieter", tr("&Quieter"), tr("Turn the volume down"), key("Shift+V"));
  mute = make("sound_mute", tr("&Mute"), tr("Turn off all sound"), key("M"), true);

  reference =
      make("sound_reference", tr("&Tone of y = 0"), tr("Play the tone of y = 0 for comparison"), key("Y"));

  draw(hear, Icon::sound);
  draw(snap, Icon::snap);
  draw(clear_ink, Icon::erase);
  draw(zoom_in, Icon::search);
  draw(curve_on, Icon::next);
  draw(curve_back, Icon::previous);

  add_group(tr("&Plot"),
            {expression, points, nullptr, zoom_in, zoom_out, pan_left, pan_right, pan_up, pan_down,
             reset_window, nullptr, export_raw, export_png, export_print, export_sound});
  add_group(tr("T&race"), {step_on,     step_back, tick_on,    tick_back,   to_start,    to_end,   branch_on,
                           branch_back, point_on,  point_back, nullptr,     coordinates, slope,    summary,
                           speech,      nullptr,   beacon,     next_beacon, nullptr,     curve_on, curve_back,
                           all_curves,  alone,     next_alone, snap,        clear_ink});
  add_group(tr("S&ound"), {hear, stop, reference, nullptr, faster, slower, nullptr, louder, quieter, mute});
}

QAction* FunctionActions::make_on_tablet(const char* name, const QString& text, const QString& tip,
                                         const QString& key) {
  auto* action = make(name, text, tip, {key});
  // The menu shows the key, but it is not a shortcut: elsewhere these keys move through lists and between
  // fields.
  action->setShortcutContext(Qt::WidgetShortcut);
  on_tablet_.append(action);
  return action;
}

QAction* FunctionActions::on_tablet(QKeyCombination key) const {
  const Qt::KeyboardModifiers modifiers = key.keyboardModifiers() & ~Qt::KeypadModifier;
  const bool back = key.key() == Qt::Key_Backtab;
  const QKeySequence pressed(QKeyCombination(back ? Qt::KeyboardModifiers(Qt::ShiftModifier) : modifiers,
                                             back ? Qt::Key_Tab : key.key()));
  for (auto* action : on_tablet_)
    if (action->shortcut() == pressed) return action;
  return nullptr;
}

}  // namespace nazori::ui
