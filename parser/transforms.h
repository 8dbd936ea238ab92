// The transforms of a block, composed in extended precision.
#pragma once

#include <string>

#include "model/affine.h"
#include "parser/field.h"

namespace lancer {

using Transform = Affine<long double>;

/// Transforms in the order written, composed to one map.
struct TransformList {
    Transform map;
    bool given = false;

    void append(const Transform& next);
};

/// True when rounding the entries to double could make the linear part singular: its determinant is
/// smaller than the error bound. The bound is a multiple of the permanent of the absolute values
/// and no absolute constant, so scaling a row or column changes nothing.
bool is_singular(const Transform& m);

/// Rounds to double. False when the result is singular or not finite.
bool round_transform(const Transform& exact, Affine<double>& rounded);

/// The rules of transform properties, for tables: `Member` is a TransformList.
namespace transform_rules {

struct Translate {
    static constexpr std::string_view takes = "a vector of 3 numbers";
    static bool read(const Value& value, TransformList& out, std::string& instead);
};
struct Scale {
    static constexpr std::string_view takes = "a number or a vector of 3 numbers, none of them 0";
    static bool read(const Value& value, TransformList& out, std::string& instead);
};
struct RotateX {
    static constexpr std::string_view takes = "an angle in degrees";
    static bool read(const Value& value, TransformList& out, std::string& instead);
};
struct RotateY {
    static constexpr std::string_view takes = "an angle in degrees";
    static bool read(const Value& value, TransformList& out, std::string& instead);
};
struct RotateZ {
    static constexpr std::string_view takes = "an angle in degrees";
    static bool read(const Value& value, TransformList& out, std::string& instead);
};
struct Rotate {
    static constexpr std::string_view takes = "[axis, angle]: a vector that is not 0, and degrees";
    static bool read(const Value& value, TransformList& out, std::string& instead);
};
struct Matrix {
    static constexpr std::string_view takes = "3 rows of 4 numbers that are not singular";
    static bool read(const Value& value, TransformList& out, std::string& instead);
};

}  // namespace transform_rules

}  // namespace lancer
