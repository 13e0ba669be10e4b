// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/machine_options.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSpinBox>
#include <algorithm>

#include "nazori/model/laser.h"
#include "nazori/widgets/controls/action_set.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

constexpr int kNarrow = 12;
// The ranges of model::MillSettings, which the command line has, too.
constexpr double kFinestCutter_mm = 0.2;
constexpr double kLargestCutter_mm = 20;
constexpr double kFinestPass_mm = 0.05;
constexpr double kDeepestPass_mm = 50;
constexpr double kShallowest_mm = 0.1;
constexpr double kDeepest_mm = 5;  // a plate with grooves is 6 mm thick and keeps 1 mm
constexpr int kPapers = 3;         // a4, b5, letter: embossed or swollen paper is not hanshi

}  // namespace

MachineOptions::MachineOptions(QFormLayout& form, QObject* parent) : QObject(parent), form_(form) {
  depth_ = add_length("solid_depth", tr("De&pth of the grooves"), kShallowest_mm, kDeepest_mm, 0.5);
  depth_->setDecimals(1);
  cutter_ =
      add_length("solid_cutter", tr("C&utter of the mill (.nc)"), kFinestCutter_mm, kLargestCutter_mm, 0.5);
  pass_ = add_length("solid_pass", tr("Depth of one p&ass (.nc)"), kFinestPass_mm, kDeepestPass_mm, 0.5);
  layers_ = named(new QSpinBox(form.parentWidget()), "solid_layers",
                  without_mnemonic(tr("La&yers of the laser (.svg)")));
  layers_->setRange(model::kFewestLayers, model::kMostLayers);
  form.addRow(tr("La&yers of the laser (.svg)"), layers_);
  paper_ =
      named(new QComboBox(form.parentWidget()), "solid_paper", without_mnemonic(tr("Swell pa&per (.pdf)")));
  paper_->addItems({tr("A4"), tr("B5"), tr("Letter")});
  make_narrow(paper_, kNarrow);
  form.addRow(tr("Swell pa&per (.pdf)"), paper_);
  english_ =
      named(new QComboBox(form.parentWidget()), "solid_english", without_mnemonic(tr("&English braille")));
  english_->addItems({tr("Uncontracted"), tr("Contracted (UEB)")});
  make_narrow(english_, kNarrow);
  form.addRow(tr("&English braille"), english_);
  connect(depth_, &QDoubleSpinBox::valueChanged, this, &MachineOptions::depth_changed);
}

QDoubleSpinBox* MachineOptions::add_length(const char* name, const QString& text, double low, double high,
                                           double step) {
  auto* spin = named(new QDoubleSpinBox(form_.parentWidget()), name, without_mnemonic(text));
  spin->setRange(low, high);
  spin->setSingleStep(step);
  spin->setSuffix(tr(" mm"));
  form_.addRow(text, spin);
  return spin;
}

void MachineOptions::show_for(Made made) {
  for (QWidget* row : {static_cast<QWidget*>(depth_), static_cast<QWidget*>(cutter_),
                       static_cast<QWidget*>(pass_), static_cast<QWidget*>(layers_)})
    form_.setRowVisible(row, made == Made::grooved_tablet);
  form_.setRowVisible(paper_, made == Made::raised_tablet || made == Made::plot);
  form_.setRowVisible(english_, made == Made::raised_tablet);
}

practice::TouchMachines MachineOptions::machines() const {
  practice::TouchMachines machines;
  machines.mill.cutter_mm = cutter_->value();
  machines.mill.pass_depth_mm = pass_->value();
  machines.layers = layers_->value();
  machines.paper = static_cast<print::Paper>(paper_->currentIndex());
  machines.english = static_cast<model::EnglishBraille>(english_->currentIndex());
  return machines;
}

double MachineOptions::depth_mm() const { return depth_->value(); }

void MachineOptions::load(const base::Settings& values) {
  const practice::TouchMachines usual;
  depth_->setValue(base::number_setting(values, "depth_mm", model::TabletPlateSettings().depth_mm,
                                        kShallowest_mm, kDeepest_mm));
  cutter_->setValue(
      base::number_setting(values, "cutter_mm", usual.mill.cutter_mm, kFinestCutter_mm, kLargestCutter_mm));
  pass_->setValue(base::number_setting(values, "pass_depth_mm", usual.mill.pass_depth_mm, kFinestPass_mm,
                                       kDeepestPass_mm));
  layers_->setValue(static_cast<int>(
      base::number_setting(values, "layers", usual.layers, model::kFewestLayers, model::kMostLayers)));
  paper_->setCurrentIndex(static_cast<int>(base::number_setting(values, "paper", 0, 0, kPapers - 1)));
  english_->setCurrentIndex(base::flag_setting(values, "contracted", false) ? 1 : 0);
}

void MachineOptions::store(base::Settings& values) const {
  base::set_number(values, "depth_mm", depth_->value());
  base::set_number(values, "cutter_mm", cutter_->value());
  base::set_number(values, "pass_depth_mm", pass_->value());
  base::set_number(values, "layers", layers_->value());
  base::set_number(values, "paper", paper_->currentIndex());
  base::set_flag(values, "contracted", english_->currentIndex() == 1);
}

}  // namespace nazori::ui
