#include "tracer/render.h"

#include <algorithm>

#include "tracer/render_types.h"

namespace lancer {

namespace {

/// \param level  used only in double precision
std::unique_ptr<RayTreeRenderer> compile_by_precision(const Scene& scene, const Settings& settings,
                                                      Level level) {
    switch (settings.precision) {
        case Precision::single:
            return compile_single(scene, settings);
        case Precision::extended:
            return compile_extended(scene, settings);
        case Precision::double_:
            break;
    }
    return compile_double(scene, settings, level);
}

}  // namespace

Image form_of(const View& view) {
    Image form;
    form.width = view.crop ? view.crop->width : view.width;
    form.height = view.crop ? view.crop->height : view.height;
    form.channels = view.alpha ? 4 : 3;
    if (view.aov)
        form.extra_names = {"object.id", "depth.Z", "normal.X", "normal.Y", "normal.Z", "shadow.Y"};
    form.channels += static_cast<int>(form.extra_names.size());
    return form;
}

Image Renderer::render(const View& view, const Progress& progress, RayCounts& counts) const {
    Image image = form_of(view);
    image.data.resize(image.index(0, image.height));
    const auto take = [&](int x, int y, const Image& tile) {
        const std::size_t values = static_cast<std::size_t>(tile.width * tile.channels);
        for (int row = 0; row < tile.height; ++row)
            std::copy_n(tile.pixel(0, row), values, image.pixel(x, y + row));
    };
    render_tiles(view, take, progress, counts);
    return image;
}

std::unique_ptr<Renderer> compile(const Scene& scene, const Settings& settings, Level level) {
    return compile_by_precision(scene, settings, level);
}

std::unique_ptr<RayTreeRenderer> compile_for_ray_trees(const Scene& scene,
                                                       const Settings& settings) {
    return compile_by_precision(scene, settings, Level::scalar);
}

}  // namespace lancer
