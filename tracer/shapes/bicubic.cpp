#include "tracer/shapes/bicubic_build.h"

namespace lancer {

template PieceTree<float> make_piece_tree(const Patch&, int);
template PieceTree<double> make_piece_tree(const Patch&, int);
template PieceTree<long double> make_piece_tree(const Patch&, int);
template class BicubicSurface<float>;
template class BicubicSurface<double>;
template class BicubicSurface<long double>;

}  // namespace lancer
