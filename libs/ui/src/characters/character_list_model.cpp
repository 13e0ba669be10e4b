// SPDX-License-Identifier: Apache-2.0
#include "characters/character_list_model.h"

#include "characters/search_words.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/own_names.h"

namespace nazori::ui {

void CharacterListModel::set_characters(practice::Summaries characters) {
  beginResetModel();
  characters_ = std::move(characters);
  answer_.reset();
  endResetModel();
}

void CharacterListModel::set_answer(std::shared_ptr<const practice::SearchAnswer> answer) {
  beginResetModel();
  answer_ = std::move(answer);
  endResetModel();
}

void CharacterListModel::set_strengths(StrengthOf strength_of) {
  strength_of_ = std::move(strength_of);
  refresh_strengths();
}

void CharacterListModel::refresh_strengths() {
  if (rowCount() > 0) emit dataChanged(index(0), index(rowCount() - 1));
}

const practice::SearchRow* CharacterListModel::found(int row) const {
  return answer_ ? &answer_->rows[static_cast<std::size_t>(row)] : nullptr;
}

const kanji::Summary& CharacterListModel::summary(int row) const {
  const auto* one = found(row);
  return one != nullptr ? one->character : (*characters_)[static_cast<std::size_t>(row)];
}

int CharacterListModel::row_of(char32_t code_point) const {
  for (int row = 0; row < rowCount(); ++row) {
    const auto* one = found(row);
    if (summary(row).code_point == code_point && (one == nullptr || !one->word)) return row;
  }
  return -1;
}

char32_t CharacterListModel::at(int row) const {
  return row >= 0 && row < rowCount() ? summary(row).code_point : 0;
}

int CharacterListModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid()) return 0;
  if (answer_) return static_cast<int>(answer_->rows.size());
  return characters_ ? static_cast<int>(characters_->size()) : 0;
}

QString CharacterListModel::describe(int row, const QString& separator) const {
  if (const auto* one = found(row)) return SearchWords::head(*one) + separator + SearchWords::why(*one);
  const auto& character = summary(row);
  QStringList words{to_text(character.code_point)};
  if (!character.meaning.empty()) words.append(to_text(character.meaning));
  if (!character.reading.empty()) words.append(kun_plain(kanji::split_kun(character.reading)));
  if (strength_of_) {
    const auto strength = strength_of_(character.code_point);
    if (strength != study::Strength::unseen) words.append(StudyCharts::strength(strength));
  }
  return words.join(separator);
}

QVariant CharacterListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto* one = found(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return one != nullptr ? SearchWords::head(*one) : to_text(summary(index.row()).code_point);
    case Qt::ToolTipRole:
      return describe(index.row(), QStringLiteral(" · "));
    case Qt::AccessibleTextRole:
      return spoken_text(describe(index.row(), QStringLiteral(", ")));
    case kCodePointRole:
      return static_cast<uint>(summary(index.row()).code_point);
    case kStrengthRole:
      if (!strength_of_ || (one != nullptr && one->word)) return {};
      return static_cast<int>(strength_of_(summary(index.row()).code_point));
    case kWhyRole:
      return one != nullptr ? SearchWords::why(*one) : QString();
    default:
      return {};
  }
}

}  // namespace nazori::ui
