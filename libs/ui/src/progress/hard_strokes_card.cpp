// SPDX-License-Identifier: Apache-2.0
#include "progress/hard_strokes_card.h"

#include <QFontInfo>
#include <QListWidget>
#include <QLocale>
#include <QPainter>

#include "nazori/geometry/point.h"
#include "nazori/widgets/charts/study_charts.h"
#include "nazori/widgets/look/ink_painting.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"
#include "nazori/widgets/words/trouble_words.h"

namespace nazori::ui {
namespace {

constexpr int kGap = 10;

int picture_side(const QFont& font) { return QFontInfo(font).pixelSize() * 4; }

}  // namespace

void HardStrokeDelegate::set_database(const kanji::KanjiDatabase* database) {
  database_ = database;
  lines_.clear();
}

const std::vector<kanji::StrokeLine>& HardStrokeDelegate::lines_of(char32_t character) const {
  const auto [place, is_new] = lines_.try_emplace(character);
  if (is_new && database_ != nullptr) {
    if (const auto found = database_->find(character))
      for (const kanji::Stroke& stroke : found->strokes) place->second.push_back(stroke.line);
  }
  return place->second;
}

QSize HardStrokeDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int side = picture_side(option.font);
  const int width = option.rect.width() > 0 ? option.rect.width() : option.widget->width();
  const QRect words = option.fontMetrics.boundingRect(0, 0, std::max(40, width - side - 3 * kGap), 10'000,
                                                      Qt::TextWordWrap, index.data().toString());
  return {side, std::max(side, words.height()) + kGap};
}

void HardStrokeDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
  const Colours& c = current_colours();
  const int side = picture_side(option.font);
  const QRect row = option.rect.adjusted(kGap / 2, kGap / 2, -kGap / 2, -kGap / 2);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (option.state.testFlag(QStyle::State_HasFocus)) {
    painter->setPen(QPen(c.indigo, 2));
    painter->drawRoundedRect(QRectF(option.rect).adjusted(1, 1, -1, -1), 6, 6);
  }
  painter->setPen(c.ink);
  painter->setFont(option.font);
  painter->drawText(row.adjusted(side + kGap, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap,
                    index.data().toString());
  painter->translate(row.left(), row.top());
  painter->setPen(QPen(c.line, 1));
  painter->setBrush(c.surface);
  painter->drawRoundedRect(QRectF(0.5, 0.5, side - 1, side - 1), 6, 6);
  const double scale = side * 0.88 / geometry::kGlyphSide;
  painter->translate(side * 0.06, side * 0.06);
  painter->scale(scale, scale);
  painter->setBrush(Qt::NoBrush);
  const auto& lines = lines_of(static_cast<char32_t>(index.data(kCharacterRole).toUInt()));
  const int hard = index.data(kStrokeRole).toInt();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    // The hard stroke is drawn thicker.
    const bool marked = static_cast<int>(i) == hard;
    painter->setPen(
        QPen(marked ? c.vermilion : c.muted, marked ? 8 : 3.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter->drawPath(path_through(lines[i].points));
  }
  painter->restore();
}

HardStrokesCard::HardStrokesCard(QWidget* parent) : HardStrokesCard(new QListWidget, parent) {}

HardStrokesCard::HardStrokesCard(QListWidget* list, QWidget* parent)
    : ChartCard(QStringLiteral("hard_strokes"), list, parent), list_(list) {
  list_->setItemDelegate(new HardStrokeDelegate(list_));
  list_->setResizeMode(QListView::Adjust);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(list_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
    emit opened(static_cast<char32_t>(item->data(HardStrokeDelegate::kCharacterRole).toUInt()));
  });
}

void HardStrokesCard::show_strokes(const study::Statistics& statistics,
                                   const kanji::KanjiDatabase* database) {
  static_cast<HardStrokeDelegate*>(list_->itemDelegate())->set_database(database);
  list_->clear();
  for (const auto& stroke : statistics.hard_strokes) {
    const QString words = TroubleWords::counted(practice::trouble_of(stroke));
    auto* item = new QListWidgetItem(words, list_);
    item->setData(Qt::AccessibleTextRole,
                  tr("%1: %2", "character, sentence").arg(to_text(stroke.character), words));
    item->setData(HardStrokeDelegate::kCharacterRole, static_cast<uint>(stroke.character));
    item->setData(HardStrokeDelegate::kStrokeRole, stroke.stroke);
  }
  ChartText text;
  text.id = QStringLiteral("hard_strokes");
  text.title = tr("Hardest strokes");
  text.empty = tr("No stroke has been wrong more than once. Those that are will appear here.");
  text.numbers = StudyCharts::hard_strokes(statistics);
  if (!statistics.hard_strokes.empty())
    text.summary = tr("Strokes that were wrong more than once: %1. Enter: open the character.")
                       .arg(QLocale().toString(static_cast<qlonglong>(statistics.hard_strokes.size())));
  list_->setAccessibleName(text.title);
  list_->setCurrentRow(0);
  show_text(text);
}

}  // namespace nazori::ui
