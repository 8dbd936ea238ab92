// Numbers and words in POV-Ray's syntax.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/affine.h"
#include "model/math.h"

namespace lancer::reference::pov {

/// The shortest decimal that reads back as exactly this double: at most 17 digits.
std::string number(double value);
/// Nine digits: enough for single precision, in which POV-Ray stores mesh data.
std::string mesh_number(double value);

/// `<x, y>`, `<x, y, z>`
std::string vector(const Vec2d& v);
std::string vector(const Vec3d& v);
std::string mesh_vector(const Vec2d& v);
std::string mesh_vector(const Vec3d& v);

/// `rgb <r, g, b>`, or `rgb k` for a grey.
std::string rgb(const Color& color);

/// `translate <…>` or `matrix <…>`; empty for the identity.
std::string transform(const Affine<double>& map);

/// `text` for a `//` comment: on one line, without control characters.
std::string comment(std::string_view text);

/// `text` with everything but letters and digits replaced by `_`.
std::string identifier(std::string_view text);

/// Scales lengths by powers of ten, so that short decimal numbers of a script stay short in the
/// export.
struct PowerOfTen {
    int exponent;
    /// The shortest decimal of the length with its decimal point moved, so that 0.0012 becomes 120
    /// and not 119.99999999999999.
    double operator()(double length) const;
    /// The plain product: faster, for data that people do not read.
    Vec3d plainly(const Vec3d& v) const;
    Vec2d operator()(const Vec2d& v) const { return {(*this)(v.x), (*this)(v.y)}; }
    Vec3d operator()(const Vec3d& v) const { return {(*this)(v.x), (*this)(v.y), (*this)(v.z)}; }
    double factor() const { return (*this)(1.0); }
    PowerOfTen inverse() const { return {-exponent}; }
};

/// Collects lines, indented by depth.
class Text {
  public:
    void line(std::string_view text);
    void blank() { out_ += '\n'; }
    void open(std::string_view text) {
        line(text);
        ++depth_;
    }
    /// Writes the items with commas between them, several to a line.
    void list(const std::vector<std::string>& items);
    void close(std::string_view text = "}") {
        --depth_;
        line(text);
    }
    std::string take() { return std::move(out_); }

  private:
    std::string out_;
    int depth_{};
};

}  // namespace lancer::reference::pov
