// Large blocks of memory lie in large pages, in the whole program: pictures, trees and meshes are
// read in any order, and a processor finds its way through few pages faster than through many; the
// system hands them out faster, too. A system without large pages on demand loses nothing.
#include <cstdlib>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace {

constexpr std::size_t large_page = std::size_t(1) << 21;

void* allocate_large(std::size_t bytes) {
    if (bytes > std::size_t(-1) - large_page) return nullptr;
    const std::size_t whole = (bytes + large_page - 1) / large_page * large_page;
    void* block = std::aligned_alloc(large_page, whole);
#ifdef __linux__
    if (block != nullptr) madvise(block, whole, MADV_HUGEPAGE);  // only advice: it may fail
#endif
    return block;
}

void* allocate(std::size_t bytes) {
    if (bytes >= large_page) return allocate_large(bytes);
    return std::malloc(bytes == 0 ? 1 : bytes);
}

}  // namespace

// The standard library's other forms, but for those with an alignment, call these.
void* operator new(std::size_t bytes) {
    for (;;) {
        if (void* block = allocate(bytes)) return block;
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr) throw std::bad_alloc();
        handler();
    }
}
void operator delete(void* block) noexcept {
    std::free(block);
}
void operator delete(void* block, std::size_t /*bytes*/) noexcept {
    std::free(block);
}
