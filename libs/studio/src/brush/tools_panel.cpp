// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/brush/tools_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "nazori/studio/brush/brush_actions.h"
#include "nazori/studio/brush/brush_words.h"
#include "nazori/studio/parts/panel_parts.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
namespace {

constexpr int kWidth_em = 19;

QString text_of(std::string_view name) {
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()));
}

/// A check box that is the action.
QCheckBox* box_for(QAction* action, QWidget* parent) {
  auto* box = named(new QCheckBox(action->iconText(), parent), "");
  box->setObjectName(QStringLiteral("box_") + action->objectName());
  box->setToolTip(action->toolTip());
  box->setChecked(action->isChecked());
  QObject::connect(box, &QCheckBox::clicked, action, &QAction::trigger);
  QObject::connect(action, &QAction::toggled, box, &QCheckBox::setChecked);
  return box;
}

void choose(QComboBox* box, const QVariant& value) {
  const QSignalBlocker quiet(box);
  box->setCurrentIndex(box->findData(value));
}

}  // namespace

InkGauge::InkGauge(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("ink_gauge"));
  setAccessibleName(BrushToolsPanel::tr("Ink in the brush"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void InkGauge::show_state(const calligraphy::SheetState& state) {
  fullness_ = state.fullness;
  strength_ = state.strength;
  ink_ = colour_of_ink(state.ink);
  setAccessibleDescription(brush_words(state));
  update();
}

QSize InkGauge::sizeHint() const { return {120, QFontInfo(font()).pixelSize() * 9 / 8}; }

void InkGauge::paintEvent(QPaintEvent* /*event*/) {
  const Colours& c = current_colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF bar = QRectF(rect()).adjusted(1, 2, -1, -2);
  const double corner = bar.height() / 2;
  painter.setPen(QPen(c.edge, 1));
  painter.setBrush(QColor(250, 247, 240));
  painter.drawRoundedRect(bar, corner, corner);
  if (fullness_ <= 0) return;
  // The rim stays pale, so that black ink can be seen in the dark theme, too.
  const QRectF ink = bar.adjusted(2, 2, -2, -2);
  painter.setPen(Qt::NoPen);
  painter.setClipRect(QRectF(ink.left(), ink.top(), ink.width() * fullness_, ink.height()));
  // Clear water is pale blue; the more ink, the more of its colour.
  painter.setBrush(blend(QColor(198, 216, 232), ink_, std::min(strength_, 1.0)));
  painter.drawRoundedRect(ink, ink.height() / 2, ink.height() / 2);
}

BrushToolsPanel::BrushToolsPanel(const BrushActions& actions, QWidget* parent)
    : QScrollArea(parent), content_(named(new QWidget(this), "brush_tools_content")) {
  setObjectName(QStringLiteral("brush_tools_panel"));
  setAccessibleName(tr("Brush, paper and model"));
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  auto* column = make_panel_column(content_);

  advice_heading_ = heading(tr("Advice (not a mark)"), content_);
  advice_words_ = sentence_label("brush_advice_words", content_);
  column->addWidget(advice_heading_);
  column->addWidget(advice_words_);
  show_advice({});

  column->addWidget(heading(tr("Brush"), content_));
  gauge_ = new InkGauge(content_);
  column->addWidget(gauge_);
  brush_words_ = text_label("brush_words", content_, "muted");
  column->addWidget(brush_words_);
  add_buttons(column, {actions.dip_in_ink, actions.dip_in_water, actions.wipe}, content_);
  auto* brush_form = add_form(column);
  ink_ = add_box("brush_ink_box", tr("Ink"), brush_form);
  for (const auto ink : calligraphy::kInks) ink_->addItem(ink_name(ink), text_of(ink));
  size_ = add_box("brush_size_box", tr("Size"), brush_form);
  for (std::size_t i = 0; i < calligraphy::kBrushSizes.size(); ++i)
    size_->addItem(brush_size_name(static_cast<calligraphy::BrushSize>(i)), static_cast<int>(i));
  hair_ = add_box("brush_hair_box", tr("Hair"), brush_form);
  for (std::size_t i = 0; i < calligraphy::kHairs.size(); ++i)
    hair_->addItem(hair_name(static_cast<brush::Hair>(i)), static_cast<int>(i));
  for (auto* action : {actions.guess_pressure, actions.left_hand, actions.show_brush})
    column->addWidget(box_for(action, content_));

  column->addSpacing(kPanelGap);
  column->addWidget(heading(tr("Paper"), content_));
  paper_words_ = text_label("paper_words", content_, "muted");
  column->addWidget(paper_words_);
  auto* paper_form = add_form(column);
  paper_ = add_box("brush_paper_box", tr("Paper"), paper_form);
  for (const auto paper : paint::paper_names()) paper_->addItem(paper_name(paper), text_of(paper));
  ruling_ = add_box("brush_ruling_box", tr("Ruling"), paper_form);
  for (const int count : calligraphy::kRulings) ruling_->addItem(ruling_name(count), count);

  column->addSpacing(kPanelGap);
  column->addWidget(heading(tr("Model"), content_));
  model_words_ = text_label("model_words", content_, "muted");
  column->addWidget(model_words_);
  auto* model_form = add_form(column);
  place_ = add_box("brush_model_box", tr("Place"), model_form);
  place_->addItem(tr("None"), static_cast<int>(ModelPlace::none));
  place_->addItem(tr("Beneath"), static_cast<int>(ModelPlace::beneath));
  place_->addItem(tr("Beside"), static_cast<int>(ModelPlace::beside));
  font_ = add_box("brush_font_box", tr("Font"), model_form);
  text_ = named(new QLineEdit(content_), "brush_text", tr("Text of the model"));
  text_->setPlaceholderText(tr("Current character"));
  text_->setMaxLength(200);
  model_form->addRow(tr("Text"), text_);
  font_hint_ = text_label("brush_font_hint", content_, "muted");
  column->addWidget(font_hint_);
  show_fonts({}, {});
  column->addStretch(1);
  make_scrolling(this, content_);

  connect(size_, &QComboBox::activated, this,
          [this] { emit size_chosen(static_cast<calligraphy::BrushSize>(size_->currentData().toInt())); });
  connect(hair_, &QComboBox::activated, this,
          [this] { emit hair_chosen(static_cast<brush::Hair>(hair_->currentData().toInt())); });
  connect(ink_, &QComboBox::activated, this, [this] { emit ink_chosen(ink_->currentData().toString()); });
  connect(paper_, &QComboBox::activated, this,
          [this] { emit paper_chosen(paper_->currentData().toString()); });
  connect(ruling_, &QComboBox::activated, this,
          [this] { emit ruling_chosen(ruling_->currentData().toInt()); });
  connect(place_, &QComboBox::activated, this,
          [this] { emit place_chosen(static_cast<ModelPlace>(place_->currentData().toInt())); });
  connect(font_, &QComboBox::activated, this, [this] { emit font_chosen(font_->currentData().toString()); });
  connect(text_, &QLineEdit::textEdited, this, &BrushToolsPanel::text_typed);
  connect(text_, &QLineEdit::returnPressed, this, &BrushToolsPanel::text_entered);
}

QComboBox* BrushToolsPanel::add_box(const char* name, const QString& label, QFormLayout* form) {
  auto* box = named(new QComboBox(content_), name, label);
  constexpr int kLetters = 9;
  make_narrow(box, kLetters);
  form->addRow(label, box);
  return box;
}

void BrushToolsPanel::show_state(const calligraphy::SheetState& state) {
  gauge_->show_state(state);
  brush_words_->setText(brush_words(state));
  paper_words_->setText(paper_words(state));
  choose(ink_, text_of(state.ink));
  choose(paper_, text_of(state.paper));
  choose(size_, static_cast<int>(state.brush.size));
  choose(hair_, static_cast<int>(state.brush.hair));
}

void BrushToolsPanel::show_ruling(int characters) { choose(ruling_, characters); }
void BrushToolsPanel::show_place(ModelPlace place) { choose(place_, static_cast<int>(place)); }

void BrushToolsPanel::show_fonts(const std::vector<author::BrushFont>& fonts, const QString& hint) {
  const QSignalBlocker quiet(font_);
  font_->clear();
  font_->addItem(font_name({}), QString());
  for (const auto& font : fonts) font_->addItem(font_name(font.family), text_of(font.family));
  font_hint_->setText(hint);
  font_hint_->setVisible(!hint.isEmpty());
}

void BrushToolsPanel::show_font(const QString& family) { choose(font_, family); }

void BrushToolsPanel::show_text(const QString& text) {
  if (text_->text() != text) text_->setText(text);
}

void BrushToolsPanel::show_model_words(const QString& words) {
  model_words_->setText(words);
  model_words_->setVisible(!words.isEmpty());
}

void BrushToolsPanel::show_advice(const QStringList& sentences) {
  advice_words_->setText(sentences.join(QLatin1Char('\n')));
  advice_heading_->setVisible(!sentences.isEmpty());
  advice_words_->setVisible(!sentences.isEmpty());
  if (!sentences.isEmpty()) ensureVisible(0, 0);
}

void BrushToolsPanel::focus_text() {
  text_->setFocus(Qt::ShortcutFocusReason);
  text_->selectAll();
}

void BrushToolsPanel::set_model_free(bool is_free) {
  ruling_->setEnabled(is_free);
  text_->setEnabled(is_free);
}

QSize BrushToolsPanel::sizeHint() const { return {QFontInfo(font()).pixelSize() * kWidth_em, 400}; }

}  // namespace nazori::ui
