// A few numbers side by side.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace lancer {

/// Computed with together where the processor has vectors of 16 bytes for the number type
/// (compilers do not find them in loops with comparisons), one by one elsewhere; the same numbers
/// either way.
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
    /// a where a > b, else b: b also where one of them is not a number.
    friend Lanes larger(Lanes a, const Lanes& b) {
        for (std::size_t i = 0; i < parts; ++i)
            a.part_[i] = a.part_[i] > b.part_[i] ? a.part_[i] : b.part_[i];
        return a;
    }
    /// a where a < b, else b: b also where one of them is not a number.
    friend Lanes smaller(Lanes a, const Lanes& b) {
        for (std::size_t i = 0; i < parts; ++i)
            a.part_[i] = a.part_[i] < b.part_[i] ? a.part_[i] : b.part_[i];
        return a;
    }

  private:
    Part part_[parts];
};

template <class Real>
using Two = Lanes<Real, 2>;
template <class Real>
using Four = Lanes<Real, 4>;

}  // namespace lancer
