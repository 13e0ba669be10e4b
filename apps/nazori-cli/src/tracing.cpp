// SPDX-License-Identifier: Apache-2.0
#include "tracing.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <memory>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "due_times.h"
#include "nazori/base/unfinished_file.h"
#include "nazori/geometry/polyline.h"
#include "nazori/recording/session_recorder.h"
#include "options.h"
#include "tracing_plan.h"

namespace nazori::cli {
namespace {

using geometry::TabletPoint;
using haptics::Vec3;
using Line = geometry::Polyline<geometry::TabletFrame>;

// A tip further from the line than this traces nothing.
constexpr double kTraced_m = 0.003;

TabletPoint from_above(const Vec3& p) { return {p.x, p.y}; }

/// Times counted in steps of 2 %, so that the thousandth part of them can be told without keeping all;
/// nothing is allocated.
class Durations {
 public:
  void add(double seconds) noexcept {
    const double octaves = std::log2(std::max(seconds, kShortest_s) / kShortest_s);
    const auto bin = static_cast<std::size_t>(octaves * kPerOctave);
    ++counts_[std::min(bin, counts_.size() - 1)];
    ++all_;
  }
  /// What `share` of the times do not exceed; 0 where there are none.
  [[nodiscard]] double quantile_s(double share) const {
    std::uint64_t seen = 0;
    for (std::size_t bin = 0; bin < counts_.size(); ++bin) {
      seen += counts_[bin];
      if (all_ > 0 && static_cast<double>(seen) >= share * static_cast<double>(all_))
        return kShortest_s * std::exp2(static_cast<double>(bin + 1) / kPerOctave);
    }
    return 0;
  }

 private:
  static constexpr double kShortest_s = 1e-9;
  static constexpr int kPerOctave = 32;
  std::array<std::uint64_t, 32 * kPerOctave> counts_{};  // up to 4 s
  std::uint64_t all_ = 0;
};

/// Sums over the ticks of one stroke.
struct Sums {
  std::uint64_t ticks = 0;
  std::uint64_t touching = 0;
  std::uint64_t snapped = 0;
  double aim_squared = 0, aim_max = 0;
  double tip_squared = 0, tip_max = 0;
  double force = 0, force_max = 0;
  double depth = 0;
  double traced_m = 0;
  int slips = 0;
};

/// A hand that is not held tightly, and not quite still.
devices::SimulatedHand loose_hand() {
  devices::SimulatedHand hand;
  hand.stiffness_n_m = 120;
  hand.damping_n_s_m = 3;
  hand.tremor_m = 5e-5;
  return hand;
}

/// The eye that watches the hand: sees when the tip has gone astray, into a groove that crosses, and has the
/// hand lift it and put it down again where it should be.
class Sight {
 public:
  /// How much higher than planned the hand wants the tip.
  /// @param off_m  of the tip from the line, seen from above.  @param to_target_m  of the tip from where the
  /// hand wants it, seen from above.  @param tracing  whether a stroke is being traced.
  double lift_m(double off_m, double to_target_m, bool tracing, double elapsed_s) {
    astray_s_ = tracing && off_m > kAstray_m ? astray_s_ + elapsed_s : 0;
    if (!lifting_ && astray_s_ > kReaction_s) {
      lifting_ = true;
      ++slips_;
    }
    if (lifting_ && (to_target_m < kBack_m || !tracing)) lifting_ = false;
    const double step = kSpeed_m_s * elapsed_s;
    lift_ += std::clamp((lifting_ ? kHeight_m : 0.0) - lift_, -step, step);
    return lift_;
  }
  /// Since the last call.
  int take_slips() { return std::exchange(slips_, 0); }

 private:
  static constexpr double kAstray_m = 0.0035;  // beyond the lip of the groove
  static constexpr double kBack_m = 0.0015;
  static constexpr double kReaction_s = 0.2;
  static constexpr double kHeight_m = 0.022;  // from below the deepest groove to above the plateau
  static constexpr double kSpeed_m_s = 0.15;
  double astray_s_ = 0;
  double lift_ = 0;
  bool lifting_ = false;
  int slips_ = 0;
};

/// The hand that feels the tip hang behind, held back by friction, and pulls harder until it comes along; and
/// that leans against its drifting aside, as far as it notices.
class Pull {
 public:
  /// By how much the hand aims beyond its plan, seen from above.
  /// @param wrong_m  from the tip to its place on the line.  @param along  unit vector along the line.
  /// @param piece  another one starts anew: there the pull has another direction.
  Vec3 lead_m(const Vec3& wrong_m, const Vec3& along, int piece, double elapsed_s) {
    if (piece != piece_) ahead_ = aside_ = 0;
    piece_ = piece;
    const Vec3 across{-along.y, along.x, 0};
    const double step = kPerSecond * elapsed_s;
    ahead_ = std::clamp(ahead_ + step * glm::dot(wrong_m, along), 0.0, kMostAhead_m);
    aside_ = std::clamp(aside_ + step * glm::dot(wrong_m, across), -kMostAside_m, kMostAside_m);
    return ahead_ * along + aside_ * across;
  }

 private:
  static constexpr double kPerSecond = 6;
  static constexpr double kMostAhead_m = 0.006;
  static constexpr double kMostAside_m = 0.003;
  double ahead_ = 0;
  double aside_ = 0;
  int piece_ = -1;
};

/// A hand at a device, the servo and what they do to each other. Stands between device and servo: each tick
/// tells the hand where to go, then lets the servo answer.
class Session final : public haptics::ServoCallback {
 public:
  Session(const tablet::CarvedTablet& tablet, const devices::SimulatedHardware& hardware, bool snapping)
      : plan_(tablet.paths(), Habits{}),
        device_(hardware, loose_hand()),
        servo_(device_.describe()),
        rate_hz_(hardware.rate_hz),
        due_times_(1 / hardware.rate_hz) {
    device_.place(plan_.at(0).target_m);
    for (const haptics::StrokePath& path : tablet.paths()) {
      Line line;
      for (const Vec3& p : path.points) line.push_back(from_above(p));
      if (line.empty()) line.push_back({});
      lines_.push_back(std::move(line));
    }
    sums_.resize(lines_.size());
    for (int stroke = 0; stroke <= static_cast<int>(lines_.size()); ++stroke) {
      haptics::Snapping snap;
      snap.enabled = snapping && stroke > 0;
      snap.stroke = stroke;
      scenes_.push_back(tablet.scene(haptics::Material{}, snap));
    }
    attend();
  }

  /// Gives the servo the scene of the stroke that the hand is at, as a learner does who steps through the
  /// strokes. Thread: the one that does not tick, or the same.
  void attend() {
    const int next = next_.load(std::memory_order_relaxed);
    if (next == scene_) return;
    scene_ = next;
    servo_.set_scene(scenes_[static_cast<std::size_t>(next)]);
  }

  /// Neither allocates nor waits.
  haptics::Vec3 tick(const haptics::DeviceSample& sample) noexcept override {
    Intent intent = plan_.at(sample.time_s);
    const TabletPoint aim = from_above(intent.target_m);
    const TabletPoint tip = from_above(servo_.latest().proxy_m);
    const bool tracing = intent.stroke > 0;
    const double off =
        tracing ? geometry::nearest_point<geometry::TabletFrame>(line_of(intent.stroke), tip).distance : 0;
    intent.target_m.z += sight_.lift_m(off, geometry::distance(tip, aim), tracing, 1 / rate_hz_);
    if (tracing) {
      const Vec3 wrong = intent.line_m - servo_.latest().proxy_m;
      intent.target_m += pull_.lead_m(wrong, intent.along, intent.piece, 1 / rate_hz_);
      sums_[static_cast<std::size_t>(intent.stroke) - 1].slips += sight_.take_slips();
    }
    device_.set_target(intent.target_m);
    const auto begin = std::chrono::steady_clock::now();
    const Vec3 force = servo_.tick(sample);
    const double took_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    tick_times_.add(took_s);
    lateness_.add(due_times_.lateness_s(sample.time_s));
    due_times_.ended(sample.time_s + took_s);
    samples_.add(servo_.latest());
    if (tracing) add(intent.stroke, aim, servo_.latest(), force);
    next_.store(intent.next, std::memory_order_relaxed);
    done_.store(sample.time_s / plan_.duration_s(), std::memory_order_relaxed);
    return force;
  }
  [[nodiscard]] std::uint16_t events() const noexcept override { return servo_.events(); }

  [[nodiscard]] devices::SimulatedDevice& device() { return device_; }
  [[nodiscard]] haptics::Servo& servo() { return servo_; }
  [[nodiscard]] bool finished() const { return done() >= 1; }
  /// 0..1 and beyond at the end. Thread-safe: yes.
  [[nodiscard]] double done() const { return done_.load(std::memory_order_relaxed); }

  [[nodiscard]] TabletTrace result() {
    TabletTrace trace;
    for (std::size_t i = 0; i < sums_.size(); ++i)
      trace.strokes.push_back(stroke_trace(static_cast<int>(i) + 1));
    trace.timing = servo_.timing();
    trace.samples = samples_;
    trace.work_on_hand_j = device_.work_j();
    trace.p999_tick_s = tick_times_.quantile_s(0.999);
    trace.p999_lateness_s = lateness_.quantile_s(0.999);
    return trace;
  }

 private:
  [[nodiscard]] const Line& line_of(int stroke) const { return lines_[static_cast<std::size_t>(stroke) - 1]; }

  void add(int stroke, TabletPoint aimed, const haptics::ServoSample& sample, const Vec3& force) {
    Sums& sums = sums_[static_cast<std::size_t>(stroke) - 1];
    const Line& line = line_of(stroke);
    const auto aim = geometry::nearest_point<geometry::TabletFrame>(line, aimed);
    const auto tip = geometry::nearest_point<geometry::TabletFrame>(line, from_above(sample.proxy_m));
    ++sums.ticks;
    sums.touching += sample.touching ? 1 : 0;
    sums.snapped += sample.stroke == stroke ? 1 : 0;
    sums.aim_squared += aim.distance * aim.distance;
    sums.aim_max = std::max(sums.aim_max, aim.distance);
    if (sample.touching) {
      sums.tip_squared += tip.distance * tip.distance;
      sums.tip_max = std::max(sums.tip_max, tip.distance);
      sums.depth -= sample.proxy_m.z;
    }
    const double strength = glm::length(force);
    sums.force += strength;
    sums.force_max = std::max(sums.force_max, strength);
    if (sample.touching && tip.distance < kTraced_m) sums.traced_m = std::max(sums.traced_m, tip.arc_length);
  }

  [[nodiscard]] StrokeTrace stroke_trace(int stroke) const {
    const Sums& sums = sums_[static_cast<std::size_t>(stroke) - 1];
    StrokeTrace trace;
    trace.stroke = stroke;
    trace.length_m = plan_.length_m(stroke);
    trace.duration_s = plan_.tracing_s(stroke);
    if (sums.ticks == 0) return trace;
    const auto ticks = static_cast<double>(sums.ticks);
    const double touching = std::max(1.0, static_cast<double>(sums.touching));
    trace.aim_rms_m = std::sqrt(sums.aim_squared / ticks);
    trace.aim_max_m = sums.aim_max;
    trace.tip_rms_m = std::sqrt(sums.tip_squared / touching);
    trace.tip_max_m = sums.tip_max;
    trace.mean_force_n = sums.force / ticks;
    trace.peak_force_n = sums.force_max;
    trace.contact_share = static_cast<double>(sums.touching) / ticks;
    trace.snapped_share = static_cast<double>(sums.snapped) / ticks;
    trace.slips = sums.slips;
    trace.mean_depth_m = sums.depth / touching;
    trace.traced_share =
        trace.length_m > 0 ? std::min(1.0, sums.traced_m / trace.length_m) : (sums.touching > 0 ? 1.0 : 0.0);
    return trace;
  }

  TracingPlan plan_;
  devices::SimulatedDevice device_;
  haptics::Servo servo_;
  double rate_hz_;
  DueTimes due_times_;
  Sight sight_;
  Pull pull_;
  std::vector<Line> lines_;
  std::vector<Sums> sums_;
  recording::SampleStatistics samples_;
  Durations tick_times_, lateness_;
  std::atomic<double> done_{0};
  std::vector<std::shared_ptr<const haptics::HapticScene>> scenes_;  // [n]: stroke n is the current one
  std::atomic<int> next_{0};
  int scene_ = -1;
};

base::Error stopped() { return {base::Errc::cancelled, "stopped", "demo", ""}; }

/// Records a servo into a file beside the one that was asked for, so that this one appears whole or stays as
/// it was.
class RecordingBeside {
 public:
  static base::Result<std::unique_ptr<RecordingBeside>> start(haptics::Servo& servo, const Record& record,
                                                              recording::Session about) {
    std::unique_ptr<RecordingBeside> beside(new RecordingBeside(record.path));
    about.character = record.character;
    auto started = recording::SessionRecorder::start(servo, beside->beside_, std::move(about));
    if (!started) return tl::unexpected(std::move(started.error()));
    beside->recorder_ = std::move(*started);
    return beside;
  }

  void wait_for_room() { recorder_->wait_for_room(); }

  /// Puts the recording in place. Not called, there is none.
  base::Result<void> finish(const base::Progress& progress) {
    auto done = put_in_place(progress);
    // The file beside is gone soon, and nobody has heard of it.
    if (!done && done.error().where == beside_.string()) done.error().where = path_.string();
    return done;
  }

 private:
  explicit RecordingBeside(const std::filesystem::path& path)
      : path_(path),
        beside_(fmt::format("{}.{}{}", path.string(), ::getpid(), recording::kRecordingExtension)),
        unfinished_(beside_) {}

  base::Result<void> put_in_place(const base::Progress& progress) {
    if (auto ended = recorder_->finish(); !ended) return tl::unexpected(std::move(ended.error()));
    if (!has_extension(path_, recording::kRecordingExtension)) {
      const auto exported = recording::export_csv(beside_, path_, progress);
      return exported ? base::Result<void>() : tl::unexpected(exported.error());
    }
    std::error_code error;
    std::filesystem::rename(beside_, path_, error);
    if (error) return base::fail(base::Errc::io, "cannot be written: " + error.message(), path_.string());
    unfinished_.finish();
    return {};
  }

  std::filesystem::path path_;
  std::filesystem::path beside_;
  base::UnfinishedFile unfinished_;  // goes after the recorder, which writes the file to its end
  std::unique_ptr<recording::SessionRecorder> recorder_;
};

}  // namespace

base::Result<TabletTrace> trace(const tablet::CarvedTablet& tablet,
                                const devices::SimulatedHardware& hardware, bool snapping, Pace pace,
                                const std::optional<Record>& record, const base::Progress& progress) {
  Session session(tablet, hardware, snapping);
  devices::SimulatedDevice& device = session.device();
  std::unique_ptr<RecordingBeside> recorder;
  if (record) {
    recording::Session about;
    about.device = device.describe();
    about.shape = tablet.shape();
    auto started = RecordingBeside::start(session.servo(), *record, std::move(about));
    if (!started) return tl::unexpected(std::move(started.error()));
    recorder = std::move(*started);
  }

  devices::ClockStatus clock;
  bool go_on = true;
  if (pace == Pace::fast) {
    constexpr std::uint64_t kBetweenProgress = 256;
    for (std::uint64_t tick = 0; go_on && !session.finished(); ++tick) {
      (void)device.step(session);
      session.attend();
      if (tick % kBetweenProgress != 0) continue;
      if (recorder) recorder->wait_for_room();
      go_on = progress(session.done(), "tracing");
    }
  } else {
    if (auto started = device.start(session); !started) return tl::unexpected(std::move(started.error()));
    while (go_on && !session.finished()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      session.attend();
      go_on = progress(std::min(session.done(), 1.0), "tracing");
    }
    clock = device.clock();
    device.stop();
  }
  if (!go_on) return tl::unexpected(stopped());
  if (recorder) {
    const auto exporting = [&progress](double, std::string_view step) { return progress(1, step); };
    if (auto ended = recorder->finish(exporting); !ended) return tl::unexpected(std::move(ended.error()));
  }
  TabletTrace result = session.result();
  result.clock = clock;
  return result;
}

}  // namespace nazori::cli
