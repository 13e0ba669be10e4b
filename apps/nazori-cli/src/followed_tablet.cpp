// SPDX-License-Identifier: Apache-2.0
#include "followed_tablet.h"

#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "nazori/base/unfinished_file.h"
#include "nazori/recording/session_recorder.h"
#include "options.h"

namespace nazori::cli {
namespace {

/// The scene of each stroke, and at [0] the one in which none is followed.
std::vector<std::shared_ptr<const haptics::HapticScene>> scenes_of(const tablet::CarvedTablet& tablet,
                                                                   bool snapping) {
  std::vector<std::shared_ptr<const haptics::HapticScene>> scenes;
  for (int stroke = 0; stroke <= static_cast<int>(tablet.paths().size()); ++stroke) {
    haptics::Snapping snap;
    snap.enabled = snapping && stroke > 0;
    snap.stroke = stroke;
    scenes.push_back(tablet.scene(haptics::Material{}, snap));
  }
  return scenes;
}

class StatisticsObserver final : public devices::HandObserver {
 public:
  void see(const haptics::ServoSample& sample) noexcept override { samples.add(sample); }
  recording::SampleStatistics samples;
};

base::Error stopped() { return {base::Errc::cancelled, "stopped", "demo", ""}; }

/// Records a servo into a temporary file in the folder of the requested one, so that this one appears
/// complete or is unchanged.
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

  /// Renames the recording to its final name. If it is not called, there is no recording.
  base::Result<void> finish(const base::Progress& progress) {
    auto done = put_in_place(progress);
    // The temporary file will be removed, and its name was never reported.
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
  base::UnfinishedFile unfinished_;  // destroyed after the recorder, which writes the end of the file
  std::unique_ptr<recording::SessionRecorder> recorder_;
};

}  // namespace

base::Result<FollowedTablet> follow_strokes(const tablet::CarvedTablet& tablet,
                                            const devices::SimulatedHardware& hardware, bool snapping,
                                            devices::HandClock clock, const std::optional<Record>& record,
                                            const base::Progress& progress) {
  StatisticsObserver statistics;
  devices::SimulatedHand hand(tablet.paths(), scenes_of(tablet, snapping), hardware, &statistics);
  std::unique_ptr<RecordingBeside> recorder;
  if (record) {
    recording::Session about;
    about.device = hand.describe();
    about.shape = tablet.shape();
    about.tip_radius_m = tablet.tip_radius_m();
    auto started = RecordingBeside::start(hand.servo(), *record, std::move(about));
    if (!started) return tl::unexpected(std::move(started.error()));
    recorder = std::move(*started);
  }

  const auto ended = hand.run(clock, [&](double done, std::string_view step) {
    // The clock thread never waits for the recorder.
    if (recorder && clock == devices::HandClock::none) recorder->wait_for_room();
    return progress(done, step);
  });
  if (!ended) return tl::unexpected(ended.error().code == base::Errc::cancelled ? stopped() : ended.error());
  if (recorder) {
    const auto exporting = [&progress](double, std::string_view step) { return progress(1, step); };
    if (auto finished = recorder->finish(exporting); !finished)
      return tl::unexpected(std::move(finished.error()));
  }
  return FollowedTablet{hand.report(), statistics.samples};
}

}  // namespace nazori::cli
