// SPDX-License-Identifier: Apache-2.0
#include "characters/character_list_model.h"

#include <algorithm>

#include "words/kanji_text.h"

namespace nazori::ui {

void CharacterListModel::set_characters(practice::Summaries characters) {
  beginResetModel();
  characters_ = std::move(characters);
  endResetModel();
}

int CharacterListModel::row_of(char32_t code_point) const {
  if (!characters_) return -1;
  const auto found =
      std::find_if(characters_->begin(), characters_->end(),
                   [code_point](const kanji::Summary& s) { return s.code_point == code_point; });
  return found == characters_->end() ? -1 : static_cast<int>(found - characters_->begin());
}

char32_t CharacterListModel::at(int row) const {
  return characters_ && row >= 0 && row < rowCount()
             ? (*characters_)[static_cast<std::size_t>(row)].code_point
             : 0;
}

int CharacterListModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !characters_ ? 0 : static_cast<int>(characters_->size());
}

QVariant CharacterListModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto& summary = (*characters_)[static_cast<std::size_t>(index.row())];
  const auto describe = [&summary](const QString& separator) {
    QStringList words{to_text(summary.code_point)};
    if (!summary.meaning.empty()) words.append(to_text(summary.meaning));
    if (!summary.reading.empty()) words.append(kun_plain(kanji::split_kun(summary.reading)));
    return words.join(separator);
  };
  switch (role) {
    case Qt::DisplayRole:
      return to_text(summary.code_point);
    case Qt::ToolTipRole:
      return describe(QStringLiteral(" · "));
    case Qt::AccessibleTextRole:
      return describe(QStringLiteral(", "));
    case kCodePointRole:
      return static_cast<uint>(summary.code_point);
    default:
      return {};
  }
}

}  // namespace nazori::ui
