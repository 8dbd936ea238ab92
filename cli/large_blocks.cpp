// Large blocks of memory lie in large pages, in the whole program: pictures, trees and meshes are
// read in any order, and a processor finds its way through few pages faster than through many; the
// system hands them out faster, too. Without large pages on demand, a block costs at most 4 MB in
// place of 2.
#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

constexpr std::size_t large_page = std::size_t(1) << 21;

#ifdef __GLIBC__
/// Gives a large block back to the system as soon as it is freed. By default the allocator raises
/// this threshold with each freed block: a scene with a million triangles then took 30 MB more.
/// Setting it also fixes the threshold for trimming the heap, which would be smaller than many
/// blocks, so that one is set as well.
[[maybe_unused]] const bool limits_are_fixed =
    mallopt(M_MMAP_THRESHOLD, large_page) != 0 && mallopt(M_TRIM_THRESHOLD, 2 * large_page) != 0;
#endif

void* allocate_large(std::size_t bytes) {
    if (bytes > std::size_t(-1) - large_page) return nullptr;
    const std::size_t whole = (bytes + large_page - 1) / large_page * large_page;
    void* block = std::aligned_alloc(large_page, whole);
#ifdef __linux__
    if (block != nullptr) madvise(block, whole, MADV_HUGEPAGE);  // only advice: it may fail
#endif
    return block;
}

void* allocate(std::size_t bytes, std::size_t alignment) {
    if (bytes >= large_page && alignment <= large_page) return allocate_large(bytes);
    if (alignment <= alignof(std::max_align_t)) return std::malloc(bytes == 0 ? 1 : bytes);
    if (bytes > std::size_t(-1) - alignment) return nullptr;
    return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

void* allocate_or_throw(std::size_t bytes, std::size_t alignment) {
    for (;;) {
        if (void* block = allocate(bytes, alignment)) return block;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}

}  // namespace

void* operator new(std::size_t bytes) {
    return allocate_or_throw(bytes, 1);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate_or_throw(bytes, static_cast<std::size_t>(alignment));
}
// The other forms call these.
void operator delete(void* block) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t /*bytes*/) noexcept {
    std::free(block);
}
void operator delete(void* block, std::align_val_t /*alignment*/) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
    std::free(block);
}
