// SPDX-License-Identifier: Apache-2.0
#include "nazori/studio/workshop/workshop_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "nazori/studio/parts/panel_parts.h"
#include "nazori/studio/workshop/groove_curve.h"
#include "nazori/studio/workshop/part_words.h"
#include "nazori/studio/workshop/parts_editor.h"
#include "nazori/studio/workshop/workshop_actions.h"
#include "nazori/studio/workshop/workshop_words.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kWidth_em = 19;
constexpr int kLongestText = 200;

/// Texts as they are typed into one field: with commas between them, Japanese ones too.
std::vector<std::string> split_texts(const QString& typed) {
  std::vector<std::string> texts;
  for (QString text : QString(typed).replace(QChar(0x3001), QLatin1Char(',')).split(QLatin1Char(','))) {
    text = text.simplified();
    if (!text.isEmpty()) texts.push_back(text.toStdString());
  }
  return texts;
}

QString joined_texts(const std::vector<std::string>& texts) { return joined(texts, QStringLiteral(", ")); }

void set_text(QLineEdit* field, const QString& text) {
  if (field->hasFocus() || field->text() == text) return;
  field->setText(text);
  field->setCursorPosition(0);
}

}  // namespace

WorkshopPanel::WorkshopPanel(const WorkshopActions& actions, QWidget* parent)
    : QScrollArea(parent), content_(named(new QWidget(this), "workshop_panel_content")) {
  setObjectName(QStringLiteral("workshop_panel"));
  setAccessibleName(tr("Strokes and details"));
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  auto* column = make_panel_column(content_);

  column->addWidget(heading(tr("Tool"), content_));
  tool_form_ = add_form(column);
  width_ = named(new QDoubleSpinBox(content_), "workshop_width", tr("Width of the tool"));
  width_->setRange(author::kThinnestTool, author::kWidestTool);
  width_->setDecimals(1);
  width_->setSingleStep(0.5);
  depth_ = named(new QSpinBox(content_), "workshop_depth", tr("Depth of the tool"));
  depth_->setRange(static_cast<int>(std::lround(author::kShallowestTool * 100)), 100);
  depth_->setSingleStep(5);
  depth_->setSuffix(tr(" %"));
  ending_ = named(new QComboBox(content_), "workshop_ending_box", tr("Ending of placed strokes"));
  for (int i = 0; i < static_cast<int>(author::kEndingNames.size()); ++i)
    ending_->addItem(ending_name(static_cast<kanji::StrokeEnding>(i)), i);
  stamp_ = named(new QComboBox(content_), "workshop_stamp_box", tr("Shape of the stamp"));
  for (const auto shape : author::kStampShapes) stamp_->addItem(stamp_name(shape), static_cast<int>(shape));
  tool_form_->addRow(tr("Width (of 109)"), width_);
  tool_form_->addRow(tr("Depth"), depth_);
  tool_form_->addRow(tr("Ending"), ending_);
  tool_form_->addRow(tr("Stamp"), stamp_);

  column->addSpacing(kPanelGap);
  column->addWidget(heading(tr("Strokes"), content_));
  selection_ = text_label("workshop_selection", content_, "muted");
  column->addWidget(selection_);
  strokes_ = named(new QListWidget(content_), "workshop_strokes_list", tr("Strokes in writing order"));
  strokes_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  strokes_->setDragDropMode(QAbstractItemView::InternalMove);
  strokes_->setMinimumHeight(QFontInfo(font()).pixelSize() * 9);
  column->addWidget(strokes_, 2);
  add_buttons(column, {actions.earlier, actions.later, actions.reverse, actions.ending, actions.remove},
              content_);

  width_curve_ = new GrooveCurve(GrooveCurve::Quantity::half_width, "workshop_width_curve", content_);
  depth_curve_ = new GrooveCurve(GrooveCurve::Quantity::depth, "workshop_depth_curve", content_);
  for (auto* curve : {width_curve_, depth_curve_}) {
    column->addWidget(curve);
    connect(curve, &GrooveCurve::point_chosen, this, &WorkshopPanel::point_chosen);
    connect(curve, &GrooveCurve::said, this, &WorkshopPanel::curve_said);
  }
  connect(width_curve_, &GrooveCurve::value_moved, this, &WorkshopPanel::half_width_moved);
  connect(depth_curve_, &GrooveCurve::value_moved, this, &WorkshopPanel::depth_moved);

  column->addSpacing(kPanelGap);
  column->addWidget(heading(tr("Details"), content_));
  auto* details = add_form(column);
  const auto field = [&](const char* name, const QString& label, const QString& hint) {
    auto* made = named(new QLineEdit(content_), name, label);
    made->setMaxLength(kLongestText);
    made->setPlaceholderText(hint);
    details->addRow(label, made);
    connect(made, &QLineEdit::editingFinished, this, &WorkshopPanel::send_facts);
    return made;
  };
  name_ = field("workshop_name", tr("Name"), tr("A character, or what you call it"));
  readings_ = field("workshop_readings", tr("Readings"), tr("With commas between them"));
  meanings_ = field("workshop_meanings", tr("Meanings"), tr("With commas between them"));
  radical_ = field("workshop_radical", tr("Radical"), tr("1 to 214, or a form"));
  author_ = field("workshop_author", tr("Author"), {});
  licence_ = field("workshop_licence", tr("Licence"), QStringLiteral("CC-BY-4.0"));
  source_ = text_label("workshop_source", content_, "muted");
  column->addWidget(source_);
  column->addWidget(heading(tr("Parts"), content_));
  parts_ = new PartsEditor(actions, content_);
  column->addWidget(parts_);

  column->addSpacing(kPanelGap);
  column->addWidget(heading(tr("Check"), content_));
  findings_words_ = sentence_label("workshop_findings_words", content_);
  column->addWidget(findings_words_);
  findings_list_ = named(new QListWidget(content_), "workshop_findings", tr("What the check found"));
  findings_list_->setWordWrap(true);
  findings_list_->setMinimumHeight(QFontInfo(font()).pixelSize() * 7);
  column->addWidget(findings_list_, 1);
  make_scrolling(this, content_);
  show_findings({}, false);

  connect(width_, &QDoubleSpinBox::valueChanged, this, &WorkshopPanel::send_tool);
  connect(depth_, &QSpinBox::valueChanged, this, &WorkshopPanel::send_tool);
  connect(ending_, &QComboBox::activated, this, &WorkshopPanel::send_tool);
  connect(stamp_, &QComboBox::activated, this, &WorkshopPanel::send_tool);
  connect(strokes_, &QListWidget::currentRowChanged, this, [this](int row) {
    if (row >= 0) emit stroke_chosen(static_cast<std::size_t>(row));
  });
  connect(strokes_->model(), &QAbstractItemModel::rowsMoved, this,
          [this](const QModelIndex&, int from, int, const QModelIndex&, int before) {
            emit stroke_dragged(static_cast<std::size_t>(from),
                                static_cast<std::size_t>(before > from ? before - 1 : before));
          });
  connect(parts_, &PartsEditor::parts_typed, this, [this](const std::vector<author::OwnPart>& parts) {
    author::Facts facts = facts_;
    facts.parts = parts;
    emit facts_typed(facts);
  });
  connect(parts_, &PartsEditor::refused, this, &WorkshopPanel::text_refused);
  const auto choose_finding = [this](QListWidgetItem* item) {
    const auto row = static_cast<std::size_t>(findings_list_->row(item));
    if (row < findings_.size()) emit finding_chosen(findings_[row]);
  };
  connect(findings_list_, &QListWidget::itemClicked, this, choose_finding);
  connect(findings_list_, &QListWidget::itemActivated, this, choose_finding);
}

void WorkshopPanel::send_tool() {
  emit tool_changed(width_->value(), depth_->value() / 100.0, ending_->currentData().toInt(),
                    stamp_->currentData().toInt());
}

void WorkshopPanel::show_settings(const author::BenchSettings& settings) {
  const QSignalBlocker no_width(width_), no_depth(depth_);
  width_->setValue(settings.width);
  depth_->setValue(static_cast<int>(std::lround(settings.depth * 100)));
  ending_->setCurrentIndex(ending_->findData(static_cast<int>(settings.ending)));
  stamp_->setCurrentIndex(stamp_->findData(static_cast<int>(settings.stamp)));
  tool_form_->setRowVisible(ending_, settings.tool == author::Tool::place);
  tool_form_->setRowVisible(stamp_, settings.tool == author::Tool::stamp);
}

void WorkshopPanel::show_character(const author::Workbench& bench) {
  const auto& character = bench.character();
  const QString chosen = selection_words(character, bench.selection());
  selection_->setText(chosen.isEmpty() ? character_words(character) : chosen);
  {
    const QSignalBlocker quiet(strokes_);
    const int count = static_cast<int>(character.strokes.size());
    while (strokes_->count() > count) delete strokes_->takeItem(count);
    for (int i = 0; i < count; ++i) {
      const QString words =
          stroke_words(static_cast<std::size_t>(i) + 1, character.strokes[static_cast<std::size_t>(i)]);
      if (i == strokes_->count())
        strokes_->addItem(words);
      else if (strokes_->item(i)->text() != words)
        strokes_->item(i)->setText(words);
    }
    // Setting the same row again would take away what else is chosen in the list.
    const int row = bench.selection().stroke ? static_cast<int>(*bench.selection().stroke) : -1;
    if (strokes_->currentRow() != row) strokes_->setCurrentRow(row, QItemSelectionModel::ClearAndSelect);
    if (row < 0) strokes_->clearSelection();
  }
  const auto& chosen_stroke = bench.selection().stroke;
  const carving::Groove groove = chosen_stroke ? character.strokes[*chosen_stroke].points : carving::Groove();
  for (auto* curve : {width_curve_, depth_curve_}) curve->show_groove(groove, bench.selection().point);
  facts_ = character.facts;
  set_text(name_, to_text(facts_.name));
  set_text(readings_, joined_texts(facts_.readings));
  set_text(meanings_, joined_texts(facts_.meanings));
  set_text(radical_, radical_words(facts_.radical));
  parts_->show_parts(facts_.parts, character.strokes.size());
  set_text(author_, to_text(facts_.rights.author));
  set_text(licence_, to_text(facts_.rights.licence));
  // What comes from KanjiVG keeps its licence and its authors.
  const bool own = facts_.rights.source != author::kKanjiVgSource;
  author_->setReadOnly(!own);
  licence_->setReadOnly(!own);
  source_->setText(facts_.rights.source.empty() ? QString()
                                                : tr("Source: %1").arg(to_text(facts_.rights.source)));
  source_->setVisible(!facts_.rights.source.empty());
}

void WorkshopPanel::send_facts() {
  author::Facts facts = facts_;
  facts.name = name_->text().simplified().toStdString();
  facts.readings = split_texts(readings_->text());
  facts.meanings = split_texts(meanings_->text());
  if (!read_radical(radical_->text(), facts.radical, radical_of_form_)) {
    emit text_refused(
        tr("“%1” is not a radical. Type its number, 1 to 214, or its form.").arg(radical_->text()));
  }
  radical_->setText(radical_words(facts.radical));
  facts.rights.author = author_->text().simplified().toStdString();
  facts.rights.licence = licence_->text().simplified().toStdString();
  if (facts != facts_) emit facts_typed(facts);
}

void WorkshopPanel::focus_curve() {
  ensureWidgetVisible(width_curve_);
  width_curve_->setFocus(Qt::ShortcutFocusReason);
}

void WorkshopPanel::add_part() {
  std::vector<int> chosen;
  for (const auto& index : strokes_->selectionModel()->selectedRows()) chosen.push_back(index.row());
  std::ranges::sort(chosen);
  ensureWidgetVisible(parts_);
  parts_->add(std::move(chosen));
}

bool WorkshopPanel::remove_part() { return parts_->remove(); }

void WorkshopPanel::show_findings(const std::vector<author::Finding>& findings, bool checked) {
  findings_ = findings;
  findings_list_->clear();
  for (const auto& finding : findings) {
    const QString sign = finding.severity == author::Severity::error     ? QStringLiteral("✗ ")
                         : finding.severity == author::Severity::warning ? QStringLiteral("⚠ ")
                                                                         : QStringLiteral("· ");
    findings_list_->addItem(sign + finding_words(finding));
  }
  findings_list_->setVisible(!findings.empty());
  findings_words_->setText(!checked           ? tr("Not checked yet.")
                           : findings.empty() ? tr("✓ Nothing was found.")
                                              : tr("%n remarks", nullptr, static_cast<int>(findings.size())));
}

void WorkshopPanel::keyPressEvent(QKeyEvent* event) {
  const bool ends_field = (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) &&
                          qobject_cast<QLineEdit*>(window()->focusWidget()) != nullptr;
  if (ends_field || event->key() == Qt::Key_Escape)
    emit left();
  else
    QScrollArea::keyPressEvent(event);
}

void WorkshopPanel::focus_name() {
  ensureWidgetVisible(name_);
  name_->setFocus(Qt::ShortcutFocusReason);
  name_->selectAll();
}

QSize WorkshopPanel::sizeHint() const { return {QFontInfo(font()).pixelSize() * kWidth_em, 400}; }

}  // namespace nazori::ui
