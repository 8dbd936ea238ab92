// Sums the light of rays in the same order as scalar code, although its terms are found in any
// order.
//
// Whitted::follow() goes along one ray, which may be refracted many times. It adds to one sum: the
// local light of each surface, the light that each surface mirrors, and finally the background.
// Here such a sum is a chain of terms. The light of a mirrored ray is a term that is a chain
// itself; this chain begins after the one that contains it. So when the chains are summed from the
// last to the first, every term is known when it is added. Each sum has the order in which its ray
// met the terms.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Appends a term to a chain.
///
/// \param child  the chain whose light is multiplied by `light`, or `nothing`
inline void add_term(Ledger& ledger, std::uint32_t chain, const double* light,
                     std::uint32_t child) {
    if (ledger.term_count == ledger.term_room) ledger.grow(ledger);
    const std::uint32_t at = ledger.term_count++;
    ledger.terms[at] = {{light[0], light[1], light[2]}, child, nothing};
    Chain& c = ledger.chains[chain];
    if (c.last == nothing)
        c.first = at;
    else
        ledger.terms[c.last].next = at;
    c.last = at;
}

/// The same for the lanes of the mask.
///
/// \param children  null: the terms are light
inline void add_terms(Ledger& ledger, const std::uint32_t* chains, Mask mask, const Vectors& light,
                      const std::uint32_t* children) {
    if (ledger.term_count + lanes > ledger.term_room) ledger.grow(ledger);
    // In local variables: the compiler cannot know that terms and chains are not the ledger itself.
    Term* const terms = ledger.terms;
    Chain* const all_chains = ledger.chains;
    std::uint32_t at = ledger.term_count;
    for_each_lane(mask, [&](int i) {
        terms[at] = {{lane(light.x, i), lane(light.y, i), lane(light.z, i)},
                     children == nullptr ? std::uint32_t(nothing) : children[i],
                     nothing};
        Chain& chain = all_chains[chains[i]];
        if (chain.last == nothing)
            chain.first = at;
        else
            terms[chain.last].next = at;
        chain.last = at++;
    });
    ledger.term_count = at;
}

/// Begins a chain. The caller makes sure that there is room.
inline std::uint32_t begin_chain(Ledger& ledger) {
    Chain& chain = ledger.chains[ledger.chain_count];
    chain.first = chain.last = nothing;
    return ledger.chain_count++;
}

/// Computes all sums.
inline void sum_chains(Ledger& ledger) {
    for (std::uint32_t k = ledger.chain_count; k-- > 0;) {
        Chain& chain = ledger.chains[k];
        double sum[3] = {0, 0, 0};
        for (std::uint32_t at = chain.first; at != nothing; at = ledger.terms[at].next) {
            const Term& term = ledger.terms[at];
            if (term.child == nothing) {
                for (int c = 0; c < 3; ++c) sum[c] += term.light[c];
                continue;
            }
            const Chain& child = ledger.chains[term.child];
            for (int c = 0; c < 3; ++c) sum[c] += term.light[c] * child.light[c];
        }
        for (int c = 0; c < 3; ++c) chain.light[c] = sum[c];
    }
}

}  // namespace lancer::wide::LANCER_LEVEL
