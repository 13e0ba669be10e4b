// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "nazori/carving/carve.h"
#include "test_strokes.h"

namespace {
std::atomic<std::size_t> g_in_use{0};
std::atomic<std::size_t> g_most{0};

void count(void* p) {
  const std::size_t now = g_in_use += malloc_usable_size(p);
  std::size_t most = g_most;
  while (now > most && !g_most.compare_exchange_weak(most, now)) {
  }
}
// This test program counts what it has allocated. NOLINTBEGIN(cppcoreguidelines-no-malloc)
void give_back(void* p) {
  if (p != nullptr) g_in_use -= malloc_usable_size(p);
  std::free(p);
}
}  // namespace

// Not inlined, because the compiler would report malloc as a mismatch of the delete it sees.
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* const p = std::malloc(size == 0 ? 1 : size);
  if (p == nullptr) throw std::bad_alloc();
  count(p);
  return p;
}
[[gnu::noinline]] void operator delete(void* p) noexcept { give_back(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t /*size*/) noexcept { give_back(p); }
// NOLINTEND(cppcoreguidelines-no-malloc)

namespace nazori::carving {
namespace {

TEST(CarveMemory, StaysWithinTwiceTheMap) {
  for (const std::string character : {"休", "鬱"}) {
    const auto strokes = test::kanjivg(character);
    for (const int size : {512, 1024, 2048}) {
      const std::size_t before = g_in_use;
      g_most = before;
      const auto map = carve(strokes, size);
      ASSERT_TRUE(map.has_value());
      EXPECT_LE(g_most - before, 2 * map->samples().size_bytes()) << character << ' ' << size;
    }
  }
}

}  // namespace
}  // namespace nazori::carving
