// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/panes.h"

#include <QVBoxLayout>
#include <algorithm>

#include "nazori/widgets/controls/parts.h"

namespace nazori::ui {
namespace {

constexpr int kLeftMin_px = 180;
constexpr int kLeftMax_px = 320;
constexpr int kRightMin_px = 240;
constexpr int kRightMax_px = 400;
constexpr int kLeftLeast_em = 11;
constexpr int kRightLeast_em = 15;
constexpr double kLeftShare = 0.22;
constexpr double kRightShare = 0.28;

QWidget* make_holder(QWidget* parent) {
  auto* holder = new QWidget(parent);
  auto* column = new QVBoxLayout(holder);
  column->setContentsMargins(0, 0, 0, 0);
  return holder;
}

/// Shows a panel in its holder and hides the one before.
void put(QWidget* panel, QWidget* before, QWidget* holder) {
  if (before != nullptr) before->hide();
  if (panel == nullptr) return;
  if (panel->parentWidget() != holder) holder->layout()->addWidget(panel);
  panel->show();
}

void give_keyboard(QWidget* panel) {
  if (panel == nullptr) return;
  const auto accepts = [panel](const QWidget* one) {
    return one != nullptr && one->isEnabled() && one->isVisibleTo(panel) &&
           (one->focusPolicy() & Qt::TabFocus) != 0;
  };
  QWidget* wanted = panel->focusWidget();
  if (!accepts(wanted)) {
    // The chain of Tab goes round the whole window; the part of it within the panel comes in its order.
    wanted = panel->nextInFocusChain();
    while (wanted != panel && !(panel->isAncestorOf(wanted) && accepts(wanted)))
      wanted = wanted->nextInFocusChain();
  }
  if (wanted != panel || accepts(panel)) wanted->setFocus(Qt::ShortcutFocusReason);
}

}  // namespace

Panes::Panes(QWidget* tablet, QWidget* parent)
    : QSplitter(Qt::Horizontal, parent), left_(make_holder(this)), right_(make_holder(this)) {
  setObjectName(QStringLiteral("panes"));
  setChildrenCollapsible(false);
  setHandleWidth(1);
  for (auto* widget : {left_, tablet, right_}) addWidget(widget);
  setStretchFactor(1, 1);
  left_->setMinimumWidth(kLeftMin_px);
  right_->setMinimumWidth(kRightMin_px);
  connect(this, &QSplitter::splitterMoved, this, [this] {
    if (drawers_) return;
    if (left_->isVisible()) left_wish_ = left_->width();
    if (right_->isVisible()) right_wish_ = right_->width();
  });
}

void Panes::set_panels(QWidget* left, QWidget* right) {
  put(left, left_panel_, left_);
  put(right, right_panel_, right_);
  left_panel_ = left;
  right_panel_ = right;
  show_wanted();
}

QWidget* Panes::shown_left() const { return left_->isVisibleTo(this) ? left_panel_ : nullptr; }

QWidget* Panes::shown_right() const { return right_->isVisibleTo(this) ? right_panel_ : nullptr; }

void Panes::set_open(bool left, bool right) {
  left_wanted_ = left;
  right_wanted_ = right;
  if (!drawers_) show_wanted();
}

void Panes::open_left(bool open) {
  if (!drawers_ && !left_folded_) left_wanted_ = open;
  show_panels(open, right_->isVisibleTo(this) && !(drawers_ && open));
}

void Panes::open_right(bool open) {
  if (!drawers_ && !right_folded_) right_wanted_ = open;
  show_panels(left_->isVisibleTo(this) && !(drawers_ && open), open);
}

void Panes::give_keyboard_left() { give_keyboard(shown_left()); }

void Panes::give_keyboard_right() { give_keyboard(shown_right()); }

void Panes::close_drawers() {
  if (drawers_ || left_folded_ || right_folded_) show_wanted();
}

void Panes::set_alone(bool alone) {
  alone_ = alone;
  show_wanted();
}

void Panes::fold(bool left, bool right) {
  if (left == left_folded_ && right == right_folded_) return;
  left_folded_ = left;
  right_folded_ = right;
  show_wanted();
}

void Panes::show_wanted() {
  show_panels(!drawers_ && left_wanted_ && !left_folded_, !drawers_ && right_wanted_ && !right_folded_);
}

void Panes::show_panels(bool left, bool right) {
  left = left && !alone_ && left_panel_ != nullptr;
  right = right && !alone_ && right_panel_ != nullptr;
  if ((!left && has_keyboard(*left_)) || (!right && has_keyboard(*right_))) emit keyboard_closing();
  left_->setVisible(left);
  right_->setVisible(right);
  emit opened(left, right);
}

void Panes::fit(int window_width, int text_pt) {
  const bool drawers = window_width < kDrawers_px;
  if (drawers != drawers_) {
    drawers_ = drawers;
    show_wanted();
  }
  // Larger text may have wider panels, but never more than half of the window together.
  const int larger = std::max(text_pt - 12, 0);
  const int half = window_width / 2 - 6;
  const auto limit = [&](double share, int most, int least) {
    const int by_share = drawers_ ? half : static_cast<int>(window_width * share) - 4;
    return std::max(std::min(by_share, most), least);
  };
  const int left_most = limit(kLeftShare, kLeftMax_px + larger * 9, kLeftMin_px);
  const int right_most = limit(kRightShare, kRightMax_px + larger * 11, kRightMin_px);
  left_->setMaximumWidth(left_most);
  right_->setMaximumWidth(right_most);
  // Large text needs a minimum width, even if the learner chose a smaller one with small text.
  const int em = text_pt * 4 / 3;
  const int left = std::min(std::max(left_wish_, kLeftLeast_em * em), left_most);
  const int right = std::min(std::max(right_wish_, kRightLeast_em * em), right_most);
  const int middle = std::max(window_width - left - right, 0);
  setSizes(mirrored_ ? QList<int>{right, middle, left} : QList<int>{left, middle, right});
}

void Panes::set_mirrored(bool mirrored) {
  if (mirrored == mirrored_) return;
  mirrored_ = mirrored;
  const QList<int> widths = sizes();
  insertWidget(0, mirrored ? right_ : left_);
  insertWidget(2, mirrored ? left_ : right_);
  setSizes({widths[2], widths[1], widths[0]});
}

void Panes::wish(int left_width, int right_width) {
  left_wish_ = left_width;
  right_wish_ = right_width;
}

}  // namespace nazori::ui
