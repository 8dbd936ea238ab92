// Numbers and vectors of 256 bits, for checking kernels.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "model/math.h"

namespace lancer::oracle {

using Exact = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<256, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

struct ExactVec {
    Exact x, y, z;
};
inline ExactVec exact(const Vec3d& v) {
    return {v.x, v.y, v.z};
}
inline ExactVec operator+(const ExactVec& a, const ExactVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline ExactVec operator-(const ExactVec& a, const ExactVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline ExactVec operator*(const Exact& s, const ExactVec& v) {
    return {s * v.x, s * v.y, s * v.z};
}
inline ExactVec operator*(const ExactVec& v, const Exact& s) {
    return s * v;
}
inline Exact dot(const ExactVec& a, const ExactVec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline ExactVec cross(const ExactVec& a, const ExactVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Exact length(const ExactVec& v) {
    return sqrt(dot(v, v));
}
inline ExactVec unit_of(const ExactVec& v) {
    return (1 / length(v)) * v;
}

}  // namespace lancer::oracle
