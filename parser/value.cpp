#include "parser/value.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace lancer {

struct Text {
    std::uint64_t uses = 1;
    std::string text;
};

struct List {
    std::uint64_t uses = 1;
    std::uint64_t size = 0;
    std::uint32_t depth = 1;
    double start = 0, step = 0;   ///< of a range
    std::vector<double> numbers;  ///< a list of numbers
    std::vector<Value> items;     ///< any other
};

Value::Value(std::string text) : kind_(Kind::text) {
    data_.text = new Text{1, std::move(text)};
}

Value::Value(std::vector<Value> elements) {
    const bool numbers =
        std::all_of(elements.begin(), elements.end(), [](const Value& v) { return v.is_number(); });
    if (numbers) {
        std::vector<double> plain(elements.size());
        std::transform(elements.begin(), elements.end(), plain.begin(),
                       [](const Value& v) { return v.number(); });
        *this = of_numbers(std::move(plain));
        return;
    }
    kind_ = Kind::list;
    data_.list = new List;
    data_.list->size = elements.size();
    for (const Value& v : elements) data_.list->depth = std::max(data_.list->depth, v.depth() + 1);
    data_.list->items = std::move(elements);
}

Value Value::of_numbers(std::vector<double> elements) {
    if (elements.size() == 2) return {elements[0], elements[1]};
    if (elements.size() == 3) return {elements[0], elements[1], elements[2]};
    Value result;
    result.kind_ = Kind::list;
    result.data_.list = new List;
    result.data_.list->size = elements.size();
    result.data_.list->numbers = std::move(elements);
    return result;
}

Value Value::of_range(double start, double step, std::uint64_t count) {
    if (count == 2) return {start, start + step};
    if (count == 3) return {start, start + step, start + 2 * step};
    Value result;
    result.kind_ = Kind::list;
    result.data_.list = new List;
    result.data_.list->size = count;
    result.data_.list->start = start;
    result.data_.list->step = step;
    return result;
}

void Value::share() const noexcept {
    if (kind_ == Kind::text)
        ++data_.text->uses;
    else
        ++data_.list->uses;
}

// Lists nest at most as deep as the limit on nesting, so this recursion is bounded.
void Value::release() noexcept {
    if (kind_ == Kind::text) {
        if (--data_.text->uses == 0) delete data_.text;
    } else {
        if (--data_.list->uses == 0) delete data_.list;
    }
}

std::string_view Value::text() const {
    return data_.text->text;
}

std::uint64_t Value::size() const {
    return kind_ == Kind::vector ? size_ : data_.list->size;
}

Value Value::at(std::uint64_t i) const {
    if (kind_ == Kind::vector) return Value(data_.numbers[i]);
    const List& list = *data_.list;
    if (!list.items.empty()) return list.items[i];
    if (!list.numbers.empty()) return Value(list.numbers[i]);
    return Value(list.start + static_cast<double>(i) * list.step);
}

std::uint32_t Value::depth() const {
    if (kind_ == Kind::vector) return 1;
    return kind_ == Kind::list ? data_.list->depth : 0;
}

std::string to_text(double number) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return {buffer.data(), end};
}

namespace {

void append(std::string& out, const Value& value, bool quoted, std::size_t longest) {
    if (out.size() > longest) return;
    switch (value.kind()) {
        case Value::Kind::broken:
            out += "?";
            break;
        case Value::Kind::number:
            out += to_text(value.number());
            break;
        case Value::Kind::boolean:
            out += value.boolean() ? "true" : "false";
            break;
        case Value::Kind::text:
            if (quoted) out += '"';
            out += value.text();
            if (quoted) out += '"';
            break;
        case Value::Kind::vector:
        case Value::Kind::list:
            out += '[';
            for (std::uint64_t i = 0; i < value.size() && out.size() <= longest; ++i) {
                if (i > 0) out += ", ";
                append(out, value.at(i), true, longest);
            }
            out += ']';
            break;
        case Value::Kind::material:
            out += "a material";
            break;
        case Value::Kind::texture:
            out += "a texture";
            break;
    }
}

}  // namespace

std::string to_text(const Value& value, std::size_t longest) {
    std::string out;
    append(out, value, false, longest);
    return out;
}

std::string describe(const Value& value) {
    constexpr std::size_t longest = 40;
    switch (value.kind()) {
        case Value::Kind::text: {
            if (value.text().size() > longest) return "a string";
            return '"' + std::string(value.text()) + '"';
        }
        case Value::Kind::list:
            return kind_name(value);
        default:
            return to_text(value, longest);
    }
}

std::string kind_name(const Value& value) {
    switch (value.kind()) {
        case Value::Kind::broken:
            return "nothing";
        case Value::Kind::number:
            return "a number";
        case Value::Kind::boolean:
            return value.boolean() ? "true" : "false";
        case Value::Kind::text:
            return "a string";
        case Value::Kind::vector:
            return value.dimension() == 2 ? "a vector of 2 numbers" : "a vector of 3 numbers";
        case Value::Kind::list:
            if (value.size() == 0) return "an empty list";
            return "a list of " + std::to_string(value.size()) +
                   (value.size() == 1 ? " element" : " elements");
        case Value::Kind::material:
            return "a material";
        case Value::Kind::texture:
            return "a texture";
    }
    return "";
}

}  // namespace lancer
