// SPDX-License-Identifier: Apache-2.0
#include "functions/parameter_sliders.h"

#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>

#include "nazori/functions/parameter_scale.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

using functions::Parameter;
using functions::ParameterScale;

namespace {

constexpr int kSignificant = 10;

bool have_one_slider(const Parameter& a, const Parameter& b) {
  return a.name == b.name && a.from == b.from && a.to == b.to;
}

}  // namespace

ParameterSliders::ParameterSliders(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  hide();
}

void ParameterSliders::show_parameters(const std::vector<Parameter>& parameters) {
  const bool same =
      std::equal(rows_.begin(), rows_.end(), parameters.begin(), parameters.end(),
                 [](const Row& row, const Parameter& p) { return have_one_slider(row.parameter, p); });
  if (!same) rebuild(parameters);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const QSignalBlocker quiet(rows_[i].slider);
    rows_[i].slider->setValue(ParameterScale(parameters[i]).place_of(parameters[i].value));
    show_value(rows_[i], parameters[i].value);
  }
}

void ParameterSliders::rebuild(const std::vector<Parameter>& parameters) {
  for (const Row& row : rows_) {
    layout()->removeWidget(row.line);
    row.line->hide();
    // One of them may be what the learner is moving at this moment.
    row.line->deleteLater();
  }
  rows_.clear();
  for (const Parameter& parameter : parameters) {
    const QString letter = to_text(parameter.name);
    const ParameterScale scale(parameter);
    auto* line = new QWidget(this);
    auto* words = new QLabel(line);
    words->setObjectName(QStringLiteral("parameter_%1_value").arg(letter));
    auto* slider = new QSlider(Qt::Horizontal, line);
    slider->setObjectName(QStringLiteral("parameter_%1").arg(letter));
    slider->setAccessibleName(tr("Parameter %1").arg(letter));
    slider->setToolTip(tr("%1 from %2 to %3. Left and Right: one step. Page Up and Page Down: ten steps")
                           .arg(letter, QLocale().toString(parameter.from, 'g', kSignificant),
                                QLocale().toString(parameter.to, 'g', kSignificant)));
    slider->setRange(0, scale.steps());
    slider->setPageStep(10);
    auto* column = new QVBoxLayout(line);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(words);
    column->addWidget(slider);
    layout()->addWidget(line);
    const Row row{parameter, line, words, slider};
    connect(slider, &QSlider::valueChanged, this, [this, row, scale, letter](int place) {
      const double value = scale.value_at(place);
      show_value(row, value);
      emit moved(letter, value);
    });
    rows_.push_back(row);
  }
  setVisible(!rows_.empty());
  emit rebuilt();
}

void ParameterSliders::show_value(const Row& row, double value) {
  const QString text =
      tr("%1 = %2").arg(to_text(row.parameter.name), QLocale().toString(value, 'g', kSignificant));
  row.words->setText(text);
  row.slider->setAccessibleDescription(text);
}

std::vector<QWidget*> ParameterSliders::sliders() const {
  std::vector<QWidget*> all;
  for (const Row& row : rows_) all.push_back(row.slider);
  return all;
}

}  // namespace nazori::ui
