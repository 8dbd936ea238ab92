// An OBJ file in chunks that end with lines, each read by itself. One pass before that counts what
// stands in each, so that a chunk knows its lines and what negative indices count from.
#include <algorithm>
#include <cassert>
#include <cstring>
#include <exception>
#include <thread>

#include "base/parallel.h"
#include "model/diagnostic.h"
#include "model/io/obj_reader.h"

namespace lancer::io {
namespace {

constexpr std::size_t least_chunk = std::size_t(1) << 20;
constexpr int chunks_per_thread = 4;

struct Stretch {
    std::string_view bytes;
    ObjCounts within, before;
    bool is_plain = true;  ///< every LF ends a statement, and nothing else does
    ObjChunk chunk;
    std::exception_ptr problem;
};

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Counts what the reader will find, if it finds no mistake.
void count(Stretch& stretch) {
    const char* at = stretch.bytes.data();
    const char* const end = at + stretch.bytes.size();
    const bool has_cr = std::memchr(at, '\r', stretch.bytes.size()) != nullptr;
    ObjCounts& found = stretch.within;
    while (at != end) {
        const auto* lf =
            static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
        const char* stop = lf == nullptr ? end : lf;
        const char* const next = lf == nullptr ? end : lf + 1;
        if (has_cr && stop != at && stop[-1] == '\r') --stop;
        const bool joins = stop != at && stop[-1] == '\\';
        const bool ends_early =
            has_cr && std::memchr(at, '\r', static_cast<std::size_t>(stop - at)) != nullptr;
        if (joins || ends_early) stretch.is_plain = false;
        while (at != stop && is_blank(*at)) ++at;
        if (stop - at >= 3) {
            if (at[0] == 'f') ++found.faces;
            if (at[0] == 'v' && is_blank(at[1])) ++found.vertices;
            if (at[0] == 'v' && at[1] == 't' && is_blank(at[2])) ++found.uvs;
            if (at[0] == 'v' && at[1] == 'n' && is_blank(at[2])) ++found.normals;
        }
        ++found.lines;
        at = next;
    }
}

std::vector<Stretch> cut(std::string_view bytes, std::size_t size) {
    std::vector<Stretch> stretches;
    while (!bytes.empty()) {
        const std::size_t lf = bytes.find('\n', std::min(size, bytes.size()) - 1);
        const std::size_t end = lf == std::string_view::npos ? bytes.size() : lf + 1;
        stretches.emplace_back().bytes = bytes.substr(0, end);
        bytes.remove_prefix(end);
    }
    return stretches;
}

void for_each(std::vector<Stretch>& stretches, int threads,
              const std::function<void(Stretch&)>& work) {
    for_each_task(static_cast<int>(stretches.size()), threads, {}, [&](const NextTask& next) {
        for (int i = 0; next(i);) work(stretches[static_cast<std::size_t>(i)]);
    });
}

void add_counts(ObjCounts& sum, const ObjCounts& more) {
    sum.lines += more.lines;
    sum.vertices += more.vertices;
    sum.uvs += more.uvs;
    sum.normals += more.normals;
    sum.faces += more.faces;
}

}  // namespace

std::vector<ObjChunk> read_obj(std::string_view bytes, const std::string& name,
                               const MeshReading& reading) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());

    const int threads = reading.threads > 0
                            ? reading.threads
                            : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::size_t size = reading.chunk_bytes;
    if (size == 0)
        size = threads == 1
                   ? bytes.size()
                   : std::max(least_chunk,
                              bytes.size() / static_cast<std::size_t>(chunks_per_thread * threads));
    std::vector<ObjChunk> chunks;
    std::vector<Stretch> stretches;
    if (size < bytes.size()) {
        stretches = cut(bytes, size);
        for_each(stretches, threads, count);
    }
    if (stretches.size() < 2 ||
        !std::all_of(stretches.begin(), stretches.end(), [](auto& s) { return s.is_plain; })) {
        chunks.push_back(read_obj_chunk(bytes, name, {}, {}));
        return chunks;
    }
    for (std::size_t i = 1; i < stretches.size(); ++i) {
        stretches[i].before = stretches[i - 1].before;
        add_counts(stretches[i].before, stretches[i - 1].within);
    }
    for_each(stretches, threads, [&](Stretch& stretch) {
        try {
            stretch.chunk = read_obj_chunk(stretch.bytes, name, stretch.before, stretch.within);
        } catch (const FileError&) {
            stretch.problem = std::current_exception();
        }
    });
    for (Stretch& stretch : stretches) {
        if (stretch.problem) std::rethrow_exception(stretch.problem);
        assert(stretch.chunk.soup.vertices.size() == stretch.within.vertices);
        assert(stretch.chunk.soup.uvs.size() == stretch.within.uvs);
        assert(stretch.chunk.soup.normals.size() == stretch.within.normals);
        chunks.push_back(std::move(stretch.chunk));
    }
    return chunks;
}

}  // namespace lancer::io
