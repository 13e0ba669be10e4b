// SPDX-License-Identifier: Apache-2.0
// The rooms and the colours of the dialogs that every page shares.
#include <gtest/gtest.h>

#include <QBoxLayout>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>

#include "nazori/widgets/dialogs/about_dialog.h"
#include "nazori/widgets/dialogs/key_list_dialog.h"
#include "nazori/widgets/dialogs/save_dialog.h"
#include "nazori/widgets/dialogs/work_dialog.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/palette.h"
#include "print_qt.h"

namespace nazori::ui {
namespace {

QString said(const char* text) { return QString::fromUtf8(text); }

TEST(AboutInDetail, ThePictureTheTitleAndTheLicencesHaveTheirRoom) {
  const AboutDialog dialog({}, nullptr);
  const auto* column = qobject_cast<QBoxLayout*>(dialog.layout());
  ASSERT_EQ(column->count(), 3);
  EXPECT_EQ(column->spacing(), 14);
  EXPECT_EQ(column->stretch(0), 0);
  EXPECT_EQ(column->stretch(1), 1);
  EXPECT_EQ(column->stretch(2), 0);
  EXPECT_NE(qobject_cast<QTextBrowser*>(column->itemAt(1)->widget()), nullptr);
  EXPECT_NE(qobject_cast<QDialogButtonBox*>(column->itemAt(2)->widget()), nullptr);
  const auto* head = qobject_cast<QBoxLayout*>(column->itemAt(0)->layout());
  ASSERT_EQ(head->count(), 2);
  EXPECT_EQ(head->spacing(), 16);
  EXPECT_EQ(head->stretch(0), 0);
  EXPECT_EQ(head->stretch(1), 1);
  EXPECT_EQ(head->itemAt(0)->alignment(), Qt::AlignTop);
  const auto* picture = qobject_cast<QLabel*>(head->itemAt(0)->widget());
  EXPECT_EQ(picture->pixmap().size(), QSize(72, 72) * dialog.devicePixelRatioF());
  EXPECT_EQ(picture->pixmap().toImage(),
            program_icon().pixmap(QSize(72, 72), dialog.devicePixelRatioF()).toImage());
  const auto* title = qobject_cast<QLabel*>(head->itemAt(1)->widget());
  EXPECT_EQ(title->textFormat(), Qt::RichText);
  EXPECT_TRUE(title->wordWrap());
  EXPECT_EQ(title->text(),
            said("<p style=\"font-size:large\"><b>Nazori</b> %1</p><p>Carved kanji you can see, "
                 "feel and trace</p>")
                .arg(QCoreApplication::applicationVersion()));
}

TEST(AboutInDetail, AChecksumIsMutedAndTheKindsOfLicencesAreHeadings) {
  const AboutDialog dialog({{"kanjivg", "r20", "0123456789abcdef0123", "CC"}}, nullptr);
  const QString html = dialog.findChild<QTextBrowser*>()->toHtml();
  EXPECT_TRUE(html.contains(current_colours().muted.name()));
  EXPECT_EQ(html.count(said("<h3")), 2);
  for (const char* link : {"https://creativecommons.org/licenses/by-sa/3.0/", "https://kanjivg.tagaini.net",
                           "https://creativecommons.org/licenses/by-sa/4.0/", "https://www.edrdg.org"})
    EXPECT_TRUE(html.contains(said("href=\"%1\"").arg(said(link)))) << link;
  const AboutDialog without({}, nullptr);
  EXPECT_EQ(without.findChild<QTextBrowser*>()->toHtml().count(said("<h3")), 1);
}

TEST(ListOfKeysInDetail, GroupsAreIndigoKeysAreMutedAndSignsAreNoMarkup) {
  QAction compare(said("A <b>&bold</b> one"));
  compare.setShortcut(QKeySequence(said("<")));
  const KeyListDialog dialog({{said("&Less < more"), {&compare}}}, nullptr);
  EXPECT_EQ(dialog.objectName(), said("key_list_dialog"));
  const auto* text = dialog.findChild<QTextBrowser*>(said("key_list"));
  EXPECT_TRUE(text->toPlainText().contains(said("A <b>bold</b> one")));
  EXPECT_TRUE(text->toPlainText().contains(said("Less < more")));
  const QString html = text->toHtml();
  EXPECT_EQ(html.count(said("color:%1").arg(current_colours().indigo.name())), 2) << "two groups";
  EXPECT_EQ(html.count(said("color:%1").arg(current_colours().muted.name())), 8) << "seven rows and one";
  const auto* column = qobject_cast<QBoxLayout*>(dialog.layout());
  ASSERT_EQ(column->count(), 2);
  EXPECT_EQ(column->itemAt(0)->widget(), text);
  EXPECT_NE(qobject_cast<QDialogButtonBox*>(column->itemAt(1)->widget()), nullptr);
}

TEST(SaveDialogInDetail, ItsFieldsAreNamedInTheirOrderAndTheButtonIsTheDefault) {
  const SaveDialog dialog(0, true, nullptr);
  EXPECT_EQ(dialog.objectName(), said("save_dialog"));
  EXPECT_EQ(dialog.windowTitle(), said("Save the tablet"));
  const auto* form = qobject_cast<QFormLayout*>(dialog.layout());
  ASSERT_EQ(form->rowCount(), 3);
  const auto label = [&](const char* field) {
    return qobject_cast<QLabel*>(form->labelForField(dialog.findChild<QComboBox*>(said(field))))->text();
  };
  EXPECT_EQ(label("save_format"), said("&Format"));
  EXPECT_EQ(label("save_size"), said("&Size"));
  int defaults = 0;
  for (const auto* button : dialog.findChildren<QPushButton*>())
    if (button->isDefault()) {
      ++defaults;
      EXPECT_EQ(button->text(), said("Choose file…"));
    }
  EXPECT_EQ(defaults, 1);
  const auto* format = dialog.findChild<QComboBox*>(said("save_format"));
  EXPECT_EQ(format->itemText(0), said("Height map, 8-bit RAW (2005 format)"));
  EXPECT_EQ(format->itemText(1), said("Height map, 16-bit PNG"));
  EXPECT_EQ(format->itemText(2), said("Stroke order, .str (2005 format)"));
}

TEST(SaveDialogInDetail, AMapOfOneSampleIsStillAMap) {
  const SaveDialog dialog(1, false, nullptr);
  const auto* size = dialog.findChild<QComboBox*>(said("save_size"));
  EXPECT_EQ(size->count(), 1);
  EXPECT_EQ(size->itemText(0), said("1 × 1"));
  EXPECT_FALSE(size->isEnabled());
}

}  // namespace
}  // namespace nazori::ui
