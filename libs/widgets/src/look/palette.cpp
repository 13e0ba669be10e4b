// SPDX-License-Identifier: Apache-2.0
#include "nazori/widgets/look/palette.h"

#include <QGuiApplication>
#include <algorithm>
#include <cmath>

namespace nazori::ui {
namespace {

double linear(double channel) {
  return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

}  // namespace

const Colours& light_colours() {
  static const Colours light{QColor(0xF7F4EC), QColor(0xFFFDF8), QColor(0xD9D2C3), QColor(0x8A8272),
                             QColor(0x1F1B16), QColor(0x625C52), QColor(0xB5301F), QColor(0x274C84),
                             QColor(0x476A2E), QColor(0x855A00)};
  return light;
}

const Colours& dark_colours() {
  static const Colours dark{QColor(0x1B1917), QColor(0x26231F), QColor(0x453F37), QColor(0x80786A),
                            QColor(0xEFE9DD), QColor(0xB3AA9B), QColor(0xFF8F78), QColor(0x9FBBEE),
                            QColor(0xAFCB8E), QColor(0xEBBB62)};
  return dark;
}

bool is_dark(const QPalette& palette) {
  return luminance(palette.color(QPalette::WindowText)) > luminance(palette.color(QPalette::Window));
}

const Colours& current_colours() {
  return is_dark(QGuiApplication::palette()) ? dark_colours() : light_colours();
}

QPalette make_palette(const Colours& c) {
  QPalette p;
  p.setColor(QPalette::Window, c.paper);
  p.setColor(QPalette::WindowText, c.ink);
  p.setColor(QPalette::Base, c.surface);
  p.setColor(QPalette::AlternateBase, c.paper);
  p.setColor(QPalette::Text, c.ink);
  p.setColor(QPalette::PlaceholderText, c.muted);
  p.setColor(QPalette::Button, c.surface);
  p.setColor(QPalette::ButtonText, c.ink);
  p.setColor(QPalette::BrightText, c.vermilion);
  p.setColor(QPalette::Highlight, c.indigo);
  p.setColor(QPalette::HighlightedText, c.surface);
  p.setColor(QPalette::Link, c.indigo);
  p.setColor(QPalette::LinkVisited, c.indigo);
  p.setColor(QPalette::ToolTipBase, c.surface);
  p.setColor(QPalette::ToolTipText, c.ink);
  p.setColor(QPalette::Light, c.surface);
  p.setColor(QPalette::Midlight, blend(c.surface, c.line, 0.5));
  p.setColor(QPalette::Mid, c.line);
  p.setColor(QPalette::Dark, blend(c.line, c.muted, 0.5));
  p.setColor(QPalette::Shadow, blend(c.line, c.muted, 0.8));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, blend(c.muted, c.paper, 0.35));
  return p;
}

QColor blend(const QColor& back, const QColor& front, double share) {
  const auto mix = [share](double a, double b) { return static_cast<float>(a + (b - a) * share); };
  return QColor::fromRgbF(mix(back.redF(), front.redF()), mix(back.greenF(), front.greenF()),
                          mix(back.blueF(), front.blueF()));
}

double contrast_ratio(const QColor& a, const QColor& b) {
  const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
  return (light + 0.05) / (dark + 0.05);
}

}  // namespace nazori::ui
