#include "parser/value.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>

#include "model/utf8.h"

namespace lancer {

namespace {

thread_local std::uint64_t held = 0;

constexpr std::uint64_t of_allocation = 16;  // the heap's own cost for each allocation

}  // namespace

struct Text {
    explicit Text(std::string content) : text(std::move(content)) { held += bytes(); }
    ~Text() { held -= bytes(); }
    Text(const Text&) = delete;
    Text& operator=(const Text&) = delete;

    std::uint64_t bytes() const { return sizeof(Text) + of_allocation + text.capacity(); }

    std::uint64_t uses = 1;
    std::uint64_t characters = 0;  ///< counted at the first use; 0: not yet
    std::string text;
};

struct List {
    explicit List(std::vector<double> all) : size(all.size()), numbers(std::move(all)) {
        held += bytes();
    }
    explicit List(std::vector<Value> all) : size(all.size()), items(std::move(all)) {
        for (const Value& v : items) depth = std::max(depth, v.depth() + 1);
        held += bytes();
    }
    List(double from, double by, std::uint64_t count) : size(count), start(from), step(by) {
        held += bytes();
    }
    ~List() { held -= bytes(); }
    List(const List&) = delete;
    List& operator=(const List&) = delete;

    std::uint64_t bytes() const {
        return sizeof(List) + 2 * of_allocation + numbers.capacity() * sizeof(double) +
               items.capacity() * sizeof(Value);
    }

    std::uint64_t uses = 1;
    std::uint64_t size = 0;
    std::uint32_t depth = 1;
    double start = 0, step = 0;   ///< of a range
    std::vector<double> numbers;  ///< a list of numbers
    std::vector<Value> items;     ///< any other
};

std::uint64_t Value::held_bytes() {
    return held;
}

Value::Value(std::string text) : kind_(Kind::text) {
    data_.text = new Text(std::move(text));
}

Value::Value(List* list) : kind_(Kind::list) {
    data_.list = list;
}

Value::Value(std::vector<Value> elements) : Value(list_of(elements)) {}

Value Value::list_of(std::span<Value> elements) {
    const bool numbers =
        std::all_of(elements.begin(), elements.end(), [](const Value& v) { return v.is_number(); });
    if (!numbers)
        return Value(new List(std::vector<Value>(std::make_move_iterator(elements.begin()),
                                                 std::make_move_iterator(elements.end()))));
    if (elements.size() == 2) return {elements[0].number(), elements[1].number()};
    if (elements.size() == 3)
        return {elements[0].number(), elements[1].number(), elements[2].number()};
    std::vector<double> plain(elements.size());
    std::transform(elements.begin(), elements.end(), plain.begin(),
                   [](const Value& v) { return v.number(); });
    return Value(new List(std::move(plain)));
}

Value Value::of_range(double start, double step, std::uint64_t count) {
    if (count == 2) return {start, start + step};
    if (count == 3) return {start, start + step, start + 2 * step};
    return Value(new List(start, step, count));
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

std::uint64_t Value::characters() const {
    Text& text = *data_.text;
    if (text.characters == 0) text.characters = count_characters(text.text);
    return text.characters;
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
