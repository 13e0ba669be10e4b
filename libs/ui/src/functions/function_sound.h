// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>

#include "nazori/audio/output.h"
#include "nazori/functions/tone_generator.h"

namespace nazori::ui {

/// What is heard of a plot: the tone under the hand, the signs of points of interest, and the sweep of whole
/// curves, with one volume. The sound card is opened when the first sound is wanted; where there is none that
/// is said once and all else goes on. Thread: interface.
class FunctionSound final : public QObject {
  Q_OBJECT
 public:
  explicit FunctionSound(QObject* parent = nullptr);
  ~FunctionSound() override;

  /// 0 to 100.
  void set_volume(int percent);
  [[nodiscard]] int volume() const { return volume_; }
  void set_muted(bool muted);
  [[nodiscard]] bool muted() const { return muted_; }

  /// What is under the hand, until the next call. A loudness of 0 is silence.
  void touch(const functions::Cue& cue, bool trembles = false);
  /// The same for a moment: a step by key.
  void touch_briefly(const functions::Cue& cue);
  void sign(functions::PointKind kind, double pan);
  void play(functions::Sound sound);
  /// Every sound.
  void stop();
  [[nodiscard]] bool is_playing() const;
  /// The computer has refused to play: there is nothing to be heard before the next start.
  [[nodiscard]] bool is_refused() const { return refused_; }

 signals:
  void unavailable(nazori::base::Error error);

 private:
  class Heard;
  [[nodiscard]] bool ready();

  int volume_ = 50;
  bool muted_ = false;
  bool refused_ = false;
  QTimer brief_;
  std::unique_ptr<Heard> heard_;
  std::unique_ptr<audio::Output> output_;  // last: goes before what it asks
};

}  // namespace nazori::ui
