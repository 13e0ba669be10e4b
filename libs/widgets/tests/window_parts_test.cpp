// SPDX-License-Identifier: Apache-2.0
// The widgets of the window, without the window.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFont>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <utility>

#include "nazori/widgets/controls/feedback_line.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/controls/key_guard.h"
#include "nazori/widgets/controls/panes.h"
#include "nazori/widgets/dialogs/save_dialog.h"
#include "nazori/widgets/words/error_text.h"

namespace nazori::ui {
namespace {

class FixedBox final : public QWidget {
 public:
  FixedBox(int width, int height, QWidget* parent) : QWidget(parent), size_(width, height) {}
  [[nodiscard]] QSize sizeHint() const override { return size_; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {5, 3}; }

 private:
  QSize size_;
};

class Flow : public testing::Test {
 protected:
  void lay_out(int width) {
    holder_.resize(width, 400);
    layout_->setGeometry({10, 20, width, 400});
  }
  QWidget holder_;
  FlowLayout* layout_ = new FlowLayout(7, 3, &holder_);
  FixedBox* one_ = new FixedBox(40, 20, &holder_);
  FixedBox* two_ = new FixedBox(30, 10, &holder_);
  FixedBox* three_ = new FixedBox(50, 30, &holder_);
  Flow() {
    for (auto* box : {one_, two_, three_}) {
      box->setAttribute(Qt::WA_WState_Hidden, false);
      layout_->addWidget(box);
    }
    holder_.show();
  }
};

TEST_F(Flow, ALineIsFilledToItsLastPixel) {
  lay_out(40 + 7 + 30);
  EXPECT_EQ(one_->geometry(), QRect(10, 20, 40, 20));
  EXPECT_EQ(two_->geometry(), QRect(10 + 47, 20 + 5, 30, 10)) << "on the middle of its line";
  EXPECT_EQ(three_->geometry(), QRect(10, 20 + 20 + 3, 50, 30));
  EXPECT_EQ(layout_->heightForWidth(77), 20 + 3 + 30);
  lay_out(76);
  EXPECT_EQ(two_->geometry().topLeft(), QPoint(10, 43));
  EXPECT_EQ(layout_->heightForWidth(76), 20 + 3 + 10 + 3 + 30);
  EXPECT_EQ(layout_->heightForWidth(40 + 7 + 30 + 7 + 50), 30);
}

TEST_F(Flow, WhatIsWiderThanALineIsCutToIt) {
  lay_out(35);
  EXPECT_EQ(one_->geometry(), QRect(10, 20, 35, 20));
  EXPECT_EQ(two_->width(), 30);
  EXPECT_EQ(three_->width(), 35);
}

TEST_F(Flow, WhatIsHiddenTakesNoRoom) {
  two_->hide();
  lay_out(200);
  EXPECT_EQ(three_->x(), 10 + 40 + 7);
  EXPECT_EQ(layout_->heightForWidth(40), 20 + 3 + 30);
}

TEST_F(Flow, ItsItemsCanBeTakenAway) {
  EXPECT_EQ(layout_->count(), 3);
  EXPECT_EQ(layout_->takeAt(-1), nullptr);
  EXPECT_EQ(layout_->takeAt(3), nullptr);
  const std::unique_ptr<QLayoutItem> taken(layout_->takeAt(2));
  ASSERT_NE(taken, nullptr);
  EXPECT_EQ(taken->widget(), three_);
  EXPECT_EQ(layout_->count(), 2);
  EXPECT_EQ(layout_->minimumSize(), QSize(0, 3)) << "as high as one, and any width";
}

class PanesBesideTheTablet : public testing::Test {
 protected:
  PanesBesideTheTablet() {
    panes_.set_panels(&left_, &right_);
    QObject::connect(&panes_, &Panes::opened, &panes_, [this](bool left, bool right) {
      opened_ = {left, right};
      ++told_;
    });
    panes_.resize(1280, 600);
    panes_.show();
    fit(1280);
  }
  void fit(int width, int text_pt = 12) {
    panes_.resize(width, 600);
    panes_.fit(width, text_pt);
  }
  std::pair<bool, bool> shown() { return {panes_.shown_left() == &left_, panes_.shown_right() == &right_}; }
  using Two = std::pair<bool, bool>;
  QWidget owner_;  // owns the panels that the panes do not own yet
  QLabel& tablet_ = *new QLabel(&owner_);
  QLabel& left_ = *new QLabel(&owner_);
  QLabel& right_ = *new QLabel(&owner_);
  QLabel& other_ = *new QLabel(&owner_);
  Panes panes_{&tablet_, nullptr};
  Two opened_{};
  int told_ = 0;
};

TEST_F(PanesBesideTheTablet, BothAreOpenWhereThereIsRoomAndEachIsFoldedAwayByItself) {
  EXPECT_EQ(shown(), Two(true, true));
  EXPECT_FALSE(panes_.are_drawers());
  panes_.open_left(false);
  EXPECT_EQ(shown(), Two(false, true));
  EXPECT_EQ(opened_, Two(false, true));
  EXPECT_FALSE(panes_.left_wanted());
  EXPECT_TRUE(panes_.right_wanted());
  panes_.open_right(false);
  EXPECT_EQ(shown(), Two(false, false));
  panes_.open_left(true);
  EXPECT_EQ(shown(), Two(true, false));
  panes_.set_open(false, true);
  EXPECT_EQ(shown(), Two(false, true));
  panes_.close_drawers();
  EXPECT_EQ(shown(), Two(false, true)) << "these are none";
}

TEST_F(PanesBesideTheTablet, BelowAThousandPixelsOneDrawerAtATimeIsOpen) {
  fit(1000);
  EXPECT_FALSE(panes_.are_drawers());
  fit(999);
  EXPECT_TRUE(panes_.are_drawers());
  EXPECT_EQ(shown(), Two(false, false));
  EXPECT_EQ(opened_, Two(false, false));
  panes_.open_left(true);
  EXPECT_EQ(shown(), Two(true, false));
  panes_.open_right(true);
  EXPECT_EQ(shown(), Two(false, true));
  panes_.open_left(true);
  EXPECT_EQ(shown(), Two(true, false));
  panes_.close_drawers();
  EXPECT_EQ(shown(), Two(false, false));
  panes_.open_right(true);
  panes_.open_right(false);
  EXPECT_EQ(shown(), Two(false, false));
  panes_.set_open(true, true);
  EXPECT_EQ(shown(), Two(false, false)) << "remembered for where there is room";
  fit(1280);
  EXPECT_EQ(shown(), Two(true, true)) << "drawers change nothing that is remembered";
  EXPECT_TRUE(panes_.left_wanted() && panes_.right_wanted());
}

TEST_F(PanesBesideTheTablet, AloneTheTabletHasTheWindowUntilTheyComeBack) {
  panes_.open_right(false);
  panes_.set_alone(true);
  EXPECT_EQ(shown(), Two(false, false));
  panes_.open_left(true);
  EXPECT_EQ(shown(), Two(false, false));
  panes_.set_alone(false);
  EXPECT_EQ(shown(), Two(true, false));
}

TEST_F(PanesBesideTheTablet, AnotherPageBringsItsOwn) {
  panes_.set_panels(&other_, nullptr);
  EXPECT_EQ(panes_.shown_left(), &other_);
  EXPECT_EQ(panes_.shown_right(), nullptr);
  EXPECT_FALSE(left_.isVisible());
  EXPECT_FALSE(right_.isVisible());
  EXPECT_EQ(opened_, Two(true, false));
  panes_.set_panels(&left_, &right_);
  EXPECT_EQ(shown(), Two(true, true));
  EXPECT_FALSE(other_.isVisible());
}

TEST_F(PanesBesideTheTablet, TheTabletHasHalfOfTheWidthAtLeast) {
  for (const int text_pt : {12, 20, 28})
    for (const int width : {1000, 1280, 1600, 2400}) {
      fit(width, text_pt);
      EXPECT_GE(2 * tablet_.width(), width - 12) << width << ' ' << text_pt;
      EXPECT_GE(left_.width(), 180);
      EXPECT_GE(right_.width(), 240);
    }
}

TEST_F(PanesBesideTheTablet, AWishIsGrantedBetweenTheLeastAndTheMost) {
  panes_.wish(200, 260);
  fit(1600);
  EXPECT_EQ(left_.width(), 200);
  EXPECT_EQ(right_.width(), 260);
  panes_.wish(5000, 5000);
  fit(1600);
  const int most_left = left_.width();
  const int most_right = right_.width();
  EXPECT_EQ(most_left, 320);
  EXPECT_EQ(most_right, 400);
  fit(1600, 28);
  EXPECT_GT(left_.width(), most_left) << "larger text has wider panels";
  EXPECT_GT(right_.width(), most_right);
  panes_.wish(0, 0);
  fit(1600);
  // 11 and 15 letters of 16 pixels, or what a panel needs.
  EXPECT_EQ(left_.width(), 180);
  EXPECT_EQ(right_.width(), 240);
  EXPECT_EQ(panes_.left_wish(), 0);
  EXPECT_EQ(panes_.right_wish(), 0);
}

TEST_F(PanesBesideTheTablet, ForALeftHandTheyChangeSidesAndKeepTheirWidths) {
  panes_.wish(200, 260);
  fit(1600);
  const auto side = [this](const QWidget& panel) { return panel.mapTo(&panes_, QPoint()).x(); };
  EXPECT_LT(side(left_), side(tablet_));
  panes_.set_mirrored(true);
  QCoreApplication::processEvents();
  EXPECT_GT(side(left_), side(tablet_));
  EXPECT_LT(side(right_), side(tablet_));
  fit(1600);
  EXPECT_EQ(left_.width(), 200);
  EXPECT_EQ(right_.width(), 260);
  panes_.set_mirrored(true);
  EXPECT_GT(side(left_), side(tablet_)) << "as it was";
  panes_.set_mirrored(false);
  QCoreApplication::processEvents();
  EXPECT_LT(side(left_), side(tablet_));
}

/// Whether a key that may be a shortcut goes to the widget instead.
bool guards(QObject& widget, Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
            QEvent::Type type = QEvent::ShortcutOverride) {
  KeyGuard guard;
  QKeyEvent event(type, key, modifiers);
  event.ignore();
  const bool taken = static_cast<QObject&>(guard).eventFilter(&widget, &event);
  EXPECT_EQ(taken, event.isAccepted());
  return taken;
}

TEST(KeysOfAWidget, AreItsOwnAndNoShortcut) {
  QListWidget list;
  QComboBox box;
  QSlider slider;
  QLineEdit line;
  QPushButton button;
  QWidget plain;
  const auto all = {Qt::Key_Left,     Qt::Key_Right,  Qt::Key_Up,    Qt::Key_Down,
                    Qt::Key_Space,    Qt::Key_Return, Qt::Key_Enter, Qt::Key_PageUp,
                    Qt::Key_PageDown, Qt::Key_Home,   Qt::Key_End,   Qt::Key_S};
  const auto kept = [&](QObject& widget) {
    QString keys;
    for (const Qt::Key key : all) keys += guards(widget, key) ? u'x' : u'-';
    return keys.toStdString();
  };
  // Walks: the arrows; takes: space, return, enter; then page up and down, home, end; a letter never.
  EXPECT_EQ(kept(list), "xxxxxxx-----");
  EXPECT_EQ(kept(box), "xxxxxxx-----");
  EXPECT_EQ(kept(slider), "xxxx---xxxx-");
  EXPECT_EQ(kept(line), "-----xx-----");
  EXPECT_EQ(kept(button), "----x-------");
  EXPECT_EQ(kept(plain), "------------");
}

TEST(KeysOfAWidget, WithControlOrShiftAreTheWindows) {
  QListWidget list;
  EXPECT_FALSE(guards(list, Qt::Key_Left, Qt::ControlModifier));
  EXPECT_FALSE(guards(list, Qt::Key_Left, Qt::ShiftModifier));
  EXPECT_TRUE(guards(list, Qt::Key_Left, Qt::KeypadModifier)) << "an arrow, wherever it lies";
  EXPECT_FALSE(guards(list, Qt::Key_Left, Qt::NoModifier, QEvent::KeyPress)) << "the key itself goes on";
}

TEST(FeedbackLine, SaysASentenceWithItsSignAndSpeaksItOnce) {
  FeedbackLine line;
  auto* text = line.findChild<QLabel*>(QStringLiteral("feedback_text"));
  const auto sign = [&] {
    return line.findChild<QLabel*>(QStringLiteral("feedback_sign"))->pixmap().toImage();
  };
  QList<QImage> signs;
  for (const Feedback kind : {Feedback::hint, Feedback::good, Feedback::advice, Feedback::wrong}) {
    line.announce(kind, QStringLiteral("a"));
    EXPECT_EQ(line.kind(), kind);
    for (const auto& other : signs) EXPECT_NE(sign(), other);
    signs.append(sign());
  }
  EXPECT_EQ(line.sentence(), QStringLiteral("a"));
  EXPECT_EQ(text->accessibleName(), QStringLiteral("a"));
  EXPECT_EQ(line.accessibleDescription(), QStringLiteral("a"));
  line.respond(Feedback::good, QStringLiteral("a"));
  EXPECT_EQ(line.kind(), Feedback::good);
  EXPECT_EQ(sign(), signs[1]);
  line.respond(Feedback::hint, QStringLiteral("b"));
  EXPECT_EQ(line.sentence(), QStringLiteral("b"));
  EXPECT_EQ(text->accessibleName(), QStringLiteral("b"));
  EXPECT_EQ(line.kind(), Feedback::hint);
}

TEST(FeedbackLine, HasRoomForTwoLinesUnlessTheWindowIsLow) {
  FeedbackLine line;
  line.resize(600, 1200);
  line.show();
  const auto* text = line.findChild<QLabel*>(QStringLiteral("feedback_text"));
  const int spacing = text->fontMetrics().lineSpacing();
  EXPECT_EQ(text->minimumHeight(), 2 * spacing);
  line.resize(600, 100);
  EXPECT_EQ(text->minimumHeight(), spacing);
  line.resize(600, 1200);
  EXPECT_EQ(text->minimumHeight(), 2 * spacing);
}

TEST(SaveDialog, OffersEachFormatAndSizeForACarvedTablet) {
  SaveDialog dialog(0, true, nullptr);
  auto* format = dialog.findChild<QComboBox*>(QStringLiteral("save_format"));
  auto* size = dialog.findChild<QComboBox*>(QStringLiteral("save_size"));
  ASSERT_EQ(format->count(), 3);
  const practice::FileFormat formats[] = {practice::FileFormat::raw, practice::FileFormat::png,
                                          practice::FileFormat::strokes};
  const char* suffixes[] = {"raw", "png", "str"};
  const char* filters[] = {"Height maps (*.raw)", "Pictures (*.png)", "Stroke order files (*.str)"};
  for (int i = 0; i < 3; ++i) {
    format->setCurrentIndex(i);
    EXPECT_EQ(dialog.format(), formats[i]);
    EXPECT_EQ(SaveDialog::suffix(formats[i]), QString::fromLatin1(suffixes[i]));
    EXPECT_EQ(SaveDialog::filter(formats[i]), QString::fromLatin1(filters[i]));
    EXPECT_TRUE(format->itemText(i).contains(QString::fromLatin1(suffixes[i]), Qt::CaseInsensitive));
  }
  QStringList sizes;
  for (int i = 0; i < size->count(); ++i) {
    size->setCurrentIndex(i);
    EXPECT_TRUE(size->currentText().startsWith(QStringLiteral("%1 × %1").arg(dialog.size())));
    sizes.append(QString::number(dialog.size()));
    EXPECT_EQ(size->currentText().contains(QStringLiteral("2005 format")), dialog.size() == 128);
  }
  EXPECT_EQ(sizes.join(u' '), QStringLiteral("128 256 512 1024 2048"));
  EXPECT_TRUE(size->isEnabled());
}

TEST(SaveDialog, AMapOfOnesOwnKeepsItsSizeAndMayHaveNoStrokes) {
  SaveDialog dialog(300, false, nullptr);
  EXPECT_EQ(dialog.size(), 300);
  EXPECT_FALSE(dialog.findChild<QComboBox*>(QStringLiteral("save_size"))->isEnabled());
  EXPECT_EQ(dialog.findChild<QComboBox*>(QStringLiteral("save_format"))->count(), 2);
  auto* buttons = dialog.findChild<QDialogButtonBox*>();
  dialog.show();
  for (auto* button : buttons->buttons())
    if (buttons->buttonRole(button) == QDialogButtonBox::AcceptRole) button->click();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  dialog.show();
  buttons->button(QDialogButtonBox::Cancel)->click();
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
}

TEST(ReasonOfAnError, IsItsKindWithWhatIsKnownOfIt) {
  using base::Errc;
  const std::pair<Errc, const char*> kinds[] = {
      {Errc::bad_argument, "a value is out of range"},
      {Errc::io, "it could not be read or written"},
      {Errc::parse, "the file format is not valid"},
      {Errc::schema, "it is a different kind of file than expected"},
      {Errc::not_found, "it does not exist"},
      {Errc::device, "the graphics driver or the device reported an error"},
      {Errc::cancelled, "it was stopped"},
      {Errc::in_use, "another program is using it"},
  };
  for (const auto& [code, words] : kinds) EXPECT_EQ(reason({code, "", "", ""}), QString::fromLatin1(words));
  EXPECT_EQ(reason({Errc::io, "disk full..", "", ""}),
            QStringLiteral("it could not be read or written (disk full)"));
  EXPECT_EQ(reason({Errc::io, "disk full", "", "delete something"}),
            QStringLiteral("it could not be read or written (disk full; delete something)"));
}

}  // namespace
}  // namespace nazori::ui
