// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/dialogs/key_list_dialog.h"

#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/palette.h"

namespace nazori::ui {
KeyListDialog::KeyListDialog(const QList<ActionSet::Group>& groups, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("key_list_dialog"));
  setWindowTitle(tr("Keyboard and mouse"));
  const Colours& c = current_colours();
  QString html = QStringLiteral("<table cellspacing=0 cellpadding=4 width=100%>");
  const auto heading = [&](const QString& title) {
    html += QStringLiteral("<tr><td colspan=2 style=\"padding-top:12px; color:%1\"><b>%2</b></td></tr>")
                .arg(c.indigo.name(), without_mnemonic(title).toHtmlEscaped());
  };
  const auto row = [&](const QString& what, const QString& how) {
    html += QStringLiteral("<tr><td>%1</td><td align=right style=\"color:%2\">%3</td></tr>")
                .arg(what.toHtmlEscaped(), c.muted.name(), how.toHtmlEscaped());
  };
  heading(tr("On the tablet"));
  row(tr("Press the stylus down"), tr("left button, pen tip"));
  row(tr("Press deeper or more lightly"), tr("wheel while pressing, or pen pressure"));
  row(tr("Undo a stroke (Memory)"), tr("eraser end of the pen"));
  row(tr("Turn and tilt"), tr("right button, or side button of the pen"));
  row(tr("Move"), tr("middle button, or Shift + right button"));
  row(tr("Zoom"), tr("wheel"));
  row(tr("Reset view"), tr("Home"));
  for (const auto& group : groups) {
    heading(group.title);
    for (const auto* action : group.actions) {
      if (action == nullptr || !action->isVisible()) continue;
      QStringList keys;
      for (const auto& key : action->shortcuts()) keys.append(key.toString(QKeySequence::NativeText));
      row(without_mnemonic(action->text()), keys.join(QStringLiteral("   ")));
    }
  }
  html += QStringLiteral("</table>");
  auto* text = named(new QTextBrowser(this), "key_list");
  text->setAccessibleName(windowTitle());
  text->document()->setDocumentMargin(12);
  text->setHtml(html);
  auto* buttons = dialog_buttons(QDialogButtonBox::Close, this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 16, 16, 16);
  column->setSpacing(12);
  column->addWidget(text);
  column->addWidget(buttons);
  const int em = QFontMetrics(font()).height();
  resize(em * 28, em * 34);
}

}  // namespace nazori::ui
