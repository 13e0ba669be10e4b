// SPDX-License-Identifier: Apache-2.0
// Loading libHD.so and opening a device with it.
#include "openhaptics_port.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "device_nodes.h"
#include "force_guard.h"
#include "shared_library.h"

namespace nazori::devices::hd {
namespace {

using haptics::DeviceTrouble;

constexpr const char* kName = "OpenHaptics";
constexpr const char* kInstall =
    "install the Touch driver and OpenHaptics from 3D Systems, see docs/devices.md, OpenHaptics";
// Some versions return garbage instead of "no device" after a first failed attempt.
constexpr Handle kLargestHandle = 1024;
constexpr int kMostErrors = 256;

std::atomic<unsigned int> last_latched{0};

/// The library prints up to twelve lines of advertisement on standard error each time it opens a device.
/// Output of other threads during these milliseconds is lost with them.
class QuietStandardError {
 public:
  QuietStandardError() : kept_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
    const int nowhere = kept_ >= 0 ? ::open("/dev/null", O_WRONLY | O_CLOEXEC) : -1;
    if (nowhere < 0) return;
    (void)std::fflush(stderr);
    (void)::dup2(nowhere, STDERR_FILENO);
    (void)::close(nowhere);
  }
  ~QuietStandardError() {
    if (kept_ < 0) return;
    (void)std::fflush(stderr);
    (void)::dup2(kept_, STDERR_FILENO);
    (void)::close(kept_);
  }
  QuietStandardError(const QuietStandardError&) = delete;
  QuietStandardError& operator=(const QuietStandardError&) = delete;

 private:
  int kept_;
};

Handle init_quietly(const Functions& hd, const char* name) {
  const QuietStandardError quiet;
  // Threads that the library starts here must not run the program's signal handlers.
  const SignalsBlocked inherited;
  return hd.init_device(name);
}

std::string hex(unsigned int code) {
  std::string text;
  constexpr const char* kDigits = "0123456789abcdef";
  for (int shift = 12; shift >= 0; shift -= 4) text += kDigits[(code >> shift) & 15U];
  return "0x" + text;
}

/// The entries of /dev that may belong to a PHANTOM or Touch. Every keyboard has a hidraw node, so only those
/// of the maker count.
std::vector<DeviceNode> own_nodes(const OpenHapticsSettings& settings) {
  constexpr std::string_view kVendor = "2988";  // 3D Systems, Geomagic
  auto nodes = device_nodes(settings.device_folder, {"ttyACM", "hidraw", "raw1394"});
  std::erase_if(nodes, [&](const DeviceNode& node) {
    const std::string name = node.path.filename().string();
    if (name.starts_with("raw1394")) return false;
    const std::string vendor = usb_vendor(node.path, settings.system_folder);
    return vendor != kVendor && (!vendor.empty() || name.starts_with("hidraw"));
  });
  return nodes;
}

tl::unexpected<DeviceProblem> refused(const Functions& hd, const ErrorInfo& error, const std::string& tried,
                                      const OpenHapticsSettings& settings) {
  const char* words = error.code != 0 ? hd.error_string(error.code) : nullptr;
  const std::string code =
      error.code == 0 ? "" : hex(error.code) + (words != nullptr ? std::string(": ") + words : "") + "; ";
  const std::string details = " (" + code + "tried " + tried + ")";
  switch (error.code) {
    case already_initiated:
      return no_device(DeviceTrouble::in_use, "the device is already in use" + details, kName,
                       "close the program that uses it");
    case licence:
      return no_device(
          DeviceTrouble::init_failed, "the library needs a licence" + details, kName,
          "put the licence file where the manufacturer's manual says, or set OH_SDK_LICENSE_PATH");
    case warm_motors:
      return no_device(DeviceTrouble::init_failed, "the device's motors are too warm" + details, kName,
                       "wait a few minutes");
    case 0:
    case device_fault:
    case communication:
    case configuration: {
      const std::string what = "no device responds" +
                               std::string(error.code == 0 ? ", and the library does not say why" : "") +
                               details;
      if (const auto advice = permission_advice(own_nodes(settings)))
        return no_device(DeviceTrouble::no_permission, what, kName, *advice);
      return no_device(DeviceTrouble::device_absent, what, kName,
                       "plug it in, switch it on and run the manufacturer's Touch_Setup once");
    }
    case timer:
      return no_device(DeviceTrouble::no_timer, "the library gets no timer from the system" + details, kName,
                       "close other programs and start this one again");
    default:
      return no_device(DeviceTrouble::init_failed, "the library cannot open the device" + details, kName,
                       "run the manufacturer's Touch_Diagnostic");
  }
}

}  // namespace

std::string remedy_for_missing(std::string_view words, std::string otherwise) {
  const auto lacks = [&](std::string_view library) { return words.find(library) != std::string_view::npos; };
  if (lacks("libncurses.so.5")) return "run sudo apt-get install libncurses5";
  if (lacks("libPhantomManagerLite"))
    return "install the Touch HID driver of 2023 or 2024 of 3D Systems, which brings it";
  if (lacks("libPHANToMIO") || lacks("libPhantomIOLib"))
    return "install the Touch driver of 3D Systems, which brings it";
  return otherwise;
}

DeviceResult<Functions> load(const std::string& user_path) {
  std::vector<std::string> names{"libHD.so", "libHD.so.3.4", "libHD.so.3.0", "/usr/lib/libHD.so",
                                 "/usr/lib64/libHD.so"};
  // A path given by the user is binding: no other file is used instead.
  if (!user_path.empty()) names = {user_path};
  auto library = SharedLibrary::load(kName, names, kInstall);
  if (!library) {
    base::Error& error = library.error().error;
    error.remedy = remedy_for_missing(error.what, error.remedy);
    return tl::unexpected(library.error());
  }
  Functions hd;
  DeviceResult<void> all;
  const auto need = [&](auto& function, const char* name) {
    if (all) all = library->need(function, name);
  };
  need(hd.init_device, "hdInitDevice");
  need(hd.disable_device, "hdDisableDevice");
  need(hd.make_current, "hdMakeCurrentDevice");
  need(hd.begin_frame, "hdBeginFrame");
  need(hd.end_frame, "hdEndFrame");
  need(hd.get_error, "hdGetError");
  need(hd.error_string, "hdGetErrorString");
  need(hd.enable, "hdEnable");
  need(hd.disable, "hdDisable");
  need(hd.is_enabled, "hdIsEnabled");
  need(hd.get_booleans, "hdGetBooleanv");
  need(hd.get_integers, "hdGetIntegerv");
  need(hd.get_doubles, "hdGetDoublev");
  need(hd.get_string, "hdGetString");
  need(hd.set_doubles, "hdSetDoublev");
  need(hd.check_calibration, "hdCheckCalibration");
  need(hd.update_calibration, "hdUpdateCalibration");
  need(hd.start_scheduler, "hdStartScheduler");
  need(hd.stop_scheduler, "hdStopScheduler");
  need(hd.schedule_asynchronous, "hdScheduleAsynchronous");
  need(hd.unschedule, "hdUnschedule");
  if (!all) return tl::unexpected(all.error());
  library->want(hd.set_scheduler_rate, "hdSetSchedulerRate");
  return hd;
}

ErrorInfo pop_errors(const Functions& hd) noexcept {
  // The newest error comes first; the oldest is the cause.
  ErrorInfo oldest{0, 0, kNoDevice};
  for (int i = 0; i < kMostErrors; ++i) {
    const ErrorInfo error = hd.get_error();
    if (error.code == 0) break;
    oldest = error;
    if (error.code == communication || error.code == configuration || error.code == timer)
      last_latched.store(error.code, std::memory_order_relaxed);
  }
  return oldest;
}

unsigned int latched_error() noexcept { return last_latched.load(std::memory_order_relaxed); }
void forget_latched_error() noexcept { last_latched.store(0, std::memory_order_relaxed); }

DeviceResult<std::shared_ptr<Port>> Port::open(const Functions& hd, const OpenHapticsSettings& settings,
                                               const std::string& wanted_name) {
  const std::string& user_name = wanted_name.empty() ? settings.device_name : wanted_name;
  std::vector<const char*> names;
  if (!user_name.empty()) names.push_back(user_name.c_str());
  // A device named by the user is binding.
  if (wanted_name.empty()) names.insert(names.end(), {nullptr, "Default Device", "Default PHANToM"});

  (void)pop_errors(hd);
  ErrorInfo first{0, 0, kNoDevice};
  std::string tried;
  for (const char* name : names) {
    const Handle handle = init_quietly(hd, name);
    const ErrorInfo error = pop_errors(hd);
    const bool plausible = handle != kNoDevice && (tried.empty() || handle <= kLargestHandle);
    if (plausible && error.code == 0) return std::shared_ptr<Port>(new Port(hd, handle));
    if (first.code == 0) first = error;
    tried +=
        (tried.empty() ? "" : ", ") + (name != nullptr ? "'" + std::string(name) + "'" : "the first device");
  }
  if (first.code == 0) first.code = latched_error();
  return refused(hd, first, tried, settings);
}

Port::~Port() {
  (void)pop_errors(hd);
  hd.disable_device(handle);
  (void)pop_errors(hd);
}

double Port::number(Enum what, double scale, double otherwise) const {
  double value = 0;
  hd.get_doubles(what, &value);
  const bool failed = pop_errors(hd).code != 0;
  return !failed && std::isfinite(value) && value > 0 ? value * scale : otherwise;
}

void Port::describe() {
  hd.make_current(handle);
  const auto text = [&](Enum what) {
    const char* value = hd.get_string(what);
    return pop_errors(hd).code == 0 && value != nullptr ? std::string(value) : std::string();
  };
  const std::string model = text(kModel), serial = text(kSerial);
  name = model.empty() ? "OpenHaptics device" : model;
  if (!serial.empty()) name += " (serial " + serial + ")";

  // Where a getter returns nothing: the values of a PHANTOM Omni, the weakest device.
  limits.max_force_n = number(kMaxForce, 1, 3.3);
  limits.continuous_force_n = std::min(number(kMaxContinuousForce, 1, 0.88), limits.max_force_n);
  limits.max_stiffness_n_m = number(kMaxStiffness, 1e3, 500);
  limits.max_damping_n_s_m = number(kMaxDamping, 1e3, 2.5);

  std::array<double, 6> box{};
  hd.get_doubles(kUsableWorkspace, box.data());
  if (pop_errors(hd).code == 0 && box[3] > box[0] && box[4] > box[1] && box[5] > box[2])
    workspace = {{box[0] * 1e-3, box[1] * 1e-3, box[2] * 1e-3},
                 {box[3] * 1e-3, box[4] * 1e-3, box[5] * 1e-3}};

  hd.get_integers(kCalibrationStyle, &calibration_styles);
  if (pop_errors(hd).code != 0) calibration_styles = 0;
  Boolean switched = 0;
  hd.get_booleans(kInkwellSwitch, &switched);
  reads_inkwell = pop_errors(hd).code == 0;
  hd.get_booleans(kSafetySwitch, &switched);
  reads_safety_switch = pop_errors(hd).code == 0;
}

}  // namespace nazori::devices::hd
