// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/print/worksheet_options.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <cmath>

#include "nazori/widgets/controls/list_choice.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

using practice::WorksheetSource;
using print::Layout;

constexpr int kLongestTitle = 60;
constexpr int kNarrow = 12;  ///< letters of a box that fit at least

}  // namespace

WorksheetOptions::WorksheetOptions(const study::LearnerStore& store, char32_t shown, QWidget* parent)
    : QWidget(parent), shown_(shown), form_(new QFormLayout(this)) {
  setObjectName(QStringLiteral("information_content"));
  form_->setContentsMargins(0, 0, 8, 0);
  form_->setSpacing(8);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);

  source_ = add_box("worksheet_source", tr("&Characters"), {});
  if (shown != 0)
    source_->addItem(tr("The character shown: %1").arg(to_text(shown)),
                     static_cast<int>(WorksheetSource::shown));
  source_->addItem(tr("A list"), static_cast<int>(WorksheetSource::list));
  source_->addItem(tr("Today's reviews"), static_cast<int>(WorksheetSource::due));
  source_->addItem(tr("Difficult characters"), static_cast<int>(WorksheetSource::difficult));
  source_->addItem(tr("From a text"), static_cast<int>(WorksheetSource::text));
  list_ = named(new ListChoice(this), "worksheet_list", tr("List"));
  list_->fill(store);
  form_->addRow(tr("&List"), list_);
  text_ = named(new QPlainTextEdit(this), "worksheet_text", tr("Text"));
  text_->setTabChangesFocus(true);
  text_->setFixedHeight(QFontInfo(font()).pixelSize() * 6);
  text_->setPlaceholderText(tr("Paste a text here"));
  form_->addRow(tr("Te&xt"), text_);

  layout_ = add_box(
      "worksheet_layout", tr("&Kind"),
      {tr("Practice sheet"), tr("Quiz"), tr("Flash cards"), tr("Manuscript paper"), tr("Brush sheet")});
  paper_ = add_box("worksheet_paper", tr("&Paper"), {tr("A4"), tr("B5"), tr("Letter"), tr("Hanshi")});
  cell_ = add_spin("worksheet_cell", tr("Cell si&ze"), static_cast<int>(print::kSmallestCell_mm),
                   static_cast<int>(print::kLargestCell_mm), tr(" mm"));
  guide_ = add_box("worksheet_guide", tr("&Guide lines"),
                   {tr("None"), tr("Cross 十"), tr("Four fields 田"), tr("Eight parts 米")});
  QStringList counts;
  for (const int count : print::kPerSheet) counts.push_back(QString::number(count));
  per_sheet_ = add_box("worksheet_per_sheet", tr("C&haracters per sheet"), counts);
  whole_page_ = add_check("worksheet_whole_page", tr("&One character a page"));
  rows_ = add_spin("worksheet_rows", tr("&Rows per character"), 0, print::kMostRows, {});
  copies_ = add_spin("worksheet_copies", tr("Cells to &trace, fading"), 0, print::kMostRows, {});
  steps_ = add_check("worksheet_steps", tr("Stroke &order, step by step"));
  numbers_ = add_check("worksheet_numbers", tr("Stroke &numbers"));
  arrows_ = add_check("worksheet_arrows", tr("&Arrows on the strokes"));
  facts_ = add_check("worksheet_facts", tr("Readings, &meanings and words"));
  answers_ = add_check("worksheet_answers", tr("Ans&wers on the back"));
  vertical_ = add_check("worksheet_vertical", tr("&Vertical writing"));
  booklet_ = add_check("worksheet_booklet", tr("Folded &booklet"));
  name_line_ = add_check("worksheet_name_line", tr("L&ine for name, class and date"));
  title_ = named(new QLineEdit(this), "worksheet_title", tr("Title"));
  title_->setMaxLength(kLongestTitle);
  form_->addRow(tr("Titl&e"), title_);
  language_ = add_box("worksheet_language", tr("Lang&uage of the sheet"), {tr("English"), tr("Japanese")});

  connect(source_, &QComboBox::currentIndexChanged, this, &WorksheetOptions::note_change);
  connect(list_, &QComboBox::currentIndexChanged, this, &WorksheetOptions::note_change);
  connect(text_, &QPlainTextEdit::textChanged, this, &WorksheetOptions::note_change);
  connect(title_, &QLineEdit::textChanged, this, &WorksheetOptions::note_change);
  show_what_matters();
}

QComboBox* WorksheetOptions::add_box(const char* name, const QString& text, const QStringList& entries) {
  auto* box = named(new QComboBox(this), name, QString(text).remove(QLatin1Char('&')));
  box->addItems(entries);
  make_narrow(box, kNarrow);
  form_->addRow(text, box);
  if (!entries.isEmpty()) connect(box, &QComboBox::currentIndexChanged, this, &WorksheetOptions::note_change);
  return box;
}

QSpinBox* WorksheetOptions::add_spin(const char* name, const QString& text, int low, int high,
                                     const QString& unit) {
  auto* spin = named(new QSpinBox(this), name, QString(text).remove(QLatin1Char('&')));
  spin->setRange(low, high);
  spin->setSuffix(unit);
  form_->addRow(text, spin);
  connect(spin, &QSpinBox::valueChanged, this, &WorksheetOptions::note_change);
  return spin;
}

QCheckBox* WorksheetOptions::add_check(const char* name, const QString& text) {
  auto* check = named(new QCheckBox(text, this), name);
  form_->addRow(check);
  connect(check, &QCheckBox::toggled, this, &WorksheetOptions::note_change);
  return check;
}

void WorksheetOptions::note_change() {
  show_what_matters();
  emit changed();
}

void WorksheetOptions::show_what_matters() {
  const auto source = static_cast<WorksheetSource>(source_->currentData().toInt());
  const auto layout = static_cast<Layout>(layout_->currentIndex());
  const bool manuscript = layout == Layout::manuscript;
  const bool practice = layout == Layout::practice;
  const bool brush = layout == Layout::brush;
  const bool has_cells = practice || layout == Layout::quiz;
  const auto set_label = [this](QWidget* field, const QString& text) {
    field->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    if (auto* label = qobject_cast<QLabel*>(form_->labelForField(field))) label->setText(text);
  };
  const auto show = [this](QWidget* field, bool on) {
    field->setVisible(on);
    if (auto* label = form_->labelForField(field)) label->setVisible(on);
  };
  show(source_, !manuscript);
  show(list_, !manuscript && source == WorksheetSource::list);
  show(text_, manuscript || source == WorksheetSource::text);
  show(cell_, has_cells);
  show(guide_, has_cells || brush);
  show(per_sheet_, brush);
  show(whole_page_, practice);
  show(rows_, brush || (practice && !whole_page_->isChecked()));
  show(copies_, practice || brush);
  set_label(rows_, brush ? tr("Sheets o&f the same characters") : tr("&Rows per character"));
  set_label(copies_, brush ? tr("Sheets to &trace, fading") : tr("Cells to &trace, fading"));
  show(steps_, practice);
  show(numbers_, practice || brush || layout == Layout::cards);
  show(arrows_, practice || brush);
  show(facts_, practice);
  show(answers_, layout == Layout::quiz);
  show(vertical_, has_cells);
  show(booklet_, has_cells);
  show(name_line_, has_cells || brush);
  show(title_, has_cells);
}

void WorksheetOptions::set_choice(const practice::WorksheetChoice& choice) {
  const QSignalBlocker quiet(this);
  // Without a shown character the list takes its place.
  const int row = source_->findData(static_cast<int>(choice.source));
  source_->setCurrentIndex(row >= 0 ? row : source_->findData(static_cast<int>(WorksheetSource::list)));
  list_->set_list(to_text(choice.list));
  text_->setPlainText(to_text(choice.text));
  const auto& sheet = choice.sheet;
  layout_->setCurrentIndex(static_cast<int>(sheet.layout));
  paper_->setCurrentIndex(static_cast<int>(sheet.paper));
  guide_->setCurrentIndex(static_cast<int>(sheet.guide));
  language_->setCurrentIndex(static_cast<int>(sheet.language));
  cell_->setValue(static_cast<int>(std::lround(sheet.cell_mm)));
  rows_->setValue(sheet.rows);
  per_sheet_->setCurrentText(QString::number(sheet.per_sheet));
  copies_->setValue(sheet.copies);
  whole_page_->setChecked(sheet.whole_page);
  steps_->setChecked(sheet.steps);
  numbers_->setChecked(sheet.numbers);
  arrows_->setChecked(sheet.arrows);
  facts_->setChecked(sheet.facts);
  answers_->setChecked(sheet.answers);
  vertical_->setChecked(sheet.vertical);
  booklet_->setChecked(sheet.booklet);
  name_line_->setChecked(sheet.name_line);
  title_->setText(to_text(sheet.title));
  show_what_matters();
}

practice::WorksheetChoice WorksheetOptions::choice() const {
  practice::WorksheetChoice choice;
  choice.source = static_cast<WorksheetSource>(source_->currentData().toInt());
  choice.shown = shown_;
  choice.list = list_->list().toStdString();
  choice.text = text_->toPlainText().toStdString();
  auto& sheet = choice.sheet;
  sheet.layout = static_cast<Layout>(layout_->currentIndex());
  sheet.paper = static_cast<print::Paper>(paper_->currentIndex());
  sheet.guide = static_cast<print::Guide>(guide_->currentIndex());
  sheet.language = static_cast<print::Language>(language_->currentIndex());
  sheet.cell_mm = cell_->value();
  sheet.rows = rows_->value();
  sheet.per_sheet = per_sheet_->currentText().toInt();
  sheet.copies = copies_->value();
  sheet.whole_page = whole_page_->isChecked();
  sheet.steps = steps_->isChecked();
  sheet.numbers = numbers_->isChecked();
  sheet.arrows = arrows_->isChecked();
  sheet.facts = facts_->isChecked();
  sheet.answers = answers_->isChecked();
  sheet.vertical = vertical_->isChecked();
  // Cards and manuscript paper fill whole sheets.
  sheet.booklet = booklet_->isChecked() && (sheet.layout == Layout::practice || sheet.layout == Layout::quiz);
  sheet.name_line = name_line_->isChecked();
  sheet.title = title_->text().trimmed().toStdString();
  return choice;
}

}  // namespace nazori::ui
