// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/appearance.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QFileInfo>
#include <QFont>
#include <QFontInfo>
#include <QPainter>
#include <QProxyStyle>
#include <QSlider>
#include <QStyleOptionSlider>
#include <algorithm>
#include <utility>

#include "nazori/widgets/look/palette.h"
#include "nazori/widgets/look/style_sheet.h"

namespace nazori::ui {
namespace {

constexpr auto kPortal = "org.freedesktop.portal.Desktop";
constexpr auto kPortalPath = "/org/freedesktop/portal/desktop";
constexpr auto kPortalSettings = "org.freedesktop.portal.Settings";
constexpr auto kAppearance = "org.freedesktop.appearance";
constexpr auto kColourScheme = "color-scheme";

/// Fusion without pictures on the buttons of dialogs, and with ticks that are seen on dark paper too.
class CalmStyle final : public QProxyStyle {
 public:
  CalmStyle() : QProxyStyle(QStringLiteral("Fusion")) {}
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    // With a screen reader, Alt and a digit would also enter the menus: key events come late then. F10 does.
    if (hint == SH_MenuBar_AltKeyNavigation) return 0;
    return hint == SH_DialogButtonBox_ButtonsHaveIcons ? 0
                                                       : QProxyStyle::styleHint(hint, option, widget, data);
  }
  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override {
    const auto* slider = qstyleoption_cast<const QStyleOptionSlider*>(option);
    if (control != CC_Slider || slider == nullptr || slider->orientation != Qt::Horizontal ||
        !slider->subControls.testFlag(SC_SliderTickmarks)) {
      QProxyStyle::drawComplexControl(control, option, painter, widget);
      return;
    }
    QStyleOptionSlider plain = *slider;
    plain.subControls.setFlag(SC_SliderTickmarks, false);
    QProxyStyle::drawComplexControl(control, &plain, painter, widget);
    draw_ticks(*slider, *painter, widget);
  }

 private:
  /// Fusion draws ticks in a darker shade of the background. On a dark background they cannot be seen.
  void draw_ticks(const QStyleOptionSlider& slider, QPainter& painter, const QWidget* widget) const {
    const QRect groove = subControlRect(CC_Slider, &slider, SC_SliderGroove, widget);
    const int handle = pixelMetric(PM_SliderLength, &slider, widget);
    const int span = groove.width() - handle;
    const int interval = std::max(1, slider.tickInterval > 0 ? slider.tickInterval : slider.pageStep);
    const int height = std::max(3, pixelMetric(PM_SliderTickmarkOffset, &slider, widget));
    const bool above = (slider.tickPosition & QSlider::TicksAbove) != 0;
    const bool below = (slider.tickPosition & QSlider::TicksBelow) != 0;
    painter.save();
    painter.setPen(slider.palette.color(QPalette::PlaceholderText));
    for (int value = slider.minimum; value <= slider.maximum; value += interval) {
      const int x = groove.left() + handle / 2 +
                    sliderPositionFromValue(slider.minimum, slider.maximum, value, span, slider.upsideDown);
      if (above) painter.drawLine(x, slider.rect.top(), x, slider.rect.top() + height);
      if (below) painter.drawLine(x, slider.rect.bottom() - height, x, slider.rect.bottom());
    }
    painter.restore();
  }
};

/// Asking where there is no session bus would start one.
bool has_session_bus() {
  return qEnvironmentVariableIsSet("DBUS_SESSION_BUS_ADDRESS") ||
         QFileInfo::exists(qEnvironmentVariable("XDG_RUNTIME_DIR") + QStringLiteral("/bus"));
}

/// The same font, and after it fonts for Japanese: for letters that a font lacks the system may choose any
/// other, also one of a brush or of Chinese forms.
QFont with_japanese(QFont font) {
  // "Sans Serif" is no font: the system would look for it among all of the list.
  QStringList families{QFontInfo(font).family()};
  for (const char* family : {"Noto Sans CJK JP", "Noto Sans JP", "IPAexGothic"})
    if (!families.contains(QLatin1String(family))) families.append(QLatin1String(family));
  font.setFamilies(families);
  return font;
}

}  // namespace

Appearance::Appearance(QObject* parent)
    : QObject(parent), palette_dark_(ui::is_dark(QApplication::palette())) {
  // The application owns the style.
  QApplication::setStyle(new CalmStyle);
  apply(theme_, text_pt_);  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks)
  ask_desktop();
}

void Appearance::ask_desktop() {
  if (!has_session_bus()) return;
  auto bus = QDBusConnection::sessionBus();
  auto question =
      QDBusMessage::createMethodCall(QString::fromLatin1(kPortal), QString::fromLatin1(kPortalPath),
                                     QString::fromLatin1(kPortalSettings), QStringLiteral("Read"));
  question << QString::fromLatin1(kAppearance) << QString::fromLatin1(kColourScheme);
  auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
  connect(watcher, &QDBusPendingCallWatcher::finished, this, [this](QDBusPendingCallWatcher* finished) {
    const QDBusPendingReply<QDBusVariant> reply = *finished;
    if (reply.isValid()) use_desktop_scheme(reply.value().variant());
    finished->deleteLater();
  });
  bus.connect(QString::fromLatin1(kPortal), QString::fromLatin1(kPortalPath),
              QString::fromLatin1(kPortalSettings), QStringLiteral("SettingChanged"), this,
              SLOT(desktop_setting_changed(QString, QString, QDBusVariant)));
}

void Appearance::desktop_setting_changed(const QString& group, const QString& key,
                                         const QDBusVariant& value) {
  if (group == QLatin1String(kAppearance) && key == QLatin1String(kColourScheme))
    use_desktop_scheme(value.variant());
}

void Appearance::use_desktop_scheme(const QVariant& value) {
  // Read() wraps its answer twice.
  const QVariant inner = value.canConvert<QDBusVariant>() ? value.value<QDBusVariant>().variant() : value;
  // 1 asks for dark, 2 for light, 0 leaves it open.
  const uint wish = inner.toUInt();
  portal_dark_ = wish == 1 ? std::optional(true) : wish == 2 ? std::optional(false) : std::nullopt;
  apply(theme_, text_pt_);
}

bool Appearance::is_dark() const {
  if (theme_ != ThemeChoice::desktop) return theme_ == ThemeChoice::dark;
  return portal_dark_.value_or(palette_dark_);
}

void Appearance::apply(ThemeChoice theme, int text_pt) {
  theme_ = theme;
  text_pt_ = text_pt;
  // Setting them again would go through every widget of the window, which takes longer than making it.
  const std::pair wanted(is_dark(), text_pt);
  if (applied_ != wanted) {
    applied_ = wanted;
    const Colours& colours = is_dark() ? dark_colours() : light_colours();
    QFont font = with_japanese(QApplication::font());
    font.setPointSize(text_pt);
    QApplication::setPalette(make_palette(colours));
    // Set the font first: widgets with a style sheet read it when the sheet is set again.
    QApplication::setFont(font);
    qApp->setStyleSheet(style_sheet(colours));
  }
  emit changed();
}

}  // namespace nazori::ui
