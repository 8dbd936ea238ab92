// Values of the scene language.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lancer {

struct List;
struct Text;

/// A value of 32 bytes. Lists and strings are shared and never change. Not thread-safe.
class Value {
  public:
    enum class Kind : std::uint8_t {
        broken,  ///< the result of a reported error: causes no further messages
        number,
        boolean,
        vector,  ///< a list of 2 or 3 numbers
        text,
        list,      ///< any other list
        material,  ///< an index into Scene::materials
        texture,   ///< an index into Scene::textures
    };

    Value() = default;
    explicit Value(double number) : kind_(Kind::number) { data_.numbers[0] = number; }
    explicit Value(bool boolean) : kind_(Kind::boolean) { data_.index = boolean; }
    Value(double x, double y) : kind_(Kind::vector), size_(2) {
        data_.numbers[0] = x;
        data_.numbers[1] = y;
    }
    Value(double x, double y, double z) : kind_(Kind::vector), size_(3) {
        data_.numbers[0] = x;
        data_.numbers[1] = y;
        data_.numbers[2] = z;
    }
    explicit Value(std::string text);
    /// Makes a vector of two or three numbers.
    explicit Value(std::vector<Value> elements);
    /// The same without a second copy: the elements are moved.
    static Value list_of(std::span<Value> elements);
    /// start + i·step for 0 <= i < count; the elements are not stored.
    static Value of_range(double start, double step, std::uint64_t count);
    static Value material(std::uint32_t index) { return {Kind::material, index}; }
    static Value texture(std::uint32_t index) { return {Kind::texture, index}; }

    Value(const Value& other) noexcept
        : kind_(other.kind_), size_(other.size_), data_(other.data_) {
        if (is_shared()) share();
    }
    Value(Value&& other) noexcept : kind_(other.kind_), size_(other.size_), data_(other.data_) {
        other.kind_ = Kind::broken;
    }
    Value& operator=(Value other) noexcept {
        std::swap(kind_, other.kind_);
        std::swap(size_, other.size_);
        std::swap(data_, other.data_);
        return *this;
    }
    ~Value() {
        if (is_shared()) release();
    }

    Kind kind() const { return kind_; }
    bool is(Kind kind) const { return kind_ == kind; }
    bool is_broken() const { return kind_ == Kind::broken; }
    bool is_number() const { return kind_ == Kind::number; }
    bool is_vector(unsigned size) const { return kind_ == Kind::vector && size_ == size; }
    bool is_list() const { return kind_ == Kind::list || kind_ == Kind::vector; }

    double number() const { return data_.numbers[0]; }
    bool boolean() const { return data_.index != 0; }
    std::uint32_t index() const { return data_.index; }
    /// `component` and `dimension` are for vectors.
    double component(unsigned i) const { return data_.numbers[i]; }
    unsigned dimension() const { return size_; }
    std::string_view text() const;
    /// The number of characters of a string; counted once.
    std::uint64_t characters() const;

    /// `size` and `at` are for lists and vectors.
    std::uint64_t size() const;
    Value at(std::uint64_t i) const;
    /// The size in bytes of all lists and strings that this thread holds.
    static std::uint64_t held_bytes();
    /// How deep lists are nested; 0 for values that are not lists.
    std::uint32_t depth() const;

  private:
    explicit Value(List* list);
    Value(Kind kind, std::uint32_t index) : kind_(kind) { data_.index = index; }
    bool is_shared() const { return kind_ == Kind::text || kind_ == Kind::list; }
    void share() const noexcept;
    void release() noexcept;

    Kind kind_ = Kind::broken;
    std::uint8_t size_ = 0;
    union {
        double numbers[3];
        std::uint32_t index;
        List* list;
        Text* text;
    } data_{};
};

/// A value as text. Numbers have the shortest text that reads back as the same number; strings
/// within lists are in quotes. The text is about `longest` bytes at most.
std::string to_text(const Value& value, std::size_t longest);
/// A number as the shortest text that reads back as the same number.
std::string to_text(double number);
/// A value as a short text for messages; it names the kind where the text does not show it.
std::string describe(const Value& value);
/// The kind of a value: "a number", "a vector of 3 numbers".
std::string kind_name(const Value& value);

}  // namespace lancer
