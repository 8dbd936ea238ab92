#include "model/scene.h"
#include "parser/blocks/blocks.h"
#include "parser/blocks/stops.h"

namespace lancer::blocks {
namespace {

constexpr Field sky_fields[] = {
    field<&Gradient::axis, rules::Direction>("gradient", required, "the axis, towards the stop 1"),
    field<&Gradient::stops, rules::Stops>(
        "stops", required, "places with colours, from -1, where a ray goes against the axis, to 1"),
};

}  // namespace

const BlockInfo sky{"sky", "", sky_fields, {}, "what rays bring that hit nothing, by direction"};

void make_sky(BlockReader& block, std::uint32_t&) {
    Evaluator& evaluator = block.evaluator();
    if (evaluator.is_repeated("sky", evaluator.sky_place, block.place())) return;
    evaluator.check_one_background(block.place());
    Gradient made;
    if (!block.read(&made)) return;
    check_order(block, made.stops);
    for (const Gradient::Stop& stop : made.stops) {
        if (stop.at >= -1 && stop.at <= 1) continue;
        if (block.good()) block.error(Message::sky_stop, block.place("stops"), to_text(stop.at));
    }
    if (!block.good()) return;
    for (const Gradient::Stop& stop : made.stops)
        warn_bright_light(evaluator.report(), block.place("stops"), stop.color);
    block.builder().scene.sky = std::move(made);
}

}  // namespace lancer::blocks
