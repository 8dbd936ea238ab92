// Textures on shapes: which texture point a ray sees. An image whose colour is its own (u, v) tells
// this.
#include "tests/tracer/scene_kit.h"

namespace lancer {
namespace {

using namespace kit;
using Mapping = ImageTexture::Mapping;

/// Bilinear look-ups in it return (u, v, 0), except within half a texel of the border.
std::shared_ptr<const Image> coordinates() {
    constexpr int size = 64;
    auto image = std::make_shared<Image>(size, size);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            image->pixel(x, y)[0] = (x + 0.5) / size;
            image->pixel(x, y)[1] = (size - 1 - y + 0.5) / size;
        }
    }
    return image;
}

/// A scene with a texture and a material 1 that shows it unshaded.
Scene with_texture(const decltype(Texture::pattern)& pattern,
                   const Affine<double>& to_object = {}) {
    Scene scene;
    scene.images.push_back({"coordinates", false, coordinates()});
    scene.textures.push_back({pattern, to_object});
    Material m = glowing(Color(1));
    m.texture = 0;
    add(scene, m);
    return scene;
}
Scene with_image(Mapping mapping, const Affine<double>& to_object = {}) {
    ImageTexture image;
    image.mapping = mapping;
    return with_texture(image, to_object);
}

constexpr double close = 1e-12;

void expect_uv(const Scene& scene, const Vec3d& from, const Vec3d& at, double u, double v) {
    EXPECT_COLOR_NEAR(seen(scene, from, at), Color(u, v, 0), close);
}

TEST(Uv, OfASphereIsSphericalAboutItsCentre) {
    Scene scene = with_image(Mapping::uv);
    show(scene, Sphere{{1, 2, 3}, 2}, 1);
    expect_uv(scene, {1, 2, 10}, {1, 2, 5}, 0.25, 0.5);
    expect_uv(scene, {-9, 2, 3}, {-1, 2, 3}, 0.5, 0.5);
    const double h = std::sqrt(2.0);
    expect_uv(scene, {1, 2 + 3 * h, 3 - 3 * h}, {1, 2, 3}, 0.75, 0.75);
}

TEST(Uv, OfABoxIsUprightOnEachFaceSeenFromOutside) {
    Scene scene = with_image(Mapping::uv);
    show(scene, Box{{1, 2, 3}, {5, 4, 11}}, 1);
    // q = (1/4, 3/4, 1/8) on the way in along each axis
    const Vec3d q(2, 3.5, 4);
    const auto from = [&](double dx, double dy, double dz) { return q + 30.0 * Vec3d(dx, dy, dz); };
    expect_uv(scene, from(0, 0, 1), q, 0.25, 0.75);
    expect_uv(scene, from(0, 0, -1), q, 0.75, 0.75);
    expect_uv(scene, from(1, 0, 0), q, 1 - 0.125, 0.75);
    expect_uv(scene, from(-1, 0, 0), q, 0.125, 0.75);
    expect_uv(scene, from(0, 1, 0), q, 0.25, 1 - 0.125);
    expect_uv(scene, from(0, -1, 0), q, 0.25, 0.125);
}

TEST(Uv, OfABoxMovesWithTheBox) {
    // A quarter turn about y takes +z to +x, and such a box is baked into the world.
    for (const double angle : {90.0, 30.0}) {
        Scene scene = with_image(Mapping::uv);
        const Affine<double> move = in_turn(stretched(1, 2, 1), turn_y(angle), shift(3, -1, 2));
        show(scene, Box{{0, 0, 0}, {1, 1, 1}}, 1, move);
        const Vec3d at = map_point(move, Vec3d(0.25, 0.75, 1));
        const Vec3d from = at + 5.0 * map_vector(move, Vec3d(0, 0, 1));
        expect_uv(scene, from, at, 0.25, 0.75);
    }
}

TEST(Uv, OfAMirroredBoxIsMirroredToo) {
    Scene scene = with_image(Mapping::uv);
    show(scene, Box{{0, 0, 0}, {1, 1, 1}}, 1, stretched(-1, 1, 1));
    expect_uv(scene, {-0.25, 0.75, 9}, {-0.25, 0.75, 1}, 0.25, 0.75);
    expect_uv(scene, {9, 0.75, 0.25}, {0, 0.75, 0.25}, 0.25, 0.75);  // its face -x
}

TEST(Uv, OfACylinderGoesRoundItsAxisFromXAndUpFromTheBase) {
    Scene scene = with_image(Mapping::uv);
    show(scene, Cylinder{{2, 1, 2}, {2, 5, 2}, 0.5, true}, 1);
    // y' = y, x' = x, z' = x' × y' = z
    expect_uv(scene, {2, 2, 9}, {2, 2, 2}, 0.25, 0.25);
    expect_uv(scene, {2, 4, -9}, {2, 4, 2}, 0.75, 0.75);
    expect_uv(scene, {-9, 3, 2}, {2, 3, 2}, 0.5, 0.5);
    expect_uv(scene, {2.25, 9, 2.125}, {2.25, 5, 2.125}, 0.75, 0.625);   // cap, top
    expect_uv(scene, {1.75, -9, 2.125}, {1.75, 1, 2.125}, 0.25, 0.625);  // cap, base
}

TEST(Uv, OfACylinderAlongXCountsFromTheWorldsZ) {
    Scene scene = with_image(Mapping::uv);
    show(scene, Cylinder{{0, 0, 0}, {4, 0, 0}, 1, true}, 1);
    // y' = x, x' = z, z' = x' × y' = z × x = y
    expect_uv(scene, {1, 9, 0}, {1, 0, 0}, 0.25, 0.25);
    expect_uv(scene, {3, -9, 0}, {3, 0, 0}, 0.75, 0.75);
    expect_uv(scene, {9, 0.5, 0.25}, {4, 0.5, 0.25}, 0.625, 0.75);
}

TEST(Uv, OfAConeKnowsItsBaseWhicheverEndIsLarger) {
    for (const bool wide_base : {true, false}) {
        Scene scene = with_image(Mapping::uv);
        const double base = wide_base ? 2 : 1;
        const double top = wide_base ? 1 : 2;
        show(scene, Cone{{0, 0, 0}, {0, 4, 0}, base, top, true}, 1);
        expect_uv(scene, {0, 1, 9}, {0, 1, 0}, 0.25, 0.25);
        expect_uv(scene, {0.5, -9, 0.25}, {0.5, 0, 0.25}, 0.5 + 0.5 / (2 * base),
                  0.5 + 0.25 / (2 * base));
        expect_uv(scene, {0.5, 9, 0.25}, {0.5, 4, 0.25}, 0.5 + 0.5 / (2 * top),
                  0.5 + 0.25 / (2 * top));
    }
}

TEST(Uv, OfATransformedConeIsThatOfItsOwnSpace) {
    for (const Vec3d& s : {Vec3d(2, 2, 2), Vec3d(1, 3, 2)}) {  // baked, and in a frame of its own
        Scene scene = with_image(Mapping::uv);
        const Affine<double> move = in_turn(stretched(s.x, s.y, s.z), turn_z(40), shift(1, 2, 3));
        show(scene, Cone{{0, 0, 0}, {0, 4, 0}, 2, 1, true}, 1, move);
        expect_uv(scene, map_point(move, Vec3d(0, 1, 9)), map_point(move, Vec3d(0, 1, 0)), 0.25,
                  0.25);
        expect_uv(scene, map_point(move, Vec3d(0.5, 9, 0.25)), map_point(move, Vec3d(0.5, 4, 0.25)),
                  0.75, 0.625);
    }
}

TEST(Uv, OfPlaneAndPlainTriangleIsPlanar) {
    Scene scene = with_image(Mapping::uv);
    show(scene, Plane{{0, 0, 1}, 0}, 1);
    show(scene, Triangle{{Vec3d(0, 0, 1), Vec3d(3, 0, 1), Vec3d(0, 3, 1)}}, 1);
    expect_uv(scene, {0.3, 0.6, 9}, {0.3, 0.6, 1}, 0.3, 0.6);
    expect_uv(scene, {-0.3, 0.6, 9}, {-0.3, 0.6, 1}, 0.7, 0.6);
}

TEST(Uv, OfATriangleIsInterpolatedBetweenItsCorners) {
    Scene scene = with_image(Mapping::uv);
    scene.triangle_attributes.push_back(
        {{}, std::array{Vec2d(0.1, 0.2), Vec2d(0.9, 0.4), Vec2d(0.3, 0.8)}});
    show(scene, Triangle{{Vec3d(0, 0, 0), Vec3d(4, 0, 0), Vec3d(0, 4, 0)}, 0}, 1);
    // weights 1/4, 1/2, 1/4
    expect_uv(scene, {2, 1, 9}, {2, 1, 0}, 0.25 * 0.1 + 0.5 * 0.9 + 0.25 * 0.3,
              0.25 * 0.2 + 0.5 * 0.4 + 0.25 * 0.8);
}

Mesh square() {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
    mesh.faces = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TEST(Uv, OfAMeshFollowsItsOwnIndices) {
    Mesh mesh = square();
    mesh.uvs = {{0.5, 0.5}, {0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.1, 0.9}};
    mesh.uv_faces = {{1, 2, 3}, {1, 3, 4}};
    Scene scene = with_image(Mapping::uv);
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    show(scene, MeshRef{0, false}, 1, in_turn(stretched(0.5, 1, 1), shift(10, 0, 0)));
    expect_uv(scene, {11.5, 1, 9}, {11.5, 1, 0}, 0.1 + 0.8 * 0.75, 0.1 + 0.8 * 0.25);
    expect_uv(scene, {10.5, 3, 9}, {10.5, 3, 0}, 0.1 + 0.8 * 0.25, 0.1 + 0.8 * 0.75);
}

TEST(Uv, OfAMeshWithoutUvsAndOfItsFacesWithoutIsPlanar) {
    Mesh mesh = square();
    Scene scene = with_image(Mapping::uv);
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    mesh.uvs = {{0.1, 0.1}};
    mesh.uv_faces = {{0, 0, 0}, {0, none, 0}};
    scene.meshes.push_back(std::make_shared<Mesh>(mesh));
    show(scene, MeshRef{0, false}, 1);
    show(scene, MeshRef{1, false}, 1, shift(10, 0, 0));
    expect_uv(scene, {3.25, 1.625, 9}, {3.25, 1.625, 0}, 0.25, 0.625);
    expect_uv(scene, {13.25, 1.625, 9}, {13.25, 1.625, 0}, 0.1, 0.1);
    expect_uv(scene, {11.25, 3.625, 9}, {11.25, 3.625, 0}, 0.25, 0.625);
}

TEST(Uv, TheTexturesOwnTransformsAreUndoneOnThem) {
    Scene scene = with_image(Mapping::uv, in_turn(stretched(0.5, 0.25, 1), shift(0.1, 0, 0)));
    show(scene, Box{{0, 0, 0}, {1, 1, 1}}, 1);
    expect_uv(scene, {0.3, 0.1, 9}, {0.3, 0.1, 1}, (0.3 - 0.1) / 0.5, 0.1 / 0.25);
}

TEST(TextureSpace, PlanarSphericalAndCylindricalFollowTheObjectAndItsGroup) {
    const Affine<double> group = in_turn(turn_y(35), shift(4, 1, -2));
    const Affine<double> own = in_turn(stretched(2, 2, 2), turn_x(20));
    const Affine<double> move = in_turn(own, group);  // as the evaluator composes them
    const Affine<double> texture = in_turn(turn_z(15), stretched(3, 3, 3), shift(0.2, 0.1, 0.3));
    const Vec3d on = normalize(Vec3d(0.3, 0.4, 0.5));  // on the unit sphere
    const Vec3d p = map_point(inverse(texture), on);
    const double around = std::atan2(p.z, p.x) / tau;
    const auto check = [&](Mapping mapping, double u, double v) {
        Scene scene = with_image(mapping, texture);
        show(scene, Sphere{{0, 0, 0}, 1}, 1, move);
        expect_uv(scene, map_point(move, 3.0 * on), map_point(move, on), u - std::floor(u),
                  v - std::floor(v));
    };
    check(Mapping::planar, p.x, p.y);
    check(Mapping::cylindrical, around, p.y);
    check(Mapping::spherical, around, 0.5 + std::asin(p.y / length(p)) / pi);
}

TEST(TextureSpace, CentreAndCornersOfAShapeDoNotMoveIt) {
    Scene scene = with_image(Mapping::planar);
    show(scene, Sphere{{5, 0, 0}, 1}, 1);
    expect_uv(scene, {5.25, 0.375, 9}, {5.25, 0.375, 0}, 0.25, 0.375);
}

TEST(TextureSpace, AScaledSceneShowsTheSameTexture) {
    for (const double k : {1e-30, 1.0, 1e30}) {
        Scene scene = with_image(Mapping::planar, stretched(k, k, k));
        show(scene, Sphere{{0, 0, 0}, k}, 1);
        expect_uv(scene, Vec3d(0.3, 0.6, 9) * k, Vec3d(0.3, 0.6, 0) * k, 0.3, 0.6);
    }
}

/// Colours of a picture that looks down onto a floor, one sample per pixel.
bool all_equal(const Scene& scene, const Color& color) {
    const Image image = picture(scene, 40, 30);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double* p = image.pixel(x, y);
            if (Color(p[0], p[1], p[2]) != color) return false;
        }
    }
    return true;
}

/// A floor on the border between two rows of cubes. The cubes are stretched along the row, so that
/// each row has one colour.
TEST(TextureSpace, AFloorOnABorderOfTheCheckerDoesNotSpeckle) {
    for (const Precision precision : {Precision::single, Precision::double_, Precision::extended}) {
        for (const double angle : {0.0, 17.0, 45.0}) {
            for (const double height : {0.0, 1.0, -0.5}) {
                // One tenth is not representable, so the floor meets the border only within
                // rounding of the precision.
                const double edge = precision == Precision::extended ? 0.125 : 0.1;
                const Affine<double> cubes =
                    in_turn(shift(-0.5, 0, -0.5), stretched(1e5, edge, 1e5));
                Scene scene = with_texture(Checker{{1, 0, 0}, {0, 1, 0}}, cubes);
                scene.settings.precision = precision;
                const Affine<double> tilt = in_turn(turn_z(angle), shift(0.7, 3.1, 0.2));
                show(scene, Plane{{0, 1, 0}, height}, 1, tilt);
                Camera camera = camera_along(map_point(tilt, Vec3d(3, height + 4, 7)),
                                             map_point(tilt, Vec3d(0, height, 0)));
                camera.projection = PerspectiveProjection{15};
                scene.cameras = {camera};
                const int row = static_cast<int>(std::lround(height / edge));
                EXPECT_TRUE(all_equal(scene, row % 2 == 0 ? Color(1, 0, 0) : Color(0, 1, 0)))
                    << "angle " << angle << " height " << height << " precision "
                    << static_cast<int>(precision);
            }
        }
    }
}

TEST(TextureSpace, ABoxFaceOnTheWrapOfAGradientDoesNotSpeckle) {
    Scene scene = with_texture(Gradient{{0, 0, 2}, {{0, Color(1, 0, 0)}, {1, Color(0, 0, 1)}}});
    show(scene, Box{{-9, -9, -1}, {9, 9, 1}}, 1, turn_x(30));
    const Vec3d up = map_vector(turn_x(30), Vec3d(0, 0, 1));
    scene.cameras = {camera_along(5.0 * up, up)};
    EXPECT_TRUE(all_equal(scene, Color(1, 0, 0)));
}

TEST(TexturesOff, AMeanColourStandsForEachTexture) {
    const auto plain = [](Scene scene) {
        scene.settings.textures = false;
        show(scene, Sphere{{0, 0, 0}, 1}, 1);
        return seen(scene, {0, 0, 5}, {0, 0, 0});
    };
    EXPECT_COLOR_NEAR(plain(with_texture(Checker{{1, 0.5, 0}, {0, 0.5, 0.25}})),
                      Color(0.5, 0.5, 0.125), close);
    EXPECT_COLOR_NEAR(
        plain(with_texture(Gradient{{0, 1, 0}, {{0.25, Color(1, 0, 0)}, {0.75, Color(0, 0, 1)}}})),
        Color(0.5, 0, 0.5), close);
    EXPECT_COLOR_NEAR(
        plain(with_texture(Gradient{
            {0, 1, 0}, {{-1, Color(0)}, {0.5, Color(0.75)}, {0.5, Color(0)}, {3, Color(0)}}})),
        Color(0.5 * 0.625), close);
    EXPECT_COLOR_NEAR(plain(with_image(Mapping::planar)), Color(0.5, 0.5, 0), close);
}

}  // namespace
}  // namespace lancer
