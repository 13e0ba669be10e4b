// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/machine_options.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QSpinBox>
#include <algorithm>
#include <array>

#include "nazori/model/laser.h"
#include "nazori/widgets/controls/action_set.h"
#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

constexpr int kNarrow = 12;
constexpr double kShallowest_mm = 0.1;
constexpr double kDeepest_mm = 5;  // a plate with grooves is 6 mm thick and keeps 1 mm
constexpr int kPapers = 3;         // a4, b5, letter: embossed or swollen paper is not hanshi
constexpr int kFewestCells = 12;
constexpr int kMostCells = 100;

/// A row for a setting of the mill. The ranges are those of model::MillSettings.
struct MillRow {
  const char* name;
  const char* key;
  const char* text;
  double model::MillSettings::*value;
  double low, high, step;
  int decimals;
  const char* unit;
};
constexpr std::array<MillRow, MachineOptions::kMillRows> kMill{{
    {"solid_cutter", "cutter_mm",
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", "C&utter of the mill (.nc)"),
     &model::MillSettings::cutter_mm, 0.2, 20, 0.5, 2,
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", " mm")},
    {"solid_pass", "pass_depth_mm",
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", "Depth of one p&ass (.nc)"),
     &model::MillSettings::pass_depth_mm, 0.05, 50, 0.5, 2,
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", " mm")},
    {"solid_step_over", "step_over_mm",
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", "Dis&tance between lines of the last pass (.nc)"),
     &model::MillSettings::step_over_mm, 0.02, 5, 0.05, 2,
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", " mm")},
    {"solid_feed", "feed_mm_min",
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", "Sp&eed along a groove (.nc)"),
     &model::MillSettings::feed_mm_min, 10, 20'000, 50, 0,
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", " mm/min")},
    {"solid_plunge", "plunge_mm_min",
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", "Speed straight do&wn (.nc)"),
     &model::MillSettings::plunge_mm_min, 10, 20'000, 50, 0,
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", " mm/min")},
    {"solid_safe", "safe_mm", QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", "Height o&f rapid moves (.nc)"),
     &model::MillSettings::safe_mm, 1, 100, 1, 1, QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", " mm")},
    {"solid_spindle", "spindle_rpm", QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", "Sp&indle (.nc)"),
     &model::MillSettings::spindle_rpm, 0, 60'000, 500, 0,
     QT_TRANSLATE_NOOP("nazori::ui::MachineOptions", " rpm")},
}};

}  // namespace

MachineOptions::MachineOptions(QFormLayout& form, QObject* parent) : QObject(parent), form_(form) {
  depth_ = add_number("solid_depth", tr("De&pth of the grooves"), kShallowest_mm, kDeepest_mm, 0.5);
  depth_->setDecimals(1);
  depth_->setSuffix(tr(" mm"));
  for (std::size_t i = 0; i < kMill.size(); ++i) {
    const MillRow& row = kMill[i];
    mill_[i] = add_number(row.name, tr(row.text), row.low, row.high, row.step);
    mill_[i]->setDecimals(row.decimals);
    mill_[i]->setSuffix(tr(row.unit));
  }
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
  columns_ = add_count("solid_columns", tr("&Cells in a line (.brf)"));
  lines_ = add_count("solid_lines", tr("Lines on a pa&ge (.brf)"));
  connect(depth_, &QDoubleSpinBox::valueChanged, this, &MachineOptions::depth_changed);
}

QDoubleSpinBox* MachineOptions::add_number(const char* name, const QString& text, double low, double high,
                                           double step) {
  auto* spin = named(new QDoubleSpinBox(form_.parentWidget()), name, without_mnemonic(text));
  spin->setRange(low, high);
  spin->setSingleStep(step);
  form_.addRow(text, spin);
  return spin;
}

QSpinBox* MachineOptions::add_count(const char* name, const QString& text) {
  auto* spin = named(new QSpinBox(form_.parentWidget()), name, without_mnemonic(text));
  spin->setRange(kFewestCells, kMostCells);
  form_.addRow(text, spin);
  return spin;
}

void MachineOptions::show_for(Made made) {
  const bool is_grooved = made == Made::grooved_tablet;
  for (QWidget* row : {static_cast<QWidget*>(depth_), static_cast<QWidget*>(layers_)})
    form_.setRowVisible(row, is_grooved);
  for (QWidget* row : mill_) form_.setRowVisible(row, is_grooved);
  const bool is_paper = made == Made::raised_tablet || made == Made::plot;
  for (QWidget* row :
       {static_cast<QWidget*>(paper_), static_cast<QWidget*>(columns_), static_cast<QWidget*>(lines_)})
    form_.setRowVisible(row, is_paper);
  form_.setRowVisible(english_, made == Made::raised_tablet);
}

practice::TouchMachines MachineOptions::machines() const {
  practice::TouchMachines machines;
  for (std::size_t i = 0; i < kMill.size(); ++i) machines.mill.*kMill[i].value = mill_[i]->value();
  machines.layers = layers_->value();
  machines.paper = static_cast<print::Paper>(paper_->currentIndex());
  machines.embosser = {columns_->value(), lines_->value()};
  machines.english = static_cast<model::EnglishBraille>(english_->currentIndex());
  return machines;
}

double MachineOptions::depth_mm() const { return depth_->value(); }

void MachineOptions::load(const base::Settings& values) {
  const practice::TouchMachines usual;
  depth_->setValue(base::number_setting(values, "depth_mm", model::TabletPlateSettings().depth_mm,
                                        kShallowest_mm, kDeepest_mm));
  for (std::size_t i = 0; i < kMill.size(); ++i) {
    const MillRow& row = kMill[i];
    mill_[i]->setValue(base::number_setting(values, row.key, usual.mill.*row.value, row.low, row.high));
  }
  const auto count = [&](const char* key, int value) {
    return static_cast<int>(base::number_setting(values, key, value, kFewestCells, kMostCells));
  };
  columns_->setValue(count("braille_columns", usual.embosser.columns));
  lines_->setValue(count("braille_lines", usual.embosser.lines));
  layers_->setValue(static_cast<int>(
      base::number_setting(values, "layers", usual.layers, model::kFewestLayers, model::kMostLayers)));
  paper_->setCurrentIndex(static_cast<int>(base::number_setting(values, "paper", 0, 0, kPapers - 1)));
  english_->setCurrentIndex(base::flag_setting(values, "contracted", false) ? 1 : 0);
}

void MachineOptions::store(base::Settings& values) const {
  base::set_number(values, "depth_mm", depth_->value());
  for (std::size_t i = 0; i < kMill.size(); ++i) base::set_number(values, kMill[i].key, mill_[i]->value());
  base::set_number(values, "braille_columns", columns_->value());
  base::set_number(values, "braille_lines", lines_->value());
  base::set_number(values, "layers", layers_->value());
  base::set_number(values, "paper", paper_->currentIndex());
  base::set_flag(values, "contracted", english_->currentIndex() == 1);
}

}  // namespace nazori::ui
