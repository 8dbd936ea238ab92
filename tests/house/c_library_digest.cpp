// Prints a digest of results of the C library's functions, bit by bit. It depends on the versions
// that the library has chosen for this processor.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>

int main() {
    std::uint64_t digest = 0;
    const auto add = [&digest](double value) {
        digest = (digest ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3;
    };
    for (int i = 1; i <= 100'000; ++i) {
        const double x = i * 0.00123;
        add(std::sin(x));
        add(std::exp(x / 10));
        add(std::pow(x, 1.7));
    }
    std::printf("%016llx\n", static_cast<unsigned long long>(digest));
}
