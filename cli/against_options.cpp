#include "cli/against_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <filesystem>
#include <limits>

#include "cli/arguments.h"
#include "cli/session.h"

namespace lancer::cli {

namespace {

judge::Encoding parse_encoding(const std::string& text) {
    using Kind = judge::Encoding::Kind;
    if (text == "auto") return {Kind::automatic};
    if (text == "linear") return {Kind::linear};
    if (text == "srgb") return {Kind::srgb};
    try {
        const double exponent = parse_number(text);
        if (exponent >= 0.1 && exponent <= 10) return {Kind::gamma, exponent};
    } catch (const UsageError&) {
        // Reported below.
    }
    throw UsageError(
        "'" + text +
        "' is not an encoding: expected auto, linear, srgb, or a gamma from 0.1 to 10, as in 2.2");
}

void parse_center(const std::string& text, judge::Reading& reading) {
    const std::size_t comma = text.find(',');
    const auto part = [&](const std::string& word) {
        const double value = parse_number(word);
        if (!(value >= 0 && value <= 1)) {
            throw UsageError(
                fmt::format("'{}' is not a position in a pixel: expected X or X,Y from 0 to 1, "
                            "from its upper left corner; 0.5 is the centre",
                            text));
        }
        return value;
    };
    reading.center_x = part(text.substr(0, comma));
    reading.center_y = comma == std::string::npos ? reading.center_x : part(text.substr(comma + 1));
}

}  // namespace

void add_against_options(CLI::App& app, AgainstOptions& options) {
    const char* group = "Another renderer's picture";
    app.add_option("--against", options.pictures,
                   "Judge this picture instead of POV-Ray's; or a folder of pictures with the "
                   "names of the scenes")
        ->type_name("PICTURE")
        ->group(group);
    app.add_option_function<std::string>(
           "--encoding",
           [&options](const std::string& text) {
               options.reading.encoding = parse_encoding(text);
               options.reading_is_given = true;
           },
           "Encoding of its values: auto (what the file says; default), linear, srgb, or a gamma "
           "such as 2.2")
        ->type_name("auto|linear|srgb|GAMMA")
        ->group(group);
    app.add_option_function<std::string>(
           "--exposure",
           [&options](const std::string& text) {
               options.reading.exposure = parse_number(text);
               if (!(options.reading.exposure > 0))
                   throw UsageError("--exposure must be greater than 0");
               options.reading_is_given = true;
           },
           "The picture contains X times the light (default 1)")
        ->type_name("X")
        ->group(group);
    app.add_option_function<std::string>(
           "--pixel-center",
           [&options](const std::string& text) {
               parse_center(text, options.reading);
               options.reading_is_given = true;
           },
           "Where its rays pass through the pixels, from the upper left corner (default 0.5)")
        ->type_name("X[,Y]")
        ->group(group);
}

std::string picture_for(const AgainstOptions& options, const std::string& scene,
                        std::size_t scenes) {
    std::error_code ignored;
    if (std::filesystem::is_directory(options.pictures, ignored))
        return judge::picture_in_folder(options.pictures, scene);
    if (scenes > 1) {
        throw UsageError(
            fmt::format("--against '{}' is one picture, but there are {} scenes: give a folder of "
                        "pictures with the names of the scenes",
                        options.pictures, scenes));
    }
    return options.pictures;
}

}  // namespace lancer::cli
