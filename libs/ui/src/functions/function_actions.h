// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/widgets/controls/action_set.h"

namespace nazori::ui {

/// The actions of the page for functions.
class FunctionActions final : public ActionSet {
  Q_OBJECT
 public:
  explicit FunctionActions(QWidget* window);

  QAction *expression, *points, *zoom_in, *zoom_out, *pan_left, *pan_right, *pan_up, *pan_down, *reset_window;
  QAction *export_raw, *export_png, *export_print, *export_sound, *make_model;
  QAction *step_on, *step_back, *tick_on, *tick_back, *to_start, *to_end, *branch_on, *branch_back;
  QAction *point_on, *point_back, *coordinates, *slope, *summary, *speech, *beacon, *next_beacon;
  QAction *curve_on, *curve_back, *all_curves, *alone, *next_alone, *snap, *clear_ink;
  QAction *hear, *stop, *faster, *slower, *louder, *quieter, *mute, *reference;

  /// The action whose key works only while the keyboard is on the tablet (arrows, Home, End, Tab, Esc);
  /// nullptr: none has this key.
  [[nodiscard]] QAction* on_tablet(QKeyCombination key) const;

 private:
  QAction* make_on_tablet(const char* name, const QString& text, const QString& tip, const char* key);
  QList<QAction*> on_tablet_;
};

}  // namespace nazori::ui
