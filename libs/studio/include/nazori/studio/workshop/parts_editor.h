// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <vector>

#include "nazori/author/own_character.h"

class QLineEdit;
class QListWidget;

namespace nazori::ui {

class WorkshopActions;

/// The parts of a character: a list, and the name and the strokes of the one that is chosen in it. It shows
/// parts and sends what was typed; the page decides.
class PartsEditor final : public QWidget {
  Q_OBJECT
 public:
  PartsEditor(const WorkshopActions& actions, QWidget* parent);

  /// @param strokes  how many the character has.
  void show_parts(const std::vector<author::OwnPart>& parts, std::size_t strokes);
  /// Adds a part without a name, and gives the keyboard to its name.
  /// @param strokes  of the part; none: those that belong to no part yet.
  void add(std::vector<int> strokes);
  /// Removes the chosen part. @return whether one is chosen.
  bool remove();

 signals:
  void parts_typed(const std::vector<nazori::author::OwnPart>& parts);
  /// What was typed cannot be read; the field shows what it had before.
  void refused(const QString& sentence);

 private:
  void choose(int row);
  void send();
  /// The part that is chosen; -1: none.
  [[nodiscard]] int chosen() const;

  QListWidget* list_;
  QLineEdit *name_, *strokes_;
  std::vector<author::OwnPart> parts_;
  std::size_t count_ = 0;  ///< strokes of the character
};

}  // namespace nazori::ui
