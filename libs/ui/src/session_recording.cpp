// SPDX-License-Identifier: Apache-2.0
#include "session_recording.h"

#include <QFile>
#include <QFileInfo>
#include <QSettings>
#include <filesystem>
#include <utility>

#include "nazori/devices/tablet_device.h"
#include "signals.h"

namespace nazori::ui {
namespace {

const QString kKey = QStringLiteral("recording/unfinished");

std::filesystem::path to_path(const QString& text) { return {text.toStdString()}; }

bool is_csv(const QString& path) { return path.endsWith(QLatin1String(".csv")); }

/// What is recorded into: a table is written from it when it is finished.
QString raw_of(const QString& path) { return is_csv(path) ? path + QStringLiteral(".nzr") : path; }

/// "session.nzr" is followed by "session-2.nzr".
QString numbered(const QString& path, qsizetype number) {
  const QFileInfo info(path);
  return info.path() +
         QStringLiteral("/%1-%2.%3").arg(info.completeBaseName()).arg(number).arg(info.suffix());
}

}  // namespace

SessionRecording::SessionRecording(devices::TabletDevice& stylus, QString settings_file, QObject* parent)
    : QObject(parent), stylus_(stylus), settings_file_(std::move(settings_file)) {
  subscribe(stylus_.leaving, this, [this] {
    if (!recorder_) return;
    going_on_ = true;
    if (const auto closed = close(); !closed) emit failed(path_, closed.error());
  });
  watch_.setInterval(1000);
  connect(&watch_, &QTimer::timeout, this, [this] {
    if (!recorder_ || recorder_->status().error.what.empty()) return;
    const QString path = path_;
    if (const auto ended = finish(); !ended) emit failed(path, ended.error());
  });
  subscribe(stylus_.changed, this, [this] { move_on(); });
}

SessionRecording::~SessionRecording() {
  leaving_ = true;
  if (recorder_) (void)close();
}

base::Result<void> SessionRecording::start(const QString& path, const QString& character,
                                           const geometry::TabletShape& shape) {
  if (recorder_) {
    const QString before = path_;
    if (const auto ended = finish(); !ended) emit failed(before, ended.error());
  }
  session_.character = character.toStdString();
  session_.shape = shape;
  first_path_ = path;
  auto begun = begin(path);
  emit changed();
  return begun;
}

base::Result<void> SessionRecording::begin(const QString& path) {
  session_.device = stylus_.describe();
  auto recorder = recording::SessionRecorder::start(stylus_.servo(), to_path(path), session_);
  if (!recorder) return tl::unexpected(std::move(recorder.error()));
  recorder_ = std::move(*recorder);
  stylus_.set_awake(true);
  watch_.start();
  path_ = path;
  written_.append(path);
  remember(path);
  return {};
}

base::Result<void> SessionRecording::close() {
  auto finished = recorder_->close();
  recorder_.reset();
  stylus_.set_awake(false);
  if (!finished) return tl::unexpected(std::move(finished.error()));
  if (is_csv(path_))
    export_table(path_);
  else
    forget(path_);
  return {};
}

void SessionRecording::export_table(const QString& path) {
  ++exports_;
  worker_.post([this, path] {
    int told_percent = -1;
    const auto progress = [&](double done, std::string_view) {
      if (const int percent = static_cast<int>(100 * done); std::exchange(told_percent, percent) != percent)
        worker_.answer([this, path, done] { emit export_came_along(path, done); });
      return !leaving_;
    };
    auto result = recording::export_csv(to_path(raw_of(path)), to_path(path), progress);
    worker_.answer([this, path, result = std::move(result)] {
      --exports_;
      if (result) {
        QFile::remove(raw_of(path));
        forget(path);
        emit exported(path);
      } else {
        emit failed(path, result.error());  // the next start tries again
      }
      emit changed();
    });
  });
}

void SessionRecording::move_on() {
  if (!std::exchange(going_on_, false)) return;
  const QString path = numbered(first_path_, written_.size() + 1);
  if (const auto begun = begin(path); !begun)
    emit failed(path, begun.error());
  else
    emit moved_on(path);
  emit changed();
}

base::Result<QStringList> SessionRecording::finish() {
  QStringList written = std::exchange(written_, {});
  if (!recorder_) return written;
  auto closed = close();
  emit changed();
  if (!closed) return tl::unexpected(std::move(closed.error()));
  return written;
}

recording::RecorderStatus SessionRecording::status() const {
  return recorder_ ? recorder_->status() : recording::RecorderStatus{};
}

void SessionRecording::remember(const QString& path) const {
  QSettings settings(settings_file_, QSettings::IniFormat);
  QStringList files = settings.value(kKey).toStringList();
  if (!files.contains(path)) files.append(path);
  settings.setValue(kKey, files);
}

void SessionRecording::forget(const QString& path) const {
  QSettings settings(settings_file_, QSettings::IniFormat);
  QStringList files = settings.value(kKey).toStringList();
  files.removeAll(path);
  if (files.isEmpty())
    settings.remove(kKey);
  else
    settings.setValue(kKey, files);
}

void SessionRecording::recover() {
  const QStringList files = QSettings(settings_file_, QSettings::IniFormat).value(kKey).toStringList();
  for (const auto& path : files) {
    worker_.post([this, path] {
      if (leaving_) return;
      const auto result = recording::recover(to_path(raw_of(path)));
      worker_.answer([this, path, result] {
        // Another window is recording into it.
        if (result && *result == recording::Recovery::in_progress) return;
        if (!result || !is_csv(path)) forget(path);
        if (!result) {
          // Moved or removed since: nothing to say.
          if (result.error().code != base::Errc::not_found) emit failed(path, result.error());
          return;
        }
        emit recovered(*result == recording::Recovery::nothing_left ? Recovered{{}, {path}}
                                                                    : Recovered{{path}, {}});
        if (is_csv(path)) export_table(path);
      });
    });
  }
}

}  // namespace nazori::ui
