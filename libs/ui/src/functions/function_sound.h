// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

#include "nazori/audio/plot_sound.h"

namespace nazori::ui {

/// audio::PlotSound in the window: a step by key is heard for a moment, and a signal says that there is no
/// sound card. Thread: interface.
class FunctionSound final : public QObject {
  Q_OBJECT
 public:
  explicit FunctionSound(QObject* parent = nullptr);

  /// 0 to 100.
  void set_volume(int percent) { sound_.set_volume(percent); }
  [[nodiscard]] int volume() const { return sound_.volume(); }
  void set_muted(bool muted) { sound_.set_muted(muted); }
  [[nodiscard]] bool muted() const { return sound_.muted(); }

  /// Plays the tone at the position of the hand, until the next call. A loudness of 0 is silence.
  void touch(const functions::Cue& cue, bool trembles = false);
  /// Plays the tone for a moment: a step by key.
  void touch_briefly(const functions::Cue& cue);
  void sign(functions::PointKind kind, double pan) { sound_.sign(kind, pan); }
  void play(functions::Sound sound) { sound_.play(std::move(sound)); }
  /// Stops every sound.
  void stop();
  [[nodiscard]] bool is_playing() const;
  /// The computer refused to play. There is no sound until the next start.
  [[nodiscard]] bool is_refused() const { return sound_.is_refused(); }

 signals:
  void unavailable(nazori::base::Error error);

 private:
  QTimer brief_;
  audio::PlotSound sound_;
};

}  // namespace nazori::ui
