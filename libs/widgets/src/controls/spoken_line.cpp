// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/controls/spoken_line.h"

#include <QAccessible>
#include <QAccessibleWidget>

namespace nazori::ui {
namespace {

QAccessibleInterface* make_notification(const QString& class_name, QObject* object) {
  if (class_name != QLatin1String(SpokenLine::staticMetaObject.className())) return nullptr;
  return new QAccessibleWidget(qobject_cast<QWidget*>(object), QAccessible::Notification);
}

}  // namespace

SpokenLine::SpokenLine(QWidget* parent, int wait_ms) : QWidget(parent) {
  QAccessible::installFactory(make_notification);  // once, however often it is asked for
  setObjectName(QStringLiteral("spoken_line"));
  // It must count as shown, or its notifications would be of a hidden widget.
  setFixedSize(1, 1);
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  timer_.setSingleShot(true);
  timer_.setInterval(wait_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { send(waiting_.join(QLatin1Char(' '))); });
}

void SpokenLine::speak(Urgency urgency, const QString& sentence) {
  if (sentence.isEmpty()) return;
  if (urgency == Urgency::at_once) return send(sentence);
  if (waiting_.contains(sentence)) return;
  waiting_.append(sentence);
  timer_.start();
}

void SpokenLine::send(const QString& text) {
  timer_.stop();
  waiting_.clear();
  setAccessibleName(text);
  // The name first: assistive technology keeps the last one it was told of.
  QAccessibleEvent named(this, QAccessible::NameChanged);
  QAccessible::updateAccessibility(&named);
  QAccessibleEvent shown(this, QAccessible::ObjectShow);
  QAccessible::updateAccessibility(&shown);
  emit spoken(text);
}

}  // namespace nazori::ui
