// The bare search for the nearest triangle: rays a second of the tracer, of Embree, of a grid and
// of no structure at all, on the same rays. Prints tables in Markdown; search.py puts them into
// docs/performance.md.
//     build/release/bin/bench_search [ROUNDS]        default: 5
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>

#include "tests/bench/search/search_rays.h"

namespace {

using namespace lancer;
using namespace lancer::search;

double seconds_of(const Search& search, std::span<const SearchRay> rays, std::span<double> found) {
    const auto begin = std::chrono::steady_clock::now();
    search(rays, found, {});
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// Rays a second, in millions, median of the rounds.
struct Measured {
    double speed = 0;
    double apart = 0;  ///< percent of the rays whose distance is off by more than 1e-4
};

/// The searches take turns. A search that tests every triangle is limited to 2 * 10^8 tests.
std::vector<Measured> measure(const std::vector<NamedSearch>& searches,
                              const std::vector<SearchRay>& rays, int rounds,
                              std::size_t triangles) {
    std::vector<SearchRay> few;
    const std::size_t stride = std::max<std::size_t>(1, rays.size() * triangles / 200'000'000);
    for (std::size_t i = 0; i < rays.size(); i += stride) few.push_back(rays[i]);
    std::vector<double> right(rays.size());
    std::vector<double> right_of_few(few.size());
    searches[0].search(rays, right, {});
    searches[0].search(few, right_of_few, {});
    std::vector<std::vector<double>> speeds(searches.size());
    std::vector<Measured> measured(searches.size());
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t s = 0; s < searches.size(); ++s) {
            const bool brute = searches[s].is_brute;
            if (brute && round > 0) continue;
            const std::vector<SearchRay>& asked = brute ? few : rays;
            const std::vector<double>& truth = brute ? right_of_few : right;
            std::vector<double> found(asked.size());
            const double seconds = seconds_of(searches[s].search, asked, found);
            speeds[s].push_back(static_cast<double>(asked.size()) / seconds / 1e6);
            std::size_t apart = 0;
            for (std::size_t i = 0; i < found.size(); ++i)
                if (found[i] != truth[i] && !(std::abs(found[i] - truth[i]) <= 1e-4)) ++apart;
            measured[s].apart =
                100 * static_cast<double>(apart) / static_cast<double>(found.size());
        }
    }
    for (std::size_t s = 0; s < searches.size(); ++s) measured[s].speed = median(speeds[s]);
    return measured;
}

void table(int around, int across, int rounds) {
    const Mesh mesh = torus_knot(around, across);
    std::vector<NamedSearch> searches = lancer_searches(mesh);
    for (auto more : {embree_searches(mesh), plain_searches(mesh)})
        for (NamedSearch& search : more) searches.push_back(std::move(search));
    const std::vector<SearchRay> coherent = camera_rays(1024);
    std::vector<double> hits(coherent.size());
    std::vector<std::uint32_t> faces(coherent.size());
    searches[0].search(coherent, hits, faces);
    const std::vector<SearchRay> scattered = scattered_rays(mesh, coherent, hits, faces);
    const auto from_camera = measure(searches, coherent, rounds, mesh.faces.size());
    const auto from_surface = measure(searches, scattered, rounds, mesh.faces.size());
    // The reference for both: Embree's single rays, if Embree is installed.
    const auto embree = std::find_if(searches.begin(), searches.end(), [](const NamedSearch& s) {
        return std::strcmp(s.name, "Embree, float, one ray") == 0;
    });
    const auto base = static_cast<std::size_t>(embree - searches.begin());
    fmt::print("Torus knot of {} triangles; {} rays from the camera, {} scattered.\n\n",
               mesh.faces.size(), coherent.size(), scattered.size());
    fmt::print(
        "| search | camera, million rays a second | against Embree's single rays | apart | "
        "scattered | against | apart |\n"
        "|---|---:|---:|---:|---:|---:|---:|\n");
    for (std::size_t s = 0; s < searches.size(); ++s) {
        fmt::print("| {} |", searches[s].name);
        for (const auto& measured : {from_camera, from_surface}) {
            const std::string against =
                embree == searches.end()
                    ? ""
                    : fmt::format("{:.3g}", measured[s].speed / measured[base].speed);
            fmt::print(" {:.3g} | {} | {:.3f} % |", measured[s].speed, against, measured[s].apart);
        }
        fmt::print("\n");
    }
    fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
    int rounds = 5;
    if (argc > 1) {
        const auto read = std::from_chars(argv[1], argv[1] + std::strlen(argv[1]), rounds);
        if (read.ec != std::errc{} || *read.ptr != 0 || rounds < 1) {
            fmt::print(stderr, "usage: bench_search [ROUNDS]\n");
            return 2;
        }
    }
    table(625, 40, rounds);
    table(6250, 80, rounds);
}
