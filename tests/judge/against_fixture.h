// Scenes drawn by a seed, and pictures of them that `validate --against` judges.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "judge/against/against.h"
#include "model/io/file.h"
#include "model/io/temporary_file.h"

namespace lancer::judge {

inline constexpr int width = 64;
inline constexpr int height = 48;

/// A scene drawn by a seed: balls and a box on a chequered floor, one of them a mirror, two lamps.
class Drawn {
  public:
    explicit Drawn(unsigned seed) : random_(seed) {
        scene_.width = width;
        scene_.height = height;
        scene_.background = {0.12, 0.2, 0.33};
        scene_.settings.max_depth = 4;
        prepare_for_validation(scene_);
        Camera camera;
        camera.position = {between(-1, 1), between(2, 3.2), between(7, 9)};
        camera.look_at = {between(-0.4, 0.4), 0.6, between(-0.4, 0.4)};
        camera.projection = PerspectiveProjection{between(35, 45)};
        scene_.cameras = {camera};
        scene_.textures.push_back({Checker{{0.8, 0.75, 0.6}, {0.25, 0.3, 0.4}}, {}});
        Material floor = material();
        floor.texture = 0;
        show(Plane{{0, 1, 0}, -0.013}, floor);
        for (int i = 0; i < 3; ++i) {
            const double radius = between(0.6, 0.9);
            show(Sphere{{1.9 * (i - 1) + between(-0.2, 0.2), radius, between(-0.5, 0.5)}, radius},
                 material());
        }
        Material mirror = material();
        mirror.reflection = Color(0.3);
        show(Sphere{{between(-1, 1), 0.5, 2.2}, 0.5}, mirror);
        light({between(-5, -3), between(5, 7), between(3, 6)}, between(0.5, 0.7));
        light({between(3, 5), between(4, 6), between(4, 7)}, between(0.2, 0.4));
    }

    double between(double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random_);
    }
    int one_of(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    Scene& scene() { return scene_; }

    Material material() {
        Material made;
        made.color = {between(0.3, 0.9), between(0.3, 0.9), between(0.3, 0.9)};
        made.ambient = between(0.1, 0.2);
        made.diffuse = between(0.5, 0.7);
        made.phong = between(0, 0.3);
        return made;
    }
    void show(Shape shape, const Material& made) {
        scene_.materials.push_back(made);
        Object object;
        object.shape = shape;
        object.material = static_cast<std::uint32_t>(scene_.materials.size() - 1);
        scene_.objects.push_back(object);
    }
    void light(Vec3d position, double brightness) {
        Light made;
        made.kind = PointLight{position, {}};
        made.color = Color(brightness, brightness, 0.9 * brightness);
        scene_.lights.push_back(made);
    }

  private:
    std::mt19937 random_;
    Scene scene_;
};

/// The picture of another program: here rendered in another precision and rounded.
inline Image rendered(const Scene& scene, double shift_x = 0, double shift_y = 0) {
    Settings settings = scene.settings;
    settings.precision = Precision::extended;
    const View view{0, width, height, {}, false};
    std::vector<PicturePoint> points;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) points.push_back({x + 0.5 + shift_x, y + 0.5 + shift_y});
    std::vector<Color> colors(points.size());
    RayCounts counts;
    compile(scene, settings)->trace(view, points, {settings.max_depth, 0}, colors, {}, counts);
    Image image(width, height);
    for (std::size_t i = 0; i < colors.size(); ++i)
        for (int c = 0; c < 3; ++c) image.data[3 * i + static_cast<std::size_t>(c)] = colors[i][c];
    return image;
}

class Against : public testing::Test {
  protected:
    Validation judged(const Scene& scene, const Image& picture, const Reading& reading = {},
                      const char* name = "other.png", int bits = 16) {
        const std::string file = folder_.path().string() + "/" + name;
        io::ImageWriteOptions options;
        options.bits = bits;
        options.linear = true;
        io::write_image(file, picture, options);
        AgainstJob job;
        job.scene.name = "drawn";
        job.scene.scene = std::make_shared<const Scene>(scene);
        job.scene.view = {0, 320, 240};
        job.picture = file;
        job.reading = reading;
        return validate_against(job);
    }
    io::TemporaryFolder folder_;
};

inline std::string said(const Validation& v) {
    std::string text = "likely cause: " + v.cause.value_or("none") + "\n";
    for (const std::string& reason : v.reasons) text += reason + "\n";
    return text;
}

}  // namespace lancer::judge
