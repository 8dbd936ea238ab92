// What a tile of rays needs beside the world: waves of rays, sums of light, counts.
#pragma once

#include "tracer/wide/exact_methods.h"
#include "tracer/wide/scene.h"

namespace lancer::wide {

/// Rays that are traced together, and what they brought. Depth by depth each wave holds what the
/// rays of the wave before it sent on.
struct Wave {
    static constexpr int most = 256;
    static constexpr int room = most + 8;  ///< full vectors may be stored at any place

    double origin[3][room], origin_lo[3][room], dir[3][room];
    double error[room], weight[room];
    double color[3][room];
    double mirror[3][room];  ///< the factor of `color` in the sender's light
    std::uint32_t sender[room];
    std::uint32_t item[room], face[room], left[room];
    bool entering[room];
    // In worlds with glassy items, in place of `mirror` and `sender`:
    double through[3][room];    ///< what the surfaces before let pass
    std::uint32_t chain[room];  ///< that the ray's light belongs to
    std::uint32_t bodies[most_bodies][room];
    int deepest;  ///< no ray is in more bodies
    int count;
};

/// A part of the light of a chain.
struct Term {
    double light[3];      ///< or the factor of what `child` brings
    std::uint32_t child;  ///< a chain; `nothing`: `light` is all
    std::uint32_t next;   ///< index into Ledger::terms
};

/// The light of a ray and of what it goes on as, bent or mirrored as a whole, as a sum of terms.
struct Chain {
    std::uint32_t first, last;  ///< terms
    double light[3];            ///< their sum, when all is traced
};

/// The light of a tile's rays as sums that are yet to be formed.
struct Ledger {
    Chain* chains;  ///< each after the one that it is a term of
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
    Wave* (*wave)(void* waves, int index);  ///< the same at each call
    void* waves;
    Ledger* ledger;                  ///< of worlds with glassy items
    std::uint32_t* last_in_the_way;  ///< an item for each light, or `nothing`: ShadowQuery
    Counts counts;
};

/// Traces camera rays through `count` points of the picture, in pixels, at most Wave::most; their
/// light is then in the `color` of the first wave.
using TraceRays = void (*)(Job& job, const Camera& camera, const double* x, const double* y,
                           int count);

}  // namespace lancer::wide
