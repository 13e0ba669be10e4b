// SPDX-License-Identifier: Apache-2.0
#include "functions/function_sound.h"

namespace nazori::ui {
namespace {

constexpr int kBrief_ms = 220;

}  // namespace

FunctionSound::FunctionSound(QObject* parent) : QObject(parent) {
  sound_.on_failure([this](const base::Error& error) { emit unavailable(error); });
  brief_.setSingleShot(true);
  brief_.setInterval(kBrief_ms);
  connect(&brief_, &QTimer::timeout, this, [this] { sound_.touch({}); });
}

void FunctionSound::touch(const functions::Cue& cue, bool trembles) {
  brief_.stop();
  sound_.touch(cue, trembles);
}

void FunctionSound::touch_briefly(const functions::Cue& cue) {
  touch(cue);
  brief_.start();
}

void FunctionSound::stop() {
  brief_.stop();
  sound_.stop();
}

bool FunctionSound::is_playing() const {
  return sound_.is_playing() || (sound_.is_open() && brief_.isActive());
}

}  // namespace nazori::ui
