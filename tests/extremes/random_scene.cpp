#include "tests/extremes/random_scene.h"

#include <cmath>
#include <memory>
#include <random>

#include "tests/extremes/stage.h"

namespace lancer::extremes {

Scene random_scene(unsigned seed) {
    std::mt19937 random(seed);
    // Not a standard distribution: those differ between libraries.
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const auto between = [&](double a, double b) { return a + (b - a) * unit(); };
    const auto place = [&] { return Vec3d(between(-2, 2), between(0, 2), between(-2, 2)); };
    Stage s;
    s.scene.width = 96;
    s.scene.height = 72;
    s.scene.background = {unit(), unit(), unit()};
    s.look({between(-2, 2), between(1, 4), between(5, 8)}, {0, 0.75, 0}, 45);
    s.lamp({between(2, 5), between(4, 8), between(0, 5)});
    s.lamp({between(-5, -2), between(4, 8), between(0, 5)}, {0.4, 0.3, 0.5});
    s.add(Plane{{0, 1, 0}, -0.25}, s.matt({unit(), unit(), unit()}));
    for (int i = 0; i < 12; ++i) {
        const double pick = unit();
        std::uint32_t m = s.matt({unit(), unit(), unit()});
        if (pick < 0.2) m = s.mirror();
        if (pick > 0.7) m = s.glass(between(1.1, 2), {between(0.7, 1), between(0.7, 1), 1});
        Affine<double> map;
        if (unit() < 0.5) {
            map = compose(turn(static_cast<int>(random() % 3), between(0, 360)),
                          stretched(between(0.5, 1.5), between(0.5, 1.5), between(0.5, 1.5)));
            if (unit() < 0.3) map = turn(static_cast<int>(random() % 3), between(0, 360));
            map = compose(shift({between(-1, 1), between(0, 1), between(-1, 1)}), map);
        }
        const Vec3d p = place();
        const double size = between(0.2, 0.6);
        switch (random() % 6) {
            case 0:
                s.add(Sphere{p, size}, m, map);
                break;
            case 1:
                s.add(Box{p, p + Vec3d(size, between(0.1, 1), between(0.1, 1))}, m, map);
                break;
            case 2:
                s.add(Cylinder{p, place(), size / 2, unit() < 0.8}, m, map);
                break;
            case 3:
                s.add(Cone{p, place(), size, unit() < 0.5 ? 0 : between(0, 1), unit() < 0.8}, m,
                      map);
                break;
            case 4:
                s.add(Triangle{{p, place(), place()}}, m, map);
                break;
            default:
                s.add(icosphere(p, size, 1), m, map);
                break;
        }
    }
    return s.scene;
}

namespace {

/// Draws one thing of each kind after the other; the same on every machine.
class Lottery {
  public:
    explicit Lottery(unsigned seed) : random_(seed) {}

    Scene scene() {
        s_.scene.width = 64;
        s_.scene.height = 48;
        s_.scene.background = color();
        s_.scene.ambient = color();
        textures();
        const Vec3d from(between(-3, 3), between(1, 4), between(5, 8));
        if (chance(0.2))
            s_.look_parallel(from, {0, 0.75, 0}, between(3, 5));
        else
            s_.look(from, {0, 0.75, 0}, between(30, 60));
        const int lights = 1 + pick(3);
        for (int i = 0; i < lights; ++i) light();
        s_.add(Plane{{between(-0.1, 0.1), 1, between(-0.1, 0.1)}, -0.25}, material(), {});
        for (int i = 0; i < 10; ++i) {
            Object& object = shape();
            object.casts_shadow = chance(0.9);
        }
        s_.add(torus(), material(), transform());
        body();
        return s_.scene;
    }

  private:
    double unit() { return static_cast<double>(random_()) / 4294967296.0; }
    double between(double a, double b) { return a + (b - a) * unit(); }
    bool chance(double share) { return unit() < share; }
    int pick(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
    Color color() {
        const double r = unit();
        const double g = unit();
        return {r, g, unit()};
    }
    Vec3d place() {
        const double x = between(-2, 2);
        const double y = between(0, 2);
        return {x, y, between(-2, 2)};
    }

    void textures() {
        auto pixels = std::make_shared<Image>(5, 4);
        for (double& value : pixels->data) value = unit();
        s_.scene.images.push_back({"random", false, pixels});
        for (const auto mapping : {ImageTexture::Mapping::planar, ImageTexture::Mapping::spherical,
                                   ImageTexture::Mapping::cylindrical, ImageTexture::Mapping::uv}) {
            ImageTexture image;
            image.mapping = mapping;
            image.filter = chance(0.5) ? ImageTexture::Filter::nearest : image.filter;
            s_.scene.textures.push_back({image, transform()});
        }
        s_.scene.textures.push_back({Checker{color(), color()}, transform()});
        s_.scene.textures.push_back(
            {Gradient{{unit(), 1, unit()}, {{0, color()}, {0.4, color()}, {1, color()}}},
             transform()});
    }

    void light() {
        Light light;
        light.color = color();
        light.shadows = chance(0.8);
        const Vec3d at = place() * 2.0 + Vec3d(0, 4, 2);
        const std::optional<Fade> fade =
            chance(0.5) ? std::optional(Fade{between(3, 8), between(1, 3)}) : std::nullopt;
        const int kind = pick(3);
        if (kind == 0) light.kind = PointLight{at, fade};
        if (kind == 1) light.kind = DirectionalLight{place() - at};
        if (kind == 2) light.kind = SpotLight{at, place(), 20, 40, between(0, 2), fade};
        s_.scene.lights.push_back(light);
    }

    std::uint32_t material() {
        Material m;
        m.color = color();
        m.ambient = between(0, 0.3);
        m.diffuse = unit();
        if (chance(0.3)) m.texture = static_cast<std::uint32_t>(pick(6));
        if (chance(0.2)) m.emission = color() * 0.3;
        if (chance(0.4)) m.phong = unit(), m.shininess = between(1, 100);
        if (chance(0.4)) m.blinn = unit(), m.roughness = between(0.01, 0.5);
        if (chance(0.3)) m.metallic = unit();
        if (chance(0.3)) m.reflection = color() * 0.8;
        m.fresnel = chance(0.3);
        if (chance(0.4)) {
            m.filter = between(0, 0.9);
            m.transmission = between(0, 1 - m.filter);
            m.ior = chance(0.3) ? 1 : between(0.8, 2);
            if (chance(0.5)) m.absorption = color();
        }
        if (chance(0.2)) m.diffuse_transmission = unit();
        if (chance(0.2)) m.phong_transmission = unit();
        return s_.material(m);
    }

    Affine<double> transform() {
        Affine<double> map;
        if (chance(0.3)) return map;
        if (chance(0.5)) map = stretched(between(0.5, 1.5), between(0.5, 1.5), between(0.5, 1.5));
        if (chance(0.2)) map = compose(stretched(-1, 1, 1), map);
        map = compose(turn(pick(3), between(0, 360)), map);
        map = compose(turn(pick(3), between(0, 360)), map);
        return compose(shift(place() * 0.5), map);
    }

    Object& shape() {
        const std::uint32_t m = material();
        const Affine<double> map = transform();
        const Vec3d p = place();
        const double size = between(0.2, 0.6);
        switch (pick(10)) {
            case 0:
                return s_.add(Sphere{p, size}, m, map);
            case 1:
                return s_.add(Box{p, p + Vec3d(size, between(0.1, 1), between(0.1, 1))}, m, map);
            case 2:
                return s_.add(Cylinder{p, place(), size / 2, chance(0.7)}, m, map);
            case 3:
                return s_.add(Cone{p, place(), size, chance(0.5) ? 0 : unit(), chance(0.7)}, m,
                              map);
            case 4:
                return s_.add(Triangle{{p, place(), place()}, attributes()}, m, map);
            case 5:
                return s_.add(patch(p, size), m, map);
            case 6:
                return s_.add(lathe(size), m, map);
            case 7:
                return s_.add(prism(size), m, map);
            default:
                return mesh(p, size, m, map);
        }
    }

    Shape torus() {
        const double radius = between(0.3, 1);
        return Torus{radius, radius * between(0.1, 1)};
    }

    void body() {
        const auto kind = static_cast<Composite::Kind>(pick(3));
        const std::uint32_t whole = material();
        std::vector<Part> parts;
        for (int i = 0; i < 3; ++i) {
            Part part{Sphere{{0, 0.5, 0}, between(0.5, 1)}, chance(0.5) ? whole : material(), {}};
            const Vec3d p(between(-0.5, 0), between(0, 0.5), between(-0.5, 0));
            const int shape = pick(5);
            if (shape == 1) part.shape = Box{p, p + Vec3d(1, between(0.3, 1), 1)};
            if (shape == 2) part.shape = Cylinder{p, p + Vec3d(unit(), 1, 0), between(0.2, 0.8)};
            if (shape == 3) part.shape = torus();
            if (shape == 4) part.shape = prism(1);
            if (shape == 4) s_.scene.prisms.back().capped = true;
            if (chance(0.5)) part.map = compose(shift({0, 0.3, 0}), turn(pick(3), between(0, 360)));
            parts.push_back(part);
        }
        s_.add_body(kind, parts, whole);
    }

    std::uint32_t attributes() {
        if (chance(0.5)) return none;
        s_.scene.triangle_attributes.push_back(
            {std::array{Vec3d(0.1, 0, 1), Vec3d(0, 0.2, 1), Vec3d(-0.1, 0, 1)},
             std::array{Vec2d(0, 0), Vec2d(1, 0), Vec2d(0, 1)}});
        return static_cast<std::uint32_t>(s_.scene.triangle_attributes.size() - 1);
    }

    Object& mesh(const Vec3d& p, double size, std::uint32_t m, const Affine<double>& map) {
        Mesh ball = icosphere(p, size, 1);
        if (chance(0.5)) {
            for (const Vec3d& v : ball.vertices) ball.normals.push_back(normalize(v - p));
        }
        Object& object = s_.add(ball, m, map);
        std::get<MeshRef>(object.shape).smooth = true;
        return object;
    }

    Shape patch(const Vec3d& p, double size) {
        Patch patch;
        patch.basis = chance(0.5) ? Patch::Basis::bezier : Patch::Basis::bspline;
        for (int i = 0; i < 16; ++i)
            patch.control.push_back(p + size * Vec3d(i % 4, between(-1, 1), i / 4));
        if (chance(0.5)) patch.tolerance = 0.01;
        s_.scene.patches.push_back(patch);
        return PatchRef{static_cast<std::uint32_t>(s_.scene.patches.size() - 1)};
    }

    Shape lathe(double size) {
        constexpr Spline splines[] = {Spline::linear, Spline::bezier, Spline::bspline,
                                      Spline::catmull_rom};
        Lathe lathe;
        lathe.spline = splines[pick(4)];
        for (int i = 0; i < 4; ++i)
            lathe.profile.push_back(Vec2d(between(0.5, 1.5) * size, i * size));
        s_.scene.lathes.push_back(lathe);
        return LatheRef{static_cast<std::uint32_t>(s_.scene.lathes.size() - 1)};
    }

    Shape prism(double size) {
        constexpr Spline splines[] = {Spline::linear, Spline::bezier, Spline::bspline,
                                      Spline::catmull_rom};
        Prism prism;
        prism.spline = splines[pick(4)];
        for (int i = 0; i < 6; ++i) {
            const auto [y, x] = sine_cosine(60.0 * i);
            prism.outline.push_back(Vec2d(x, y) * (size * between(0.7, 1.3)));
        }
        prism.top = size;
        prism.capped = chance(0.7);
        s_.scene.prisms.push_back(prism);
        return PrismRef{static_cast<std::uint32_t>(s_.scene.prisms.size() - 1)};
    }
    static std::pair<double, double> sine_cosine(double angle) {
        const auto both = elementary::sine_cosine_of_degrees(angle);
        return {both.sine, both.cosine};
    }

    std::mt19937 random_;
    Stage s_;
};

}  // namespace

Scene random_anything(unsigned seed) {
    return Lottery(seed).scene();
}

}  // namespace lancer::extremes
