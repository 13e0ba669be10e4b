// SPDX-License-Identifier: Apache-2.0
#include "nazori/view/offscreen.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "gl_object.h"

namespace nazori::view {
namespace {

constexpr int kMaxSide = 16384;
constexpr const char* kRemedy = "install libegl1 and libgl1-mesa-dri (Mesa's software renderer)";

/// Framebuffer of the off-screen context: colour and depth.
struct Target {
  Framebuffer framebuffer;
  Renderbuffer colour;
  Renderbuffer depth;
};

bool has_extension(const char* list, std::string_view name) {
  return list != nullptr && std::string_view(list).find(name) != std::string_view::npos;
}

EGLDisplay surfaceless_display() {
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has_extension(extensions, "EGL_MESA_platform_surfaceless") &&
      has_extension(extensions, "EGL_EXT_platform_base"))
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (has_extension(extensions, "EGL_EXT_platform_device") &&
      has_extension(extensions, "EGL_EXT_device_enumeration")) {
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (eglQueryDevicesEXT(1, &device, &count) == EGL_TRUE && count > 0)
      return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
  }
  return EGL_NO_DISPLAY;
}

base::Result<void> refused(const std::string& what) {
  return base::fail(base::Errc::device, what, "EGL", kRemedy);
}

}  // namespace

struct OffscreenContext::Inside {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::unique_ptr<Target> target;
  int width = 0;
  int height = 0;

  Inside() = default;
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
  ~Inside() {
    if (context == EGL_NO_CONTEXT) return;
    const EGLContext current = eglGetCurrentContext();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    target.reset();
    const bool other = current != context;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, other ? current : EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    if (!other) eglReleaseThread();
  }

  base::Result<void> make_context();
  base::Result<void> make_target();
};

base::Result<void> OffscreenContext::Inside::make_context() {
  // libepoxy ends the program when the library is missing, so check for it before the first EGL call.
  if (dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL) == nullptr)
    return refused("the EGL library (libEGL.so.1) is not installed");
  display = surfaceless_display();
  if (display == EGL_NO_DISPLAY) return refused("EGL here cannot draw without a screen");
  EGLint major = 0;
  EGLint minor = 0;
  if (eglInitialize(display, &major, &minor) != EGL_TRUE)
    return refused(fmt::format("EGL cannot be started (error 0x{:04x})", eglGetError()));
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  if (!has_extension(extensions, "EGL_KHR_surfaceless_context"))
    return refused("EGL here has no contexts without a surface");
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return refused("EGL here offers no desktop OpenGL");

  EGLConfig config = nullptr;
  if (!has_extension(extensions, "EGL_KHR_no_config_context")) {
    const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count < 1)
      return refused("EGL here has no configuration for OpenGL");
  }
  const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                         3,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         3,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_NONE};
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT)
    return refused(fmt::format("no OpenGL 3.3 context can be made (error 0x{:04x})", eglGetError()));
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE)
    return refused(fmt::format("the OpenGL context cannot be used (error 0x{:04x})", eglGetError()));
  return {};
}

base::Result<void> OffscreenContext::Inside::make_target() {
  target = std::make_unique<Target>();
  glBindRenderbuffer(GL_RENDERBUFFER, target->colour.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, target->depth.name());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target->colour.name());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target->depth.name());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    return refused(fmt::format("no framebuffer of {} x {} pixels can be made", width, height));
  glViewport(0, 0, width, height);
  return {};
}

OffscreenContext::OffscreenContext(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
OffscreenContext::~OffscreenContext() = default;

base::Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create(int width, int height) {
  if (width < 1 || height < 1 || width > kMaxSide || height > kMaxSide) {
    return base::fail(base::Errc::bad_argument,
                      fmt::format("a picture of {} x {} pixels cannot be drawn", width, height), "size",
                      fmt::format("give 1 to {} pixels a side", kMaxSide));
  }
  auto inside = std::make_unique<Inside>();
  inside->width = width;
  inside->height = height;
  if (auto made = inside->make_context(); !made) return tl::unexpected(made.error());
  if (auto made = inside->make_target(); !made) return tl::unexpected(made.error());
  return std::unique_ptr<OffscreenContext>(new OffscreenContext(std::move(inside)));
}

Picture OffscreenContext::read() const {
  if (eglGetCurrentContext() != inside_->context)
    eglMakeCurrent(inside_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, inside_->context);
  Picture picture{inside_->width, inside_->height, {}};
  const std::size_t row = static_cast<std::size_t>(picture.width) * 4;
  picture.rgba.resize(row * static_cast<std::size_t>(picture.height));
  GLint bound = 0;
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, inside_->target->framebuffer.name());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(0, 0, picture.width, picture.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(bound));
  for (std::size_t top = 0, bottom = static_cast<std::size_t>(picture.height) - 1; top < bottom;
       ++top, --bottom) {
    std::swap_ranges(picture.rgba.begin() + static_cast<std::ptrdiff_t>(top * row),
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>((top + 1) * row),
                     picture.rgba.begin() + static_cast<std::ptrdiff_t>(bottom * row));
  }
  return picture;
}

}  // namespace nazori::view
