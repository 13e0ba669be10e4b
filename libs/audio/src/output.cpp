// SPDX-License-Identifier: Apache-2.0
#include "nazori/audio/output.h"

#include <SDL.h>

#include <cstdint>
#include <mutex>

#include "asking.h"
#include "nazori/base/sdl_lock.h"

namespace nazori::audio {
namespace {

tl::unexpected<base::Error> no_sound(const std::string& why) {
  return base::fail(base::Errc::device, why, "sound card",
                    "plug in or switch on loudspeakers or headphones; all else works without");
}

}  // namespace

base::Result<std::unique_ptr<Output>> Output::open(Source& source, const OutputSettings& settings) {
  const bool power_of_two = (settings.frames & (settings.frames - 1)) == 0;
  if (settings.rate_hz < 8'000 || settings.rate_hz > 192'000)
    return base::fail(base::Errc::bad_argument, "the sample rate is out of range", "rate_hz",
                      "8000 to 192000");
  if (settings.frames < 64 || settings.frames > 8'192 || !power_of_two)
    return base::fail(base::Errc::bad_argument, "the number of frames is out of range", "frames",
                      "a power of two from 64 to 8192");
  std::unique_ptr<Output> output(new Output);
  const std::lock_guard one(base::sdl_lock());
  // Without this hint SDL would handle Ctrl+C in place of the terminal.
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  SDL_SetHint(SDL_HINT_APP_NAME, "Nazori");
  if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return no_sound(SDL_GetError());
  output->started_ = true;
  SDL_AudioSpec wanted{};
  wanted.freq = settings.rate_hz;
  wanted.format = AUDIO_F32SYS;
  wanted.channels = 2;
  wanted.samples = static_cast<std::uint16_t>(settings.frames);
  wanted.callback = ask;
  wanted.userdata = &source;
  SDL_AudioSpec got{};
  output->device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, &got, SDL_AUDIO_ALLOW_SAMPLES_CHANGE);
  if (output->device_ == 0) return no_sound(SDL_GetError());
  const char* driver = SDL_GetCurrentAudioDriver();
  output->driver_ = driver != nullptr ? driver : "";
  SDL_PauseAudioDevice(output->device_, 0);
  return output;
}

Output::~Output() {
  if (!started_) return;
  const std::lock_guard one(base::sdl_lock());
  if (device_ != 0) SDL_CloseAudioDevice(device_);
  SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

}  // namespace nazori::audio
