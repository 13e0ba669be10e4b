// SPDX-License-Identifier: Apache-2.0
#include "device_settings.h"

#include <QSettings>
#include <algorithm>
#include <cmath>
#include <utility>

namespace nazori::ui {
namespace {

constexpr const char* kButtonWords[] = {"nothing", "next_stroke", "previous_stroke", "all_strokes",
                                        "clear_ink"};
constexpr const char* kTextureWords[] = {"none", "paper", "wood", "stone"};

template <class Enum, std::size_t N>
Enum read_word(const QSettings& s, const QString& key, const char* const (&words)[N], Enum fallback) {
  const QString text = s.value(key).toString();
  for (std::size_t i = 0; i < N; ++i)
    if (text == QLatin1String(words[i])) return static_cast<Enum>(i);
  return fallback;
}

double read_number(const QSettings& s, const QString& key, double fallback, double low, double high) {
  bool is_number = false;
  const double value = s.value(key).toDouble(&is_number);
  return is_number && std::isfinite(value) ? std::clamp(value, low, high) : fallback;
}

const QString kScale = QStringLiteral("scale");
const QString kRoll = QStringLiteral("roll");
constexpr const char* kCentre[] = {"centre_x", "centre_y", "centre_z"};

DeviceSettings read_device(const QSettings& s) {
  DeviceSettings d;
  auto& posture = d.posture;
  posture.tilt_rad = read_number(s, QStringLiteral("tilt"), posture.tilt_rad, 0, 2);
  posture.yaw_rad = read_number(s, QStringLiteral("yaw"), posture.yaw_rad, -2, 2);
  if (s.value(QStringLiteral("hand")).toString() == QLatin1String("left"))
    posture.hand = devices::WritingHand::left;
  if (s.contains(kScale)) {
    devices::WorkspaceCalibration c;
    c.scale = read_number(s, kScale, 0, 0, 1e3);
    for (int i = 0; i < 3; ++i) c.centre_m[i] = read_number(s, QLatin1String(kCentre[i]), 0, -10, 10);
    c.roll_rad = read_number(s, kRoll, 0, -4, 4);
    c.posture = posture;
    // A calibration that cannot be used is none: the automatic fit takes its place.
    if (devices::WorkspaceMapping::create(c)) d.calibration = c;
  }
  d.max_force_n = read_number(s, QStringLiteral("max_force_n"), 0, 0, 1e3);
  d.max_stiffness_n_m = read_number(s, QStringLiteral("max_stiffness_n_m"), 0, 0, 1e6);
  for (std::size_t i = 0; i < d.buttons.size(); ++i)
    d.buttons[i] = read_word(s, QStringLiteral("button_%1").arg(i + 1), kButtonWords, d.buttons[i]);
  return d;
}

void write_device(QSettings& s, const DeviceSettings& d) {
  s.setValue(QStringLiteral("tilt"), d.posture.tilt_rad);
  s.setValue(QStringLiteral("yaw"), d.posture.yaw_rad);
  s.setValue(QStringLiteral("hand"),
             d.posture.hand == devices::WritingHand::left ? QStringLiteral("left") : QStringLiteral("right"));
  if (d.calibration) {
    s.setValue(kScale, d.calibration->scale);
    for (int i = 0; i < 3; ++i) s.setValue(QLatin1String(kCentre[i]), d.calibration->centre_m[i]);
    s.setValue(kRoll, d.calibration->roll_rad);
  } else {
    s.remove(kScale);
  }
  s.setValue(QStringLiteral("max_force_n"), d.max_force_n);
  s.setValue(QStringLiteral("max_stiffness_n_m"), d.max_stiffness_n_m);
  for (std::size_t i = 0; i < d.buttons.size(); ++i)
    s.setValue(QStringLiteral("button_%1").arg(i + 1),
               QLatin1String(kButtonWords[static_cast<std::size_t>(d.buttons[i])]));
}

/// The numbers of a material by name, as they are stored.
template <class M>
auto numbers(M& m) {
  return std::array{
      std::pair{"stiffness", &m.stiffness},
      std::pair{"damping", &m.damping},
      std::pair{"static_friction", &m.static_friction},
      std::pair{"dynamic_friction", &m.dynamic_friction},
      std::pair{"popthrough", &m.popthrough},
      std::pair{"roughness", &m.roughness},
  };
}

/// Ids hold characters that a settings file would take for folders.
QString group_of(const QString& id) { return QString::fromLatin1(id.toUtf8().toHex()); }

}  // namespace

void DeviceMemory::load(QSettings& s) {
  chosen = s.value(QStringLiteral("chosen")).toString();
  for (auto [name, number] : numbers(material))
    *number = read_number(s, QStringLiteral("material_") + QLatin1String(name), *number, 0, 1);
  material.dynamic_friction = std::min(material.dynamic_friction, material.static_friction);
  material.texture = read_word(s, QStringLiteral("material_texture"), kTextureWords, material.texture);
  s.beginGroup(QStringLiteral("known"));
  for (const auto& group : s.childGroups()) {
    s.beginGroup(group);
    const QString id = QString::fromUtf8(QByteArray::fromHex(group.toLatin1()));
    if (!id.isEmpty()) devices.insert(id, read_device(s));
    s.endGroup();
  }
  s.endGroup();
}

void DeviceMemory::save(QSettings& s) const {
  s.setValue(QStringLiteral("chosen"), chosen);
  for (auto [name, number] : numbers(material))
    s.setValue(QStringLiteral("material_") + QLatin1String(name), *number);
  s.setValue(QStringLiteral("material_texture"),
             QLatin1String(kTextureWords[static_cast<std::size_t>(material.texture)]));
  s.beginGroup(QStringLiteral("known"));
  for (auto at = devices.cbegin(); at != devices.cend(); ++at) {
    s.beginGroup(group_of(at.key()));
    write_device(s, at.value());
    s.endGroup();
  }
  s.endGroup();
}

haptics::DeviceLimits limited(haptics::DeviceLimits own, const DeviceSettings& settings) {
  if (settings.max_force_n > 0) {
    own.max_force_n = std::min(own.max_force_n, settings.max_force_n);
    own.continuous_force_n = std::min(own.continuous_force_n, own.max_force_n);
  }
  if (settings.max_stiffness_n_m > 0)
    own.max_stiffness_n_m = std::min(own.max_stiffness_n_m, settings.max_stiffness_n_m);
  return own;
}

}  // namespace nazori::ui
