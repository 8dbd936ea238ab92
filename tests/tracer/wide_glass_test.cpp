// Rays side by side through glass of all shapes give the same bytes and the same counts of rays as
// one at a time.
#include <gtest/gtest.h>

#include <random>

#include "tests/extremes/stage.h"
#include "tests/tracer/supported_levels.h"

namespace lancer {
namespace {

using namespace extremes;

struct Dice {
    std::mt19937 engine;

    double operator()(double a, double b) {
        return a + (b - a) * (static_cast<double>(engine()) / 4294967296.0);
    }
    bool once_in(unsigned n) { return engine() % n == 0; }
    template <class T>
    const T& of(const std::vector<T>& all) {
        return all[engine() % all.size()];
    }
};

/// Clear and coloured glass, water and air; with and without a mirror, Fresnel, absorption.
std::vector<std::uint32_t> glasses(Stage& s, Dice& dice) {
    std::vector<std::uint32_t> all;
    for (int i = 0; i < 6; ++i) {
        Material m = s.scene.materials[s.glass(
            dice.once_in(6) ? 1 : dice(1.1, 1.9),
            dice.once_in(2) ? Color(1) : Color(dice(0.3, 1), dice(0.3, 1), dice(0.3, 1)))];
        if (dice.once_in(2)) {
            m.filter = dice(0.1, 0.5);
            m.transmission = dice(0, 0.5);
            m.diffuse = dice(0, 0.5);
        }
        m.fresnel = dice.once_in(2);
        if (dice.once_in(2)) m.reflection = Color(dice(0, 0.6), 0.2, 0.3);
        if (dice.once_in(2)) m.phong = 0.5;
        if (dice.once_in(2))
            m.absorption = Color(dice(0, 2), dice(0, 0.5), dice.once_in(2) ? 0 : 5);
        all.push_back(s.material(m));
    }
    return all;
}

/// Matt things, mirrors, and opaque bodies with an index of their own.
std::vector<std::uint32_t> opaques(Stage& s, Dice& dice) {
    Material lacquer;
    lacquer.fresnel = true;
    lacquer.reflection = Color(0.9, 0.8, 1);
    lacquer.ior = 1.4;
    lacquer.phong = 0.3;
    Material dense;
    dense.ior = dice(1.1, 2);
    dense.color = Color(0.2, 0.4, 0.9);
    return {s.matt({0.2, 0.9, 0.3}), s.mirror(), s.material(lacquer), s.material(dense)};
}

class Cupboard {
  public:
    explicit Cupboard(unsigned seed) : dice_{std::mt19937(seed)} {
        Scene& scene = s_.scene;
        scene.width = 40;
        scene.height = 30;
        scene.background = Color(0.2, 0.3, 0.5);
        if (dice_.once_in(3))
            scene.sky = Gradient{{0.2, 1, 0.1}, {{0, {1, 0.8, 0.6}}, {1, {0.2, 0.3, 0.9}}}};
        scene.settings.max_depth = 1 + static_cast<int>(dice_.engine() % 9);
        if (dice_.once_in(3)) scene.settings.min_contribution = dice_.once_in(2) ? 0 : 0.05;
        s_.look({dice_(-2, 2), dice_(0.5, 3), dice_(6, 8)}, {0, 0.7, 0}, 45);
        s_.lamp({dice_(2, 5), dice_(3, 6), dice_(0, 5)});
        if (dice_.once_in(2)) s_.lamp({dice_(-1, 1), dice_(0.2, 1.5), 0.5}, {0.3, 0.4, 0.2});
        if (dice_.once_in(2)) s_.sun({dice_(-1, 1), -1, 0}, {0.3, 0.2, 0.1});
        glass_ = glasses(s_, dice_);
        opaque_ = opaques(s_, dice_);
    }

    Scene fill(int count) {
        if (dice_.once_in(4))
            s_.add(Plane{{0, 1, 0}, 0.1}, dice_.of(glass_));  // water over the ground
        s_.add(Plane{{0, 1, 0}, dice_.once_in(4) ? -0.3 : 0}, s_.matt({0.6, 0.5, 0.4}));
        for (int i = 0; i < count; ++i) {
            put(Vec3d(dice_(-2, 2), dice_.once_in(2) ? 0 : dice_(0, 1.5), dice_(-2, 2)),
                dice_(0.1, 0.6));
            if (dice_.once_in(8)) s_.scene.objects.back().casts_shadow = false;
        }
        return s_.scene;
    }

  private:
    std::uint32_t some() { return dice_.once_in(4) ? dice_.of(opaque_) : dice_.of(glass_); }
    Affine<double> turned(const Vec3d& at) {
        return dice_.once_in(3)
                   ? shift(at)
                   : compose(shift(at),
                             compose(turn(static_cast<int>(dice_.engine() % 3), dice_(0, 360)),
                                     stretched(1, dice_(0.5, 1), 1)));
    }

    void put(const Vec3d& at, double size) {
        switch (dice_.engine() % 11) {
            case 0: {  // a tumbler with a drink that overlaps the wall, and ice in it
                const Vec3d up(0, 2 * size, 0);
                s_.add(Cylinder{at, at + up, size}, dice_.of(glass_));
                s_.add(Cylinder{at + 0.1 * up, at + 0.7 * up, 0.95 * size}, dice_.of(glass_));
                s_.add(Box{at + 0.5 * up, at + 0.8 * up + Vec3d(size / 3, 0, size / 2)}, some());
                break;
            }
            case 1: {  // one in another, side on side and cap on cap, as long as there is glass
                const Vec3d up(0, size, 0);
                for (int k = 0; k < 6; ++k)
                    s_.add(
                        Cylinder{at, at + (dice_.once_in(2) ? 1 : 0.9) * up, size * (1 - 0.15 * k)},
                        dice_.of(glass_));
                break;
            }
            case 2:  // glued
                s_.add(Cylinder{at, at + Vec3d(0, size, 0), size / 2}, glass_[0]);
                s_.add(Cylinder{at + Vec3d(0, size, 0), at + Vec3d(0, 2 * size, 0), size / 2},
                       dice_.once_in(2) ? glass_[0] : glass_[1]);
                break;
            case 3:
                s_.add(Cone{at, at + Vec3d(dice_(-1, 1), size, dice_(-1, 1)), size / 2,
                            dice_.once_in(2) ? 0 : size / 3},
                       some());
                break;
            case 4:
                s_.add(Cylinder{at, at + Vec3d(dice_(-1, 1), size, dice_(-1, 1)), size / 3,
                                !dice_.once_in(4)},
                       some());
                break;
            case 5: {  // a mesh that cuts a cylinder
                MeshRef* mesh = std::get_if<MeshRef>(
                    &s_.add(icosphere({0, 0, 0}, size, 2), some(), turned(at)).shape);
                mesh->smooth = dice_.once_in(2);
                s_.add(Cylinder{at, at + Vec3d(0, 2 * size, 0), size / 3}, some());
                break;
            }
            case 6:
                s_.add(cube({0, 0, 0}, {size, size, size / 2}), some(), turned(at));
                break;
            case 7:
                s_.add(Torus{size, size / 4}, some(), turned(at));
                break;
            case 8:  // on the ground, side by side, touching
                s_.add(Sphere{{at.x, size, at.z}, size}, some());
                s_.add(Sphere{{at.x + 2 * size, size, at.z}, size}, some());
                break;
            case 9:  // a pane, and a sheet of it
                s_.add(Box{at, at + Vec3d(size, size, 0.02)}, some());
                s_.add(Triangle{{at, at + Vec3d(size, size, 0), at + Vec3d(0, size, size)}},
                       some());
                break;
            default:
                s_.add(Sphere{at, size}, dice_.of(glass_));
                s_.add(Sphere{at + Vec3d(0, size / 2, 0), size / 2}, some());
        }
    }

    Stage s_;
    Dice dice_;
    std::vector<std::uint32_t> glass_, opaque_;
};

TEST(WideGlass, CupboardsOfGlassAreTheSame) {
    int wide = 0;
    for (unsigned seed = 1; seed <= 120; ++seed)
        wide += expect_same_on_all_levels(Cupboard(seed).fill(1 + static_cast<int>(seed % 12)),
                                          "seed " + std::to_string(seed));
    EXPECT_GE(wide, supported_wide_levels().empty() ? 0 : 100) << "too few went side by side";
}

}  // namespace
}  // namespace lancer
