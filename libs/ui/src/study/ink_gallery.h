// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "nazori/study/handwriting.h"

namespace nazori::ui {

/// Writings of one character side by side, in as many rows as needed, each with its words below.
class InkGallery final : public QWidget {
  Q_OBJECT
 public:
  struct Piece {
    study::Handwriting ink;
    QString words;  ///< "today, Good"
  };

  explicit InkGallery(QWidget* parent = nullptr);
  void show_pieces(std::vector<Piece> pieces);
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }

  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] int columns(int width) const;
  [[nodiscard]] int words_flags(int side) const;
  [[nodiscard]] int words_height(int side) const;

  std::vector<Piece> pieces_;
};

}  // namespace nazori::ui
