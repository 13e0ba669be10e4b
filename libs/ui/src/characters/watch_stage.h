// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QTimer>

#include "characters/character_stage.h"
#include "nazori/practice/stroke_player.h"

class QLabel;

namespace nazori::ui {

/// A brush writes the character at a teacher's speed, and says what each stroke is called and how it ends.
class WatchStage final : public CharacterStage {
  Q_OBJECT
 public:
  WatchStage(Desk& desk, CharacterActions& actions);
  [[nodiscard]] QList<QAction*> own_actions() const override;
  [[nodiscard]] QList<Tool> tools() const override;

  /// Goes to a moment of the writing, as a timer does [s]. For tests, too.
  void show_moment(double time_s);
  [[nodiscard]] const practice::StrokePlayer& player() const { return player_; }

 protected:
  void begin() override;
  void end() override;

 private:
  void set_playing(bool playing);
  void step(int by);
  void change_speed(double factor);
  void advance();
  void tell_stroke(int stroke);
  void show_place();

  practice::StrokePlayer player_;
  QLabel* place_label_;
  QAction* place_;
  QTimer timer_;
  QElapsedTimer since_;
  double time_s_ = 0;
  double speed_ = 1;
  int told_ = 0;  ///< stroke last spoken of
};

}  // namespace nazori::ui
