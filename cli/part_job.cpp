#include "cli/part_job.h"

#include <fmt/format.h>

#include "cli/session.h"
#include "model/io/part_file.h"

namespace lancer::cli {

io::PartHead head_of(const PartOf& part, const View& view, const io::Origin& origin) {
    io::PartHead head;
    head.number = part.number;
    head.count = part.count;
    head.width = view.crop ? view.crop->width : view.width;
    head.height = view.crop ? view.crop->height : view.height;
    if (view.aov)
        head.extra_names = {"object.id", "depth.Z", "normal.X", "normal.Y", "normal.Z", "shadow.Y"};
    head.origin = origin;
    if (part.count > head.height) {
        throw UsageError(
            fmt::format("--part {}/{}: a picture of {} rows has no more parts than rows",
                        part.number, part.count, head.height));
    }
    return head;
}

void draw_part(const Renderer& renderer, const View& view, const io::PartHead& head,
               const std::string& output, const Progress& progress, RayCounts& rays) {
    const Crop whole = view.crop.value_or(Crop{0, 0, view.width, view.height});
    const auto strips = static_cast<double>(io::strips_of(head).size());
    double done = 0;
    io::write_part(output, head, [&](const io::Strip& strip) {
        View part = view;
        part.crop = Crop{whole.x, whole.y + strip.first, whole.width, strip.rows};
        const Progress share = [&](double of_strip) {
            if (progress) progress((done + of_strip) / strips);
        };
        Image image = renderer.render(part, share, rays);
        ++done;
        return image;
    });
}

}  // namespace lancer::cli
