// SPDX-License-Identifier: Apache-2.0
#include "panes.h"

#include <algorithm>

namespace nazori::ui {
namespace {

constexpr int kLibraryMin_px = 180;
constexpr int kLibraryMax_px = 320;
constexpr int kInformationMin_px = 240;
constexpr int kInformationMax_px = 400;
constexpr double kLibraryShare = 0.22;
constexpr double kInformationShare = 0.28;

}  // namespace

Panes::Panes(QWidget* library, QWidget* tablet, QWidget* information, QWidget* parent)
    : QSplitter(Qt::Horizontal, parent), library_(library), information_(information) {
  setObjectName(QStringLiteral("panes"));
  setChildrenCollapsible(false);
  setHandleWidth(1);
  for (auto* widget : {library, tablet, information}) addWidget(widget);
  setStretchFactor(0, 0);
  setStretchFactor(1, 1);
  setStretchFactor(2, 0);
  library_->setMinimumWidth(kLibraryMin_px);
  information_->setMinimumWidth(kInformationMin_px);
  connect(this, &QSplitter::splitterMoved, this, [this] {
    if (drawers_) return;
    if (library_->isVisible()) library_wish_ = library_->width();
    if (information_->isVisible()) information_wish_ = information_->width();
  });
}

void Panes::set_open(bool library, bool information) {
  library_wanted_ = library;
  information_wanted_ = information;
  if (!drawers_) show_panels(library, information);
}

void Panes::open_library(bool open) {
  if (!drawers_) library_wanted_ = open;
  show_panels(open, information_->isVisibleTo(this) && !(drawers_ && open));
}

void Panes::open_information(bool open) {
  if (!drawers_) information_wanted_ = open;
  show_panels(library_->isVisibleTo(this) && !(drawers_ && open), open);
}

void Panes::close_drawers() {
  if (drawers_) show_panels(false, false);
}

void Panes::set_alone(bool alone) {
  alone_ = alone;
  const bool both = !drawers_;
  show_panels(both && library_wanted_, both && information_wanted_);
}

void Panes::show_panels(bool library, bool information) {
  library_->setVisible(library && !alone_);
  information_->setVisible(information && !alone_);
  emit opened(library && !alone_, information && !alone_);
}

void Panes::fit(int window_width, int text_pt) {
  const bool drawers = window_width < kDrawers_px;
  if (drawers != drawers_) {
    drawers_ = drawers;
    show_panels(!drawers && library_wanted_, !drawers && information_wanted_);
  }
  // Larger text may have wider panels, but never more than half of the window together.
  const int larger = std::max(text_pt - 12, 0);
  const int half = window_width / 2 - 6;
  const auto limit = [&](double share, int most, int least) {
    const int by_share = drawers_ ? half : static_cast<int>(window_width * share) - 4;
    return std::max(std::min(by_share, most), least);
  };
  const int library_most = limit(kLibraryShare, kLibraryMax_px + larger * 9, kLibraryMin_px);
  const int information_most = limit(kInformationShare, kInformationMax_px + larger * 11, kInformationMin_px);
  library_->setMaximumWidth(library_most);
  information_->setMaximumWidth(information_most);
  const int library = std::min(library_wish_, library_most);
  const int information = std::min(information_wish_, information_most);
  setSizes({library, std::max(window_width - library - information, 0), information});
}

void Panes::wish(int library_width, int information_width) {
  library_wish_ = library_width;
  information_wish_ = information_width;
}

}  // namespace nazori::ui
