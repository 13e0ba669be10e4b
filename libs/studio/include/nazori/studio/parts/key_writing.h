// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QAction>
#include <QObject>
#include <QTimer>
#include <functional>

#include "nazori/audio/plot_sound.h"
#include "nazori/practice/key_pen.h"

namespace nazori::ui {

class WindowParts;

/// The actions of a pen that is moved by key.
struct KeyPenActions {
  QAction* on;          ///< checkable: the keys move the pen
  QAction* press;       ///< puts it down or lifts it
  QAction* next_start;  ///< to the start of the next stroke
  QAction* where;       ///< says where it is
};

/// The sentence for what a key did to the pen; empty for a step that needs none.
[[nodiscard]] QString key_pen_words(const practice::KeyPenEvent& event);
/// The sentence for where the pen is.
[[nodiscard]] QString key_pen_words(const practice::KeyPenPlace& place);

/// The pen that is moved by key, in the window: its keys while the tablet or the sheet has the keyboard, what
/// is said and what is heard. Arrow keys move it, with Shift in fine steps; the number pad moves it
/// diagonally, too, and its 5 puts the pen down. Thread: interface.
class KeyWriting final : public QObject {
  Q_OBJECT
 public:
  /// @param ground  outlives this. @param has_ground  whether a widget is the one that shows the ground.
  KeyWriting(WindowParts& parts, practice::KeyPenGround& ground, const KeyPenActions& actions,
             std::function<bool(const QObject*)> has_ground, QObject* parent);

  /// Ends it, as when the page is left.
  void end();
  [[nodiscard]] bool is_on() const { return pen_.is_in_use(); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void switch_on(bool on);
  void show_actions();
  void answer(const practice::KeyPenEvent& event);

  WindowParts& parts_;
  KeyPenActions actions_;
  std::function<bool(const QObject*)> has_ground_;
  practice::KeyPen pen_;
  audio::PlotSound sound_;
  QTimer silence_;
};

}  // namespace nazori::ui
