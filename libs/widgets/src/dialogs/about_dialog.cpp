// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/dialogs/about_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "nazori/widgets/controls/parts.h"
#include "nazori/widgets/look/icons.h"
#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/words/kanji_text.h"

namespace nazori::ui {

AboutDialog::AboutDialog(const std::vector<kanji::Source>& sources, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("about_dialog"));
  setWindowTitle(tr("About Nazori"));
  auto* picture = new QLabel(this);
  picture->setPixmap(program_icon().pixmap(QSize(72, 72), devicePixelRatioF()));
  auto* title = new QLabel(this);
  title->setTextFormat(Qt::RichText);
  title->setWordWrap(true);
  title->setText(QStringLiteral("<p style=\"font-size:large\"><b>Nazori</b> %1</p><p>%2</p>")
                     .arg(QCoreApplication::applicationVersion().toHtmlEscaped(),
                          tr("Carved kanji you can see, feel and trace").toHtmlEscaped()));
  const auto item = [](const QString& what, const QString& licence) {
    return QStringLiteral("<p><b>%1</b><br>%2</p>").arg(what, licence);
  };
  QString html = QStringLiteral("<h3>%1</h3>").arg(tr("Licences"));
  html += item(tr("Nazori (program)"), QStringLiteral("Apache License 2.0"));
  html += item(tr("Strokes: KanjiVG, © Ulrich Apel"),
               QStringLiteral("<a href=\"https://creativecommons.org/licenses/by-sa/3.0/\">CC BY-SA 3.0</a>, "
                              "<a href=\"https://kanjivg.tagaini.net\">kanjivg.tagaini.net</a>"));
  html += item(tr("Readings, meanings and words: KANJIDIC2 and EDICT, © EDRDG"),
               QStringLiteral("<a href=\"https://creativecommons.org/licenses/by-sa/4.0/\">CC BY-SA 4.0</a>, "
                              "<a href=\"https://www.edrdg.org\">www.edrdg.org</a>"));
  html += item(tr("Textbook font: Klee One, © Fontworks Inc."), QStringLiteral("SIL Open Font License 1.1"));
  html += item(tr("User interface: Qt %1").arg(QLatin1String(qVersion())), QStringLiteral("LGPL 3"));
  if (!sources.empty()) {
    html += QStringLiteral("<h3>%1</h3>").arg(tr("Sources of the kanji database"));
    for (const auto& source : sources)
      html += item(QStringLiteral("%1 %2").arg(to_text(source.name), to_text(source.version)).toHtmlEscaped(),
                   to_text(source.licence).toHtmlEscaped() +
                       QStringLiteral("<br><span style=\"color:%1\">SHA-256 %2…</span>")
                           .arg(current_colours().muted.name(), to_text(source.sha256).left(16)));
  }
  auto* text = named(new QTextBrowser(this), "licences", tr("Licences"));
  text->setOpenExternalLinks(true);
  text->document()->setDocumentMargin(12);
  text->setHtml(html);
  auto* buttons = dialog_buttons(QDialogButtonBox::Close, this);
  auto* head = new QHBoxLayout;
  head->setSpacing(16);
  head->addWidget(picture, 0, Qt::AlignTop);
  head->addWidget(title, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 20, 20, 16);
  column->setSpacing(14);
  column->addLayout(head);
  column->addWidget(text, 1);
  column->addWidget(buttons);
  const int em = QFontMetrics(font()).height();
  resize(em * 28, em * 27);
}

}  // namespace nazori::ui
