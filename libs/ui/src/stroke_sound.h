// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <memory>
#include <span>

#include "nazori/audio/groove_sound.h"
#include "nazori/audio/output.h"
#include "nazori/base/result.h"
#include "nazori/geometry/frames.h"
#include "nazori/haptics/servo.h"

namespace nazori::ui {

/// How the stylus moves, for the ear. @param before,now  two samples of one servo. A stroke is where the
/// surface lies lower than the plateau by a tenth of the tablet's depth.
[[nodiscard]] audio::GrooveMotion groove_motion(const haptics::ServoSample& before,
                                                const haptics::ServoSample& now,
                                                const geometry::TabletShape& shape);

/// The scratch of the stylus through the loudspeakers, while it is wanted. The sound card is opened when it
/// is wanted first. Thread: interface.
class StrokeSound final : public QObject {
  Q_OBJECT
 public:
  explicit StrokeSound(QObject* parent = nullptr);
  ~StrokeSound() override;

  void set_on(bool on);
  [[nodiscard]] bool is_on() const { return on_; }
  /// 0..1
  void set_volume(double volume);
  void follow(std::span<const haptics::ServoSample> samples, const geometry::TabletShape& shape);

 signals:
  /// There is no sound card; told once, and everything else goes on.
  void failed(nazori::base::Error error);

 private:
  bool on_ = false;
  bool told_ = false;
  haptics::ServoSample last_;
  audio::GrooveSound sound_;
  std::unique_ptr<audio::Output> output_;  // last: it goes before what it asks
};

}  // namespace nazori::ui
