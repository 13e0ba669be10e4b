// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <SDL2/SDL.h>
#include <gtest/gtest.h>

#include <atomic>

namespace nazori::devices::standin {

/// A virtual pad, plugged in while it lives.
class VirtualPad {
 public:
  VirtualPad() {
    SDL_VirtualJoystickDesc desc{};
    desc.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    desc.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
    desc.naxes = SDL_CONTROLLER_AXIS_MAX;
    desc.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
    desc.name = "Nazori's virtual pad";
    desc.userdata = this;
    desc.Rumble = [](void* self, Uint16 slow, Uint16 fast) {
      static_cast<VirtualPad*>(self)->low = slow;
      static_cast<VirtualPad*>(self)->high = fast;
      return 0;
    };
    index_ = SDL_JoystickAttachVirtualEx(&desc);
    EXPECT_GE(index_, 0) << SDL_GetError();
    joystick_ = SDL_JoystickOpen(index_);
    EXPECT_NE(joystick_, nullptr) << SDL_GetError();
    // A trigger's axis rests at its lower end.
    axis(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, -32768);
    axis(SDL_CONTROLLER_AXIS_TRIGGERLEFT, -32768);
  }
  ~VirtualPad() {
    SDL_JoystickDetachVirtual(index_);
    SDL_JoystickClose(joystick_);
  }
  VirtualPad(const VirtualPad&) = delete;
  VirtualPad& operator=(const VirtualPad&) = delete;
  void axis(int which, Sint16 value) const { SDL_JoystickSetVirtualAxis(joystick_, which, value); }
  void button(int which, bool down) const { SDL_JoystickSetVirtualButton(joystick_, which, down ? 1 : 0); }

  std::atomic<int> low{0}, high{0};

 private:
  int index_ = -1;
  SDL_Joystick* joystick_ = nullptr;
};

}  // namespace nazori::devices::standin
