// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/tablets.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "nazori/base/utf8.h"
#include "nazori/exchange/samples.h"
#include "nazori/kanji/character_name.h"

namespace nazori::exchange {
namespace {

/// The members that say which character it is.
Value named(const kanji::Character& character) {
  return {{"character", base::encode_utf8(character.code_point)},
          {"code_point", kanji::code_point_text(character.code_point)},
          {"variant", character.variant}};
}

Value to_json(const devices::FollowedStroke& followed) {
  return {{"stroke", followed.stroke},
          {"length_m", followed.length_m},
          {"duration_s", followed.duration_s},
          {"aim_rms_m", followed.aim_rms_m},
          {"aim_max_m", followed.aim_max_m},
          {"tip_rms_m", followed.tip_rms_m},
          {"tip_max_m", followed.tip_max_m},
          {"mean_force_n", followed.mean_force_n},
          {"peak_force_n", followed.peak_force_n},
          {"contact_share", followed.contact_share},
          {"snapped_share", followed.snapped_share},
          {"mean_depth_m", followed.mean_depth_m},
          {"slips", followed.slips},
          {"traced_share", followed.followed_share}};
}

Value timing_of(const devices::HandReport& hand) {
  return {{"real_time_scheduling", hand.clock.real_time},
          {"scheduling", scheduling_of(hand)},
          {"ticks", hand.timing.ticks},
          {"p999_tick_s", hand.p999_tick_s},
          {"p999_lateness_s", hand.p999_lateness_s},
          {"skipped_periods", hand.clock.missed},
          {"late_ticks", hand.timing.late_ticks},
          {"missed_ticks", hand.timing.missed_ticks},
          {"mean_tick_s", hand.timing.mean_tick_s},
          {"max_tick_s", hand.timing.max_tick_s},
          {"max_lateness_s", hand.timing.max_lateness_s}};
}

}  // namespace

Value to_json(const kanji::Character& character, const CarvedFiles& files) {
  Value json = named(character);
  json["file"] = files.map;
  json["size"] = files.size;
  json["strokes_file"] = or_null(files.strokes);
  json["stroke_count"] = character.strokes.size();
  return json;
}

Value to_json(const PaintedPicture& picture) {
  return {{"subject", picture.subject},
          {"file", picture.file},
          {"width", picture.width},
          {"height", picture.height}};
}

Value to_json(const SolidModel& model) {
  return {{"subject", model.subject},
          {"file", model.file},
          {"width_mm", model.width_mm},
          {"height_mm", model.height_mm},
          {"thickness_mm", model.thickness_mm},
          {"volume_mm3", model.volume_mm3},
          {"triangles", model.triangles},
          {"error_mm", model.error_mm},
          {"strokes_without_number", model.without_number}};
}

Value to_json(const MadeTouchFile& made) {
  Value json{{"subject", made.subject},
             {"file", made.file},
             {"kind", made.kind},
             {"width_mm", made.width_mm},
             {"height_mm", made.height_mm},
             {"pages", made.pages},
             {"strokes_without_number", made.without_number}};
  if (made.closest_mm > 0) json["closest_mm"] = made.closest_mm;
  if (made.milling) {
    json["passes"] = made.milling->passes;
    json["deepest_mm"] = made.milling->deepest_mm;
    json["cut_length_mm"] = made.milling->cut_length_mm;
    json["minutes"] = made.milling->minutes;
  }
  return json;
}

Value to_json(const PrintedSheet& sheet) {
  return {{"file", sheet.file},
          {"layout", sheet.layout},
          {"characters", sheet.character_count},
          {"bytes", sheet.bytes}};
}

Value to_json(const PaintedSheet& sheet) {
  return {{"script", sheet.script},
          {"file", sheet.file},
          {"paper", sheet.paper},
          {"brush", sheet.brush},
          {"size", sheet.size},
          {"samples", sheet.samples},
          {"seconds", sheet.seconds},
          {"painted_mm2", sheet.painted_mm2},
          {"ink_left", sheet.ink_left},
          {"frames", sheet.frames},
          {"model_font", sheet.model_font}};
}

HandTracking tracking_of(const devices::HandReport& hand) {
  HandTracking tracking;
  double squares = 0, weights = 0;
  for (const devices::FollowedStroke& stroke : hand.strokes) {
    const double weight = stroke.duration_s * stroke.contact_share;
    squares += weight * stroke.tip_rms_m * stroke.tip_rms_m;
    weights += weight;
    tracking.max_m = std::max(tracking.max_m, stroke.tip_max_m);
  }
  if (weights > 0) tracking.rms_m = std::sqrt(squares / weights);
  return tracking;
}

std::string_view scheduling_of(const devices::HandReport& hand) {
  return hand.clock.real_time ? "SCHED_FIFO" : "SCHED_OTHER";
}

Value to_json(const kanji::Character& character, const FollowedBy& by, const devices::HandReport& hand,
              const recording::SampleStatistics& samples) {
  Value strokes = Value::array();
  for (const devices::FollowedStroke& stroke : hand.strokes) strokes.push_back(to_json(stroke));
  const HandTracking tracking = tracking_of(hand);
  Value json = named(character);
  json.update({{"picture", by.picture},
               {"device", by.device},
               {"rate_hz", by.rate_hz},
               {"snapping", by.snapping},
               {"tracking_rms_m", tracking.rms_m},
               {"tracking_max_m", tracking.max_m},
               {"work_on_hand_j", hand.work_on_hand_j},
               {"dissipated_j", -hand.work_on_hand_j},
               {"samples", to_json(samples)},
               {"strokes", std::move(strokes)}});
  if (by.in_real_time) json["timing"] = timing_of(hand);
  return json;
}

double FeltMotion::real_time_factor() const {
  return took_s > 0 ? static_cast<double>(samples.samples) / rate_hz / took_s : 0;
}

Value to_json(const FeltMotion& felt) {
  Value json{{"subject", felt.subject},
             {"mode", felt.mode},
             {"device", felt.device},
             {"rate_hz", felt.rate_hz},
             {"tip_radius_m", felt.tip_radius_m},
             {"input", felt.input},
             {"output", felt.output}};
  json.update(to_json(felt.samples));
  json["late_ticks"] = felt.timing.late_ticks;
  json["missed_ticks"] = felt.timing.missed_ticks;
  json["mean_tick_s"] = felt.timing.mean_tick_s;
  json["took_s"] = felt.took_s;
  json["real_time_factor"] = felt.real_time_factor();
  return json;
}

}  // namespace nazori::exchange
