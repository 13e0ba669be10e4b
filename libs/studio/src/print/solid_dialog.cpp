// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/solid_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFontInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

#include "nazori/studio/print/machine_options.h"
#include "nazori/studio/print/relief_view.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/controls/spoken_line.h"
#include "nazori/widgets/events/signals.h"
#include "nazori/widgets/page/window_parts.h"
#include "nazori/widgets/settings/stored_settings.h"
#include "nazori/widgets/words/error_text.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kSoon_ms = 150;
constexpr int kWide_ems = 30;  ///< from here on the picture stands beside the options
constexpr int kSmallest_mm = 10;
constexpr int kLargest_mm = 500;
constexpr int kLongestName = 40;
enum Kind { raised, grooves };

QString settings_group() { return QStringLiteral("model"); }

/// A name that every file system takes: "y = x/2" becomes "y = x-2".
QString file_name(const QString& subject) {
  static const QRegularExpression forbidden(QStringLiteral("[/\\\\:*?\"<>|\\x00-\\x1F]"));
  return QString(subject).replace(forbidden, QStringLiteral("-")).left(kLongestName).trimmed();
}

}  // namespace

SolidDialog::SolidDialog(WindowParts& parts, SolidSubject subject, QWidget* parent)
    : QDialog(parent),
      parts_(parts),
      subject_(std::move(subject)),
      kind_(named(new QComboBox(this), "solid_kind", tr("Lines"))),
      size_(named(new QSpinBox(this), "solid_size", tr("Size"))),
      numbers_(named(new QCheckBox(tr("Stroke &numbers in braille"), this), "solid_numbers")),
      dots_(named(new QCheckBox(tr("&Dots where strokes start"), this), "solid_dots")),
      hole_(named(new QCheckBox(tr("&Hole to hang it up"), this), "solid_hole")),
      mould_(named(new QCheckBox(tr("&Mould, to cast several"), this), "solid_mould")),
      view_(named(new ReliefView(this), "solid_picture", tr("The model from above"))),
      area_(new QScrollArea(this)),
      words_(sentence_label("solid_words", this)),
      spoken_(new SpokenLine(this)),
      maker_(parts.inbox()) {
  setObjectName(QStringLiteral("solid_dialog"));
  setWindowTitle(tr("Make a model to touch: %1").arg(subject_.name));
  kind_->addItems({tr("Raised, for fingers"), tr("Grooves, for a stylus")});
  make_narrow(kind_, 12);
  size_->setRange(kSmallest_mm, kLargest_mm);
  size_->setSuffix(tr(" mm"));
  auto* form_widget = named(new QWidget(this), "information_content");
  auto* form = new QFormLayout(form_widget);
  form->setContentsMargins(0, 0, 8, 0);
  form->setSpacing(10);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("&Lines"), kind_);
  form->addRow(tr("Si&ze of the square"), size_);
  for (auto* check : {numbers_, dots_, hole_, mould_}) form->addRow(check);
  if (subject_.plot) form->setRowVisible(kind_, false);
  machines_ = new MachineOptions(*form, this);
  area_->setFrameShape(QFrame::NoFrame);
  make_scrolling(area_, form_widget);
  auto* buttons = dialog_buttons(QDialogButtonBox::Close, this);
  save_ = named(buttons->addButton(tr("&Save…"), QDialogButtonBox::ActionRole), "solid_save");
  save_->setDefault(true);
  sides_ = new QBoxLayout(QBoxLayout::LeftToRight);
  sides_->setSpacing(12);
  sides_->addWidget(area_, 2);
  sides_->addWidget(view_, 3);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(16, 16, 16, 12);
  all->addLayout(sides_, 1);
  all->addWidget(words_);
  all->addWidget(buttons);

  load();
  soon_.setSingleShot(true);
  soon_.setInterval(kSoon_ms);
  connect(&soon_, &QTimer::timeout, this, &SolidDialog::request);
  connect(kind_, &QComboBox::currentIndexChanged, this, &SolidDialog::choose_later);
  connect(size_, &QSpinBox::valueChanged, this, &SolidDialog::choose_later);
  for (auto* check : {numbers_, dots_, hole_, mould_})
    connect(check, &QCheckBox::toggled, this, &SolidDialog::choose_later);
  connect(machines_, &MachineOptions::depth_changed, this, &SolidDialog::choose_later);
  connect(save_, &QPushButton::clicked, this, &SolidDialog::ask_and_save);
  subscribe(maker_.shown, this, [this](const practice::SolidView& view) { show_view(view); });
  subscribe(maker_.refused, this, [this](const base::Error& error) {
    view_->clear();
    say(tr("There is no model: %1.").arg(reason(error)), true);
  });
  subscribe(maker_.saved, this, [this](const std::filesystem::path& path) {
    parts_.announce(Feedback::good, tr("Saved as %1.").arg(QDir::toNativeSeparators(to_text(path.string()))));
    accept();
  });
  subscribe(maker_.not_saved, this, [this](const std::filesystem::path& path, const base::Error& error) {
    save_->setEnabled(true);
    say(tr("%1: %2. Nothing was saved.").arg(to_text(path.filename().string()), reason(error)), true);
  });
  show_what_matters();
  say(tr("Making the model…"), false);
  save_->setEnabled(false);
  request();
  if (parent != nullptr) {
    const int em = QFontInfo(font()).pixelSize();
    resize(QSize(em * 54, em * 34).boundedTo(parent->size() * 0.95));
  }
}

SolidDialog::~SolidDialog() = default;

practice::SolidSettings SolidDialog::settings() const {
  practice::SolidSettings chosen;
  chosen.raised = kind_->currentIndex() == raised;
  chosen.mould = mould_->isChecked();
  chosen.plate.side_mm = size_->value();
  chosen.plate.depth_mm = machines_->depth_mm();
  chosen.plate.hanging_hole = hole_->isChecked();
  chosen.plate.strokes.numbers = numbers_->isChecked();
  chosen.plate.strokes.start_dots = dots_->isChecked();
  return chosen;
}

void SolidDialog::load() {
  QSettings stored(parts_.settings_file(), QSettings::IniFormat);
  stored.beginGroup(settings_group());
  const base::Settings values = read_settings(stored);
  const practice::SolidSettings usual;
  kind_->setCurrentIndex(base::flag_setting(values, "raised", usual.raised) ? raised : grooves);
  const bool plot = subject_.plot != nullptr;
  size_->setValue(static_cast<int>(base::number_setting(
      values, plot ? "plot_size_mm" : "size_mm",
      plot ? model::RaisedPlotSettings().side_mm : usual.plate.side_mm, kSmallest_mm, kLargest_mm)));
  numbers_->setChecked(base::flag_setting(values, "numbers", true));
  dots_->setChecked(base::flag_setting(values, "start_dots", true));
  hole_->setChecked(base::flag_setting(values, "hole", true));
  mould_->setChecked(base::flag_setting(values, "mould", false));
  machines_->load(values);
}

void SolidDialog::store_choice() const {
  QSettings stored(parts_.settings_file(), QSettings::IniFormat);
  stored.beginGroup(settings_group());
  base::Settings values = read_settings(stored);
  base::set_flag(values, "raised", kind_->currentIndex() == raised);
  base::set_number(values, subject_.plot ? "plot_size_mm" : "size_mm", size_->value());
  base::set_flag(values, "numbers", numbers_->isChecked());
  base::set_flag(values, "start_dots", dots_->isChecked());
  base::set_flag(values, "hole", hole_->isChecked());
  base::set_flag(values, "mould", mould_->isChecked());
  machines_->store(values);
  write_settings(stored, values);
}

void SolidDialog::show_what_matters() {
  const bool tablet = subject_.plot == nullptr;
  const bool has_marks = tablet && kind_->currentIndex() == raised;
  numbers_->setVisible(has_marks);
  dots_->setVisible(has_marks);
  hole_->setVisible(tablet && !mould_->isChecked());
  using Made = MachineOptions::Made;
  if (tablet)
    machines_->show_for(has_marks ? Made::raised_tablet : Made::grooved_tablet);
  else
    machines_->show_for(is_surface() ? Made::surface : Made::plot);
}

void SolidDialog::choose_later() {
  show_what_matters();
  fit_options();
  save_->setEnabled(false);
  soon_.start();
}

void SolidDialog::request() {
  maker_.show({practice::without_labels(subject_.tablets), subject_.plot, settings()});
}

void SolidDialog::show_view(const practice::SolidView& view) {
  // An older model may arrive while the newest choice still waits to be asked for.
  if (soon_.isActive()) return;
  solid_ = view.solid;
  const auto mm = [](double value) { return QLocale().toString(value, 'f', 0); };
  const auto& solid = *view.solid;
  QString sentence =
      tr("%1 × %2 × %3 mm")
          .arg(mm(solid.width_mm), mm(solid.height_mm), QLocale().toString(solid.thickness_mm, 'f', 1)) +
      QStringLiteral(" · ") + tr("%1 triangles").arg(QLocale().toString(solid.mesh.triangles.size())) +
      QStringLiteral(" · ") + (view.is_watertight ? tr("watertight") : tr("not watertight"));
  if (!solid.without_number.empty()) {
    QStringList strokes;
    for (const int stroke : solid.without_number) strokes.append(QString::number(stroke));
    sentence += QLatin1Char('\n') + tr("No room for the numbers of strokes %1: a larger model has more.")
                                        .arg(strokes.join(QStringLiteral(", ")));
  }
  view_->show_picture(view.picture, sentence);
  save_->setEnabled(true);
  say(sentence, false);
}

void SolidDialog::say(const QString& sentence, bool wrong) {
  words_->setText(wrong ? QStringLiteral("✗ ") + sentence : sentence);
  spoken_->speak(wrong ? Urgency::at_once : Urgency::queued, sentence);
}

bool SolidDialog::is_surface() const { return subject_.plot && subject_.plot->request.plot.is_surface(); }

QStringList SolidDialog::file_kinds() const {
  QStringList kinds{tr("3MF, with its size in millimetres (*.3mf)"), tr("STL (*.stl)")};
  if (is_surface()) return kinds;
  // Machines that cut make grooves, and paper that swells or is embossed has raised lines.
  if (subject_.plot || kind_->currentIndex() == raised)
    kinds << tr("PDF for swell paper (*.pdf)") << tr("BRF for a braille embosser (*.brf)");
  else
    kinds << tr("G-code for a mill (*.nc)") << tr("SVG for a laser cutter (*.svg)");
  return kinds;
}

void SolidDialog::ask_and_save() {
  QFileDialog dialog(this, tr("Save the model"));
  dialog.setObjectName(QStringLiteral("solid_file_dialog"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setNameFilters(file_kinds());
  dialog.setDefaultSuffix(QStringLiteral("3mf"));
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    dialog.setDefaultSuffix(filter.section(QLatin1Char('.'), -1).remove(QLatin1Char(')')));
  });
  dialog.setDirectory(parts_.preferences().start_folder());
  dialog.selectFile(file_name(subject_.name));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString path = dialog.selectedFiles().front();
  parts_.preferences().folder = QFileInfo(path).absolutePath();
  parts_.save_later();
  save(path);
}

void SolidDialog::save(const QString& path) {
  if (!solid_) return;
  save_->setEnabled(false);
  if (const auto kind = practice::touch_kind_of(path.toStdString()); kind) {
    return maker_.save(practice::TouchRequest{*kind, subject_.tablets, subject_.plot, settings(),
                                              machines_->machines(), subject_.name.toStdString()},
                       path.toStdString());
  }
  maker_.save(solid_, path.toStdString(), subject_.name.toStdString());
}

void SolidDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  const bool wide = event->size().width() >= QFontInfo(font()).pixelSize() * kWide_ems;
  // In a narrow window the picture stands above the options.
  sides_->setDirection(wide ? QBoxLayout::LeftToRight : QBoxLayout::BottomToTop);
  sides_->setStretch(0, wide ? 2 : 3);
  sides_->setStretch(1, wide ? 3 : 2);
  fit_options();
}

void SolidDialog::fit_options() {
  // The options scroll up and down only, so they must not be wider than what shows them.
  area_->setMinimumWidth(area_->widget()->minimumSizeHint().width() +
                         area_->verticalScrollBar()->sizeHint().width());
}

void SolidDialog::done(int result) {
  store_choice();
  QDialog::done(result);
  parts_.focus_tablet();
}

void ask_solid(WindowParts& parts, SolidSubject subject) {
  auto* dialog = new SolidDialog(parts, std::move(subject), &parts.window());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

}  // namespace nazori::ui
