// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <functional>
#include <memory>

#include "nazori/practice/character_library.h"

class QBoxLayout;
class QLabel;
class QVBoxLayout;

namespace nazori::ui {

class ConfusableView;
class FlowLayout;
class GlyphView;

/// Everything about the character that is shown: meanings, readings with the okurigana in another colour, the
/// radical with its names, components that can be opened, and compounds.
class InformationPanel final : public QScrollArea {
  Q_OBJECT
 public:
  explicit InformationPanel(QWidget* parent = nullptr);

  void show_character(std::shared_ptr<const practice::CharacterSheet> sheet);
  /// A tablet of the learner's own: its name, and how large it is.
  void show_own(const QString& name, int map_size, int strokes);

  /// Shows only meanings and readings, not the character, its parts and its words: the learner writes it from
  /// memory.
  void set_hidden_character(bool hidden);
  /// Whether the learner knows a character, for the choice of words; empty: that is not known.
  void set_knows(std::function<bool(char32_t)> knows) { knows_ = std::move(knows); }
  /// Puts a widget above everything else. It shows and hides itself.
  void set_head(QWidget* head);
  /// Puts a widget below meanings and facts. It is hidden where no character is shown.
  void set_standing(QWidget* standing);
  /// Puts a widget of characters that are confused with the one shown below its words.
  void set_confusables(ConfusableView* view);
  /// Uses the current colours and text size.
  void refresh();

 signals:
  void character_chosen(char32_t code_point);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Section {
    QWidget* box;
    FlowLayout* flow;
  };

  Section add_section(const QString& name, const QString& title, int horizontal_gap, int vertical_gap);
  void rebuild();
  void fill_facts();
  void fill_readings();
  void show_example(QLabel* label, const QString& reading, const practice::ReadingUse& use);
  void fill_radical();
  void fill_parts();
  void fill_words();
  void fill_confusables();
  void fit();
  QLabel* add_label(FlowLayout* flow, const QString& text, double scale, bool textbook, bool muted = false);

  std::shared_ptr<const practice::CharacterSheet> sheet_;
  bool hides_character_ = false;
  bool is_narrow_ = false;  ///< large text in a narrow panel
  QWidget* content_;
  QBoxLayout* head_;
  GlyphView* glyph_;
  QLabel* meanings_;
  QLabel* facts_;
  Section on_;
  Section kun_;
  Section radical_;
  Section parts_;
  Section words_;
  QVBoxLayout* word_list_;
  Section confusables_;
  ConfusableView* confusable_view_ = nullptr;
  QWidget* standing_ = nullptr;
  std::function<bool(char32_t)> knows_;
};

}  // namespace nazori::ui
