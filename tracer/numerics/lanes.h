// A few numbers side by side (SIMD).
#pragma once

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace lancer {

/// If the processor has vectors of 16 bytes for the number type, operations use them; otherwise
/// they go number by number. The results are the same. (Compilers do not vectorise loops with
/// comparisons.)
template <class Real, std::size_t count>
class Lanes {
    static constexpr bool has_vectors =
        (std::same_as<Real, float> || std::same_as<Real, double>)&&count * sizeof(Real) % 16 == 0;
    template <class T, bool vectors>
    struct PartOf {
        using type = T;
    };
    template <class T>
    struct PartOf<T, true> {
        typedef T type __attribute__((vector_size(16)));
    };
    using Part = typename PartOf<Real, has_vectors>::type;
    static constexpr std::size_t parts = count * sizeof(Real) / sizeof(Part);

  public:
    explicit Lanes(Real all) {
        if constexpr (has_vectors)
            for (Part& p : part_) p = all - Part{};
        else
            for (Part& p : part_) p = all;
    }
    explicit Lanes(const std::array<Real, count>& numbers) {
        if constexpr (has_vectors)
            std::memcpy(part_, numbers.data(), sizeof part_);
        else
            for (std::size_t i = 0; i < parts; ++i) part_[i] = numbers[i];
    }
    std::array<Real, count> numbers() const {
        std::array<Real, count> out;
        if constexpr (has_vectors)
            std::memcpy(out.data(), part_, sizeof part_);
        else
            for (std::size_t i = 0; i < parts; ++i) out[i] = part_[i];
        return out;
    }

    friend Lanes operator-(Lanes a, const Lanes& b) {
        for (std::size_t i = 0; i < parts; ++i) a.part_[i] = a.part_[i] - b.part_[i];
        return a;
    }
    friend Lanes operator+(Lanes a, const Lanes& b) {
        for (std::size_t i = 0; i < parts; ++i) a.part_[i] = a.part_[i] + b.part_[i];
        return a;
    }
    friend Lanes operator*(Lanes a, const Lanes& b) {
        for (std::size_t i = 0; i < parts; ++i) a.part_[i] = a.part_[i] * b.part_[i];
        return a;
    }
    /// a where a > b, else b; so b if one of them is NaN.
    friend Lanes larger(Lanes a, const Lanes& b) {
        for (std::size_t i = 0; i < parts; ++i)
            a.part_[i] = a.part_[i] > b.part_[i] ? a.part_[i] : b.part_[i];
        return a;
    }
    /// a where a < b, else b; so b if one of them is NaN.
    friend Lanes smaller(Lanes a, const Lanes& b) {
        for (std::size_t i = 0; i < parts; ++i)
            a.part_[i] = a.part_[i] < b.part_[i] ? a.part_[i] : b.part_[i];
        return a;
    }

    /// Bit i: whether number i of `a` is less than that of `b`.
    friend unsigned less(const Lanes& a, const Lanes& b) {
        return bits_of(a, b, [](auto x, auto y) { return x < y; });
    }
    /// Bit i: whether number i of `a` is at most that of `b`.
    friend unsigned at_most(const Lanes& a, const Lanes& b) {
        return bits_of(a, b, [](auto x, auto y) { return x <= y; });
    }

  private:
    template <class Compare>
    static unsigned bits_of(const Lanes& a, const Lanes& b, Compare compare) {
        unsigned bits = 0;
#ifdef __SSE2__
        if constexpr (has_vectors) {
            for (std::size_t i = 0; i < parts; ++i) {
                const auto mask = compare(a.part_[i], b.part_[i]);
                if constexpr (std::same_as<Real, double>)
                    bits |= unsigned(_mm_movemask_pd(__m128d(mask))) << (2 * i);
                else
                    bits |= unsigned(_mm_movemask_ps(__m128(mask))) << (4 * i);
            }
            return bits;
        }
#endif
        const std::array<Real, count> x = a.numbers();
        const std::array<Real, count> y = b.numbers();
        for (std::size_t i = 0; i < count; ++i) bits |= (compare(x[i], y[i]) ? 1U : 0U) << i;
        return bits;
    }

    Part part_[parts];
};

template <class Real>
using Two = Lanes<Real, 2>;
template <class Real>
using Four = Lanes<Real, 4>;

/// a - b, computed in double and rounded once.
inline Four<float> narrowed_difference(const Four<float>& a, double b) {
    typedef float Narrow __attribute__((vector_size(16)));
    typedef double Wide __attribute__((vector_size(32)));
    const std::array<float, 4> numbers = a.numbers();
    Narrow narrow;
    std::memcpy(&narrow, numbers.data(), sizeof narrow);
    const Wide difference = __builtin_convertvector(narrow, Wide) - b;
    narrow = __builtin_convertvector(difference, Narrow);
    std::array<float, 4> rounded;
    std::memcpy(rounded.data(), &narrow, sizeof narrow);
    return Four<float>(rounded);
}

}  // namespace lancer
