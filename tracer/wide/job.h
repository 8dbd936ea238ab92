// The data of a tile of rays, apart from the world: waves of rays, sums of light, counts.
#pragma once

#include "tracer/wide/exact_methods.h"
#include "tracer/wide/scene.h"

namespace lancer::wide {

/// Rays that are traced together, and what they brought. Depth by depth each wave holds what the
/// rays of the wave before it sent on.
struct Wave {
    static constexpr int most = 256;
    static constexpr int room = most + 8;  ///< whole vectors may be stored from any index on

    double origin[3][room], origin_lo[3][room], dir[3][room];
    double error[room], weight[room];
    double color[3][room];
    double mirror[3][room];  ///< factor of `color` in the sender's colour
    std::uint32_t sender[room];
    std::uint32_t item[room], face[room], left[room];
    bool entering[room];
    double normal[3][room];  ///< where the scene has patches: of what the ray starts on
    // In worlds with glassy items, in place of `mirror` and `sender`:
    double through[3][room];    ///< product of the transmittances before the ray's start
    std::uint32_t chain[room];  ///< the chain of the ray's light
    std::uint32_t bodies[most_bodies][room];
    std::uint32_t optical[most_bodies][room];  ///< in worlds with smooth media: Media::optical
    int deepest;                               ///< the largest number of bodies in a list
    int count;
};

/// A term of the light of a chain.
struct Term {
    double light[3];      ///< light, or the factor of the light of `child`
    std::uint32_t child;  ///< a chain, or `nothing`
    std::uint32_t next;   ///< index into Ledger::terms
};

/// The light of a ray as a sum of terms. After a refraction or a total reflection, the ray's chain
/// continues.
struct Chain {
    std::uint32_t first, last;  ///< terms
    double light[3];            ///< sum of the terms, set by sum_chains()
};

/// The light of a tile's rays, as sums that sum_chains() computes.
struct Ledger {
    Chain* chains;  ///< a child comes after the chain that it is a term of
    std::uint32_t chain_count, chain_room;
    Term* terms;
    std::uint32_t term_count, term_room;
    void (*grow)(Ledger& ledger);  ///< makes room for more terms
};

struct Counts {
    std::uint64_t primary, shadow, reflected, transmitted;
};

/// Everything that a tile of rays needs.
struct Job {
    const Scene* scene;
    ExactMethods* exact;
    Wave* (*wave)(void* waves, int index);  ///< returns the same wave at each call
    void* waves;
    Ledger* ledger;                  ///< of worlds with glassy items
    std::uint32_t* last_in_the_way;  ///< per light an item, or `nothing`: ShadowQuery
    Counts counts;
};

/// Traces camera rays through `count` points of the picture, in pixels, count <= Wave::most. Their
/// colours are then in `color` of the first wave.
using TraceRays = void (*)(Job& job, const Camera& camera, const double* x, const double* y,
                           int count);

}  // namespace lancer::wide
