// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>

#include "nazori/author/font_model.h"
#include "nazori/studio/brush/paper_view.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace nazori::ui {

class BrushActions;

/// A bar that shows how full the brush is and how dark its ink.
class InkGauge final : public QWidget {
 public:
  explicit InkGauge(QWidget* parent);
  void show_state(const calligraphy::SheetState& state);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double fullness_ = 0, strength_ = 0;
  QColor ink_;
};

/// Brush, paper and model beside the paper.
class BrushToolsPanel final : public QScrollArea {
  Q_OBJECT
 public:
  BrushToolsPanel(const BrushActions& actions, QWidget* parent);

  void show_state(const calligraphy::SheetState& state);
  void show_ruling(int characters);
  void show_place(ModelPlace place);
  /// Offers printed lines and these fonts for the model. @param hint  how to get more; may be empty.
  void show_fonts(const std::vector<author::BrushFont>& fonts, const QString& hint);
  /// The font that is chosen; empty: printed lines.
  void show_font(const QString& family);
  void show_text(const QString& text);
  /// What stands as model now, in words.
  void show_model_words(const QString& words);
  /// Sentences of advice; none: takes them away.
  void show_advice(const QStringList& sentences);
  void focus_text();
  /// Whether ruling and text of the model can be chosen.
  void set_model_free(bool is_free);

  [[nodiscard]] QSize sizeHint() const override;

 signals:
  // The learner chose something.
  void size_chosen(nazori::calligraphy::BrushSize size);
  void hair_chosen(nazori::brush::Hair hair);
  void ink_chosen(const QString& ink);
  void paper_chosen(const QString& paper);
  void ruling_chosen(int characters);
  void place_chosen(nazori::ui::ModelPlace place);
  void font_chosen(const QString& family);
  void text_typed(const QString& text);
  void text_entered();

 private:
  QComboBox* add_box(const char* name, const QString& label, class QFormLayout* form);

  QWidget* content_;
  InkGauge* gauge_;
  QLabel *advice_heading_, *advice_words_;
  QLabel *brush_words_, *paper_words_, *model_words_, *font_hint_;
  QComboBox *size_, *hair_, *ink_, *paper_, *ruling_, *place_, *font_;
  QLineEdit* text_;
};

}  // namespace nazori::ui
