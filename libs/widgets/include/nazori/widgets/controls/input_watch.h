// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

namespace nazori::ui {

/// Notices whether the learner points with a mouse, a pen or a finger: it looks at all input of the program.
/// Thread: interface.
class InputWatch final : public QObject {
  Q_OBJECT
 public:
  enum class Kind : std::uint8_t { mouse, pen, finger };

  /// That of the program, made with the first call.
  [[nodiscard]] static InputWatch& of_program();

  [[nodiscard]] Kind kind() const { return kind_; }
  /// Whether a mouse button puts the tip on the tablet: false for a pen, a finger and a device. It is also
  /// false until something has pointed: someone who writes with keys has no button to hold.
  [[nodiscard]] bool writes_with_button() const {
    return has_pointed_ && !has_device_ && kind_ == Kind::mouse;
  }
  /// @param has_device  whether a device drives the tablet in place of the pointer.
  void set_has_device(bool has_device) { has_device_ = has_device; }
  /// What the learner writes with, in one sentence. @param device  that drives the tablet in place of the
  /// pointer; empty: none.
  [[nodiscard]] QString sentence(const QString& device) const;
  /// The same of the pointer, as long as there is room: the sentence, its beginning, or one word.
  [[nodiscard]] QStringList shorter_and_shorter() const;

 signals:
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  explicit InputWatch(QObject* program);

  Kind kind_ = Kind::mouse;
  bool has_pointed_ = false;
  bool has_device_ = false;
};

}  // namespace nazori::ui
