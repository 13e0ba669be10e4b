// SPDX-License-Identifier: Apache-2.0
#include "alloc_guard.h"

#include <cstdlib>
#include <new>

namespace {

thread_local long t_calls = 0;

void* counted(std::size_t size, const std::nothrow_t&) noexcept {
  ++t_calls;
  return std::malloc(size == 0 ? 1 : size);  // NOLINT(cppcoreguidelines-no-malloc): this is operator new
}

void* counted(std::size_t size) {
  void* made = counted(size, std::nothrow);
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

void* counted(std::size_t size, std::align_val_t alignment) {
  ++t_calls;
  const auto a = static_cast<std::size_t>(alignment);
  void* made = std::aligned_alloc(a, (size + a - 1) / a * a);
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

void give_back(void* p) noexcept {
  ++t_calls;
  std::free(p);  // NOLINT(cppcoreguidelines-no-malloc)
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void* operator new(std::size_t size, const std::nothrow_t& n) noexcept { return counted(size, n); }
void* operator new[](std::size_t size, const std::nothrow_t& n) noexcept { return counted(size, n); }
void* operator new(std::size_t size, std::align_val_t a) { return counted(size, a); }
void* operator new[](std::size_t size, std::align_val_t a) { return counted(size, a); }
void operator delete(void* p) noexcept { give_back(p); }
void operator delete[](void* p) noexcept { give_back(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { give_back(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { give_back(p); }
void operator delete(void* p, std::size_t) noexcept { give_back(p); }
void operator delete[](void* p, std::size_t) noexcept { give_back(p); }
void operator delete(void* p, std::align_val_t) noexcept { give_back(p); }
void operator delete[](void* p, std::align_val_t) noexcept { give_back(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { give_back(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { give_back(p); }

namespace nazori::haptics::test {

AllocGuard::AllocGuard() : at_start_(t_calls) {}
long AllocGuard::calls() const { return t_calls - at_start_; }

}  // namespace nazori::haptics::test
