#include "parser/evaluation/builtin_calls.h"

#include <algorithm>
#include <cmath>

namespace lancer {
namespace {

/// Warns about `sin(90)`: a literal angle that can only be meant in degrees.
void warn_of_degrees(const ast::Step& call, const SourceSpan& place, std::string_view function,
                     Report& report) {
    const ast::Step& argument = (&call)[-1];
    if (argument.op != ast::Op::number) return;
    if (function != "sin" && function != "cos" && function != "tan") return;
    constexpr double least = 10;
    const double angle = argument.number();
    if (std::abs(angle) < least || angle != std::floor(angle)) return;
    const std::string degrees = to_text(angle);
    Diagnostic* warning = report.warning(Message::angle_of_degrees, place, function, degrees);
    if (warning != nullptr)
        warning->hint = "for degrees write " + std::string(function) + "(radians(" + degrees + "))";
}

}  // namespace

Value call_builtin(const Function& function, const ast::File& file, const ast::Step& call,
                   ValueStack& stack, const Context& context) {
    Report& report = context.report;
    const std::size_t count = call.high();
    const std::size_t first = stack.size() - count;
    const SourceSpan place = file.span(call);
    const std::span<const Value> arguments = stack.from(first);
    bool good = std::none_of(arguments.begin(), arguments.end(),
                             [](const Value& v) { return v.is_broken(); });
    for (const ValueStack::Label& label : stack.labels_from(first)) {
        report.error(Message::named_to_function, file.span(*label.step));
        good = false;
    }
    if (count < function.least || count > function.most) {
        report.error(Message::function_count, place, function.name,
                     arguments_text(function.least, function.most), count);
        good = false;
    }
    if (!good) return {};
    warn_of_degrees(call, place, function.name, report);
    Value result = function.apply(function.name, arguments, {report, context.meter, place});
    if (is_finite_value(result)) return result;
    report.error(Message::not_finite, place);
    return {};
}

}  // namespace lancer
