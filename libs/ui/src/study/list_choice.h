// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>

#include "nazori/study/character_lists.h"
#include "nazori/study/learner_store.h"

namespace nazori::ui {

/// A list of characters to choose: those met so far (id: empty), the ready lists, the learner's own.
class ListChoice final : public QComboBox {
  Q_OBJECT
 public:
  explicit ListChoice(QWidget* parent = nullptr);

  /// Fills it anew; what was chosen stays where it is still there. Where lists and tags of one's own cannot
  /// be read a line that cannot be chosen says so. Emits nothing.
  void fill(const study::LearnerStore& store);
  /// As practice::list_members() reads it.
  [[nodiscard]] QString list() const { return currentData().toString(); }
  void set_list(const QString& id);

  /// "School grade 1", "Own list: street", by the id of a list.
  [[nodiscard]] static QString name_of(const QString& id);
};

}  // namespace nazori::ui
