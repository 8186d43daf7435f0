#include "measure/allocations.hpp"

#ifdef __SANITIZE_ADDRESS__
#include <cstddef>

// As sanitizer/allocator_interface.h has it, which not every compiler brings along.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void*, std::size_t),
                                                         void (*)(const volatile void*));
#else
#include <cstdlib>
#include <new>
#endif

namespace {

thread_local std::int64_t count = 0;

#ifdef __SANITIZE_ADDRESS__
// Its operators replace all of the standard library's, some of which would not call those below: it tells by itself.
void add(const volatile void*, std::size_t) { ++count; }
void ignore(const volatile void*) {}
[[maybe_unused]] const int hooks = __sanitizer_install_malloc_and_free_hooks(add, ignore);

}  // namespace
#else
void* allocate(std::size_t size) {
  ++count;
  void* const memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* allocate(std::size_t size, std::align_val_t alignment) {
  ++count;
  const auto step = static_cast<std::size_t>(alignment);
  // A multiple of the step, as aligned_alloc asks for.
  void* const memory = std::aligned_alloc(step, (size / step + 1) * step);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// All others of the standard library's call these.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) { return allocate(size, alignment); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
#endif

namespace terrella {

std::int64_t allocations() { return count; }

}  // namespace terrella
