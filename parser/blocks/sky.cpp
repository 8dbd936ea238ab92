#include "model/scene.h"
#include "parser/blocks/blocks.h"
#include "parser/blocks/stops.h"
#include "parser/evaluation/singles.h"

namespace lancer::blocks {
namespace {

constexpr Field sky_fields[] = {
    field<&Gradient::axis, rules::Direction>("gradient", required, "the axis, towards the stop 1"),
    field<&Gradient::stops, rules::Stops>(
        "stops", required,
        "positions with colours, from -1, for rays against the axis, to 1, for rays along it"),
};

}  // namespace

const BlockInfo sky{
    "sky", "", sky_fields, {}, "colour of rays that hit nothing, by their direction"};

void make_sky(BlockReader& block, std::uint32_t&) {
    if (block.context().singles.is_second_sky(block.place())) return;
    Gradient made;
    if (!block.read(&made)) return;
    check_order(block, made.stops);
    for (const Gradient::Stop& stop : made.stops) {
        if (stop.at >= -1 && stop.at <= 1) continue;
        if (block.good()) block.error(Message::sky_stop, block.place("stops"), to_text(stop.at));
    }
    if (!block.good()) return;
    for (const Gradient::Stop& stop : made.stops)
        warn_bright_light(block.report(), block.place("stops"), stop.color);
    block.builder().scene.sky = std::move(made);
}

}  // namespace lancer::blocks
