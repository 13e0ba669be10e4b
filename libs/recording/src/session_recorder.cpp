// SPDX-License-Identifier: Apache-2.0
#include "nazori/recording/session_recorder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "nazori/base/file.h"
#include "recording_output.h"
#include "shared_ring.h"

namespace nazori::recording {
namespace {

using base::Errc;
using haptics::SampleRing;
namespace fs = std::filesystem;

constexpr auto kBetweenWrites = std::chrono::milliseconds(20);
constexpr auto kBetweenFlushes = std::chrono::seconds(1);

base::Result<SessionId> random_id() {
  SessionId id{};
  if (::getrandom(id.data(), id.size(), 0) != static_cast<ssize_t>(id.size()))
    return base::fail(Errc::io, "the system has no random numbers");
  return id;
}

}  // namespace

struct SessionRecorder::Inside {
  Inside(haptics::Servo& of, fs::path to, SharedRing in, RecordingOutput out)
      : servo(of), path(std::move(to)), shared(std::move(in)), output(std::move(out)) {}

  void run();
  [[nodiscard]] bool drain();

  haptics::Servo& servo;
  const fs::path path;  // the requested path; for .csv not the file being written
  SharedRing shared;
  RecordingOutput output;  // used by the thread while it runs

  mutable std::mutex mutex;
  std::condition_variable wake, drained;
  bool stopping = false, hurry = false;  // under mutex
  base::Error error;                     // under mutex
  bool exported = false;                 // whether the .csv was written from the .nzr
  std::thread thread;
};

/// Moves the content of the ring into the file. @return false when the file cannot be written.
bool SessionRecorder::Inside::drain() {
  auto written = output.take(shared.ring());
  if (written) return true;
  const std::lock_guard lock(mutex);
  error = std::move(written.error());
  return false;
}

void SessionRecorder::Inside::run() {
  auto flushed = std::chrono::steady_clock::now();
  for (bool go_on = true; go_on;) {
    {
      std::unique_lock lock(mutex);
      wake.wait_for(lock, kBetweenWrites, [this] { return stopping || hurry; });
      go_on = !stopping;
      hurry = false;
    }
    if (!drain()) go_on = false;
    drained.notify_all();
    if (const auto now = std::chrono::steady_clock::now(); now - flushed >= kBetweenFlushes) {
      output.flush();
      flushed = now;
    }
  }
}

SessionRecorder::SessionRecorder(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}

base::Result<std::unique_ptr<SessionRecorder>> SessionRecorder::start(haptics::Servo& servo,
                                                                      const fs::path& path, Session session) {
  const std::string extension = path.extension().string();
  if (extension != kRecordingExtension && extension != ".csv") {
    return base::fail(Errc::bad_argument, "is not a kind of recording", path.string(),
                      "use a name that ends in .nzr or .csv");
  }
  const auto id = random_id();
  if (!id) return tl::unexpected(id.error());
  session.id = *id;
  session.start_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                         std::chrono::system_clock::now().time_since_epoch())
                         .count();
  auto shared = SharedRing::create(*id);
  if (!shared) return tl::unexpected(std::move(shared.error()));
  fs::path target = path;
  if (extension == ".csv") target += kRecordingExtension;
  auto output = RecordingOutput::create(target, session);
  if (!output) {
    shared->remove();
    return tl::unexpected(std::move(output.error()));
  }
  auto inside = std::make_unique<Inside>(servo, path, std::move(*shared), std::move(*output));
  try {
    inside->thread = std::thread([in = inside.get()] { in->run(); });
  } catch (const std::system_error& e) {
    inside->shared.remove();
    return base::fail(Errc::io, std::string("no thread to record with: ") + e.what());
  }
  servo.set_recording(&inside->shared.ring());
  return std::unique_ptr<SessionRecorder>(new SessionRecorder(std::move(inside)));
}

SessionRecorder::~SessionRecorder() {
  if (inside_->thread.joinable()) (void)finish();
}

const fs::path& SessionRecorder::raw_path() const { return inside_->output.path(); }

RecorderStatus SessionRecorder::status() const {
  const Inside& in = *inside_;
  const SampleRing& ring = in.shared.ring();
  RecorderStatus status;
  status.written = ring.taken.load(std::memory_order_acquire);
  status.samples = ring.pushed.load(std::memory_order_acquire);
  status.lost = ring.lost.load(std::memory_order_relaxed);
  const std::lock_guard lock(in.mutex);
  status.error = in.error;
  return status;
}

void SessionRecorder::wait_for_room() {
  Inside& in = *inside_;
  const SampleRing& ring = in.shared.ring();
  const auto crowded = [&ring] {
    return ring.pushed.load(std::memory_order_relaxed) - ring.taken.load(std::memory_order_acquire) >
           SampleRing::kCapacity / 2;
  };
  if (!crowded()) return;
  std::unique_lock lock(in.mutex);
  while (crowded() && in.error.what.empty() && in.thread.joinable()) {
    in.hurry = true;
    in.wake.notify_one();
    in.drained.wait_for(lock, kBetweenWrites);
  }
}

base::Result<RecorderStatus> SessionRecorder::close() {
  Inside& in = *inside_;
  if (in.thread.joinable()) {
    in.servo.set_recording(nullptr);
    {
      const std::lock_guard lock(in.mutex);
      in.stopping = true;
    }
    in.wake.notify_one();
    in.thread.join();
    if (in.error.what.empty() && in.drain()) {
      const SampleRing& ring = in.shared.ring();
      auto closed =
          in.output.close(ring.lost.load(std::memory_order_relaxed), RecordingOutput::Ending::regular);
      if (!closed) in.error = std::move(closed.error());
    }
    in.shared.remove();
  }
  RecorderStatus ended = status();
  if (!ended.error.what.empty()) return tl::unexpected(std::move(ended.error));
  return ended;
}

base::Result<RecorderStatus> SessionRecorder::finish() {
  Inside& in = *inside_;
  auto closed = close();
  if (!closed || in.output.path() == in.path || std::exchange(in.exported, true)) return closed;
  auto exported = export_csv(in.output.path(), in.path, {});
  if (!exported) {
    exported.error().remedy = "the recording is kept as " + in.output.path().string();
    const std::lock_guard lock(in.mutex);
    in.error = exported.error();
    return tl::unexpected(std::move(exported.error()));
  }
  std::error_code ignored;
  fs::remove(in.output.path(), ignored);
  return closed;
}

base::Result<Recovery> recover(const fs::path& path) {
  auto reader = RecordingReader::open(path);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  auto shared = SharedRing::adopt(reader->session().id);
  if (!shared) {
    if (RecordingOutput::is_complete(path)) return Recovery::not_needed;
    switch (shared.error().code) {
      case Errc::not_found:
        return Recovery::nothing_left;
      case Errc::device:
        return Recovery::in_progress;
      default:
        return tl::unexpected(std::move(shared.error()));
    }
  }
  if (RecordingOutput::is_complete(
          path)) {  // the program crashed between finishing the file and removing the ring
    shared->remove();
    return Recovery::not_needed;
  }
  auto output = RecordingOutput::reopen(path);
  if (!output) return tl::unexpected(std::move(output.error()));
  SampleRing& ring = shared->ring();
  // The recorder may have crashed between writing a record and marking it as stored.
  const std::uint64_t pushed = ring.pushed.load(std::memory_order_acquire);
  const std::uint64_t oldest = pushed - std::min(pushed, SampleRing::kCapacity);
  const std::uint64_t from = std::max(output->records(), ring.taken.load(std::memory_order_acquire));
  ring.taken.store(std::clamp(from, oldest, pushed), std::memory_order_release);
  auto done = output->take(ring);
  if (done) {
    done = output->close(ring.lost.load(std::memory_order_relaxed), RecordingOutput::Ending::recovered);
  }
  if (!done) return tl::unexpected(std::move(done.error()));
  shared->remove();
  return Recovery::recovered;
}

}  // namespace nazori::recording
