// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/words/device_text.h"

#include <QCoreApplication>

#include "nazori/devices/back_end.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(nazori::ui::DeviceText)
};

}  // namespace

QString device_name(std::string_view name) {
  using namespace devices;
  if (name == back_end_names::kPointer) return Words::tr("Mouse, pen or finger");
  if (name == back_end_names::kGamepads) return Words::tr("Joysticks, wheels and gamepads");
  if (name == back_end_names::kSimulated) return Words::tr("Simulated devices");
  if (name.ends_with(kSimulatedMark))
    return Words::tr("%1 (simulated)").arg(to_text(name.substr(0, name.size() - kSimulatedMark.size())));
  return to_text(name);
}

QString trouble_text(haptics::DeviceTrouble trouble, const QString& name, const QString& detail) {
  using enum haptics::DeviceTrouble;
  const auto with_detail = [&](const QString& sentence) {
    // The driver speaks English.
    return detail.isEmpty() || !is_english() ? sentence : Words::tr("%1 (%2)").arg(sentence, detail);
  };
  switch (trouble) {
    case none:
      return {};
    case library_missing:
      return with_detail(Words::tr("%1: the manufacturer's library is not installed.").arg(name));
    case symbol_missing:
      return with_detail(
          Words::tr("%1: the manufacturer's library is too old or the wrong one. Install a newer version.")
              .arg(name));
    case service_missing:
      return with_detail(Words::tr("%1: the manufacturer's service is not responding. Start it.").arg(name));
    case device_absent:
      return with_detail(Words::tr("%1: no device is connected. Check the cable and the power.").arg(name));
    case no_permission:
      return with_detail(Words::tr("%1 is connected, but you do not have permission to use it. Add yourself "
                                   "to its group or install its udev rule.")
                             .arg(name));
    case in_use:
      return with_detail(Words::tr("%1 is in use. Close the program that uses it.").arg(name));
    case init_failed:
      return with_detail(
          Words::tr("%1 is connected but does not start. Unplug it and plug it in again.").arg(name));
    case bad_calibration:
      return with_detail(
          Words::tr("%1: the saved calibration cannot be used. Calibrate it again.").arg(name));
    case docked:
      return Words::tr("%1 rests in its inkwell. Take the stylus out to go on.").arg(name);
    case safety_switch:
      return Words::tr("%1 gives no force. Hold its safety switch.").arg(name);
    case not_calibrated:
      return Words::
          tr("%1 is not calibrated. Move the stylus through all of its space, or use the maker's program.")
              .arg(name);
    case wants_inkwell:
      return Words::tr("%1 is not calibrated. Put the stylus into its inkwell for a moment.").arg(name);
    case wants_reset_position:
      return Words::tr(
                 "%1 is not calibrated. Hold the arm at its reset position and press a button of the stylus.")
          .arg(name);
    case not_at_rest:
      return Words::tr("%1 was not at rest when it was opened. Put its handle to rest and choose it again.")
          .arg(name);
    case not_homed:
      return Words::
          tr("%1 is not homed. Press its button; with a Falcon, pull all three arms out and push them in.")
              .arg(name);
    case forces_off:
      return Words::tr("The forces of %1 are off. Press its force button or move more slowly.").arg(name);
    case over_force:
      return Words::tr("%1 paused because the force was too large. It resumes by itself.").arg(name);
    case over_speed:
      return Words::tr("%1 paused because it was moved too fast. It resumes by itself.").arg(name);
    case warm_motors:
      return Words::tr("The motors of %1 are too warm. It resumes when they have cooled down.").arg(name);
    case not_ready:
      return with_detail(Words::tr("%1 is switched off, or its brake is on. Switch it on.").arg(name));
    case too_slow:
      return Words::
          tr("%1 responds too slowly for safe force feedback. Close other programs, or connect it by cable.")
              .arg(name);
    case communication_lost:
      return Words::tr("The connection to %1 was lost. Check the cable.").arg(name);
    case device_fault:
      return with_detail(Words::tr("%1 reports a fault. Switch it off and on again.").arg(name));
    case no_timer:
      return Words::tr("The library of %1 gets no timer from the system. Close other programs.").arg(name);
    case stalled:
      return Words::tr("%1 no longer responds. Unplug it and plug it in again.").arg(name);
    case service_gone:
      return Words::tr("The service for %1 has stopped. Start it again.").arg(name);
    case bad_message:
      return with_detail(Words::tr("%1 sends data that cannot be read. Update its service.").arg(name));
  }
  return {};
}

}  // namespace nazori::ui
