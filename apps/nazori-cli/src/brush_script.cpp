// SPDX-License-Identifier: Apache-2.0
#include "brush_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "nazori/base/file.h"
#include "nazori/base/utf8.h"
#include "nazori/exchange/handwriting.h"
#include "nazori/json/json.h"
#include "nazori/recording/trajectory_csv.h"
#include "options.h"

namespace nazori::cli {
namespace {

using base::Errc;
using brush::PenSample;
using geometry::PaperPoint;

constexpr double kBetweenStrokes_s = 0.25;
constexpr double kLift_s = 0.02;
constexpr std::size_t kMostSamples = 1'000'000;

/// Puts the strokes of one character behind one another.
class Pen {
 public:
  void go_to(PaperPoint at, std::optional<double> time_s, std::optional<double> pressure) {
    PenSample sample;
    sample.at = at;
    sample.pressure = pressure;
    if (!begun_) {
      const double earliest = samples_.empty() ? 0 : samples_.back().time_s + kBetweenStrokes_s;
      // Times may start again with each stroke.
      if (time_s) shift_ = std::max(shift_, earliest - *time_s);
      sample.time_s = time_s ? *time_s + shift_ : earliest;
      if (!samples_.empty()) above(at, sample.time_s - kLift_s);
      begun_ = true;
    } else {
      const PenSample& before = samples_.back();
      const double way = geometry::distance(before.at, at);
      sample.time_s = time_s ? *time_s + shift_ : before.time_s + way / kPlainSpeed_m_s;
      if (sample.time_s <= before.time_s) return;
    }
    samples_.push_back(sample);
  }
  void lift() {
    if (begun_) above(samples_.back().at, samples_.back().time_s + kLift_s);
    begun_ = false;
  }
  [[nodiscard]] std::vector<PenSample> samples() && { return std::move(samples_); }

 private:
  void above(PaperPoint at, double time_s) {
    PenSample sample;
    sample.time_s = time_s;
    sample.at = at;
    sample.down = false;
    samples_.push_back(sample);
  }

  std::vector<PenSample> samples_;
  double shift_ = 0;
  bool begun_ = false;
};

base::Result<BrushScript> read_trajectory(const std::string& file) {
  auto reader = recording::TrajectoryReader::open(file);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  BrushScript script;
  recording::TrajectoryPoint point;
  for (;;) {
    const auto more = reader->next(point);
    if (!more) return tl::unexpected(more.error());
    if (!*more) return script;
    if (script.samples.size() == kMostSamples)
      return base::fail(Errc::bad_argument, fmt::format("has more than {} moments", kMostSamples), file,
                        "give a part of it");
    PenSample sample;
    sample.time_s = point.time_s;
    sample.at = {point.position_m[0], point.position_m[1]};
    sample.height_m = point.position_m[2];
    script.samples.push_back(sample);
  }
}

base::Result<BrushScript> handwriting_of(const json::Value& request, double side_m) {
  const auto ink = exchange::read_handwriting(request);
  if (!ink) return tl::unexpected(ink.error());
  BrushScript script;
  if (const auto name = request.find("char"); name != request.end()) {
    const auto letters =
        name->is_string() ? base::decode_utf8(name->get<std::string>()) : std::optional<std::u32string>();
    if (!letters || letters->size() != 1)
      return base::fail(Errc::bad_argument, "must be one character", "char", "give one, such as \"休\"");
    script.character = letters->front();
  }
  if (!ink->box)
    return base::fail(Errc::bad_argument, "is missing", "box",
                      "give [left, top, side], or coordinates within 0..1");
  if (!(ink->box->side > 0)) return base::fail(Errc::bad_argument, "has a side that is not above 0", "box");
  Pen pen;
  for (const auto& stroke : ink->strokes) {
    for (const auto& point : stroke) {
      if (point.pressure && !(*point.pressure >= 0 && *point.pressure <= 1))
        return base::fail(Errc::bad_argument,
                          fmt::format("has {}, but a pressure is 0 to 1", *point.pressure), "pressures");
      const double x = (point.at.x - ink->box->corner.x) / ink->box->side;
      const double y = (point.at.y - ink->box->corner.y) / ink->box->side;
      pen.go_to({(x - 0.5) * side_m, (0.5 - y) * side_m}, point.time_s, point.pressure);
    }
    pen.lift();
  }
  script.samples = std::move(pen).samples();
  return script;
}

base::Result<BrushScript> read_either(const std::string& file, double side_m) {
  if (has_extension(file, ".csv")) return read_trajectory(file);
  if (!has_extension(file, ".json"))
    return base::fail(Errc::bad_argument, "has an unsupported file type", file,
                      "give a trajectory (.csv) or handwriting (.json)");
  const auto bytes = base::read_file(file, json::Limits{}.bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto request = json::parse({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  auto script = [&]() -> base::Result<BrushScript> {
    if (!request) return tl::unexpected(request.error());
    if (!request->is_object())
      return base::fail(Errc::parse, "is not an object", "", "give {\"strokes\": [[[x, y], ...], ...]}");
    return handwriting_of(*request, side_m);
  }();
  if (!script) {
    base::Error error = script.error();
    error.where = error.where.empty() ? file : file + ": " + error.where;
    return tl::unexpected(std::move(error));
  }
  return script;
}

}  // namespace

base::Result<BrushScript> read_brush_script(const std::string& file, double side_m) {
  auto script = read_either(file, side_m);
  if (!script) return script;
  // Small times keep their precision.
  const double first_s = script->samples.empty() ? 0 : script->samples.front().time_s;
  for (PenSample& sample : script->samples) sample.time_s -= first_s;
  return script;
}

}  // namespace nazori::cli
