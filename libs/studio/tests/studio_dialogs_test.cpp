// SPDX-License-Identifier: Apache-2.0
// The dialogs of the workshop, its questions, and the parts that panels are made of.
#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QTouchEvent>

#include "in_english.h"
#include "nazori/author/font_picture.h"
#include "nazori/studio/parts/key_writing.h"
#include "nazori/studio/parts/one_finger.h"
#include "nazori/studio/parts/panel_parts.h"
#include "nazori/studio/parts/question_box.h"
#include "nazori/studio/parts/unsaved_box.h"
#include "nazori/studio/workshop/plot_dialog.h"
#include "nazori/studio/workshop/trace_dialog.h"
#include "nazori/widgets/controls/flow_layout.h"
#include "nazori/widgets/events/event_loop_inbox.h"
#include "nazori/widgets/words/plot_text.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QString said(const char* text) { return QString::fromUtf8(text); }

class StudioDialogs : public testing::Test {
 protected:
  StudioDialogs() { test::speak_english(); }
  template <class T>
  static T& in(const QWidget& dialog, const char* name) {
    return *dialog.findChild<T*>(QString::fromLatin1(name));
  }
};

TEST_F(StudioDialogs, APictureIsTracedWithOrWithoutTheCharacterItShows) {
  const TraceDialog dialog(said("scan.png"), said(" 休 "), nullptr);
  EXPECT_EQ(dialog.objectName(), said("trace_dialog"));
  EXPECT_EQ(dialog.windowTitle(), said("Strokes of a picture"));
  EXPECT_EQ(in<QLabel>(dialog, "trace_picture").text(), said("scan.png"));
  EXPECT_EQ(dialog.findChild<QComboBox*>(said("trace_family")), nullptr);
  EXPECT_EQ(dialog.family(), QString());
  EXPECT_EQ(dialog.character(), U'休');
  auto& character = in<QLineEdit>(dialog, "trace_character");
  EXPECT_EQ(character.maxLength(), 8);
  character.setText(said("𠮟木"));
  EXPECT_EQ(dialog.character(), U'𠮟') << "the first of them";
  character.setText(said("  "));
  EXPECT_EQ(dialog.character(), U'\0');
  EXPECT_TRUE(in<QLabel>(dialog, "trace_words").text().startsWith(said("If you type the character, ")));
  EXPECT_TRUE(in<QPushButton>(dialog, "trace_find").isDefault());
  EXPECT_TRUE(in<QPushButton>(dialog, "trace_find").isEnabled());
  EXPECT_EQ(in<QPushButton>(dialog, "trace_find").text(), said("&Find strokes"));
}

TEST_F(StudioDialogs, AFontIsOfferedForWhatItHas) {
  const TraceDialog dialog({}, said("一"), nullptr);
  EXPECT_EQ(dialog.windowTitle(), said("Strokes of a font"));
  EXPECT_EQ(dialog.findChild<QLabel*>(said("trace_picture")), nullptr);
  auto& family = in<QComboBox>(dialog, "trace_family");
  auto& find = in<QPushButton>(dialog, "trace_find");
  auto& words = in<QLabel>(dialog, "trace_words");
  auto& character = in<QLineEdit>(dialog, "trace_character");
  EXPECT_EQ(family.minimumContentsLength(), 14);
  QStringList families;
  for (const auto& name : author::font_families(U'一')) families.append(QString::fromStdString(name));
  const auto offered = [&family] {
    QStringList all;
    for (int i = 0; i < family.count(); ++i) all.append(family.itemText(i));
    return all;
  };
  EXPECT_EQ(offered(), families);
  ASSERT_GE(families.size(), 2) << "the fonts that are needed are not installed";
  EXPECT_EQ(words.text(), said("%1 fonts have this character.").arg(families.size()));
  EXPECT_TRUE(find.isEnabled());
  family.setCurrentIndex(1);
  character.setText(said("二"));
  EXPECT_EQ(dialog.family(), families[1]) << "the same font where it has the next one";
  character.setText({});
  EXPECT_EQ(words.text(), said("Type a character."));
  EXPECT_FALSE(find.isEnabled());
  EXPECT_EQ(family.count(), 0);
  character.setText(QString::fromUcs4(U"\U0010FFFD"));
  EXPECT_EQ(words.text(), said("No installed font has this character."));
  EXPECT_FALSE(find.isEnabled());
}

class DialogForAPlot : public StudioDialogs {
 protected:
  EventLoopInbox loop_;
  functions::PlotModel model_;
};

TEST_F(DialogForAPlot, ProposesTheExpressionAndTheRange) {
  ASSERT_TRUE(model_.start_with({-1.0 / 3, 2, -3, 4.25}));
  const PlotDialog dialog(loop_.inbox(), model_, said("y = x"), 64, nullptr);
  EXPECT_EQ(dialog.objectName(), said("plot_dialog"));
  EXPECT_EQ(dialog.windowTitle(), said("A function plot"));
  const auto& line = in<QLineEdit>(dialog, "plot_expression");
  EXPECT_EQ(line.text(), said("y = x"));
  EXPECT_EQ(line.selectedText(), said("y = x"));
  EXPECT_EQ(line.placeholderText(), said("y = sin x"));
  for (const auto& [name, value, words] :
       {std::tuple("plot_x0", "-0.3333333333", "x from"), std::tuple("plot_x1", "2", "x to"),
        std::tuple("plot_y0", "-3", "y from"), std::tuple("plot_y1", "4.25", "y to")}) {
    EXPECT_EQ(in<QLineEdit>(dialog, name).text(), localised(value));
    EXPECT_EQ(in<QLineEdit>(dialog, name).accessibleName(), said(words));
  }
  const auto& progress = in<QProgressBar>(dialog, "plot_progress");
  EXPECT_EQ(progress.minimum(), 0);
  EXPECT_EQ(progress.maximum(), 100);
  EXPECT_FALSE(progress.isTextVisible());
  EXPECT_TRUE(progress.isHidden());
  EXPECT_TRUE(progress.sizePolicy().retainSizeWhenHidden());
  EXPECT_TRUE(in<QPushButton>(dialog, "plot_draw").isDefault());
  EXPECT_EQ(in<QLabel>(dialog, "plot_words").text(), said("y equals x"));
  EXPECT_EQ(line.accessibleDescription(), said("y equals x"));
  EXPECT_EQ(dialog.expression(), said("y = x"));
  EXPECT_EQ(dialog.relief(), nullptr);
  EXPECT_EQ(dialog.width(), 28 * QFontInfo(dialog.font()).pixelSize());
}

TEST_F(DialogForAPlot, SaysWhatIsWrongAndStaysOpen) {
  PlotDialog dialog(loop_.inbox(), model_, said("y = 1 +"), 64, nullptr);
  dialog.show();
  auto& words = in<QLabel>(dialog, "plot_words");
  auto& line = in<QLineEdit>(dialog, "plot_expression");
  auto& draw = in<QPushButton>(dialog, "plot_draw");
  EXPECT_TRUE(words.text().startsWith(said("✗ Column 8: "))) << words.text().toStdString();
  draw.click();
  EXPECT_TRUE(words.text().startsWith(said("✗ Column 8: ")));
  EXPECT_TRUE(dialog.isVisible());
  line.setText(said("y = 1"));
  EXPECT_EQ(words.text(), said("y equals 1"));
  in<QLineEdit>(dialog, "plot_y0").setText(said("down"));
  draw.click();
  EXPECT_EQ(words.text(), said("✗ “down” is not a number."));
  in<QLineEdit>(dialog, "plot_y0").setText(said("3"));
  in<QLineEdit>(dialog, "plot_y1").setText(said("2"));
  draw.click();
  EXPECT_TRUE(words.text().startsWith(said("✗ This range cannot be shown: "))) << words.text().toStdString();
  EXPECT_TRUE(draw.isEnabled());
  EXPECT_EQ(dialog.relief(), nullptr);
}

TEST_F(DialogForAPlot, IsAcceptedWithTheReliefOnceItIsDrawn) {
  PlotDialog dialog(loop_.inbox(), model_, said("y = x"), 64, nullptr);
  dialog.show();
  in<QLineEdit>(dialog, "plot_expression").setText(said("y = 2"));
  in<QPushButton>(dialog, "plot_draw").click();
  EXPECT_FALSE(in<QPushButton>(dialog, "plot_draw").isEnabled());
  EXPECT_FALSE(in<QProgressBar>(dialog, "plot_progress").isHidden());
  ASSERT_TRUE(QTest::qWaitFor([&] { return dialog.result() == QDialog::Accepted; }, 30'000));
  ASSERT_NE(dialog.relief(), nullptr);
  EXPECT_EQ(dialog.relief()->size(), 64);
  EXPECT_EQ(dialog.expression(), said("y = 2"));
}

TEST_F(DialogForAPlot, StopsWhereSomethingIsTyped) {
  PlotDialog dialog(loop_.inbox(), model_, said("y = x"), 256, nullptr);
  dialog.show();
  in<QPushButton>(dialog, "plot_draw").click();
  auto& border = in<QLineEdit>(dialog, "plot_x1");
  emit border.textEdited(said("3"));
  EXPECT_TRUE(in<QPushButton>(dialog, "plot_draw").isEnabled());
  EXPECT_TRUE(in<QProgressBar>(dialog, "plot_progress").isHidden());
}

TEST_F(StudioDialogs, AQuestionIsAnsweredWithTheNumberOfItsButton) {
  QWidget window;
  const Answer answers[] = {{said("First"), QMessageBox::AcceptRole},
                            {said("Second"), QMessageBox::DestructiveRole},
                            {said("Third"), QMessageBox::RejectRole}};
  const auto asked = [&](const std::function<void(QMessageBox&)>& answer, std::size_t proposed = 1) {
    QTimer::singleShot(0, &window, [&] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      EXPECT_EQ(box->objectName(), said("question"));
      EXPECT_EQ(box->windowTitle(), said("Nazori"));
      EXPECT_EQ(box->text(), said("Which one?"));
      EXPECT_EQ(box->icon(), QMessageBox::Question);
      EXPECT_EQ(box->defaultButton()->text(), answers[proposed].text);
      EXPECT_EQ(box->escapeButton()->text(), said("Third"));
      answer(*box);
    });
    return ask("question", said("Which one?"), answers, proposed, &window);
  };
  const auto press = [](const char* text) {
    return [text](QMessageBox& box) {
      for (auto* button : box.buttons())
        if (button->text() == said(text)) return button->click();
    };
  };
  EXPECT_EQ(asked(press("First")), 0U);
  EXPECT_EQ(asked(press("Second")), 1U);
  EXPECT_EQ(asked(press("Third"), 0), 2U);
  EXPECT_EQ(asked([](QMessageBox& box) { QTest::keyClick(&box, Qt::Key_Escape); }), 2U);
  EXPECT_EQ(asked([](QMessageBox& box) { box.close(); }), 2U);
}

TEST_F(StudioDialogs, WhatIsUnsavedMayBeSavedOrNotOrKeptOpen) {
  QWidget window;
  const std::pair<const char*, Unsaved> all[] = {
      {"Save…", Unsaved::save}, {"Do not save", Unsaved::discard}, {"Go back", Unsaved::stay}};
  for (const auto& [text, meant] : all) {
    QTimer::singleShot(0, &window, [text = text] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      ASSERT_NE(box, nullptr);
      EXPECT_EQ(box->defaultButton()->text(), said("Save…"));
      for (auto* button : box->buttons())
        if (button->text() == said(text)) return button->click();
      ADD_FAILURE() << text;
    });
    EXPECT_EQ(ask_unsaved("unsaved", said("It is not saved."), &window), meant);
  }
}

TEST_F(StudioDialogs, AColumnAndAFormOfAPanelHaveTheirRoom) {
  QWidget content;
  auto* column = make_panel_column(&content);
  EXPECT_EQ(column->contentsMargins(), QMargins(12, 12, 12, 12));
  EXPECT_EQ(column->spacing(), kPanelGap);
  EXPECT_EQ(content.layout(), column);
  auto* form = add_form(column);
  EXPECT_EQ(form->verticalSpacing(), kPanelGap);
  EXPECT_EQ(form->rowWrapPolicy(), QFormLayout::WrapLongRows);
  EXPECT_EQ(form->fieldGrowthPolicy(), QFormLayout::AllNonFixedFieldsGrow);
  QAction one(said("&One…")), two(said("Two"));
  one.setIconText(said("One"));
  add_buttons(column, {&one, &two}, &content);
  ASSERT_EQ(column->count(), 2);
  EXPECT_EQ(column->itemAt(0)->layout(), form);
  auto* row = column->itemAt(1)->layout();
  ASSERT_NE(dynamic_cast<FlowLayout*>(row), nullptr);
  ASSERT_EQ(row->count(), 2);
  auto* button = qobject_cast<QPushButton*>(row->itemAt(0)->widget());
  EXPECT_EQ(button->text(), said("One"));
  content.resize(400, 200);
  content.show();
  const auto* second = row->itemAt(1)->widget();
  EXPECT_EQ(second->x(), button->geometry().right() + 1 + kPanelGap);
}

TEST_F(StudioDialogs, WhatTheKeysOfThePenDidIsSaid) {
  using practice::KeyPenDid;
  practice::KeyPenEvent event;
  event.place.stroke = 3;
  event.left = 2;
  const std::pair<KeyPenDid, const char*> all[] = {{KeyPenDid::moved, ""},
                                                   {KeyPenDid::met_stroke, "Stroke 3."},
                                                   {KeyPenDid::at_start, "Start of stroke 3."},
                                                   {KeyPenDid::at_end, "End of stroke 3."},
                                                   {KeyPenDid::left_stroke, "Beside stroke 2."},
                                                   {KeyPenDid::at_border, "This is the edge."},
                                                   {KeyPenDid::put_down, "Pen down."},
                                                   {KeyPenDid::lifted, "Pen up."},
                                                   {KeyPenDid::no_strokes, "There are no strokes to go to."}};
  for (const auto& [did, sentence] : all) {
    event.did = did;
    EXPECT_EQ(key_pen_words(event), said(sentence));
  }
  practice::KeyPenPlace place;
  place.from_left = 0.256;
  place.from_top = 0.704;
  EXPECT_EQ(key_pen_words(place), said("No stroke here: 26% from the left, 70% from the top."));
  place.stroke = 3;
  place.along = 0.996;
  EXPECT_EQ(key_pen_words(place), said("Stroke 3, 100% of its length: 26% from the left, 70% from the top."));
  place.from_left = -0.2;
  place.from_top = 1.3;
  EXPECT_EQ(key_pen_words(place), said("Stroke 3, 100% of its length: 0% from the left, 100% from the top."));
}

class OneFingerOfAHand : public testing::Test {
 protected:
  using State = QEventPoint::State;
  std::optional<OneFinger::Move> take(QEvent::Type type,
                                      const QList<std::pair<QEventPoint::State, QPointF>>& touches) {
    QList<QEventPoint> points;
    for (int i = 0; i < touches.size(); ++i) {
      QEventPoint point(i, touches[i].first, touches[i].second, touches[i].second);
      points.append(point);
    }
    const QTouchEvent event(type, &screen_, Qt::NoModifier, points);
    return finger_.take(
        event, [this](QPointF) { return allowed_; }, [this] { ++lost_; });
  }
  QPointingDevice screen_{QStringLiteral("screen"),
                          52,
                          QInputDevice::DeviceType::TouchScreen,
                          QPointingDevice::PointerType::Finger,
                          QInputDevice::Capability::Position,
                          10,
                          0};
  OneFinger finger_;
  bool allowed_ = true;
  int lost_ = 0;
};

TEST_F(OneFingerOfAHand, WritesFromItsFirstTouchToItsLast) {
  auto move = take(QEvent::TouchBegin, {{State::Pressed, {}}});
  ASSERT_TRUE(move);
  EXPECT_TRUE(move->down);
  move = take(QEvent::TouchUpdate, {{State::Updated, {}}});
  ASSERT_TRUE(move);
  EXPECT_TRUE(move->down);
  move = take(QEvent::TouchEnd, {{State::Released, {}}});
  ASSERT_TRUE(move);
  EXPECT_FALSE(move->down);
  EXPECT_FALSE(take(QEvent::TouchUpdate, {{State::Updated, {}}})) << "it was lifted";
  EXPECT_EQ(lost_, 0);
}

TEST_F(OneFingerOfAHand, OutsideItWritesNothing) {
  allowed_ = false;
  EXPECT_FALSE(take(QEvent::TouchBegin, {{State::Pressed, {}}}));
  allowed_ = true;
  EXPECT_FALSE(take(QEvent::TouchUpdate, {{State::Updated, {}}})) << "it began outside";
  EXPECT_FALSE(take(QEvent::TouchEnd, {{State::Released, {}}}));
}

TEST_F(OneFingerOfAHand, ASecondFingerACancelAndAPenEndIt) {
  ASSERT_TRUE(take(QEvent::TouchBegin, {{State::Pressed, {}}}));
  EXPECT_FALSE(take(QEvent::TouchUpdate, {{State::Updated, {}}, {State::Pressed, {}}}));
  EXPECT_EQ(lost_, 1);
  EXPECT_FALSE(take(QEvent::TouchUpdate, {{State::Updated, {}}, {State::Updated, {}}}));
  EXPECT_EQ(lost_, 1) << "once";
  EXPECT_FALSE(take(QEvent::TouchUpdate, {{State::Updated, {}}, {State::Released, {}}}));
  ASSERT_TRUE(take(QEvent::TouchBegin, {{State::Pressed, {}}}));
  EXPECT_FALSE(take(QEvent::TouchCancel, {{State::Updated, {}}}));
  EXPECT_EQ(lost_, 2);
  ASSERT_TRUE(take(QEvent::TouchBegin, {{State::Pressed, {}}}));
  EXPECT_FALSE(take(QEvent::TouchUpdate, {}));
  EXPECT_EQ(lost_, 3);
  ASSERT_TRUE(take(QEvent::TouchBegin, {{State::Pressed, {}}}));
  finger_.note_pen();
  EXPECT_FALSE(take(QEvent::TouchUpdate, {{State::Updated, {}}}));
  EXPECT_EQ(lost_, 4);
  EXPECT_FALSE(take(QEvent::TouchBegin, {{State::Pressed, {}}})) << "the palm of a hand with a pen";
}

}  // namespace
}  // namespace nazori::ui
