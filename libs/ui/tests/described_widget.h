// SPDX-License-Identifier: Apache-2.0
// How a widget is made and what stands where in it, in words that can be compared with a design.
#pragma once

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFontInfo>
#include <QFormLayout>
#include <QGridLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QMetaProperty>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSlider>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableWidget>
#include <QToolBar>
#include <QToolButton>
#include <functional>
#include <map>
#include <memory>

#include "nazori/widgets/controls/flow_layout.h"
#include "painted_page.h"

namespace nazori::ui::test {

/// Takes away what windows of other tests have left: their style sheet, colours and letters.
inline void use_plain_look() {
  qApp->setStyleSheet({});
  QApplication::setFont(QFont());
  QApplication::setPalette(make_palette(light_colours()));
}

/// The object name of a widget, else its text in quotes, else its class.
inline QString called(const QWidget& widget) {
  if (!widget.objectName().isEmpty()) return widget.objectName();
  for (const char* property : {"text", "title"})
    if (const QString text = widget.property(property).toString(); !text.isEmpty())
      return QStringLiteral("“%1”").arg(text);
  return QString::fromLatin1(widget.metaObject()->className()).section(QStringLiteral("::"), -1);
}

inline QString alignment_words(Qt::Alignment alignment) {
  const std::pair<Qt::AlignmentFlag, const char*> all[] = {
      {Qt::AlignLeft, " left"}, {Qt::AlignRight, " right"},   {Qt::AlignHCenter, " centre"},
      {Qt::AlignTop, " top"},   {Qt::AlignBottom, " bottom"}, {Qt::AlignVCenter, " middle"}};
  QString words;
  for (const auto& [flag, word] : all)
    if (alignment.testFlag(flag)) words += QString::fromLatin1(word);
  return words;
}

/// The gaps of words that wrap, found from the room that they need: "gap 6 6". What is hidden has none.
inline QString flow_gaps(const FlowLayout& flow) {
  int shown = 0, widths = 0, heights = 0, highest = 0;
  for (int i = 0; i < flow.count(); ++i)
    if (auto* item = flow.itemAt(i); !item->isEmpty()) {
      ++shown;
      widths += item->sizeHint().width();
      heights += item->sizeHint().height();
      highest = std::max(highest, item->sizeHint().height());
    }
  if (shown < 2) return {};
  int one_line = widths;
  while (flow.heightForWidth(one_line) > highest) ++one_line;
  return QStringLiteral(" gap %1 %2")
      .arg((one_line - widths) / (shown - 1))
      .arg((flow.heightForWidth(0) - heights) / (shown - 1));
}

/// "column 16 16 16 12 gap 6: title, row (undo, clear), stretch*1". Margins are left, top, right and bottom.
/// Margins and gaps that are the style's, or those of the layout around it, are left out.
inline QString layout_words(const QLayout& layout, const QLayout* around = nullptr) {
  const auto item_words = [&layout](QLayoutItem& item) {
    if (item.widget() != nullptr) return called(*item.widget());
    if (item.layout() != nullptr) return QStringLiteral("(%1)").arg(layout_words(*item.layout(), &layout));
    const QSize size = item.sizeHint();
    return size.isEmpty() && size.width() + size.height() == 0
               ? QStringLiteral("stretch")
               : QStringLiteral("space %1").arg(std::max(size.width(), size.height()));
  };
  QWidget plain;
  const QVBoxLayout plain_column(&plain);
  const QFormLayout plain_form;
  const int usual = around != nullptr ? around->spacing() : plain_column.spacing();
  const QMargins m = layout.contentsMargins();
  QString head;
  if (m != (around != nullptr ? QMargins() : plain_column.contentsMargins()))
    head = QStringLiteral(" %1 %2 %3 %4").arg(m.left()).arg(m.top()).arg(m.right()).arg(m.bottom());
  const auto gap = [usual](int is) { return is == usual ? QString() : QStringLiteral(" gap %1").arg(is); };
  QStringList items;
  if (const auto* box = qobject_cast<const QBoxLayout*>(&layout)) {
    const char* const kinds[] = {"row", "row from the right", "column", "column from below"};
    head.prepend(QString::fromLatin1(kinds[box->direction()]));
    head += gap(box->spacing());
    for (int i = 0; i < box->count(); ++i)
      items.append(item_words(*box->itemAt(i)) +
                   (box->stretch(i) != 0 ? QStringLiteral("*%1").arg(box->stretch(i)) : QString()) +
                   alignment_words(box->itemAt(i)->alignment()));
  } else if (const auto* grid = qobject_cast<const QGridLayout*>(&layout)) {
    head.prepend(QStringLiteral("grid"));
    if (grid->horizontalSpacing() != usual || grid->verticalSpacing() != usual)
      head += QStringLiteral(" gap %1 %2").arg(grid->horizontalSpacing()).arg(grid->verticalSpacing());
    for (int i = 0; i < grid->count(); ++i) {
      int row = 0, column = 0, rows = 0, columns = 0;
      grid->getItemPosition(i, &row, &column, &rows, &columns);
      items.append(
          QStringLiteral("%1 %2/%3%4")
              .arg(item_words(*grid->itemAt(i)))
              .arg(row)
              .arg(column)
              .arg(rows * columns > 1 ? QStringLiteral(" over %1/%2").arg(rows).arg(columns) : QString()));
    }
    QString stretches;
    for (int column = 0; column < grid->columnCount(); ++column)
      stretches += QStringLiteral(" %1").arg(grid->columnStretch(column));
    if (stretches.count(QLatin1Char('0')) < grid->columnCount())
      items.append(QStringLiteral("columns") + stretches);
  } else if (const auto* form = qobject_cast<const QFormLayout*>(&layout)) {
    head.prepend(QStringLiteral("form"));
    if (form->horizontalSpacing() != usual || form->verticalSpacing() != usual)
      head += QStringLiteral(" gap %1 %2").arg(form->horizontalSpacing()).arg(form->verticalSpacing());
    if (form->fieldGrowthPolicy() != plain_form.fieldGrowthPolicy()) head += QStringLiteral(" grows");
    if (form->rowWrapPolicy() != plain_form.rowWrapPolicy()) head += QStringLiteral(" wraps");
    for (int row = 0; row < form->rowCount(); ++row) {
      if (auto* whole = form->itemAt(row, QFormLayout::SpanningRole)) {
        items.append(item_words(*whole));
        continue;
      }
      auto* label = form->itemAt(row, QFormLayout::LabelRole);
      items.append(QStringLiteral("%1 | %2").arg(label != nullptr ? item_words(*label) : QString(),
                                                 item_words(*form->itemAt(row, QFormLayout::FieldRole))));
    }
  } else {
    head.prepend(QStringLiteral("flow"));
    if (const auto* flow = dynamic_cast<const FlowLayout*>(&layout)) head += flow_gaps(*flow);
    for (int i = 0; i < layout.count(); ++i) items.append(item_words(*layout.itemAt(i)));
  }
  return QStringLiteral("%1: %2").arg(head, items.join(QStringLiteral(", ")));
}
/// Of the widget itself.
inline QString layout_words(const QWidget& widget) {
  return widget.layout() == nullptr ? QStringLiteral("none") : layout_words(*widget.layout());
}
/// The widget of that name in another one, or that one itself. "around NAME": the one that it stands in.
inline const QWidget* part_of(const QWidget& whole, const char* name) {
  const QString around = QStringLiteral("around "), wanted = QString::fromUtf8(name);
  if (wanted.startsWith(around)) {
    const auto* inner = whole.findChild<QWidget*>(wanted.mid(around.size()));
    return inner == nullptr ? nullptr : inner->parentWidget();
  }
  return whole.objectName() == wanted ? &whole : whole.findChild<QWidget*>(wanted);
}

/// A fresh widget of the nearest kind of Qt.
inline std::unique_ptr<QWidget> fresh_one_like(const QWidget& widget) {
  const std::map<QByteArray, std::function<QWidget*()>> kinds{
      {"QLabel", [] { return new QLabel; }},
      {"QPushButton", [] { return new QPushButton; }},
      {"QToolButton", [] { return new QToolButton; }},
      {"QRadioButton", [] { return new QRadioButton; }},
      {"QCheckBox", [] { return new QCheckBox; }},
      {"QComboBox", [] { return new QComboBox; }},
      {"QSpinBox", [] { return new QSpinBox; }},
      {"QDoubleSpinBox", [] { return new QDoubleSpinBox; }},
      {"QSlider", [] { return new QSlider(Qt::Horizontal); }},
      {"QProgressBar", [] { return new QProgressBar; }},
      {"QLineEdit", [] { return new QLineEdit; }},
      {"QPlainTextEdit", [] { return new QPlainTextEdit; }},
      {"QListWidget", [] { return new QListWidget; }},
      {"QListView", [] { return new QListView; }},
      {"QTableWidget", [] { return new QTableWidget; }},
      {"QTabWidget", [] { return new QTabWidget; }},
      {"QScrollArea", [] { return new QScrollArea; }},
      {"QStackedWidget", [] { return new QStackedWidget; }},
      {"QFrame", [] { return new QFrame; }},
      {"QDialog", [] { return new QDialog; }},
      {"QToolBar", [] { return new QToolBar; }},
      {"QWidget", [] { return new QWidget; }}};
  for (const auto* kind = widget.metaObject(); kind != nullptr; kind = kind->superClass())
    if (const auto made = kinds.find(kind->className()); made != kinds.end())
      return std::unique_ptr<QWidget>(made->second());
  return nullptr;
}

inline QString value_words(const QMetaProperty& property, const QVariant& value) {
  const QString name = QString::fromLatin1(property.name());
  if (name == QLatin1String("alignment"))
    return name + alignment_words(Qt::Alignment::fromInt(value.toInt()));
  if (property.isFlagType())
    return name + QLatin1Char(' ') +
           QString::fromLatin1(property.enumerator().valueToKeys(value.toInt())).replace(u'|', u' ');
  if (property.isEnumType())
    return name + QLatin1Char(' ') + QString::fromLatin1(property.enumerator().valueToKey(value.toInt()));
  if (value.metaType().id() == QMetaType::Bool) return value.toBool() ? name : QStringLiteral("no ") + name;
  if (value.metaType().id() == QMetaType::QSizePolicy) {
    const auto policy = value.value<QSizePolicy>();
    const auto kind = QMetaEnum::fromType<QSizePolicy::Policy>();
    return QStringLiteral("%1 %2 %3%4%5")
        .arg(name, QString::fromLatin1(kind.valueToKey(policy.horizontalPolicy())),
             QString::fromLatin1(kind.valueToKey(policy.verticalPolicy())),
             policy.hasHeightForWidth() ? QStringLiteral(" with height") : QString(),
             policy.retainSizeWhenHidden() ? QStringLiteral(" keeps") : QString());
  }
  if (value.metaType().id() == QMetaType::QCursor)
    return QStringLiteral("%1 %2").arg(name).arg(QString::fromLatin1(
        QMetaEnum::fromType<Qt::CursorShape>().valueToKey(value.value<QCursor>().shape())));
  return name + QLatin1Char(' ') + value.toString();
}

/// Whether a property follows from another one, by the way of Qt.
inline bool follows(const QWidget& widget, const QByteArray& property) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget))
    return (property == "sizePolicy" && label->sizePolicy().hasHeightForWidth() &&
            label->sizePolicy().horizontalPolicy() == QSizePolicy::Preferred) ||
           (property == "focusPolicy" && label->focusPolicy() == Qt::ClickFocus &&
            label->textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
  if (property == "shortcut")
    return widget.property("shortcut").value<QKeySequence>() ==
           QKeySequence::mnemonic(widget.property("text").toString());
  return property == "text" && widget.inherits("QAbstractSpinBox");
}

/// What a widget is that a fresh one of its kind is not, by the alphabet: "minimumWidth 20; role muted".
/// Letters of another size are compared with those of the program: "letters 1.7".
inline QString made_words(const QWidget& widget) {
  // Places, and what follows from the rest.
  static const QList<QByteArray> kLeftOut{"objectName",
                                          "modal",
                                          "windowModality",
                                          "geometry",
                                          "frameGeometry",
                                          "normalGeometry",
                                          "x",
                                          "y",
                                          "pos",
                                          "frameSize",
                                          "size",
                                          "width",
                                          "height",
                                          "rect",
                                          "childrenRect",
                                          "childrenRegion",
                                          "minimumSize",
                                          "maximumSize",
                                          "palette",
                                          "font",
                                          "isActiveWindow",
                                          "focus",
                                          "visible",
                                          "minimized",
                                          "maximized",
                                          "fullScreen",
                                          "sizeHint",
                                          "minimumSizeHint",
                                          "windowIcon",
                                          "windowIconText",
                                          "windowFilePath",
                                          "locale",
                                          "icon",
                                          "iconSize",
                                          "displayText",
                                          "cursorPosition",
                                          "hasSelectedText",
                                          "selectedText",
                                          "undoAvailable",
                                          "redoAvailable",
                                          "acceptableInput",
                                          "modified",
                                          "cleanText",
                                          "count",
                                          "currentIndex",
                                          "currentText",
                                          "currentData",
                                          "sliderPosition",
                                          "sliderDown",
                                          "tabStopDistance",
                                          "blockCount",
                                          "layoutDirection",
                                          "frameRect",
                                          "rowCount",
                                          "currentRow",
                                          "inputMethodHints",
                                          "updatesEnabled",
                                          "autoRepeatDelay",
                                          "autoRepeatInterval",
                                          "windowOpacity",
                                          "plainText",
                                          "frameWidth",
                                          "floating"};
  const auto fresh = fresh_one_like(widget);
  QStringList words;
  for (const QByteArray& own : widget.dynamicPropertyNames())
    if (!own.startsWith("_q_"))
      words.append(QStringLiteral("%1 %2").arg(QString::fromLatin1(own), widget.property(own).toString()));
  const auto* meta = fresh->metaObject();
  for (int i = 0; i < meta->propertyCount(); ++i) {
    const QMetaProperty property = meta->property(i);
    if (kLeftOut.contains(property.name())) continue;
    if (follows(widget, property.name())) continue;
    const QVariant is = property.read(&widget), was = property.read(fresh.get());
    const QString now = value_words(property, is);
    if (now != value_words(property, was)) words.append(now);
  }
  const QFontInfo font(widget.font()), usual(QApplication::font());
  const double points = widget.font().pointSizeF() > 0 ? widget.font().pointSizeF() : font.pointSizeF();
  const double larger = std::round(1000 * points / usual.pointSizeF()) / 1000;
  if (larger != 1) words.append(QStringLiteral("letters %1").arg(larger));
  if (font.family() != usual.family()) words.append(QStringLiteral("in ") + font.family());
  if (font.weight() != usual.weight()) words.append(QStringLiteral("weight %1").arg(font.weight()));
  if (const auto* label = qobject_cast<const QLabel*>(&widget); label != nullptr && label->buddy() != nullptr)
    words.append(QStringLiteral("of ") + called(*label->buddy()));
  if (widget.focusProxy() != nullptr && !widget.inherits("QAbstractSpinBox") &&
      !widget.inherits("QTabWidget"))
    words.append(QStringLiteral("keyboard to ") + called(*widget.focusProxy()));
  if (widget.testAttribute(Qt::WA_StyledBackground) && !fresh->testAttribute(Qt::WA_StyledBackground))
    words.append(QStringLiteral("styled"));
  if (!widget.isWindow() && widget.isHidden()) words.append(QStringLiteral("hidden"));
  words.sort();
  return words.join(QStringLiteral("; "));
}

/// Compares the parts of a widget with how they are to be made.
inline void expect_made(const QWidget& whole,
                        std::initializer_list<std::pair<const char*, const char*>> parts) {
  for (const auto& [name, made] : parts) {
    const auto* part = part_of(whole, name);
    ASSERT_NE(part, nullptr) << name;
    EXPECT_EQ(made_words(*part).toStdString(), made) << "how " << name << " is made";
  }
}
/// Compares the layouts of the parts of a widget with a design.
inline void expect_laid_out(const QWidget& whole,
                            std::initializer_list<std::pair<const char*, const char*>> parts) {
  for (const auto& [name, layout] : parts) {
    const auto* part = part_of(whole, name);
    ASSERT_NE(part, nullptr) << name;
    EXPECT_EQ(layout_words(*part).toStdString(), layout) << "what stands in " << name;
  }
}

}  // namespace nazori::ui::test
