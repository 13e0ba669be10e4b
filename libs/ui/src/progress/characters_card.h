// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nazori/study/character_lists.h"
#include "nazori/study/learner_store.h"
#include "nazori/study/statistics.h"
#include "nazori/widgets/charts/chart_card.h"

namespace nazori::ui {

class ListChoice;
class StrengthGrid;

/// The strength of every character of a list, or of all that were studied.
class CharactersCard final : public ChartCard {
  Q_OBJECT
 public:
  explicit CharactersCard(QWidget* parent = nullptr);

  /// @param lists  may be nullptr: then only the characters that were studied can be shown.
  void show_characters(const study::Statistics& statistics, study::CharacterLists* lists,
                       const study::LearnerStore& store);
  /// The id of the list that is shown; empty: all characters that were studied.
  [[nodiscard]] QString list() const;
  void set_list(const QString& id);
  [[nodiscard]] const StrengthGrid& grid() const { return *grid_; }

 signals:
  void opened(char32_t character);
  void list_changed();

 private:
  CharactersCard(QWidget* drawing, QWidget* parent);

  ListChoice* list_ = nullptr;
  StrengthGrid* grid_ = nullptr;
  QString wanted_;
};

}  // namespace nazori::ui
