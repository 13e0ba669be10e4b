// SPDX-License-Identifier: Apache-2.0
#include "functions/function_actions.h"

namespace nazori::ui {

FunctionActions::FunctionActions(QWidget* window) : ActionSet(window) {
  const auto key = [](const char* text) { return QStringList{QString::fromLatin1(text)}; };
  expression =
      make("plot_expression", tr("&Expression"), tr("Go to the line with the expression"), key("Ctrl+L"));
  points = make("plot_points", tr("&Points of interest"), tr("Go to the table of points"), key("Ctrl+T"));
  zoom_in = make("plot_zoom_in", tr("&Zoom in"), tr("Half of the window, about the point"), key("Z"));
  zoom_out = make("plot_zoom_out", tr("Zoom &out"), tr("Twice the window, about the point"), key("Shift+Z"));
  reset_window =
      make("plot_reset_window", tr("&Whole window"), tr("The window as it was at first"), key("W"));
  export_raw = make("plot_export_raw", tr("Save the height map as &RAW…"),
                    tr("8-bit height map without header, as in 2005"), key("Ctrl+Alt+R"));
  export_png = make("plot_export_png", tr("Save the height map as P&NG…"), tr("16-bit grey height map"),
                    key("Ctrl+Alt+P"));
  export_print = make("plot_export_print", tr("Save for &tactile paper…"),
                      tr("Black and white picture with thick lines, for swell paper and for low vision"),
                      key("Ctrl+Alt+T"));
  export_sound = make("plot_export_sound", tr("Save the s&ound…"), tr("The sweep of all curves as WAV"),
                      key("Ctrl+Alt+W"));

  const auto at = [](const char* text) { return QString::fromLatin1(text); };
  step_on = make_on_tablet("trace_on", tr("&Along the curve"), tr("A hundredth of the window to the right"),
                           at("Right"));
  step_back = make_on_tablet("trace_back", tr("&Back along the curve"),
                             tr("A hundredth of the window to the left"), at("Left"));
  tick_on = make_on_tablet("trace_tick_on", tr("To the next &tick"),
                           tr("Along the curve to the next tick of the x axis"), at("Ctrl+Right"));
  tick_back = make_on_tablet("trace_tick_back", tr("To the tick be&fore"),
                             tr("Back along the curve to the tick before"), at("Ctrl+Left"));
  to_start = make_on_tablet("trace_start", tr("To its &start"), tr("Where this piece of the curve begins"),
                            at("Home"));
  to_end =
      make_on_tablet("trace_end", tr("To its &end"), tr("Where this piece of the curve ends"), at("End"));
  branch_on = make_on_tablet("trace_branch_on", tr("&Next curve or branch"),
                             tr("To the next curve or branch"), at("Up"));
  branch_back = make_on_tablet("trace_branch_back", tr("&Previous curve or branch"),
                               tr("To the curve or branch before"), at("Down"));
  point_on =
      make_on_tablet("trace_point_on", tr("Next po&int"), tr("To the next point of interest"), at("Tab"));
  point_back = make_on_tablet("trace_point_back", tr("P&oint before"), tr("To the point of interest before"),
                              at("Shift+Tab"));
  pan_left = make_on_tablet("plot_pan_left", tr("Window to the &left"), tr("Show what lies to the left"),
                            at("Shift+Left"));
  pan_right = make_on_tablet("plot_pan_right", tr("Window to the r&ight"), tr("Show what lies to the right"),
                             at("Shift+Right"));
  pan_up = make_on_tablet("plot_pan_up", tr("Window &up"), tr("Show what lies above"), at("Shift+Up"));
  pan_down =
      make_on_tablet("plot_pan_down", tr("Window &down"), tr("Show what lies below"), at("Shift+Down"));
  coordinates = make("trace_coordinates", tr("&Coordinates"), tr("Say where the point is"), key("C"));
  slope = make("trace_slope", tr("S&lope"), tr("Say how steep the curve is here"), key("D"));
  summary = make("trace_summary", tr("Su&mmary"), tr("Say in one sentence what is drawn"), key("S"));
  beacon = make("trace_beacon", tr("&Drop a beacon"), tr("Remember this place"), key("B"));
  next_beacon = make("trace_next_beacon", tr("&Go to the next beacon"),
                     tr("To the next of the places remembered"), key("G"));
  curve_on =
      make("curve_on", tr("Next piece alone"), tr("Hold the stylus to the next piece alone"), key("."));
  curve_back =
      make("curve_back", tr("Piece before alone"), tr("Hold the stylus to the piece before alone"), key(","));
  all_curves = make("all_curves", tr("All pieces"), tr("Hold the stylus to any piece"), key("0"));
  alone = make("curve_alone", tr("&Only this curve"), tr("Carve and play one curve without the others"),
               key("O"), true);
  next_alone =
      make("curve_next_alone", tr("Next cur&ve alone"),
           tr("Carve and play the next curve without the others, after the last one all"), key("Shift+O"));
  snap = make("plot_snap", tr("Snap"), tr("Curves hold the stylus"), key("F"), true);
  clear_ink = make("plot_clear_ink", tr("Clear the ink"), tr("Wipe the tablet clean"), key("Del"));

  hear = make("sound_hear", tr("&Hear the curves"), tr("Play every curve from end to end"), key("H"));
  stop = make_on_tablet("sound_stop", tr("&Stop"), tr("Stop every sound, and the drawing"), at("Esc"));
  faster = make("sound_faster", tr("&Faster"), tr("Play the curves faster"), key("+"));
  slower = make("sound_slower", tr("S&lower"), tr("Play the curves slower"), key("-"));
  louder = make("sound_louder", tr("L&ouder"), tr("More volume"), key("V"));
  quieter = make("sound_quieter", tr("&Quieter"), tr("Less volume"), key("Shift+V"));
  mute = make("sound_mute", tr("&Mute"), tr("No sound at all"), key("M"), true);

  reference =
      make("sound_reference", tr("&Tone of y = 0"), tr("Play the tone of y = 0, to compare with"), key("Y"));

  draw(hear, Icon::sound);
  draw(snap, Icon::snap);
  draw(clear_ink, Icon::erase);
  draw(zoom_in, Icon::search);
  draw(curve_on, Icon::next);
  draw(curve_back, Icon::previous);

  add_group(tr("&Plot"),
            {expression, points, nullptr, zoom_in, zoom_out, pan_left, pan_right, pan_up, pan_down,
             reset_window, nullptr, export_raw, export_png, export_print, export_sound});
  add_group(
      tr("T&race"),
      {step_on,    step_back,  tick_on,     tick_back, to_start,   to_end,  branch_on, branch_back, point_on,
       point_back, nullptr,    coordinates, slope,     summary,    nullptr, beacon,    next_beacon, nullptr,
       curve_on,   curve_back, all_curves,  alone,     next_alone, snap,    clear_ink});
  add_group(tr("S&ound"), {hear, stop, reference, nullptr, faster, slower, nullptr, louder, quieter, mute});
}

QAction* FunctionActions::make_on_tablet(const char* name, const QString& text, const QString& tip,
                                         const QString& key) {
  auto* action = make(name, text, tip, {key});
  // Shown with its key, but the shortcut map leaves it alone: elsewhere these keys walk through lists and
  // from field to field.
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
