// Every message of the parser, in one place. A test asks for a scene in scenes/bad/ for each.
#pragma once

#include <string_view>

namespace lancer {

// clang-format off
#define LANCER_PARSER_MESSAGES(M) \
    /* Text and syntax */ \
    M(invalid_utf8,           "this byte (0x{}) is not valid UTF-8") \
    M(nul_byte,               "a script cannot hold a NUL byte") \
    M(source_limit,           "more than {} bytes of script") \
    M(too_many_errors,        "more than {} errors: the rest is not shown") \
    M(comment_not_closed,     "this comment has no '*/'") \
    M(string_not_closed,      "this string has no closing '\"' on its line") \
    M(unknown_escape,         "a '\\' in a string is followed by n, t, \" or \\") \
    M(number_runs_on,         "a name cannot follow a number without a blank") \
    M(number_out_of_range,    "this number is out of range") \
    M(color_digits,           "a colour in this form is #rrggbb, six hexadecimal digits") \
    M(expected_member,        "'.' must be followed by x, y or z (a number does not end in '.')") \
    M(expected_expression,    "expected an expression, found {}") \
    M(expected_value,         "'{}' needs a value, found {}") \
    M(expected_close,         "expected ',' or '{}', found {}") \
    M(expected_index_close,   "expected ']' after the index, found {}") \
    M(expected_paren_close,   "expected ')', found {}") \
    M(expected_colon,         "expected ':' and what is chosen otherwise, found {}") \
    M(expected_element,       "expected ':' and the element that is computed, found {}") \
    M(expected_name,          "expected a name, found {}") \
    M(name_reserved,          "'{}' is a word of the language and cannot be a name") \
    M(expected_equals,        "expected '=', found {}") \
    M(value_missing,          "'{}' is given no value") \
    M(expected_parameters,    "expected '(' and the {}'s parameters, found {}") \
    M(expected_in,            "expected 'in', found {}") \
    M(expected_open_brace,    "expected '{{', found {}") \
    M(missing_close_brace,    "missing '}}' before {}") \
    M(stray_close_brace,      "this '}}' closes nothing") \
    M(stray_separator,        "'{}' has no place here: statements and properties are separated by blanks alone") \
    M(stray_equals,           "a property is written without '='") \
    M(hash_comment,           "'#' begins a colour, and no statement") \
    M(values_do_not_change,   "'{}' has a value, and values do not change") \
    M(expected_statement,     "expected a statement or a property, found {}") \
    M(after_definition,       "expected nothing after the value, found {}") \
    M(nesting_limit,          "nested more than {} levels deep") \
    /* Names */ \
    M(name_not_defined,       "'{}' is not defined") \
    M(function_not_defined,   "there is no function or template '{}'") \
    M(already_defined,        "'{}' is already defined in this scope") \
    M(template_as_value,      "'{}' is a template, which has no value") \
    M(function_as_value,      "'{}' is a function: its arguments are missing") \
    M(function_as_statement,  "'{}' is a function: its value is not used here") \
    M(not_a_template,         "'{}' is not a template: it cannot be called") \
    M(template_in_expression, "'{}' is a template: it stands as a statement and has no value") \
    M(template_takes_word,    "a template cannot be called '{}', as a property of groups is") \
    M(block_as_call,          "'{}' is a block: what it holds stands in braces") \
    M(param_not_at_top,       "a param stands at file level only") \
    /* Calls */ \
    M(missing_argument,       "'{}' needs a value for '{}'") \
    M(too_many_arguments,     "'{}' takes {}, not {}") \
    M(unknown_argument,       "'{}' has no parameter '{}'") \
    M(argument_twice,         "'{}' is given twice") \
    M(positional_after_named, "an argument without a name cannot follow one with a name") \
    M(named_to_function,      "functions of the language take no named arguments") \
    M(function_count,         "'{}' takes {}, not {}") \
    M(function_argument,      "'{}' takes {}, not {}") \
    M(function_domain,        "'{}' is not defined for {}") \
    /* Expressions */ \
    M(operator_operands,      "'{}' does not work on {} and {}") \
    M(operator_operand,       "'{}' does not work on {}") \
    M(division_by_zero,       "division by zero") \
    M(power_domain,           "a negative number has no power that is not whole ({} ^ {})") \
    M(not_finite,             "the result is not a finite number") \
    M(vector_sizes,           "'{}' of vectors with {} and {} components") \
    M(condition_type,         "{} takes true or false, not {}") \
    M(index_type,             "an index is a whole number, not {}") \
    M(index_range,            "index {} is out of range: the {} has {}") \
    M(slice_range,            "from {} to {} is out of range: the {} has {}") \
    M(not_a_list,             "{} has no elements") \
    M(no_member,              "{} has no component '{}'") \
    M(list_depth,             "lists nested more than {} levels deep") \
    M(css_unknown,            "the web has no colour '{}'") \
    /* Statements */ \
    M(range_bound,            "a range goes from one whole number to another, not to or from {}") \
    M(range_step_zero,        "the step of range() is zero") \
    M(loop_type,              "'for' runs over a range or a list, not {}") \
    M(assertion_failed,       "assertion failed: {}") \
    M(assertion_message,      "the message of an assertion is a string, not {}") \
    M(include_type,           "'include' takes a string, not {}") \
    M(include_cycle,          "this include is a cycle: {}") \
    M(file_unreadable,        "{}") \
    M(statement_limit,        "more than {} statements executed") \
    M(call_limit,             "more than {} nested calls and includes") \
    M(element_limit,          "more than {} list elements made") \
    M(held_limit,             "lists of more than {} bytes at one time") \
    M(text_limit,             "more than {} bytes of strings made") \
    M(object_limit,           "more than {} {}") \
    /* Blocks */ \
    M(unknown_block,          "there is no block '{}'") \
    M(unknown_light,          "there is no light '{}'") \
    M(light_without_kind,     "a light is point, directional or spot") \
    M(unknown_property,       "'{}' is not a property of {}") \
    M(unknown_word,           "there is no statement '{}'") \
    M(property_outside,       "'{}' is a property and stands in a block, not in a file or template") \
    M(property_is_block,      "'{}' is a block: '{{' is missing") \
    M(block_is_property,      "'{}' is a property and takes a value, not a block") \
    M(block_misplaced,        "'{}' cannot stand in {}") \
    M(statement_misplaced,    "'{}' cannot stand in {}, which holds properties only") \
    M(given_twice,            "'{}' is given twice") \
    M(property_missing,       "{} needs {}") \
    M(property_takes,         "'{}' takes {}, not {}") \
    M(block_name_missing,     "this {} needs a name") \
    M(block_takes_no_name,    "{} takes no name") \
    M(camera_twice,           "there is already a camera '{}'") \
    /* Cameras and lights */ \
    M(look_at_is_position,    "'look_at' is the camera's own position") \
    M(up_along_view,          "'up' points along the view") \
    M(fov_of_orthographic,    "an orthographic camera has a height, not a field of view") \
    M(height_of_perspective,  "a perspective camera has a field of view, not a height") \
    M(height_missing,         "an orthographic camera needs 'height'") \
    M(spot_without_direction, "the spot's 'look_at' is its own position") \
    M(falloff_below_radius,   "the spot's falloff ({}) is less than its radius ({})") \
    /* Shapes */ \
    M(box_corners,            "each component of 'max' must be at least that of 'min'") \
    M(axis_is_point,          "'base' and 'top' are the same point") \
    M(cone_without_radius,    "a cone needs a radius greater than 0 at one end") \
    M(torus_crosses,          "a tube of {} is wider than its ring of {}: the surface would cross itself on the axis") \
    M(element_count,          "'{}' has {}, but there are {}") \
    M(mesh_two_ways,          "a mesh has either 'file' or 'vertices' and 'faces'") \
    M(face_index,             "face {} names vertex {}, but there are {}") \
    M(net_ragged,             "row {} of 'control' has {}, the first row has {}") \
    M(net_bezier,             "a bezier patch has 4 x 4 control points, not {} x {}") \
    M(net_bspline,            "a bspline patch has 4 x 4 control points or more, not {} x {}") \
    M(profile_count,          "a {} profile has {} points, not {}") \
    M(outline_count,          "a {} outline has {} points, not {}") \
    M(profile_negative,       "the profile's curve has a negative radius near height {}") \
    M(profile_swings,         "the profile's curve swings to a negative radius near height {}, though no point of it has one") \
    M(outline_crosses,        "the outline crosses itself near [{}, {}]") \
    M(prism_upside_down,      "'top' must be greater than 'bottom'") \
    M(transform_singular,     "these transforms leave nothing of the object: together they are singular or out of range") \
    M(sheet_in_body,          "{} has no inside: only bodies can be joined, intersected and cut") \
    M(body_of_nothing,        "there is no body in this {}") \
    M(light_in_body,          "a light is no body: it stands beside what is joined, intersected or cut") \
    /* Materials and textures */ \
    M(passes_too_much,        "'filter' + 'transmission' is {}, more than 1") \
    M(texture_patterns,       "a texture has one of 'image', 'checker' and 'gradient'") \
    M(texture_option,         "'{}' belongs to a texture with '{}'") \
    M(stops_missing,          "a gradient needs 'stops'") \
    M(sky_stop,               "the stops of a sky lie between -1 and 1, not at {}") \
    M(sky_and_background,     "a sky stands in place of the background: one of the two") \
    M(no_vertex_colors,       "the material takes the colours of vertices, and {}") \
    M(stops_order,            "the stops of a gradient must not go back: {} follows {}") \
    /* Command line */ \
    M(unknown_definition,     "-D {}: the scene has no param of this name") \
    M(definition_is_block,    "a material or texture stands in the script, and cannot be given here") \
    /* Warnings */ \
    M(template_and_block,     "'{}' is a block, too: '{}(...)' calls this template") \
    M(hides_function,         "'{}' is a function of the language, too: from here on this one is called") \
    M(color_far_above_white,  "the colour {} is far brighter than white") \
    M(fov_of_radians,         "a field of view of {} degrees is that of a telescope") \
    M(angle_of_degrees,       "'{}' takes radians, and {} is more than a whole turn") \
    M(degenerate_triangles,   "{} dropped: the corners are on one line") \
    M(mesh_file,              "{}") \
    M(degenerate_triangle,    "this triangle's corners are on one line: nothing is drawn") \
    M(all_points_equal,       "all points of this {} are equal: nothing is drawn") \
    M(shadow_of_part,         "a part has no shadow of its own: 'shadow' counts where it is said of the whole body") \
    /* Notes */ \
    M(first_here,             "first here") \
    M(defined_later,          "defined here, later") \
    M(defined_elsewhere,      "defined here, within other braces") \
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
