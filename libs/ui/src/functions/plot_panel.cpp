// SPDX-License-Identifier: Apache-2.0
#include "functions/plot_panel.h"

#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontInfo>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "functions/expression_line.h"
#include "functions/parameter_sliders.h"
#include "functions/plot_words.h"
#include "nazori/functions/plot_examples.h"
#include "nazori/functions/plot_model.h"
#include "nazori/widgets/controls/field_row.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;
constexpr int kBeside_em = 11;  ///< room for a name beside its field
constexpr double kTabletSide_mm = geometry::TabletShape{}.width_m * 1000;

}  // namespace

PlotPanel::PlotPanel(QWidget* parent)
    : QScrollArea(parent),
      content_(named(new QWidget(this), "plot_content")),
      line_(named(new ExpressionLine(content_), "expression", tr("Expression"))),
      words_(sentence_label("expression_words", content_, "muted")),
      error_row_(new QWidget(content_)),
      error_sign_(new QLabel(error_row_)),
      error_(sentence_label("expression_error", error_row_)),
      progress_(named(new QProgressBar(content_), "plot_progress", tr("Drawing"))),
      parameters_(named(new ParameterSliders(content_), "parameters")),
      examples_(named(new QComboBox(content_), "examples", tr("Examples"))),
      axes_(named(new QCheckBox(tr("&Axes"), content_), "layer_axes")),
      ticks_(named(new QCheckBox(tr("Tic&ks"), content_), "layer_ticks")),
      grid_(named(new QCheckBox(tr("&Grid"), content_), "layer_grid")),
      rim_(named(new QCheckBox(tr("Fra&me"), content_), "layer_rim")),
      width_(named(new QDoubleSpinBox(content_), "groove_width", tr("Groove width in millimetres"))),
      size_(named(new QComboBox(content_), "plate_size", tr("Samples per side"))),
      volume_(named(new QSlider(Qt::Horizontal, content_), "volume", tr("Volume"))),
      mute_(named(new QCheckBox(tr("Soun&d off"), content_), "no_sound")) {
  setObjectName(QStringLiteral("plot_panel"));
  setAccessibleName(tr("Expression and range"));
  setFocusPolicy(Qt::NoFocus);

  line_->setPlaceholderText(QStringLiteral("y = sin x"));
  line_->setToolTip(tr("Separate several expressions with semicolons. Up and Down: earlier expressions"));
  words_->setAccessibleName(tr("The expression in words"));
  auto* error_layout = new QHBoxLayout(error_row_);
  error_layout->setContentsMargins(0, 0, 0, 0);
  error_layout->addWidget(error_sign_, 0, Qt::AlignTop);
  error_layout->addWidget(error_, 1);
  error_row_->hide();
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(6);
  QSizePolicy keeps = progress_->sizePolicy();
  keeps.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(keeps);
  progress_->hide();

  examples_->addItem(tr("Examples…"));
  for (const auto& example : functions::plot_examples()) examples_->addItem(to_text(example.expression));
  make_narrow(examples_, 6);
  connect(examples_, &QComboBox::activated, this, [this](int row) {
    if (row <= 0) return;
    const auto& example = functions::plot_examples()[static_cast<std::size_t>(row - 1)];
    emit example_chosen(to_text(example.expression), example.window);
  });

  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(8);
  auto* title = heading(tr("E&xpression"), content_);
  title->setBuddy(line_);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{title, line_, progress_, words_, error_row_, parameters_, examples_})
    column->addWidget(widget);

  column->addSpacing(8);
  column->addWidget(heading(tr("Range"), content_));
  const auto add_row = [this, column](const QString& name, QWidget* field) {
    column->addWidget(rows_.emplace_back(new FieldRow(name, field, content_)));
  };
  const QString names[] = {tr("x from"), tr("x to"), tr("y from"), tr("y to")};
  const char* ids[] = {"window_x0", "window_x1", "window_y0", "window_y1"};
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    borders_[i] = named(new QLineEdit(content_), ids[i], names[i]);
    connect(borders_[i], &QLineEdit::editingFinished, this, &PlotPanel::read_window);
    add_row(names[i], borders_[i]);
  }
  const QString height_names[] = {tr("z from"), tr("z to")};
  const char* height_ids[] = {"window_z0", "window_z1"};
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    heights_[i] = named(new QLineEdit(content_), height_ids[i], height_names[i]);
    heights_[i]->setToolTip(tr("Height range of a surface; leave empty to fit its values"));
    connect(heights_[i], &QLineEdit::editingFinished, this, &PlotPanel::read_heights);
    add_row(height_names[i], heights_[i]);
  }

  column->addSpacing(8);
  column->addWidget(heading(tr("Show on the plot"), content_));
  for (auto* layer : {axes_, ticks_, grid_, rim_}) {
    connect(layer, &QCheckBox::clicked, this, &PlotPanel::read_plate);
    column->addWidget(layer);
  }
  width_->findChild<QLineEdit*>()->setAccessibleName(width_->accessibleName());
  width_->setRange(0.4, 10);
  width_->setSingleStep(0.1);
  width_->setDecimals(1);
  width_->setSuffix(tr(" mm"));
  width_->setKeyboardTracking(false);
  width_->setLocale(QLocale::system());
  connect(width_, &QDoubleSpinBox::valueChanged, this, &PlotPanel::read_plate);
  add_row(tr("Groo&ve width"), width_);
  for (const int side : {128, 256, 512, 1024, 2048}) size_->addItem(QString::number(side), side);
  connect(size_, &QComboBox::activated, this, &PlotPanel::read_plate);
  make_narrow(size_, 4);
  add_row(tr("Sam&ples"), size_);

  column->addSpacing(8);
  auto* sound = heading(tr("Vol&ume"), content_);
  sound->setBuddy(volume_);
  column->addWidget(sound);
  volume_->setRange(0, 100);
  connect(volume_, &QSlider::valueChanged, this, &PlotPanel::volume_changed);
  column->addWidget(volume_);
  connect(mute_, &QCheckBox::clicked, this, &PlotPanel::mute_changed);
  column->addWidget(mute_);
  column->addStretch(1);
  make_scrolling(this, content_);
  // The fields shrink before the panel becomes too wide.
  for (QWidget* field : std::initializer_list<QWidget*>{line_, examples_, width_, size_})
    field->setMinimumWidth(1);
  connect(line_, &QLineEdit::textChanged, this, [this](const QString& text) {
    // The list shows the example that is in the field, or none if the field contains another expression.
    examples_->setCurrentIndex(
        std::max(0, examples_->findText(text, Qt::MatchExactly | Qt::MatchCaseSensitive)));
    emit expression_typed(text);
  });
  connect(parameters_, &ParameterSliders::moved, this, &PlotPanel::parameter_moved);
  connect(parameters_, &ParameterSliders::rebuilt, this, &PlotPanel::order_tabs);
  order_tabs();
  show_surface(false);
}

void PlotPanel::order_tabs() {
  // From top to bottom, not in the order of creation.
  std::vector<QWidget*> order{line_};
  for (QWidget* slider : parameters_->sliders()) order.push_back(slider);
  order.insert(order.end(), {examples_, borders_[0], borders_[1], borders_[2], borders_[3], heights_[0],
                             heights_[1], axes_, ticks_, grid_, rim_, width_, size_, volume_, mute_});
  for (std::size_t i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
}

void PlotPanel::show_parameters(const std::vector<functions::Parameter>& parameters) {
  parameters_->show_parameters(parameters);
}

void PlotPanel::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fit();
}

void PlotPanel::changeEvent(QEvent* event) {
  QScrollArea::changeEvent(event);
  if (event->type() == QEvent::FontChange) fit();
}

void PlotPanel::fit() {
  // Large text in a narrow panel: the names above their fields instead of beside them.
  const int em = QFontInfo(font()).pixelSize();
  const bool narrow = viewport()->width() - 2 * kMargin < kBeside_em * em;
  const int margin = narrow ? kMargin / 4 : kMargin;
  content_->layout()->setContentsMargins(margin, kMargin, margin, kMargin);
  FieldRow::arrange(rows_, narrow);
}

void PlotPanel::show_surface(bool surface) {
  for (auto* border : heights_) border->parentWidget()->setVisible(surface);
}

void PlotPanel::show_words(const QString& words) {
  line_->mark_error(0);
  error_row_->hide();
  words_->setText(words);
  words_->show();
  words_->setAccessibleDescription(words);
  line_->setAccessibleDescription(words);
  QAccessibleEvent changed(line_, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&changed);
}

void PlotPanel::show_error(const functions::SyntaxError& error) {
  line_->mark_error(error.column);
  const QString text = syntax_error_words(error);
  error_->setText(text);
  line_->setAccessibleDescription(text);
  QAccessibleEvent changed(line_, QAccessible::DescriptionChanged);
  QAccessible::updateAccessibility(&changed);
  refresh_appearance();
  words_->hide();
  error_row_->show();
}

void PlotPanel::refresh_appearance() {
  const int side = QFontInfo(font()).pixelSize() * 5 / 4;
  error_sign_->setPixmap(sign(Icon::cross, current_colours().vermilion, side, devicePixelRatioF()));
}

void PlotPanel::show_window(const functions::Window& window) {
  window_ = window;
  const double values[] = {window.x0, window.x1, window.y0, window.y1};
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    borders_[i]->setText(number_text(values[i], 10));
    borders_[i]->setCursorPosition(0);
    borders_[i]->setModified(false);
  }
}

void PlotPanel::read_window() {
  functions::Window typed = window_;
  double* values[] = {&typed.x0, &typed.x1, &typed.y0, &typed.y1};
  for (std::size_t i = 0; i < borders_.size(); ++i) {
    if (!borders_[i]->isModified()) continue;
    borders_[i]->setModified(false);
    const auto value = functions::read_number(borders_[i]->text().toStdString(), {uses_decimal_comma()});
    if (!value) {
      emit window_refused(borders_[i]->text());
      show_window(window_);
      return;
    }
    *values[i] = *value;
  }
  if (!(typed == window_)) emit window_typed(typed);
}

void PlotPanel::read_heights() {
  std::array<double, 2> typed{};
  int given = 0;
  bool modified = false;
  for (std::size_t i = 0; i < heights_.size(); ++i) {
    modified = modified || heights_[i]->isModified();
    heights_[i]->setModified(false);
    const QString text = heights_[i]->text().trimmed();
    if (text.isEmpty()) continue;
    ++given;
    typed[i] = functions::read_number(text.toStdString(), {uses_decimal_comma()}).value_or(std::nan(""));
  }
  // With only one of the two numbers the range is still being typed.
  if (!modified || given == 1) return;
  plate_.heights.reset();
  if (given == 2) {
    if (!(typed[0] < typed[1]) || !std::isfinite(typed[1] - typed[0])) {
      emit heights_refused(heights_[0]->text() + QStringLiteral("; ") + heights_[1]->text());
      return;
    }
    plate_.heights = functions::HeightRange{typed[0], typed[1]};
  }
  emit plate_changed(plate_);
}

void PlotPanel::show_plate(const functions::PlateSettings& plate) {
  plate_ = plate;
  heights_[0]->setText(plate.heights ? number_text(plate.heights->low, 10) : QString());
  heights_[1]->setText(plate.heights ? number_text(plate.heights->high, 10) : QString());
  const QSignalBlocker quiet(width_);
  axes_->setChecked(plate.layers.axes);
  ticks_->setChecked(plate.layers.ticks);
  grid_->setChecked(plate.layers.grid);
  rim_->setChecked(plate.layers.rim);
  width_->setValue(plate.half_width * 2 * kTabletSide_mm);
  size_->setCurrentIndex(std::max(0, size_->findData(plate.size)));
}

void PlotPanel::read_plate() {
  plate_.layers = {axes_->isChecked(), ticks_->isChecked(), grid_->isChecked(), rim_->isChecked()};
  plate_.half_width = width_->value() / 2 / kTabletSide_mm;
  plate_.size = size_->currentData().toInt();
  emit plate_changed(plate_);
}

void PlotPanel::show_volume(int percent, bool muted) {
  const QSignalBlocker quiet(volume_);
  volume_->setValue(percent);
  mute_->setChecked(muted);
}

void PlotPanel::show_progress(double done) {
  progress_->setVisible(done >= 0);
  if (done >= 0) progress_->setValue(static_cast<int>(std::lround(done * 100)));
}

}  // namespace nazori::ui
