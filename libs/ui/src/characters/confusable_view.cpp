// SPDX-License-Identifier: Apache-2.0
#include "characters/confusable_view.h"

#include <QAction>
#include <QFontInfo>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>

#include "nazori/practice/confusables.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr double kMargin = 0.1;
constexpr double kThin = 4, kThick = 8;  ///< of strokes, glyph units

QString meaning_of(const kanji::Character& character) {
  for (const auto& meaning : character.entry.meanings)
    if (meaning.language == "en") return to_text(meaning.text);
  return {};
}

/// A picture of a character that opens it.
class Picture final : public QPushButton {
 public:
  Picture(const kanji::Character& character, std::vector<bool> differs, QWidget* parent)
      : QPushButton(parent), strokes_(character.strokes), differs_(std::move(differs)) {
    const QString text = to_text(character.code_point);
    const QString meaning = meaning_of(character);
    setObjectName(QStringLiteral("confusable_") + text);
    setAccessibleName(meaning.isEmpty() ? text : text + QStringLiteral(", ") + meaning);
    setToolTip(accessibleName());
    setCursor(Qt::PointingHandCursor);
    const int side = QFontInfo(font()).pixelSize() * 5;
    setFixedSize(side, side);
  }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Colours& c = current_colours();
    painter.setPen(QPen(hasFocus() ? c.indigo : c.line, hasFocus() ? 2 : 1));
    painter.setBrush(underMouse() ? blend(c.surface, c.line, 0.35) : c.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 6, 6);
    const double scale = width() * (1 - 2 * kMargin) / geometry::kGlyphSide;
    painter.translate(width() * kMargin, width() * kMargin);
    painter.scale(scale, scale);
    painter.setBrush(Qt::NoBrush);
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
      const bool differs = i < differs_.size() && differs_[i];
      painter.setPen(QPen(differs ? c.indigo : c.ink, differs ? kThick : kThin, Qt::SolidLine, Qt::RoundCap,
                          Qt::RoundJoin));
      QPainterPath path;
      for (const auto& point : strokes_[i].line.points)
        if (path.elementCount() == 0)
          path.moveTo(point.x, point.y);
        else
          path.lineTo(point.x, point.y);
      painter.drawPath(path);
    }
  }

 private:
  std::vector<kanji::Stroke> strokes_;
  std::vector<bool> differs_;
};

}  // namespace

ConfusableView::ConfusableView(const QList<QAction*>& actions, QWidget* parent)
    : QWidget(parent), pictures_(new QWidget(this)) {
  auto* pictures = new FlowLayout(8, 8, pictures_);
  pictures->setContentsMargins(0, 0, 0, 0);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(pictures_);
  auto* row = new FlowLayout(6, 6);
  for (auto* action : actions) {
    auto* button = new QPushButton(action->iconText(), this);
    button->setObjectName(QStringLiteral("button_") + action->objectName());
    button->setProperty("role", QStringLiteral("compact"));
    button->setToolTip(action->toolTip());
    button->setEnabled(action->isEnabled());
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    connect(action, &QAction::changed, button, [button, action] { button->setEnabled(action->isEnabled()); });
    row->addWidget(button);
  }
  column->addLayout(row);
}

void ConfusableView::show_sheet(const practice::CharacterSheet& sheet) {
  auto* layout = pictures_->layout();
  while (QLayoutItem* item = layout->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  const auto add = [this, layout](const kanji::Character& character, std::vector<bool> differs) {
    auto* picture = new Picture(character, std::move(differs), pictures_);
    connect(picture, &QPushButton::clicked, this,
            [this, chosen = character.code_point] { emit character_chosen(chosen); });
    layout->addWidget(picture);
  };
  for (const auto& other : sheet.confusables) {
    auto contrast = practice::contrast_of(sheet.character, other);
    // The character itself is shown once, against the one that it is most easily confused with.
    if (&other == &sheet.confusables.front()) add(sheet.character, std::move(contrast.first));
    add(other, std::move(contrast.second));
  }
}

}  // namespace nazori::ui
