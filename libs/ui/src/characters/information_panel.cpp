// SPDX-License-Identifier: Apache-2.0
#include "characters/information_panel.h"

#include <QFontInfo>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "characters/confusable_view.h"
#include "characters/glyph_view.h"
#include "characters/word_label.h"
#include "nazori/kanji/kana.h"
#include "nazori/kanji/meanings.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {
namespace {

constexpr int kMargin = 16;

void make_selectable(QLabel* label) {
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setCursor(Qt::IBeamCursor);
}

/// The meanings in the language of the interface where KANJIDIC2 has it, else in English.
QString meanings_of(const kanji::DictionaryEntry& entry) {
  const auto own = kanji::meanings_in(QLocale().name().section(QLatin1Char('_'), 0, 0).toStdString(), entry);
  return joined(own.empty() ? kanji::meanings_in("en", entry) : own, QStringLiteral(", "));
}

/// The word that shows a reading; nullptr where no common word has it.
const practice::ReadingUse* use_of(const practice::CharacterWords& words, const std::string& reading) {
  const auto use = std::find_if(words.uses.begin(), words.uses.end(),
                                [&reading](const auto& one) { return one.reading == reading; });
  return use == words.uses.end() ? nullptr : &*use;
}

}  // namespace

InformationPanel::InformationPanel(QWidget* parent)
    : QScrollArea(parent),
      content_(named(new QWidget(this), "information_content")),
      head_(new QBoxLayout(QBoxLayout::LeftToRight)),
      glyph_(new GlyphView(content_)),
      meanings_(text_label("meanings", content_)),
      facts_(text_label("facts", content_, "muted")) {
  setObjectName(QStringLiteral("information_panel"));
  setAccessibleName(tr("About the character"));

  make_selectable(meanings_);
  make_selectable(facts_);

  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(14);
  auto* beside = new QVBoxLayout;
  beside->setSpacing(6);
  beside->addWidget(meanings_);
  beside->addWidget(facts_);
  beside->addStretch(1);
  head_->setSpacing(14);
  head_->addWidget(glyph_, 0, Qt::AlignTop | Qt::AlignLeft);
  head_->addLayout(beside, 1);
  column->addLayout(head_);
  on_ = add_section(QStringLiteral("on"), tr("On'yomi"), 14, 2);
  kun_ = add_section(QStringLiteral("kun"), tr("Kun'yomi"), 14, 2);
  radical_ = add_section(QStringLiteral("radical"), tr("Radical"), 8, 2);
  parts_ = add_section(QStringLiteral("parts"), tr("Parts"), 8, 8);
  words_ = add_section(QStringLiteral("words"), tr("Words"), 0, 0);
  word_list_ = new QVBoxLayout;
  word_list_->setSpacing(9);
  word_list_->setContentsMargins(0, 0, 0, 0);
  static_cast<QVBoxLayout*>(words_.box->layout())->addLayout(word_list_);
  confusables_ = add_section(QStringLiteral("confusables"), tr("Easily confused"), 8, 8);
  column->addStretch(1);
  make_scrolling(this, content_);
  rebuild();
}

InformationPanel::Section InformationPanel::add_section(const QString& name, const QString& title,
                                                        int horizontal_gap, int vertical_gap) {
  auto* box = new QWidget(content_);
  box->setObjectName(name + QStringLiteral("_section"));
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(3);
  auto* heading = with_role(new QLabel(title, box), "heading");
  heading->setWordWrap(true);
  column->addWidget(heading);
  auto* flow = new FlowLayout(horizontal_gap, vertical_gap);
  column->addLayout(flow);
  static_cast<QVBoxLayout*>(content_->layout())->addWidget(box);
  return {box, flow};
}

QLabel* InformationPanel::add_label(FlowLayout* flow, const QString& text, double scale, bool textbook,
                                    bool muted) {
  auto* label = new QLabel(text, flow->parentWidget());
  const double size_pt = QFontInfo(font()).pointSizeF() * scale;
  if (textbook) {
    label->setFont(textbook_font(size_pt));
  } else {
    QFont scaled = font();
    scaled.setPointSizeF(size_pt);
    label->setFont(scaled);
  }
  if (muted) with_role(label, "muted");
  label->setMinimumWidth(0);
  make_selectable(label);
  flow->addWidget(label);
  return label;
}

void InformationPanel::show_character(std::shared_ptr<const practice::CharacterSheet> sheet) {
  sheet_ = std::move(sheet);
  rebuild();
  verticalScrollBar()->setValue(0);
}

void InformationPanel::show_own(const QString& name, int map_size, int strokes) {
  sheet_.reset();
  rebuild();
  meanings_->setText(name);
  QStringList facts{tr("Your own tablet")};
  if (map_size > 0) facts.append(tr("%1 × %1 samples").arg(map_size));
  facts.append(tr("%n strokes", nullptr, strokes));
  facts_->setText(facts.join(QStringLiteral(" · ")));
  verticalScrollBar()->setValue(0);
}

void InformationPanel::rebuild() {
  content_->setUpdatesEnabled(false);
  glyph_->setVisible(sheet_ != nullptr && !hides_character_);
  glyph_->show_character(sheet_);
  QFont large = font();
  large.setPointSizeF(QFontInfo(font()).pointSizeF() * 1.2);
  meanings_->setFont(large);
  fit();
  for (const Section* section : {&on_, &kun_, &radical_, &parts_, &words_, &confusables_}) {
    clear_layout(section->flow);
    section->box->setVisible(false);
    if (auto* heading = section->box->findChild<QLabel*>(QString(), Qt::FindDirectChildrenOnly)) {
      QFont small = font();
      small.setPointSizeF(QFontInfo(font()).pointSizeF() * 0.9);
      heading->setFont(small);
    }
  }
  clear_layout(word_list_);
  if (standing_ != nullptr) standing_->setVisible(sheet_ != nullptr && !hides_character_);
  if (sheet_) {
    fill_facts();
    fill_readings();
    if (!hides_character_) {
      fill_radical();
      fill_parts();
      fill_words();
      fill_confusables();
    }
  } else {
    meanings_->clear();
    facts_->clear();
  }
  fit();
  content_->setUpdatesEnabled(true);
}

void InformationPanel::fill_facts() {
  const auto& character = sheet_->character;
  const auto& entry = character.entry;
  const QString meanings = meanings_of(entry);
  const QString letter = [&character] {
    switch (kanji::script_of(character.code_point)) {
      case kanji::Script::hiragana:
        return tr("Hiragana");
      case kanji::Script::katakana:
        return tr("Katakana");
      case kanji::Script::latin:
        return tr("Letter or digit");
      case kanji::Script::other:
        return tr("No meaning given");
    }
    return QString();
  }();
  meanings_->setText(meanings.isEmpty() ? letter : meanings);

  QStringList facts;
  const auto drawn = static_cast<int>(character.strokes.size());
  QString strokes = tr("%n strokes", nullptr, drawn);
  // The sources differ for a few characters. Both counts are shown.
  if (!entry.stroke_counts.empty() && entry.stroke_counts.front() != drawn)
    strokes = tr("%1 here, %2 in the dictionary").arg(strokes).arg(entry.stroke_counts.front());
  facts.append(strokes);
  if (character.own_form) facts.append(tr("your own form instead of the published one"));
  if (entry.grade) {
    if (*entry.grade <= 6)
      facts.append(tr("grade %1").arg(*entry.grade));
    else
      facts.append(*entry.grade == 8 ? tr("secondary school") : tr("used in names"));
  }
  if (entry.frequency)
    facts.append(tr("newspaper frequency: no. %1").arg(QLocale().toString(*entry.frequency)));
  if (entry.old_jlpt_level) facts.append(tr("old JLPT level %1").arg(*entry.old_jlpt_level));
  facts_->setText(facts.join(QStringLiteral(" · ")));
}

void InformationPanel::fill_readings() {
  const auto& entry = sheet_->character.entry;
  const QColor muted = current_colours().muted;
  // The words would give the character away.
  const auto add_example = [&](QLabel* label, const QString& reading, const std::string& published) {
    const auto* use = hides_character_ ? nullptr : use_of(sheet_->helpful, published);
    const bool is_itself = use != nullptr && to_text(use->word.word.text).size() == 1;
    if (use != nullptr && !is_itself) show_example(label, reading, *use);
  };
  for (const auto& on : entry.on_readings) {
    auto* label = add_label(on_.flow, to_text(on), 1.25, true);
    label->setObjectName(QStringLiteral("on_reading"));
    add_example(label, to_text(on), on);
  }
  for (const auto& kun : entry.kun_readings) {
    const kanji::KunReading reading = kanji::split_kun(kun);
    auto* label = add_label(kun_.flow, kun_rich(reading, muted), 1.25, true);
    label->setTextFormat(Qt::RichText);
    label->setObjectName(QStringLiteral("kun_reading"));
    label->setAccessibleName(kun_plain(reading));
    if (!reading.okurigana.empty())
      label->setToolTip(tr("The kanji is read %1; %2 follows in kana (okurigana)")
                            .arg(to_text(reading.stem), to_text(reading.okurigana)));
    add_example(label, kun_plain(reading), kun);
  }
  on_.box->setVisible(!entry.on_readings.empty());
  kun_.box->setVisible(!entry.kun_readings.empty());
}

void InformationPanel::show_example(QLabel* label, const QString& reading, const practice::ReadingUse& use) {
  const auto& word = use.word.word;
  const QString muted = current_colours().muted.name();
  const QString shown = label->textFormat() == Qt::RichText ? label->text() : label->text().toHtmlEscaped();
  label->setTextFormat(Qt::RichText);
  label->setText(QStringLiteral("%1 <span style=\"color:%2; font-size:%3pt\">%4</span>")
                     .arg(shown, muted)
                     .arg(QFontInfo(font()).pointSizeF() * 0.95)
                     .arg(to_text(word.text).toHtmlEscaped()));
  const QString says = tr("Read %1, as in %2 (%3)").arg(reading, to_text(word.text), to_text(word.reading));
  label->setAccessibleName(says);
  label->setToolTip(label->toolTip().isEmpty() ? says : label->toolTip() + QStringLiteral("\n") + says);
}

void InformationPanel::fill_radical() {
  if (!sheet_->radical) return;
  const auto& radical = *sheet_->radical;
  add_label(radical_.flow, QString::number(radical.number), 1.0, false)
      ->setObjectName(QStringLiteral("radical_number"));
  add_label(radical_.flow, to_text(radical.form), 1.4, true)->setObjectName(QStringLiteral("radical_form"));
  // The part is written in another form in this character.
  const auto& parts = sheet_->parts;
  for (const auto& form : radical.variant_forms) {
    const bool here = std::any_of(parts.begin(), parts.end(),
                                  [&form](const practice::Part& p) { return p.element == form; });
    if (here)
      add_label(radical_.flow, to_text(form), 1.4, true)->setObjectName(QStringLiteral("radical_variant"));
  }
  for (const auto& name : radical.japanese_names)
    add_label(radical_.flow, to_text(name), 1.1, true)->setObjectName(QStringLiteral("radical_name"));
  add_label(radical_.flow, to_text(radical.english_name), 1.0, false, true)
      ->setObjectName(QStringLiteral("radical_english"));
  radical_.box->setVisible(true);
}

void InformationPanel::fill_parts() {
  const double size_pt = QFontInfo(font()).pointSizeF();
  for (const auto& part : sheet_->parts) {
    const QString element = to_text(part.element);
    auto* button = with_role(new QPushButton(element, parts_.box), "part");
    button->setObjectName(QStringLiteral("part_") + element);
    button->setFont(textbook_font(size_pt * 1.45));
    QString says = element;
    if (!part.original.empty() && part.original != part.element)
      says += tr(", a form of %1").arg(to_text(part.original));
    if (!part.meaning.empty()) says += QStringLiteral(": ") + to_text(part.meaning);
    button->setAccessibleName(says);
    button->setEnabled(part.target != 0);
    button->setCursor(Qt::PointingHandCursor);
    button->setToolTip(part.target != 0 ? tr("%1. Open this character").arg(says) : says);
    connect(button, &QPushButton::clicked, this,
            [this, target = part.target] { emit character_chosen(target); });
    parts_.flow->addWidget(button);
  }
  parts_.box->setVisible(!sheet_->parts.empty());
}

void InformationPanel::fill_words() {
  const char32_t character = sheet_->character.code_point;
  for (const auto& word : practice::choose_words(sheet_->helpful.words, character, knows_)) {
    auto* label = new WordLabel(word, is_narrow_, words_.box);
    connect(label, &WordLabel::character_chosen, this, &InformationPanel::character_chosen);
    word_list_->addWidget(label);
  }
  words_.box->setVisible(!sheet_->helpful.words.empty());
}

void InformationPanel::fill_confusables() {
  if (confusable_view_ == nullptr || sheet_->confusables.empty()) return;
  confusable_view_->show_sheet(*sheet_);
  confusables_.box->setVisible(true);
}

void InformationPanel::set_head(QWidget* head) {
  static_cast<QVBoxLayout*>(content_->layout())->insertWidget(0, head);
}

void InformationPanel::set_standing(QWidget* standing) {
  standing_ = standing;
  auto* column = static_cast<QVBoxLayout*>(content_->layout());
  column->insertWidget(column->indexOf(head_) + 1, standing);
  standing->setVisible(sheet_ != nullptr && !hides_character_);
}

void InformationPanel::set_confusables(ConfusableView* view) {
  confusable_view_ = view;
  static_cast<QVBoxLayout*>(confusables_.box->layout())->addWidget(view);
  connect(view, &ConfusableView::character_chosen, this, &InformationPanel::character_chosen);
}

void InformationPanel::set_hidden_character(bool hidden) {
  if (hides_character_ == hidden) return;
  hides_character_ = hidden;
  refresh();
}

void InformationPanel::refresh() {
  const int scrolled = verticalScrollBar()->value();
  if (sheet_) rebuild();
  verticalScrollBar()->setValue(scrolled);
}

void InformationPanel::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  const bool before = is_narrow_;
  fit();
  if (is_narrow_ != before) refresh();
}

void InformationPanel::fit() {
  // Large text in a narrow panel: the glyph above instead of beside.
  const int beside = viewport()->width() - 2 * kMargin - glyph_->sizeHint().width() - head_->spacing();
  is_narrow_ = beside < QFontInfo(font()).pixelSize() * 8;
  head_->setDirection(is_narrow_ ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  const int margin = is_narrow_ ? kMargin / 2 : kMargin;
  content_->layout()->setContentsMargins(margin, kMargin, margin, kMargin);
}

}  // namespace nazori::ui
