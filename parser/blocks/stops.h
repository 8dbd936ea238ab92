// The stops of a gradient: of a texture or of the sky.
#pragma once

#include "model/material.h"
#include "parser/blocks/brightness.h"
#include "parser/evaluation/block_reader.h"
#include "parser/rules.h"

namespace lancer {

namespace rules {

struct Stops {
    static constexpr std::string_view takes = "a list of stops, each [number, colour], one or more";
    static bool read(const Value& value, std::vector<Gradient::Stop>& out, std::string& instead) {
        return read_list(value, out, instead,
                         [&](const Value& stop, Gradient::Stop& to) {
                             std::string ignored;
                             if (!stop.is_list() || stop.size() != 2 || !stop.at(0).is_number())
                                 return false;
                             to.at = stop.at(0).number();
                             return ColorRule::read(stop.at(1), to.color, ignored);
                         }) &&
               !out.empty();
    }
};

}  // namespace rules

namespace blocks {

/// Reports stops whose positions decrease.
inline void check_order(BlockReader& block, const std::vector<Gradient::Stop>& stops) {
    for (std::size_t i = 1; i < stops.size() && block.good(); ++i)
        if (stops[i].at < stops[i - 1].at)
            block.error(Message::stops_order, block.place("stops"), to_text(stops[i].at),
                        to_text(stops[i - 1].at));
}

}  // namespace blocks
}  // namespace lancer
