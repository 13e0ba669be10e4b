// SPDX-License-Identifier: Apache-2.0
#include "allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<bool> counting{false};
std::atomic<int> allocations{0};
}  // namespace

// In a file of its own, so that the compiler does not see new and delete together.
void* operator new(std::size_t size) {
  if (counting.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
  void* p = std::malloc(size == 0 ? 1 : size);  // NOLINT
  if (p == nullptr) throw std::bad_alloc();
  return p;
}
void* operator new(std::size_t size, const std::nothrow_t& /*unused*/) noexcept {
  if (counting.load(std::memory_order_relaxed)) allocations.fetch_add(1, std::memory_order_relaxed);
  return std::malloc(size == 0 ? 1 : size);  // NOLINT
}
void operator delete(void* p) noexcept { std::free(p); }                                    // NOLINT
void operator delete(void* p, std::size_t /*size*/) noexcept { std::free(p); }              // NOLINT
void operator delete(void* p, const std::nothrow_t& /*unused*/) noexcept { std::free(p); }  // NOLINT

namespace nazori::functions::test {

void begin_counting_allocations() {
  allocations = 0;
  counting = true;
}

int end_counting_allocations() {
  counting = false;
  return allocations;
}

}  // namespace nazori::functions::test
