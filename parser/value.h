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

/// A value: 32 bytes; lists and strings are shared and never change. Not for several threads.
class Value {
  public:
    enum class Kind : std::uint8_t {
        broken,  ///< of something that was wrong and has been reported: silences what follows
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
    /// The same, without storing them apart: the elements are moved from.
    static Value list_of(std::span<Value> elements);
    /// start + i·step for 0 <= i < count, without storing them.
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
    /// Of a vector.
    double component(unsigned i) const { return data_.numbers[i]; }
    unsigned dimension() const { return size_; }
    std::string_view text() const;
    /// Of a string: how many characters it has, counted once.
    std::uint64_t characters() const;

    /// Of lists and vectors.
    std::uint64_t size() const;
    Value at(std::uint64_t i) const;
    /// Bytes of all lists and strings that this thread holds.
    static std::uint64_t held_bytes();
    /// Lists within lists; 0 for what is no list.
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

/// A value as text: numbers as the shortest text that reads back the same, strings in lists in
/// quotes. At most about `longest` bytes.
std::string to_text(const Value& value, std::size_t longest);
/// A number as the shortest text that reads back the same.
std::string to_text(double number);
/// A value for a message: short, with what it is where its text does not say so.
std::string describe(const Value& value);
/// What kind of value it is: "a number", "a vector of 3 numbers".
std::string kind_name(const Value& value);

}  // namespace lancer
