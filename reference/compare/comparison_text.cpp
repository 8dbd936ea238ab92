#include "reference/compare/comparison_text.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace lancer::reference {

namespace {

/// The name of a channel.
std::string channel_name(int channel, int channels) {
    if (channels <= 2) return channel == 0 ? "grey" : "alpha";
    static constexpr const char* names[] = {"red", "green", "blue", "alpha"};
    return channel < 4 ? names[channel] : fmt::format("channel {}", channel);
}

}  // namespace

std::string curves_note(const Comparison& c) {
    if (c.curve_a.empty() || c.curve_b.empty() || c.curve_a == c.curve_b) return {};
    return fmt::format("{} against {}: the same number means different values in the two files",
                       c.curve_a, c.curve_b);
}

std::string to_text(const Comparison& c, const CompareOptions& options) {
    if (!c.comparable) return fmt::format("FAIL: {}\n", c.reason);
    std::string text = fmt::format("{} x {} pixels, {} channels, differences in linear light\n",
                                   c.width, c.height, c.channels);
    if (c.left_out > 0)
        text += fmt::format("  mask    {} pixels compared, {} left out\n", c.pixels, c.left_out);
    if (const std::string note = curves_note(c); !note.empty())
        text += fmt::format("  curves  {}\n", note);
    text += fmt::format("  mean    {:.4g}\n", c.mean);
    text += fmt::format("  rmse    {:.4g}\n", c.rmse);
    text += c.rmse > 0 ? fmt::format("  psnr    {:.2f} dB\n", c.psnr)
                       : std::string("  psnr    infinite, the pictures are equal\n");
    text += fmt::format("  p99     {:.4g}\n", c.p99);
    text += fmt::format("  p99.9   {:.4g}\n", c.p999);
    text += fmt::format("  max     {:.4g}", c.max);
    if (c.max > 0) {
        text += fmt::format(" at ({}, {}), {}: {:.6g} against {:.6g}", c.max_x, c.max_y,
                            channel_name(c.max_channel, c.channels), c.max_a, c.max_b);
    }
    text += '\n';
    if (options.flip) text += fmt::format("  flip    {:.4g}\n", c.flip);
    text += fmt::format("  over    {:.4g} % of the pixels over {:g}, allowed {:g} %\n",
                        c.over * 100, options.fail, options.fail_percent);
    if (c.over_at_edges > 0) {
        text += fmt::format(
            "  edges   {} of these {} pixels: an edge is displaced by up to a pixel{}\n",
            c.over_at_edges, c.pixels_over, options.edges_may_move ? ", which is allowed" : "");
    }
    if (const Window& w = c.densest; w.flagged > 0) {
        text += fmt::format("  densest {} of {} x {} pixels from ({}, {}) on are over, {:.4g} %",
                            w.flagged, w.width, w.height, w.x, w.y, w.share() * 100);
        text += options.fail_window < 100 ? fmt::format(", allowed {:g} %\n", options.fail_window)
                                          : std::string("\n");
    }
    text += c.pass ? std::string("PASS\n") : fmt::format("FAIL: {}\n", c.reason);
    return text;
}

std::string to_json(const Comparison& c, const CompareOptions& options) {
    nlohmann::ordered_json json;
    const auto number = [&](double value) {
        return c.comparable && std::isfinite(value) ? nlohmann::ordered_json(value)
                                                    : nlohmann::ordered_json(nullptr);
    };
    json["verdict"] = c.pass ? "pass" : "fail";
    json["reason"] = c.reason;
    json["width"] = c.width;
    json["height"] = c.height;
    json["channels"] = c.channels;
    json["pixels"] = c.pixels;
    json["left_out"] = c.left_out;
    json["curves"] = {c.curve_a, c.curve_b};
    json["mean"] = number(c.mean);
    json["rmse"] = number(c.rmse);
    json["psnr"] = number(c.psnr);
    json["max"] = number(c.max);
    if (c.comparable) {
        json["max_at"] = {c.max_x, c.max_y};
        json["max_channel"] = channel_name(c.max_channel, c.channels);
        json["max_values"] = {c.max_a, c.max_b};
    }
    json["p99"] = number(c.p99);
    json["p999"] = number(c.p999);
    json["over"] = number(c.over);
    json["pixels_over"] = c.pixels_over;
    json["over_at_edges"] = c.over_at_edges;
    const Window& w = c.densest;
    json["densest"] = w.flagged > 0 ? nlohmann::ordered_json{{"x", w.x},
                                                             {"y", w.y},
                                                             {"width", w.width},
                                                             {"height", w.height},
                                                             {"over", w.flagged}}
                                    : nlohmann::ordered_json(nullptr);
    json["flip"] = options.flip ? number(c.flip) : nlohmann::ordered_json(nullptr);
    json["fail"] = options.fail;
    json["fail_percent"] = options.fail_percent;
    json["fail_window"] = options.fail_window;
    json["edges_may_move"] = options.edges_may_move;
    json["non_finite"] = {c.non_finite_a, c.non_finite_b};
    return json.dump(2) + "\n";
}

}  // namespace lancer::reference
