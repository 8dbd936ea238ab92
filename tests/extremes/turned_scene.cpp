#include "tests/extremes/turned_scene.h"

#include <memory>
#include <random>

#include "tests/extremes/stage.h"

namespace lancer::extremes {
namespace {

/// About an axis, without rounding.
Affine<double> quarter_turn(int axis) {
    Affine<double> map;
    const auto a = static_cast<std::size_t>((axis + 1) % 3);
    const auto b = static_cast<std::size_t>((axis + 2) % 3);
    map.rows[a] = map.rows[b] = Vec3d(0);
    map.rows[a][static_cast<int>(b)] = -1;
    map.rows[b][static_cast<int>(a)] = 1;
    return map;
}

class Grid {
  public:
    Grid(unsigned seed, Turns turns) : random_(seed), turns_(turns) {}

    Scene scene() {
        s_.scene.width = 64;
        s_.scene.height = 48;
        s_.scene.background = {0.25, 0.5, 0.75};
        const double side = pick(3) - 1;
        s_.look({side + 0.0625 * pick(16), 2.5, 5}, {0, 0.5, 0}, 40);
        s_.lamp({-4, 6, 3}, {0.7, 0.7, 0.7});
        s_.lamp({5, 5, 4}, {0.4, 0.3, 0.5});
        s_.add(Plane{{0, 1, 0}, 0}, matt());
        for (int x = -1; x <= 1; ++x) {
            for (int z = -1; z <= 1; ++z)
                if (pick(4) > 0) fill({static_cast<double>(x), 0.5, static_cast<double>(z)});
        }
        return s_.scene;
    }

  private:
    static constexpr int cylinder = 1, cone = 2, composite = 9;

    int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    double part() { return 0.0625 * (4 + pick(12)); }

    std::uint32_t matt() {
        const double red = part();
        return s_.matt({red, part(), 0.5});
    }
    std::uint32_t material() {
        switch (pick(6)) {
            case 0:
                return s_.mirror();
            case 1:
            case 2:
                return matt();
            default:
                return s_.glass(1.25 + 0.0625 * pick(8));
        }
    }

    Affine<double> turned(bool about_itself) {
        Affine<double> map;
        if (turns_ == Turns::any_ends || (turns_ == Turns::any && about_itself)) {
            map = turn(1, 360.0 * pick(1000) / 1000);
            if (pick(3) == 0) map = compose(turn(pick(3), 360.0 * pick(1000) / 1000), map);
            return map;
        }
        for (int turns = pick(4); turns > 0; --turns) map = compose(quarter_turn(pick(3)), map);
        return map;
    }

    void fill(const Vec3d& at) {
        const int kind = pick(10);
        const bool has_ends = kind == cylinder || kind == cone || kind >= composite;
        const Affine<double> map = compose(shift(at), turned(!has_ends));
        const Box box{Vec3d(-0.5), Vec3d(0.5)};
        const std::uint32_t m = material();
        switch (kind) {
            case 0:
                s_.add(box, m, map);
                break;
            case cylinder:
                s_.add(Cylinder{{0, -0.5, 0}, {0, 0.5, 0}, 0.5}, m, map);
                break;
            case cone:
                s_.add(Cone{{0, -0.5, 0}, {0, 0.5, 0}, 0.5, 0.25 * pick(2)}, m, map);
                break;
            case 3:
                s_.add(Sphere{{0, 0, 0}, 0.5}, m, map);
                break;
            case 4:
                s_.add(Torus{0.375, 0.125}, m, map);
                break;
            case 5:
                s_.add(cube(Vec3d(-0.5), Vec3d(0.5)), m, map);
                break;
            case 6:
                s_.add(icosphere({0, 0, 0}, 0.5, 1), m, map);
                break;
            case 7:
                s_.add(prism(), m, map);
                break;
            case 8:
                s_.add(lathe(), m, map);
                break;
            default:
                body(box, m, map);
                break;
        }
    }

    Shape prism() {
        Prism prism;
        prism.outline = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.25}, {0, 0.5}, {-0.5, 0.25}};
        prism.bottom = -0.5;
        prism.top = 0.5;
        prism.capped = true;
        s_.scene.prisms.push_back(prism);
        return PrismRef{static_cast<std::uint32_t>(s_.scene.prisms.size() - 1)};
    }
    Shape lathe() {
        Lathe lathe;
        lathe.spline = pick(2) == 0 ? Spline::linear : Spline::catmull_rom;
        lathe.profile = {{0, -0.5}, {0.5, -0.5}, {0.25, 0}, {0.5, 0.25}, {0.25, 0.5}, {0, 0.5}};
        s_.scene.lathes.push_back(lathe);
        return LatheRef{static_cast<std::uint32_t>(s_.scene.lathes.size() - 1)};
    }
    void body(const Box& box, std::uint32_t m, const Affine<double>& map) {
        const std::uint32_t inside = pick(2) == 0 ? m : matt();
        const auto kind = static_cast<Composite::Kind>(pick(3));
        const Shape other = pick(2) == 0 ? Shape(Sphere{{0.25, 0.25, 0.25}, 0.5})
                                         : Shape(Cylinder{{0, -0.5, 0}, {0, 0.5, 0}, 0.25});
        s_.add_body(kind, {{box, m, map}, {other, inside, map}}, m);
    }

    std::mt19937 random_;
    Turns turns_;
    Stage s_;
};

}  // namespace

Scene random_turned(unsigned seed, Turns turns) {
    return Grid(seed, turns).scene();
}

}  // namespace lancer::extremes
