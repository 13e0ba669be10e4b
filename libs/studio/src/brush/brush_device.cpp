// SPDX-License-Identifier: Apache-2.0
// The brush in the hand of a force-feedback device.
#include <QAction>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_page.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"

namespace nazori::ui {

void BrushPage::connect_device() {
  subscribe(felt_.pen_moved, this, [this](const brush::PenSample& sample) {
    clear_advice();
    writing_->move_pen(sample);
    if (!sample.down && is_watching()) dip_between_strokes();
    wake();
  });
  subscribe(felt_.pen_lost, this, [this] {
    stop_teacher();
    writing_->lift_pen();
    wake();
  });
  subscribe(felt_.pointed, this, [this](geometry::PaperPoint at) { paper_->show_brush_at(at); });
  // Later: samples of the device are being read.
  subscribe(felt_.button_pressed, this, [this] {
    QMetaObject::invokeMethod(actions_->dip_in_ink, &QAction::trigger, Qt::QueuedConnection);
  });
  subscribe(felt_.led, this, [this] { tell_written(); });
  on(actions_->strengthen, [this](bool on) {
    choice_.strengthen = on;
    set_feeling();
    parts().respond(Feedback::hint, on ? tr("The device pushes four times as hard as the brush.")
                                       : tr("The device pushes as hard as the brush."));
    parts().save_later();
  });
}

void BrushPage::set_feeling() {
  const auto tilt = calligraphy::assumed_tilt(choice_.left_hand);
  felt_.set_tilt(tilt.lean_rad, tilt.lean_to_rad);
  felt_.set_feel(choice_.strengthen ? brush::Feel::strengthened : brush::Feel::true_force);
}

}  // namespace nazori::ui
