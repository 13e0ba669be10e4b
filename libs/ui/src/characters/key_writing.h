// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QTimer>

#include "nazori/audio/plot_sound.h"
#include "nazori/practice/key_pen.h"

namespace nazori::ui {

class CharacterActions;
class WindowParts;

/// The sentence for what a key did to the pen; empty for a step that needs none.
[[nodiscard]] QString key_pen_words(const practice::KeyPenEvent& event);
/// The sentence for where the pen is.
[[nodiscard]] QString key_pen_words(const practice::KeyPenPlace& place);

/// The pen that is moved by key, in the window: its keys while the tablet has the keyboard, what is said and
/// what is heard. Arrow keys move it, with Shift in fine steps; the number pad moves it diagonally, too, and
/// its 5 puts the pen down. Thread: interface.
class KeyWriting final : public QObject {
  Q_OBJECT
 public:
  KeyWriting(WindowParts& parts, CharacterActions& actions, QObject* parent);

  /// Ends it, as when the page is left.
  void end();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void switch_on(bool on);
  void show_actions();
  void answer(const practice::KeyPenEvent& event);

  WindowParts& parts_;
  CharacterActions& actions_;
  practice::KeyPen pen_;
  audio::PlotSound sound_;
  QTimer silence_;
};

}  // namespace nazori::ui
