// SPDX-License-Identifier: Apache-2.0
// The parts of Home that no other page has.
#pragma once

#include <QPushButton>
#include <vector>

#include "nazori/practice/day_record.h"
#include "nazori/practice/milestones.h"

class QLabel;
class QProgressBar;

namespace nazori::ui {

/// The one button to press next: a large word, its key on the right, and below it what it holds, in as many
/// lines as needed.
class StartButton final : public QPushButton {
  Q_OBJECT
 public:
  explicit StartButton(QWidget* parent = nullptr);
  /// @param details  "12 reviews and 5 new characters · about 15 minutes"
  void show_work(const QString& word, const QString& details);

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] int padding() const;
  QString details_;
};

/// A character large enough to read, with a caption below it; a button that opens it.
class CharacterTile final : public QPushButton {
  Q_OBJECT
 public:
  /// @param share  size of the character, of 48 points.
  CharacterTile(char32_t character, const QString& caption, double share, QWidget* parent = nullptr);
  [[nodiscard]] char32_t character() const { return character_; }

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QFont large_font() const;
  char32_t character_;
  QString caption_;
  double share_;
};

/// Handwriting in a row: as much as fits, or all of it in several rows.
class InkRow final : public QWidget {
  Q_OBJECT
 public:
  explicit InkRow(QWidget* parent = nullptr);
  void show_inks(std::vector<practice::InkedWriting> inks);
  [[nodiscard]] const std::vector<practice::InkedWriting>& inks() const { return inks_; }
  void show_all(bool all);
  /// Whether one row is too short for all of them.
  [[nodiscard]] bool has_more() const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;

 signals:
  /// The width has changed, and with it has_more().
  void resized();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] int side() const;
  [[nodiscard]] int columns(int width) const;
  std::vector<practice::InkedWriting> inks_;
  bool all_ = false;
};

/// A list with how many of its characters are learned, a bar below them, and when it is done.
class MilestoneBar final : public QWidget {
  Q_OBJECT
 public:
  explicit MilestoneBar(QWidget* parent = nullptr);
  void show_milestone(const practice::Milestone& milestone);

 private:
  QLabel* name_;
  QLabel* reached_;
  QProgressBar* bar_;
  QLabel* done_;
};

}  // namespace nazori::ui
