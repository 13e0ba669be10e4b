// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <atomic>
#include <memory>

#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/recording/session_recorder.h"
#include "worker.h"

namespace nazori::devices {
class TabletDevice;
}  // namespace nazori::devices

namespace nazori::ui {

/// Records every moment of feeling to a file, whatever device has the tablet. Another device goes on in a
/// file of its own, numbered, because a recording says of which device it is. Which file is being written is
/// kept in the settings, so that the next start can complete it after a crash. Tables are written and broken
/// recordings completed on a thread of its own. Thread: interface.
class SessionRecording final : public QObject {
  Q_OBJECT
 public:
  SessionRecording(devices::TabletDevice& stylus, QString settings_file, QObject* parent = nullptr);
  ~SessionRecording() override;

  /// @param path  .nzr or .csv. @param character  what lies on the desk.
  [[nodiscard]] base::Result<void> start(const QString& path, const QString& character,
                                         const geometry::TabletShape& shape);
  /// @return the files that were recorded; the error of the last. A table follows with exported().
  base::Result<QStringList> finish();
  /// Whether a table is being written. One that the window does not wait for is written by the next start.
  [[nodiscard]] bool is_exporting() const { return exports_ > 0; }
  [[nodiscard]] bool is_on() const { return recorder_ != nullptr; }
  /// The file that is being written.
  [[nodiscard]] const QString& path() const { return path_; }
  [[nodiscard]] recording::RecorderStatus status() const;

  /// What a program that died has left unfinished, completed.
  struct Recovered {
    QStringList files;   ///< complete to the last moment
    QStringList broken;  ///< end before the last moment: the computer was restarted
  };
  /// Completes it; recovered() answers where there was something.
  void recover();

 signals:
  void changed();
  void recovered(const nazori::ui::SessionRecording::Recovered& found);
  /// How much of a table is written, 0..1.
  void export_came_along(QString path, double done);
  /// A table is written whole.
  void exported(QString path);
  /// Recording goes on in another file, with another device.
  void moved_on(QString path);
  void failed(QString path, nazori::base::Error error);

 private:
  base::Result<void> begin(const QString& path);
  base::Result<void> close();
  void export_table(const QString& path);
  void move_on();
  void remember(const QString& path) const;
  void forget(const QString& path) const;

  devices::TabletDevice& stylus_;
  QString settings_file_;
  QString first_path_;
  QString path_;
  QStringList written_;
  recording::Session session_;
  QTimer watch_;           ///< for a full disk
  bool going_on_ = false;  ///< between two devices
  int exports_ = 0;        ///< tables that are being written
  std::unique_ptr<recording::SessionRecorder> recorder_;
  std::atomic<bool> leaving_{false};
  Worker worker_{QStringLiteral("recordings")};  // last: stops before what it uses goes
};

}  // namespace nazori::ui
