// SPDX-License-Identifier: Apache-2.0
#include "nazori/practice/tablet_recording.h"

#include <algorithm>
#include <utility>

namespace nazori::practice {
namespace {

using Path = std::filesystem::path;

bool is_csv(const Path& path) { return path.extension() == ".csv"; }

/// The recording itself: a table is written from it when it is finished.
Path raw_of(const Path& path) { return is_csv(path) ? Path(path.string() + ".nzr") : path; }

/// "session.nzr" is followed by "session-2.nzr".
Path numbered(const Path& path, std::size_t number) {
  return path.parent_path() /
         (path.stem().string() + "-" + std::to_string(number) + path.extension().string());
}

}  // namespace

TabletRecording::TabletRecording(base::Inbox& inbox, devices::TabletDevice& device,
                                 UnfinishedFiles unfinished)
    : device_(device),
      unfinished_(std::move(unfinished)),
      leaving_(device.leaving.connect([this] {
        if (!recorder_) return;
        is_between_devices_ = true;
        if (const auto closed = close(); !closed) failed(path_, closed.error());
      })),
      changed_(device.changed.connect([this] { move_on(); })),
      background_("recordings", inbox) {}

TabletRecording::~TabletRecording() {
  is_ending_ = true;
  if (recorder_) (void)close();
}

void TabletRecording::tick() {
  if (!recorder_ || recorder_->status().error.what.empty()) return;
  const Path path = path_;
  if (const auto ended = finish(); !ended) failed(path, ended.error());
}

base::Result<void> TabletRecording::start(const Path& path, const std::string& character,
                                          const geometry::TabletShape& shape, double tip_radius_m) {
  if (recorder_) {
    const Path before = path_;
    if (const auto ended = finish(); !ended) failed(before, ended.error());
  }
  session_.character = character;
  session_.shape = shape;
  session_.tip_radius_m = tip_radius_m;
  first_path_ = path;
  auto begun = begin(path);
  changed();
  return begun;
}

base::Result<void> TabletRecording::begin(const Path& path) {
  session_.device = device_.describe();
  auto recorder = recording::SessionRecorder::start(device_.servo(), path, session_);
  if (!recorder) return tl::unexpected(std::move(recorder.error()));
  recorder_ = std::move(*recorder);
  device_.set_awake(true);
  path_ = path;
  written_.push_back(path);
  remember(path);
  return {};
}

base::Result<void> TabletRecording::close() {
  auto finished = recorder_->close();
  recorder_.reset();
  device_.set_awake(false);
  if (!finished) return tl::unexpected(std::move(finished.error()));
  if (is_csv(path_))
    export_table(path_);
  else
    forget(path_);
  return {};
}

void TabletRecording::export_table(const Path& path) {
  ++exports_;
  background_.post([this, path] {
    int reported_percent = -1;
    const auto progress = [&](double done, std::string_view) {
      if (const int percent = static_cast<int>(100 * done);
          std::exchange(reported_percent, percent) != percent)
        background_.answer([this, path, done] { export_progressed(path, done); });
      return !is_ending_;
    };
    auto result = recording::export_csv(raw_of(path), path, progress);
    background_.answer([this, path, result = std::move(result)] { finish_export(path, result); });
  });
}

void TabletRecording::finish_export(const Path& path, const base::Result<recording::RecordingEnd>& result) {
  --exports_;
  if (result) {
    std::error_code ignored;
    std::filesystem::remove(raw_of(path), ignored);
    forget(path);
    exported(path);
  } else {
    failed(path, result.error());  // tried again at the next start
  }
  changed();
}

void TabletRecording::move_on() {
  if (!std::exchange(is_between_devices_, false)) return;
  const Path path = numbered(first_path_, written_.size() + 1);
  if (const auto begun = begin(path); !begun)
    failed(path, begun.error());
  else
    moved_on(path);
  changed();
}

base::Result<std::vector<Path>> TabletRecording::finish() {
  std::vector<Path> written = std::exchange(written_, {});
  if (!recorder_) return written;
  auto closed = close();
  changed();
  if (!closed) return tl::unexpected(std::move(closed.error()));
  return written;
}

recording::RecorderStatus TabletRecording::status() const {
  return recorder_ ? recorder_->status() : recording::RecorderStatus{};
}

void TabletRecording::remember(const Path& path) const {
  auto files = unfinished_.read();
  if (std::find(files.begin(), files.end(), path.string()) == files.end()) files.push_back(path.string());
  unfinished_.write(files);
}

void TabletRecording::forget(const Path& path) const {
  auto files = unfinished_.read();
  std::erase(files, path.string());
  unfinished_.write(files);
}

void TabletRecording::recover() {
  for (const auto& file : unfinished_.read()) recover_file(file);
}

void TabletRecording::recover_file(const Path& path) {
  background_.post([this, path] {
    if (is_ending_) return;
    auto result = recording::recover(raw_of(path));
    background_.answer([this, path, result = std::move(result)] { finish_recovery(path, result); });
  });
}

void TabletRecording::finish_recovery(const Path& path, const base::Result<recording::Recovery>& result) {
  // Another window is recording into it.
  if (result && *result == recording::Recovery::in_progress) return;
  if (!result || !is_csv(path)) forget(path);
  if (!result) {
    // A file that was moved or removed since needs no report.
    if (result.error().code != base::Errc::not_found) failed(path, result.error());
    return;
  }
  recovered(*result == recording::Recovery::nothing_left ? Recovered{{}, {path}} : Recovered{{path}, {}});
  if (is_csv(path)) export_table(path);
}

}  // namespace nazori::practice
