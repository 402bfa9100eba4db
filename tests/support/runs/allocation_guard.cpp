// SPDX-License-Identifier: Apache-2.0
#include "support/runs/allocation_guard.hpp"

#include <cstddef>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define FAIRWAY_MALLOC_IS_TAKEN
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || \
    __has_feature(memory_sanitizer)
#define FAIRWAY_MALLOC_IS_TAKEN
#endif
#endif

namespace {

thread_local std::size_t heap_calls = 0;

}  // namespace

#ifndef FAIRWAY_MALLOC_IS_TAKEN
// glibc's own functions, which the functions below replace in this program.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-inconsistent-declaration-parameter-name)
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  ++heap_calls;
  return __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size) {
  ++heap_calls;
  return __libc_calloc(number, size);
}

void* realloc(void* block, std::size_t size) {
  ++heap_calls;
  return __libc_realloc(block, size);
}

void* memalign(std::size_t alignment, std::size_t size) {
  ++heap_calls;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++heap_calls;
  return __libc_memalign(alignment, size);
}
}
// NOLINTEND(bugprone-reserved-identifier,readability-inconsistent-declaration-parameter-name)
#endif

namespace fairway::test {

#ifdef FAIRWAY_MALLOC_IS_TAKEN
const bool AllocationGuard::available = false;
#else
const bool AllocationGuard::available = true;
#endif

AllocationGuard::AllocationGuard() noexcept : before_(heap_calls) {}

std::size_t AllocationGuard::count() const noexcept { return heap_calls - before_; }

}  // namespace fairway::test
