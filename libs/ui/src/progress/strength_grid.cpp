// SPDX-License-Identifier: Apache-2.0
#include "progress/strength_grid.h"

#include <QFontInfo>
#include <QPainter>

#include "nazori/practice/strengths.h"
#include "nazori/widgets/charts/role_colours.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/own_names.h"

namespace nazori::ui {

StrengthLook look_of(study::Strength strength, const Colours& c) {
  const auto look = practice::look_of(strength);
  return {colour_of(look.fill, c), colour_of(look.text, c), look.sign == 0 ? QString() : to_text(look.sign),
          look.dashed};
}

void StrengthModel::set_states(std::vector<study::CharacterState> states) {
  beginResetModel();
  states_ = std::move(states);
  endResetModel();
}

char32_t StrengthModel::at(int row) const {
  return row >= 0 && row < rowCount() ? states_[static_cast<std::size_t>(row)].character : 0;
}

QString StrengthModel::words(const study::CharacterState& state) {
  const QString strength = StudyCharts::strength(state.strength);
  if (state.strength == study::Strength::unseen || state.retrievability <= 0)
    return tr("%1, %2").arg(to_text(state.character), strength);
  return tr("%1, %2, %3 likely to be remembered")
      .arg(to_text(state.character), strength, StudyCharts::percent(state.retrievability));
}

int StrengthModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(states_.size());
}

QVariant StrengthModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const auto& state = states_[static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return to_text(state.character);
    case Qt::ToolTipRole:
      return words(state);
    case Qt::AccessibleTextRole:
      return spoken_text(words(state));
    case kStrengthRole:
      return static_cast<int>(state.strength);
    default:
      return {};
  }
}

int StrengthDelegate::tile_side(const QFont& font) { return QFontInfo(font).pixelSize() * 5 / 2; }

QSize StrengthDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
  const int side = tile_side(option.font);
  return {side, side};
}

void StrengthDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const {
  const Colours& c = current_colours();
  const auto strength = static_cast<study::Strength>(index.data(StrengthModel::kStrengthRole).toInt());
  const StrengthLook look = look_of(strength, c);
  const bool here = option.state.testFlag(QStyle::State_HasFocus);
  const QRectF tile = QRectF(option.rect).adjusted(2, 2, -2, -2);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(
      QPen(here ? c.ink : c.line, here ? 3 : 1, look.dashed && !here ? Qt::DashLine : Qt::SolidLine));
  painter->setBrush(look.fill);
  painter->drawRoundedRect(tile, 5, 5);
  painter->setPen(look.text);
  const QString text = index.data(Qt::DisplayRole).toString();
  QFont font = character_font(text, 12);
  font.setPixelSize(std::max(8, static_cast<int>(tile.height() * 0.60)));
  painter->setFont(font);
  painter->drawText(tile.adjusted(0, 0, -tile.width() * 0.12, tile.height() * 0.08),
                    Qt::AlignCenter | Qt::TextDontClip, text);
  if (!look.sign.isEmpty()) {
    QFont small = option.font;
    small.setPixelSize(std::max(7, static_cast<int>(tile.height() * 0.27)));
    small.setBold(true);
    painter->setFont(small);
    painter->drawText(tile.adjusted(0, 0, -3, 0), Qt::AlignTop | Qt::AlignRight, look.sign);
  }
  painter->restore();
}

StrengthGrid::StrengthGrid(QWidget* parent) : QListView(parent), model_(new StrengthModel(this)) {
  setModel(model_);
  setItemDelegate(new StrengthDelegate(this));
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(true);
  setMouseTracking(true);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListView::activated, this,
          [this](const QModelIndex& index) { emit opened(model_->at(index.row())); });
  connect(selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& index) { emit walked(index.data(Qt::AccessibleTextRole).toString()); });
}

void StrengthGrid::show_states(std::vector<study::CharacterState> states) {
  const char32_t before = model_->at(currentIndex().row());
  int row = 0;
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i].character == before) row = static_cast<int>(i);
  model_->set_states(std::move(states));
  setCurrentIndex(model_->index(row));
}

}  // namespace nazori::ui
