// Functions for eight numbers at once, compared with those for one: the same bits.
#include <bit>

#include "model/elementary.h"
#include "tests/oracle/tally.h"
#include "tests/oracle/wide_kernels.h"
#include "tests/oracle/wide_levels.h"
#include "tests/oracle/wide_rays.h"

namespace lancer::oracle {
namespace {

TEST(OracleWide, Power) {
    on_each_level([](const WideKernels& kernels) {
        Tally("pow, side by side").run([&](Draw& draw) {
            double x[lanes], y[lanes], out[lanes];
            for (int i = 0; i < lanes; ++i) {
                x[i] = draw.number() % 8 == 0 ? draw.decade(-300, 9) : 2 * draw.unit();
                y[i] = draw.decade(-3, 4);
            }
            kernels.power(x, y, out);
            for (int i = 0; i < lanes; ++i)
                EXPECT_EQ(std::bit_cast<std::uint64_t>(out[i]),
                          std::bit_cast<std::uint64_t>(elementary::pow(x[i], y[i])))
                    << x[i] << " " << y[i];
        });
    });
}

TEST(OracleWide, Exponential) {
    on_each_level([](const WideKernels& kernels) {
        Tally("exp, side by side").run([&](Draw& draw) {
            double x[lanes], out[lanes];
            for (double& each : x)
                each = draw.number() % 2 == 0 ? -draw.decade(-300, 308) : -20 * draw.unit();
            if (draw.number() % 16 == 0) x[draw.number() % lanes] = 0;
            kernels.exponential(x, out);
            for (int i = 0; i < lanes; ++i)
                EXPECT_EQ(std::bit_cast<std::uint64_t>(out[i]),
                          std::bit_cast<std::uint64_t>(elementary::exp(x[i])))
                    << x[i];
        });
    });
}

TEST(OracleWide, ArcCosine) {
    on_each_level([](const WideKernels& kernels) {
        Tally("acos, side by side").run([&](Draw& draw) {
            double x[lanes], out[lanes];
            for (double& each : x)
                each = draw.number() % 8 == 0 ? 1 - draw.decade(-16, 0) : 2 * draw.unit() - 1;
            kernels.arc_cosine(x, out);
            for (int i = 0; i < lanes; ++i)
                EXPECT_EQ(std::bit_cast<std::uint64_t>(out[i]),
                          std::bit_cast<std::uint64_t>(elementary::acos(x[i])))
                    << x[i];
        });
    });
}

}  // namespace
}  // namespace lancer::oracle
