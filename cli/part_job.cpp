#include "cli/part_job.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/session.h"
#include "model/io/part_file.h"

namespace lancer::cli {

io::PartHead head_of(const PartOf& part, const View& view, const io::Origin& origin,
                     bool by_error) {
    io::PartHead head;
    head.number = part.number;
    head.count = part.count;
    const Image form = form_of(view);
    head.width = form.width;
    head.height = form.height;
    head.extra_names = form.extra_names;
    if (view.aov && by_error)
        head.extra_names.insert(head.extra_names.end(), {"error.Y", "samples.Z"});
    head.origin = origin;
    if (part.count > head.height) {
        throw UsageError(
            fmt::format("--part {}/{}: a picture of {} rows cannot have more parts than rows",
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

accuracy::PictureRows rows_of(const io::PartHead& head) {
    accuracy::PictureRows rows{head.number - 1, head.count, {}};
    for (const io::Strip& strip : io::strips_of(head))
        rows.ranges.push_back({strip.first, strip.rows});
    return rows;
}

void write_drawn(const Image& rows, const io::PartHead& head, const std::string& output) {
    int first = 0;
    io::write_part(output, head, [&](const io::Strip& strip) {
        Image image(rows.width, strip.rows, rows.channels);
        std::copy_n(rows.pixel(0, first), image.data.size(), image.data.begin());
        first += strip.rows;
        return image;
    });
}

}  // namespace lancer::cli
