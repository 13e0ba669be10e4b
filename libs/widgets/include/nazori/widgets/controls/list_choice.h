// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>

#include "nazori/study/character_lists.h"
#include "nazori/study/learner_store.h"

namespace nazori::ui {

/// A box to choose a list of characters: those studied so far (id: empty), the built-in lists, and the
/// learner's own.
class ListChoice final : public QComboBox {
  Q_OBJECT
 public:
  explicit ListChoice(QWidget* parent = nullptr);

  /// Fills the box again. The choice stays if it still exists. If the learner's lists and tags cannot be
  /// read, an entry that cannot be chosen says so. Emits nothing.
  void fill(const study::LearnerStore& store);
  /// As practice::list_members() reads it.
  [[nodiscard]] QString list() const { return currentData().toString(); }
  void set_list(const QString& id);

  /// "School grade 1", "Own list: street", by the id of a list.
  [[nodiscard]] static QString name_of(const QString& id);
};

}  // namespace nazori::ui
