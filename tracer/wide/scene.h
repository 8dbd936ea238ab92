// The world as wide code reads it: plain numbers in plain arrays. This header defines no functions
// and uses no templates of the standard library: see lanes_avx512.h.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lancer::wide {

inline constexpr std::uint32_t nothing = 0xFFFFFFFF;  ///< lancer::none

/// BvhNode<double>, with the same layout.
struct Node {
    float min[3][8];
    float max[3][8];
    std::uint32_t child[8];
    std::uint32_t count[8];
};

struct Tree {
    const Node* nodes;
    std::size_t node_count;
    double min[3];  ///< of the whole tree
    double max[3];
};

/// BallSolid<double>
struct Ball {
    double center[3];
    double radius;
    double transform_error;
    double filter_error;
};

/// HalfSpace<double>
struct Plane {
    double normal[3];
    double point[3];
    double transform_error;
    double filter_error;
    double offset;
    double unit_normal[3];  ///< unit(normal)
};

/// BoxSolid<double>
struct Box {
    double min[3], max[3];
    double transform_error;
};

/// FrustumSolid<double>. Fills two cache lines.
struct alignas(64) Frustum {
    double small_end[3], large_end[3], axis[3];
    double height, radius, slope, filter_error, transform_error;
    bool capped, tilted;
};

/// The flat part of a ball, in the world, that a torus lies in: discs.h.
struct Disc {
    double center[3];
    double axis[3];         ///< times a vector: how far it climbs in the torus' own space
    double radius, height;  ///< in the world; in the torus' own space
    double blur, lift;      ///< what a displacement of a ray adds to both, per length
};

/// TorusSolid<double>
struct Torus {
    double ring, tube, shrink, grow;
    std::uint32_t frame;  ///< index into Scene::frames; `nothing`: in world space
    Disc disc;
};

/// Frame<double>
struct Frame {
    double to_world[3][3];
    double shift[3];
    double linear_inverse[3][3];
    double norm, inverse_norm, transform_error;
    bool keeps_digits;
};

/// TriangleLeaf<double>, with the same layout.
struct TriangleBlock {
    double corner[3][3][4];
    std::uint32_t face[4];
};

/// TriangleMesh<double>, smooth or not
struct MeshShape {
    Tree tree;
    const TriangleBlock* leaves;
    double reach;
    const std::uint8_t* inward;  ///< per face, whether its normal points inside; null: none does
    const double (*vertices)[3];
    const std::uint32_t (*faces)[3];
    const double (*normals)[3];  ///< null: none are interpolated
    const std::uint32_t (*normal_faces)[3];
};

/// splines::Piece<double>
struct PatchPiece {
    double c[3][16];
    double u0, v0, du, dv;
};

/// splines::PieceFrame<double>
struct PieceFrame {
    double row[3][3];
    double row_size[3], low[3], high[3], middle[3], uneven[3];
    double slope;
};

/// PieceTree<double>::Home
struct PatchHome {
    double anchor[3];
    double size;
    double points[16][3];
    double column, row;
};

/// PieceTree<double>, where it lies.
struct PatchShape {
    Tree tree;
    const std::uint32_t* order;  ///< of the items of its leaves
    const PatchPiece* pieces;
    const PieceFrame* frames;
    const std::uint32_t* home;  ///< of each piece
    const PatchHome* homes;
    std::size_t home_count;
};

/// BicubicSolid<double>; its pieces are cut when a ray comes near: ExactMethods::patch()
struct Patch {
    std::uint32_t frame;  ///< index into Scene::frames; `nothing`: in world space
};

/// A mesh with its place: MeshInstance<double>, and those parts of its primitive's frame that map a
/// ray to it. Fills two cache lines.
struct alignas(64) Mesh {
    double shift[3];
    double inverse_norm;
    double inverse_x[3];  ///< first column of linear_inverse
    double transform_error;
    double inverse_y[3];
    const MeshShape* shape;
    double inverse_z[3];
    std::uint32_t frame;  ///< index into Scene::frames; `nothing`: in world space
    bool keeps_digits;
    bool casts_shadow, glassy, clear;  ///< as its item
};

enum class Kind : std::uint8_t {
    ball,  ///< in world space, like boxes and frustums
    box,
    frustum,
    torus,  ///< with or without a transform, like meshes and patches
    mesh,
    patch,
    other,  ///< computed by scalar code
};

struct OtherShape {
    std::uint32_t index = 0;  ///< into the arrays of its kind
    Ball around{};            ///< of a frustum: ball_around()
};

/// Fills one cache line, so that a ray that comes to a ball or a box finds it there.
struct alignas(64) Item {
    std::uint32_t material = 0;
    Kind kind = Kind::other;
    bool convex : 1 = false;
    bool body : 1 = false;
    bool casts_shadow : 1 = true;
    bool glassy : 1 = false;  ///< transmits light, or is a medium
    /// Glassy, and wide code can shade it. Scalar code traces rays that meet other glassy items.
    bool clear : 1 = false;
    union {
        OtherShape shape{};  ///< of the other kinds than these two
        Ball ball;
        Box box;
    };
};

/// Those parts of Finish<double> that wide code uses.
struct Finish {
    double color[3];
    double reflection[3];
    double own[3];  ///< ambient * World::ambient + emission
    double diffuse, phong, shininess, blinn, inverse_roughness, metallic;
    double opacity;
    double transmittance[3];  ///< the share of light that passes, if there is no texture
    double ior;
    double fresnel;  ///< 1: the reflectance follows Fresnel's equations; else 0
    double absorption[3];
    bool absorbs;   ///< light fades inside of its bodies
    bool plain;     ///< wide code computes the local light
    bool textured;  ///< the colour comes from a texture
};

/// A stop of GradientPattern<double>
struct Stop {
    double at;
    double color[3];
};

/// CheckerPattern<double> or GradientPattern<double>
struct Pattern {
    enum class Kind : std::uint8_t { checker, gradient };
    Kind kind;
    double even[3], odd[3];  ///< checkers only
    double axis[3];          ///< gradients only, like `stops`
    const Stop* stops;
    std::uint32_t stop_count;
};

/// The placement of a pattern on one item: Placement<double>.
struct Texture {
    double rows[3][3], shift[3], bound[3], from[3];
    std::uint32_t pattern;
};

struct Light {
    enum class Kind : std::uint8_t {
        point,
        directional,  ///< its direction is `place`
        spot,
    };
    Kind kind;
    bool shadows;  ///< both the light and the settings have shadows
    bool fill;     ///< a light without highlights
    bool fades;
    double place[3];
    double color[3];
    double fade_distance, fade_power;
    double axis[3];  ///< spots only: the direction in which the light travels
    double cos_radius, cos_falloff, tightness;
};

struct Camera {
    double position[3], forward[3], right[3], up[3];
    bool orthographic;
    double width, height;  ///< of the whole picture, in pixels
};

struct Scene {
    Tree tree;
    const Item* items;  ///< in the order of World::primitives
    std::uint32_t bounded;
    std::uint32_t item_count;
    const Plane* planes;  ///< items[bounded..]
    const Mesh* meshes;
    /// The meshes of items[0..bounded), in their order. Null unless all of these are meshes, and so
    /// many that most of them are in no cache.
    const Mesh* meshes_of_items;
    const Frame* frames;
    const Frustum* frustums;
    const Torus* tori;
    const Patch* patches;
    bool has_patches;
    const Finish* finishes;
    /// Per item the index of its texture; `nothing` if it has none, or one that only scalar code
    /// can compute. Null if wide code can compute no texture of the scene.
    const std::uint32_t* texture_of;
    const Texture* textures;
    const Pattern* patterns;
    const std::uint32_t* medium_slots;  ///< per item; null if the world has no media
    const double (*medium_bounds)[6];   ///< Bounds<double>: World::medium_bounds
    const Light* lights;
    std::size_t light_count;
    double background[3];
    bool has_sky;  ///< the background depends on the direction
    bool has_glassy;
    bool has_smooth_media;
    bool has_clear_meshes;  ///< some mesh of glass goes side by side
    bool has_absorption;    ///< some body absorbs
    int max_depth;
    double min_contribution;
};

}  // namespace lancer::wide
