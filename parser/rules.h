// The rules of properties: each describes its values for messages and reads a value.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/material.h"
#include "model/math.h"
#include "model/shapes.h"
#include "parser/value.h"

namespace lancer::rules {

// --- Numbers. Each rule can also read into a std::optional<double>.

template <class Condition>
struct NumberRule {
    template <class Number>
    static bool read(const Value& value, Number& out, std::string&) {
        if (!value.is_number() || !Condition::holds(value.number())) return false;
        out = static_cast<Number>(value.number());
        return true;
    }
    static bool read(const Value& value, std::optional<double>& out, std::string&) {
        if (!value.is_number() || !Condition::holds(value.number())) return false;
        out = value.number();
        return true;
    }
};

struct Number : NumberRule<Number> {
    static constexpr std::string_view takes = "a number";
    static bool holds(double) { return true; }
};
struct Positive : NumberRule<Positive> {
    static constexpr std::string_view takes = "a number greater than 0";
    static bool holds(double x) { return x > 0; }
};
struct NotNegative : NumberRule<NotNegative> {
    static constexpr std::string_view takes = "a number of 0 or more";
    static bool holds(double x) { return x >= 0; }
};
struct Share : NumberRule<Share> {
    static constexpr std::string_view takes = "a number from 0 to 1";
    static bool holds(double x) { return x >= 0 && x <= 1; }
};
struct FieldOfView : NumberRule<FieldOfView> {
    static constexpr std::string_view takes = "an angle greater than 0 and less than 180 degrees";
    static bool holds(double x) { return x > 0 && x < 180; }
};
struct HalfAngle : NumberRule<HalfAngle> {
    static constexpr std::string_view takes = "an angle from 0 to 180 degrees";
    static bool holds(double x) { return x >= 0 && x <= 180; }
};
struct PixelCount : NumberRule<PixelCount> {
    static constexpr std::string_view takes = "a whole number from 1 to 65535";
    static bool holds(double x) { return x >= 1 && x <= 65535 && x == std::floor(x); }
};
struct Depth : NumberRule<Depth> {
    static constexpr std::string_view takes = "a whole number from 1 to 1000";
    static bool holds(double x) { return x >= 1 && x <= 1000 && x == std::floor(x); }
};

struct Flag {
    static constexpr std::string_view takes = "true or false";
    static bool read(const Value& value, bool& out, std::string&) {
        if (!value.is(Value::Kind::boolean)) return false;
        out = value.boolean();
        return true;
    }
};

struct String {
    static constexpr std::string_view takes = "a string";
    static bool read(const Value& value, std::string& out, std::string&) {
        if (!value.is(Value::Kind::text)) return false;
        out = value.text();
        return true;
    }
};

// --- Vectors and colours

inline bool read_vector(const Value& value, Vec3d& out) {
    if (!value.is_vector(3)) return false;
    out = {value.component(0), value.component(1), value.component(2)};
    return true;
}

struct Vector {
    static constexpr std::string_view takes = "a vector of 3 numbers";
    static bool read(const Value& value, Vec3d& out, std::string&) {
        return read_vector(value, out);
    }
    static bool read(const Value& value, std::optional<Vec3d>& out, std::string&) {
        out.emplace();
        return read_vector(value, *out);
    }
};
struct Direction {
    static constexpr std::string_view takes = "a vector of 3 numbers that are not all 0";
    static bool read(const Value& value, Vec3d& out, std::string&) {
        return read_vector(value, out) && out != Vec3d(0, 0, 0);
    }
    static bool read(const Value& value, std::optional<Vec3d>& out, std::string&) {
        out.emplace();
        return read_vector(value, *out) && *out != Vec3d(0, 0, 0);
    }
};
/// A light may have a negative colour: then it takes light away.
struct LightColor {
    static constexpr std::string_view takes = "a colour, [red, green, blue] or #rrggbb";
    static bool read(const Value& value, Color& out, std::string&) {
        return read_vector(value, out);
    }
};
struct ColorRule {
    static constexpr std::string_view takes =
        "a colour, [red, green, blue] or #rrggbb, without negative parts";
    static bool read(const Value& value, Color& out, std::string&) {
        return read_vector(value, out) && out.x >= 0 && out.y >= 0 && out.z >= 0;
    }
};
struct NumberOrColor {
    static constexpr std::string_view takes =
        "a number of 0 or more, or a colour without negative parts";
    static bool read(const Value& value, Color& out, std::string& instead) {
        if (!value.is_number()) return ColorRule::read(value, out, instead);
        out = Color(value.number());
        return value.number() >= 0;
    }
};

// --- One of a few words

template <class Enum>
struct Words;  // has `takes`, `words` and `values`

template <class Enum>
struct WordRule : Words<Enum> {
    static bool read(const Value& value, Enum& out, std::string&) {
        if (!value.is(Value::Kind::text)) return false;
        for (std::size_t i = 0; i < Words<Enum>::words.size(); ++i) {
            if (value.text() != Words<Enum>::words[i]) continue;
            out = Words<Enum>::values[i];
            return true;
        }
        return false;
    }
};

// --- Lists

/// Reads every element with `one`; `instead` names the first that does not fit.
template <class Element, class Read>
bool read_list(const Value& value, std::vector<Element>& out, std::string& instead, Read one) {
    if (!value.is_list()) return false;
    out.resize(value.size());
    for (std::uint64_t i = 0; i < value.size(); ++i) {
        const Value element = value.at(i);
        if (element.is_broken()) return false;
        if (one(element, out[i])) continue;
        instead = "one whose element " + std::to_string(i) + " is " + describe(element);
        return false;
    }
    return true;
}

struct Points {
    static constexpr std::string_view takes = "a list of vectors of 3 numbers";
    static bool read(const Value& value, std::vector<Vec3d>& out, std::string& instead) {
        return read_list(value, out, instead, read_vector);
    }
};
struct Colors {
    static constexpr std::string_view takes = "a list of colours without negative parts";
    static bool read(const Value& value, std::vector<Vec3d>& out, std::string& instead) {
        return read_list(value, out, instead, [](const Value& one, Vec3d& color) {
            std::string ignored;
            return ColorRule::read(one, color, ignored);
        });
    }
};
struct PlanePoints {
    static constexpr std::string_view takes = "a list of vectors of 2 numbers";
    static bool read(const Value& value, std::vector<Vec2d>& out, std::string& instead) {
        return read_list(value, out, instead, [](const Value& v, Vec2d& point) {
            if (!v.is_vector(2)) return false;
            point = {v.component(0), v.component(1)};
            return true;
        });
    }
};
template <class Element, class Rule, std::size_t count>
struct Exactly {
    template <class Out>
    static bool read(const Value& value, Out& out, std::string& instead) {
        std::vector<Element> all;
        if (!Rule::read(value, all, instead)) return false;
        if (all.size() != count) return false;
        std::array<Element, count> exact{};
        std::copy(all.begin(), all.end(), exact.begin());
        out = exact;
        return true;
    }
};
struct ThreePoints : Exactly<Vec3d, Points, 3> {
    static constexpr std::string_view takes = "a list of 3 vectors of 3 numbers";
};
struct ThreePlanePoints : Exactly<Vec2d, PlanePoints, 3> {
    static constexpr std::string_view takes = "a list of 3 vectors of 2 numbers";
};
struct Net {
    static constexpr std::string_view takes = "a list of rows of vectors of 3 numbers";
    static bool read(const Value& value, std::vector<std::vector<Vec3d>>& out,
                     std::string& instead);
};
struct Faces {
    static constexpr std::string_view takes =
        "a list of faces, each a list of 3 or more indices of vertices";
    static bool read(const Value& value, std::vector<std::vector<std::uint32_t>>& out,
                     std::string& instead);
};

// --- Materials and textures

struct MaterialRule {
    static constexpr std::string_view takes = "a material";
    static bool read(const Value& value, std::uint32_t& out, std::string&) {
        if (!value.is(Value::Kind::material)) return false;
        out = value.index();
        return true;
    }
};

/// The value of a material's `color`.
struct ColorOrTexture {
    Color color{1, 1, 1};
    std::uint32_t texture = none;
    bool of_vertices = false;
};
struct ColorOrTextureRule {
    static constexpr std::string_view takes =
        "a colour, [red, green, blue] or #rrggbb, without negative parts, a texture, or vertex";
    static constexpr std::array<std::string_view, 1> words{"vertex"};
    static bool read(const Value& value, ColorOrTexture& out, std::string& instead) {
        out.of_vertices = value.is(Value::Kind::text) && value.text() == words[0];
        if (out.of_vertices) return true;
        if (!value.is(Value::Kind::texture)) return ColorRule::read(value, out.color, instead);
        out.texture = value.index();
        return true;
    }
};

}  // namespace lancer::rules
