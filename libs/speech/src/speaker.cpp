// SPDX-License-Identifier: Apache-2.0
#include "nazori/speech/speaker.h"

#include <utility>

#include "nazori/base/latest.h"

namespace nazori::speech {
namespace {

struct Request {
  std::string kana;
  VoiceChoice choice;
};

/// An answer with its request number.
struct Answer {
  std::uint64_t number;
  base::Result<Spoken> spoken;
};

}  // namespace

struct Speaker::Inside {
  Inside(Speaker& owner, base::Inbox& inbox, SpeechPlaces places)
      : voices(std::make_shared<Voices>(std::move(places))),
        background(std::make_shared<base::Background>("speech", inbox)),
        requests(
            background,
            [voices = voices](const Request& request, const auto& run) {
              voices->choose(request.choice);
              return Answer{run.ticket(),
                            voices->speak(request.kana, false, [&run] { return run.is_wanted(); })};
            },
            [&owner](const Answer& answer) {
              if (answer.spoken)
                owner.spoken(answer.number, *answer.spoken);
              else
                owner.failed(answer.number, answer.spoken.error());
            }),
        questions(
            background,
            [voices = voices](const VoiceChoice& choice, const auto&) {
              voices->choose(choice);
              return voices->voice();
            },
            [&owner](const base::Result<VoiceState>& voice) { owner.voice_found(voice); }) {}

  std::shared_ptr<Voices> voices;  ///< used by the background thread only
  std::shared_ptr<base::Background> background;
  base::Latest<Request, Answer> requests;
  base::Latest<VoiceChoice, base::Result<VoiceState>> questions;
};

Speaker::Speaker(base::Inbox& inbox, SpeechPlaces places, VoiceChoice choice)
    : choice_(std::move(choice)), inside_(std::make_unique<Inside>(*this, inbox, std::move(places))) {}

Speaker::~Speaker() = default;

void Speaker::choose(const VoiceChoice& choice) { choice_ = choice; }

std::uint64_t Speaker::speak(const std::string& kana) { return inside_->requests.request({kana, choice_}); }

void Speaker::stop() { inside_->requests.cancel(); }

bool Speaker::is_busy() const { return inside_->requests.is_busy(); }

void Speaker::find_voice() { inside_->questions.request(choice_); }

}  // namespace nazori::speech
