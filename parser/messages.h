// Every message of the parser. A test requires a scene in scenes/bad/ for each.
#pragma once

#include <string_view>

namespace lancer {

// clang-format off
#define LANCER_PARSER_MESSAGES(M) \
    /* Text and syntax */ \
    M(invalid_utf8,           "this byte (0x{}) is not valid UTF-8") \
    M(nul_byte,               "a script cannot contain a NUL byte") \
    M(source_limit,           "the source files have more than {} bytes") \
    M(too_many_errors,        "there are more than {} errors: the others are not shown") \
    M(comment_not_closed,     "this comment has no closing '*/'") \
    M(string_not_closed,      "this string has no closing '\"' on its line") \
    M(unknown_escape,         "in a string, '\\' must be followed by n, t, \" or \\") \
    M(number_runs_on,         "a name after a number must be separated from it by a space") \
    M(number_out_of_range,    "this number is out of range") \
    M(color_digits,           "a colour needs six hexadecimal digits after '#', as in #rrggbb") \
    M(expected_member,        "'.' must be followed by x, y or z (a number cannot end in '.')") \
    M(expected_expression,    "expected an expression, found {}") \
    M(expected_value,         "'{}' needs a value, found {}") \
    M(expected_close,         "expected ',' or '{}', found {}") \
    M(expected_index_close,   "expected ']' after the index, found {}") \
    M(expected_paren_close,   "expected ')', found {}") \
    M(expected_colon,         "expected ':' and the value for the other case, found {}") \
    M(expected_element,       "expected ':' and the expression for the elements, found {}") \
    M(expected_name,          "expected a name, found {}") \
    M(name_reserved,          "'{}' is a reserved word and cannot be a name") \
    M(expected_equals,        "expected '=', found {}") \
    M(value_missing,          "'{}' has no value") \
    M(expected_parameters,    "expected '(' and the parameters of the {}, found {}") \
    M(expected_in,            "expected 'in', found {}") \
    M(expected_open_brace,    "expected '{{', found {}") \
    M(missing_close_brace,    "missing '}}' before {}") \
    M(stray_close_brace,      "this '}}' has no matching opening brace") \
    M(stray_separator,        "'{}' is not allowed here: statements and properties are separated by white space only") \
    M(stray_equals,           "a property is written without '='") \
    M(hash_comment,           "'#' starts a colour, not a statement") \
    M(values_do_not_change,   "'{}' already has a value, and a value cannot be changed") \
    M(expected_statement,     "expected a statement or a property, found {}") \
    M(after_definition,       "expected the end after the value, found {}") \
    M(nesting_limit,          "the nesting is more than {} levels deep") \
    /* Names */ \
    M(name_not_defined,       "'{}' is not defined") \
    M(function_not_defined,   "there is no function or template '{}'") \
    M(already_defined,        "'{}' is already defined in this scope") \
    M(template_as_value,      "'{}' is a template and has no value") \
    M(function_as_value,      "'{}' is a function: its arguments are missing") \
    M(function_as_statement,  "'{}' is a function: its value must be used, it cannot be a statement") \
    M(not_a_template,         "'{}' cannot be called: it is not a template") \
    M(template_in_expression, "'{}' is a template: it is called as a statement and has no value") \
    M(template_takes_word,    "a template cannot be named '{}': a property of groups has this name") \
    M(block_as_call,          "'{}' is a block: its contents must be in braces") \
    M(param_not_at_top,       "a param is allowed only at file level") \
    /* Calls */ \
    M(missing_argument,       "'{}' needs a value for '{}'") \
    M(too_many_arguments,     "'{}' takes {}, not {}") \
    M(unknown_argument,       "'{}' has no parameter '{}'") \
    M(argument_twice,         "'{}' is given twice") \
    M(positional_after_named, "an argument without a name cannot follow one with a name") \
    M(named_to_function,      "built-in functions take no named arguments") \
    M(function_count,         "'{}' takes {}, not {}") \
    M(function_argument,      "'{}' takes {}, not {}") \
    M(function_domain,        "'{}' is not defined for {}") \
    /* Expressions */ \
    M(operator_operands,      "'{}' cannot be applied to {} and {}") \
    M(operator_operand,       "'{}' cannot be applied to {}") \
    M(division_by_zero,       "division by zero") \
    M(power_domain,           "a negative number can only be raised to a whole power ({} ^ {})") \
    M(not_finite,             "the result is not a finite number") \
    M(vector_sizes,           "'{}' needs vectors of the same size, not with {} and {} components") \
    M(condition_type,         "{} takes true or false, not {}") \
    M(index_type,             "an index must be a whole number, not {}") \
    M(index_range,            "index {} is out of range: the {} has {}") \
    M(slice_range,            "the range from {} to {} is not within the {}, which has {}") \
    M(not_a_list,             "{} has no elements") \
    M(no_member,              "{} has no component '{}'") \
    M(list_depth,             "lists are nested more than {} levels deep") \
    M(css_unknown,            "there is no CSS colour '{}'") \
    /* Statements */ \
    M(range_bound,            "the ends of a range must be whole numbers, not {}") \
    M(range_step_zero,        "the step of range() is zero") \
    M(loop_type,              "'for' needs a range or a list, not {}") \
    M(assertion_failed,       "assertion failed: {}") \
    M(assertion_message,      "the message of an assertion must be a string, not {}") \
    M(include_type,           "'include' takes a string, not {}") \
    M(include_cycle,          "files include each other in a cycle: {}") \
    M(file_unreadable,        "{}") \
    M(statement_limit,        "more than {} statements were executed") \
    M(call_limit,             "calls and includes are nested more than {} levels deep") \
    M(element_limit,          "more than {} list elements were created") \
    M(held_limit,             "lists take more than {} bytes at one time") \
    M(text_limit,             "more than {} bytes of strings were created") \
    M(object_limit,           "the scene has more than {} {}") \
    /* Blocks */ \
    M(unknown_block,          "there is no block '{}'") \
    M(unknown_light,          "there is no light '{}'") \
    M(light_without_kind,     "a light needs its kind: point, directional or spot") \
    M(unknown_property,       "'{}' is not a property of {}") \
    M(unknown_word,           "there is no statement '{}'") \
    M(property_outside,       "'{}' is a property: it belongs in a block, not in a file or template") \
    M(property_is_block,      "'{}' is a block: '{{' is missing") \
    M(block_is_property,      "'{}' is a property and takes a value, not a block") \
    M(block_misplaced,        "'{}' is not allowed in {}") \
    M(statement_misplaced,    "'{}' is not allowed in {}, which can hold only properties") \
    M(given_twice,            "'{}' is given twice") \
    M(property_missing,       "{} needs {}") \
    M(property_takes,         "'{}' takes {}, not {}") \
    M(block_name_missing,     "this {} needs a name") \
    M(block_takes_no_name,    "{} takes no name") \
    M(camera_twice,           "there is already a camera '{}'") \
    /* Cameras and lights */ \
    M(look_at_is_position,    "the camera's 'look_at' and 'position' are the same point") \
    M(up_along_view,          "'up' is parallel to the viewing direction") \
    M(fov_of_orthographic,    "an orthographic camera takes 'height', not 'fov'") \
    M(height_of_perspective,  "a perspective camera takes 'fov', not 'height'") \
    M(height_missing,         "an orthographic camera needs 'height'") \
    M(spot_without_direction, "the spot light's 'look_at' and 'position' are the same point") \
    M(falloff_below_radius,   "the spot light's 'falloff' ({}) is less than its 'radius' ({})") \
    /* Shapes */ \
    M(box_corners,            "each component of 'max' must be at least that of 'min'") \
    M(axis_is_point,          "'base' and 'top' are the same point") \
    M(cone_without_radius,    "a cone needs a radius greater than 0 at one end") \
    M(torus_crosses,          "the radius of the tube ({}) is larger than that of the ring ({}): the surface would cross itself on the axis") \
    M(element_count,          "'{}' has {}, but there are {}") \
    M(mesh_two_ways,          "a mesh takes either 'file', or 'vertices' and 'faces'") \
    M(face_index,             "face {} refers to vertex {}, but there are {}") \
    M(net_ragged,             "row {} of 'control' has {}, the first row has {}") \
    M(net_bezier,             "a bezier patch needs 4 x 4 control points, not {} x {}") \
    M(net_bspline,            "a bspline patch needs at least 4 x 4 control points, not {} x {}") \
    M(profile_count,          "a {} profile needs {} points, not {}") \
    M(outline_count,          "a {} outline needs {} points, not {}") \
    M(profile_negative,       "the profile's curve has a negative radius near height {}") \
    M(profile_swings,         "the profile's curve reaches a negative radius near height {}, although none of its points has one") \
    M(outline_crosses,        "the outline crosses itself near [{}, {}]") \
    M(prism_upside_down,      "'top' must be greater than 'bottom'") \
    M(transform_singular,     "these transforms together are singular or out of range: nothing is left of the object") \
    M(sheet_in_body,          "{} has no inside: only bodies can be parts of a union, an intersection or a difference") \
    M(body_of_nothing,        "this {} contains no body") \
    M(light_in_body,          "a light is not a body: it must be outside of unions, intersections and differences") \
    /* Materials and textures */ \
    M(passes_too_much,        "the sum of 'filter' and 'transmission' is {}, but must not be more than 1") \
    M(texture_patterns,       "a texture needs exactly one of 'image', 'checker' and 'gradient'") \
    M(texture_option,         "'{}' is allowed only in a texture with '{}'") \
    M(stops_missing,          "a gradient needs 'stops'") \
    M(sky_stop,               "the stops of a sky must be between -1 and 1, not at {}") \
    M(sky_and_background,     "a scene can have a sky or a background, not both") \
    M(no_vertex_colors,       "the material uses the colours of vertices, but {}") \
    M(stops_order,            "the stops of a gradient must not decrease: {} follows {}") \
    /* Command line */ \
    M(unknown_definition,     "-D {}: the scene has no param of this name") \
    M(definition_is_block,    "a material or texture cannot be given here: it must be defined in the script") \
    /* Warnings */ \
    M(template_and_block,     "'{}' is also a block: '{}(...)' calls this template") \
    M(hides_function,         "'{}' is also a built-in function: from here on this definition is called instead") \
    M(color_far_above_white,  "the colour {} is far brighter than white") \
    M(fov_of_radians,         "the field of view 'fov {}' is very narrow") \
    M(angle_of_degrees,       "'{}' takes radians, but {} is more than a full turn") \
    M(degenerate_triangles,   "{} left out: the corners are on one line") \
    M(mesh_file,              "{}") \
    M(degenerate_triangle,    "this triangle's corners are on one line: nothing is drawn") \
    M(all_points_equal,       "all points of this {} are equal: nothing is drawn") \
    M(shadow_of_part,         "a part has no shadow of its own: 'shadow' must be given for the whole body") \
    /* Notes */ \
    M(first_here,             "first here") \
    M(defined_later,          "it is defined later, here") \
    M(defined_elsewhere,      "it is defined here, within other braces") \
    M(opened_here,            "opened here") \
    M(called_here,            "called here, '{}'") \
    M(included_here,          "included here") \
    M(more_calls,             "... {} more calls")
// clang-format on

enum class Message {
#define LANCER_MESSAGE_ID(id, text) id,
    LANCER_PARSER_MESSAGES(LANCER_MESSAGE_ID)
#undef LANCER_MESSAGE_ID
};

/// Format strings of libfmt, in the order of `Message`.
inline constexpr std::string_view message_texts[] = {
#define LANCER_MESSAGE_TEXT(id, text) text,
    LANCER_PARSER_MESSAGES(LANCER_MESSAGE_TEXT)
#undef LANCER_MESSAGE_TEXT
};

constexpr std::string_view text_of(Message message) {
    return message_texts[static_cast<std::size_t>(message)];
}

}  // namespace lancer
