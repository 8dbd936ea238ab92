// The light of rays whose parts are found in any order, summed in the scalar code's.
//
// Whitted::follow() goes along one ray, bent and bent again, and adds to one sum: what each surface
// sends, what each mirrors, and at last the background. Such a sum is a chain of terms here. A
// term that is a mirrored ray's light is a chain itself, begun after the one that it is in; so,
// summed from the last chain back to the first, every term is known when it is added, and each sum
// is formed in the order in which its ray met its terms.
#pragma once

namespace lancer::wide::LANCER_LEVEL {

/// Appends a term to a chain.
///
/// \param child  the chain that `light` is the factor of, or `nothing`
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

/// There is room for one more.
inline std::uint32_t begin_chain(Ledger& ledger) {
    Chain& chain = ledger.chains[ledger.chain_count];
    chain.first = chain.last = nothing;
    return ledger.chain_count++;
}

/// Forms all sums.
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
