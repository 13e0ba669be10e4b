// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/parts/key_writing.h"

#include <QApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/words/error_text.h"

namespace nazori::ui {
namespace {

using practice::KeyPenDid;

constexpr int kHeard_ms = 220;  ///< how long a step is heard

struct Direction {
  int right, up;
};

/// Arrow keys, and the keys of a number pad with and without NumLock.
std::optional<Direction> direction_of(const QKeyEvent& key) {
  const bool pad = key.modifiers().testFlag(Qt::KeypadModifier);
  switch (key.key()) {
    case Qt::Key_Left:
      return Direction{-1, 0};
    case Qt::Key_Right:
      return Direction{1, 0};
    case Qt::Key_Up:
      return Direction{0, 1};
    case Qt::Key_Down:
      return Direction{0, -1};
    default:
      break;
  }
  if (!pad) return {};
  switch (key.key()) {
    case Qt::Key_1:
    case Qt::Key_End:
      return Direction{-1, -1};
    case Qt::Key_2:
      return Direction{0, -1};
    case Qt::Key_3:
    case Qt::Key_PageDown:
      return Direction{1, -1};
    case Qt::Key_4:
      return Direction{-1, 0};
    case Qt::Key_6:
      return Direction{1, 0};
    case Qt::Key_7:
    case Qt::Key_Home:
      return Direction{-1, 1};
    case Qt::Key_8:
      return Direction{0, 1};
    case Qt::Key_9:
    case Qt::Key_PageUp:
      return Direction{1, 1};
    default:
      return {};
  }
}

bool is_middle_of_pad(const QKeyEvent& key) {
  return key.modifiers().testFlag(Qt::KeypadModifier) &&
         (key.key() == Qt::Key_5 || key.key() == Qt::Key_Clear);
}

int percent(double share) { return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * 100)); }

}  // namespace

QString key_pen_words(const practice::KeyPenEvent& event) {
  const int stroke = event.place.stroke;
  switch (event.did) {
    case KeyPenDid::moved:
      return {};
    case KeyPenDid::met_stroke:
      return KeyWriting::tr("Stroke %1.").arg(stroke);
    case KeyPenDid::at_start:
      return KeyWriting::tr("Start of stroke %1.").arg(stroke);
    case KeyPenDid::at_end:
      return KeyWriting::tr("End of stroke %1.").arg(stroke);
    case KeyPenDid::left_stroke:
      return KeyWriting::tr("Beside stroke %1.").arg(event.left);
    case KeyPenDid::at_border:
      return KeyWriting::tr("This is the edge.");
    case KeyPenDid::put_down:
      return KeyWriting::tr("Pen down.");
    case KeyPenDid::lifted:
      return KeyWriting::tr("Pen up.");
    case KeyPenDid::no_strokes:
      return KeyWriting::tr("There are no strokes to go to.");
  }
  return {};
}

QString key_pen_words(const practice::KeyPenPlace& place) {
  const QString where = KeyWriting::tr("%1% from the left, %2% from the top.")
                            .arg(percent(place.from_left))
                            .arg(percent(place.from_top));
  if (place.stroke == 0) return KeyWriting::tr("No stroke here: %1").arg(where);
  return KeyWriting::tr("Stroke %1, %2% of its length: %3")
      .arg(place.stroke)
      .arg(percent(place.along))
      .arg(where);
}

KeyWriting::KeyWriting(WindowParts& parts, practice::KeyPenGround& ground, const KeyPenActions& actions,
                       std::function<bool(const QObject*)> has_ground, QObject* parent)
    : QObject(parent), parts_(parts), actions_(actions), has_ground_(std::move(has_ground)), pen_(ground) {
  silence_.setSingleShot(true);
  silence_.setInterval(kHeard_ms);
  connect(&silence_, &QTimer::timeout, this, [this] { sound_.touch({}); });
  sound_.on_failure([this](const base::Error& error) { parts_.announce(Feedback::advice, no_sound(error)); });
  connect(actions_.on, &QAction::triggered, this, &KeyWriting::switch_on);
  connect(actions_.press, &QAction::triggered, this, [this] { answer(pen_.press()); });
  connect(actions_.next_start, &QAction::triggered, this, [this] { answer(pen_.go_to_next_start()); });
  connect(actions_.where, &QAction::triggered, this,
          [this] { parts_.respond(Feedback::hint, key_pen_words(pen_.where())); });
  show_actions();
}

void KeyWriting::switch_on(bool on) {
  if (on) {
    (void)pen_.begin();
    QCoreApplication::instance()->installEventFilter(this);
    emit parts_.focus_tablet();
    const auto key = [](const QAction* action) {
      return action->shortcut().toString(QKeySequence::NativeText);
    };
    parts_.respond(
        Feedback::hint,
        tr("The keys move the pen. Arrow keys: move. %1: pen down or up. %2: next start. %3: where.")
            .arg(key(actions_.press), key(actions_.next_start), key(actions_.where)));
  } else {
    end();
    parts_.respond(Feedback::hint, tr("The keys no longer move the pen."));
  }
  show_actions();
}

void KeyWriting::end() {
  pen_.end();
  QCoreApplication::instance()->removeEventFilter(this);
  silence_.stop();
  sound_.stop();
  actions_.on->setChecked(false);
  show_actions();
}

void KeyWriting::show_actions() {
  for (auto* action : {actions_.press, actions_.next_start, actions_.where})
    action->setEnabled(pen_.is_in_use());
}

void KeyWriting::answer(const practice::KeyPenEvent& event) {
  const functions::Cue cue = practice::cue_of(event.place);
  sound_.touch(cue);
  silence_.start();
  if (event.did == KeyPenDid::at_start) sound_.sign(functions::PointKind::zero, cue.pan);
  if (event.did == KeyPenDid::at_end) sound_.sign(functions::PointKind::end, cue.pan);
  if (const QString words = key_pen_words(event); !words.isEmpty()) parts_.respond(Feedback::hint, words);
}

bool KeyWriting::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
  if (!pen_.is_in_use() || !has_ground_(watched)) return false;
  if (QApplication::activeModalWidget() != nullptr || QApplication::activePopupWidget() != nullptr)
    return false;
  const auto& key = *static_cast<QKeyEvent*>(event);
  // With Ctrl and Alt, arrow keys turn the view and go back and forth.
  if ((key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != Qt::NoModifier) return false;
  const auto direction = direction_of(key);
  if (!direction && !is_middle_of_pad(key)) return false;
  if (event->type() == QEvent::KeyPress)
    answer(direction ? pen_.step(direction->right, direction->up, key.modifiers().testFlag(Qt::ShiftModifier))
                     : pen_.press());
  event->accept();
  return true;
}

}  // namespace nazori::ui
