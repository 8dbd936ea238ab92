// The fields that every shape and group takes.
#pragma once

#include "parser/field.h"
#include "parser/rules.h"
#include "parser/scene_builder.h"

namespace lancer {

inline constexpr Field attribute_fields[] = {
    field<&Attributes::material, rules::MaterialRule>(
        "material", "the group's, or white", "its material: a name, or material { ... } in place"),
    field<&Attributes::name, rules::String>("name", "none", "its name in statistics and exports"),
    field<&Attributes::shadow, rules::Flag>("shadow", "true", "false: it casts no shadow"),
    repeated_field<&Attributes::transforms, transform_rules::Translate>("translate",
                                                                        "moves it by a vector"),
    repeated_field<&Attributes::transforms, transform_rules::Scale>(
        "scale", "scales it about the origin, by one factor or one for each axis"),
    repeated_field<&Attributes::transforms, transform_rules::RotateX>("rotate_x",
                                                                      "turns it about the x axis"),
    repeated_field<&Attributes::transforms, transform_rules::RotateY>("rotate_y",
                                                                      "turns it about the y axis"),
    repeated_field<&Attributes::transforms, transform_rules::RotateZ>("rotate_z",
                                                                      "turns it about the z axis"),
    repeated_field<&Attributes::transforms, transform_rules::Rotate>(
        "rotate", "turns it about an axis through the origin"),
    repeated_field<&Attributes::transforms, transform_rules::Matrix>(
        "matrix", "maps [x, y, z] to the three rows times [x, y, z, 1]"),
};

}  // namespace lancer
