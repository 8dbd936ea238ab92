// What wide code sees of a world: plain numbers in plain arrays. No function has its body here, and
// nothing of the standard library's templates: see lanes_avx512.h.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lancer::wide {

inline constexpr std::uint32_t nothing = 0xFFFFFFFF;  ///< lancer::none

/// BvhNode<double>, which this must lie over.
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

/// FrustumSolid<double>, for its filter.
struct Frustum {
    double small_end[3], axis[3];
    double height, radius, slope, filter_error;
};

/// Frame<double>
struct Frame {
    double to_world[3][3];
    double shift[3];
    double linear_inverse[3][3];
    double norm, inverse_norm, transform_error;
    bool keeps_digits;
};

/// TriangleLeaf<double>, which this must lie over.
struct TriangleBlock {
    double corner[3][3][4];
    std::uint32_t face[4];
};

/// A mesh where it stands: MeshInstance<double> and the frame of its primitive.
struct Mesh {
    Tree tree;
    const TriangleBlock* leaves;
    double reach;
    const std::uint8_t* inward;  ///< null: no face looks inside
    const double (*vertices)[3];
    const std::uint32_t (*faces)[3];
    const double (*normals)[3];  ///< null: none are interpolated
    const std::uint32_t (*normal_faces)[3];
    const Frame* frame;  ///< null: in world space
};

enum class Kind : std::uint8_t {
    ball,  ///< in world space, as boxes and frustums are
    box,
    frustum,  ///< which wide code filters alone
    mesh,
    other,  ///< which scalar code knows
};

struct Item {
    std::uint32_t shape = 0;  ///< index into the arrays of its kind
    std::uint32_t material = 0;
    Kind kind = Kind::other;
    bool convex = false;
    bool body = false;
    bool casts_shadow = true;
    bool glassy = false;  ///< lets light pass, or is a medium
    /// Glassy, and wide code knows what it does to light; else rays that meet it are scalar code's.
    bool clear = false;
};

/// What of Finish<double> wide code computes with.
struct Finish {
    double color[3];
    double reflection[3];
    double own[3];  ///< ambient * World::ambient + emission
    double diffuse, phong, shininess, blinn, inverse_roughness, metallic;
    double opacity;
    double transmittance[3];  ///< the share of light that passes, where it has no texture
    double ior;
    double fresnel;  ///< 1: `reflection` goes by Fresnel's equations, else 0
    bool plain;      ///< its light is computed in lanes
    bool textured;   ///< its colour is not
};

struct Light {
    enum class Kind : std::uint8_t {
        point,
        directional,  ///< its direction is `place`
        spot,
    };
    Kind kind;
    bool shadows;  ///< it, and the settings, have them
    bool fill;     ///< it brings no highlights
    bool fades;
    double place[3];
    double color[3];
    double fade_distance, fade_power;
    double axis[3];  ///< of a spot, the way its light travels
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
    const Ball* balls;
    const Plane* planes;  ///< items[bounded..]
    const Mesh* meshes;
    const Box* boxes;
    const Frustum* frustums;
    const Finish* finishes;
    const std::uint32_t* medium_slots;  ///< of the items; null where nothing is a medium
    const double (*medium_bounds)[6];   ///< Bounds<double>: World::medium_bounds
    const Light* lights;
    std::size_t light_count;
    double background[3];
    bool has_sky;  ///< what is behind depends on the direction
    bool has_glassy;
    int max_depth;
    double min_contribution;
};

/// One ray, as Ray<double>.
struct LaneRay {
    double origin[3], origin_lo[3], dir[3];
    double dir_squared, inv_squared, origin_error, filter_error;
    double inv_dir[3];
    bool whole;
};

/// Lists of bodies that are longer are scalar code's.
inline constexpr int most_bodies = 4;

/// What a ray starts on, if anything, what it leaves for good, and what it is inside of.
struct LaneStart {
    std::uint32_t item, face;
    bool entering;
    std::uint32_t left;
    std::uint32_t bodies[most_bodies];  ///< in the order entered, then `nothing`
};

struct LaneHit {
    double t, error, u, v;
    std::uint32_t item, face;
    bool entering;
};

/// Surface<double>, as far as it does not follow from the hit.
struct LaneSurface {
    double position[3], position_lo[3], geometric[3], normal[3], color[3];
    double error, opacity;
};

struct LaneLight {
    double direction[3], color[3];
    double distance;
};

/// Gets crossings that count.
struct HitSink {
    void* self;
    double (*limit)(void* self);
    void (*add)(void* self, const LaneHit& hit);
};

/// Gets light.
struct LightSink {
    void* self;
    void (*add)(void* self, const double* light);
};

/// The exact methods: what wide code asks where it is unsure, one ray at a time. Rays carry their
/// own counts.
class ExactMethods {
  public:
    /// The light that a ray brings; in worlds without glassy items, as `shade`.
    virtual void trace(const LaneRay& ray, const LaneStart& start, double weight, int level,
                       double* color) = 0;
    /// The same where there are glassy items, term by term.
    ///
    /// \param through  what the surfaces before let pass of it
    virtual void follow(const LaneRay& ray, const LaneStart& start, double weight, int level,
                        const double* through, const LightSink& sink) = 0;
    /// The light that a ray brings where it is known what it meets first.
    virtual void shade(const LaneRay& ray, const LaneHit& hit, double weight, int level,
                       double* color) = 0;
    /// What a ray brings that hits nothing.
    virtual void behind(const double* direction, double* color) = 0;
    virtual void surface(const LaneRay& ray, const LaneHit& hit, LaneSurface& surface) = 0;
    virtual void light(std::size_t index, const double* position, const double* position_lo,
                       LaneLight& light) = 0;
    /// The crossings with one item up to the sink's limit that count.
    virtual void crossings(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                           const HitSink& sink) = 0;
    /// Whether the item lies on the way to a light.
    virtual bool blocks(std::uint32_t item, const LaneRay& ray, const LaneStart& start,
                        double distance) = 0;
    /// The share of a light that reaches the start of a ray, by colour.
    virtual void light_share(const LaneRay& ray, const LaneStart& start, double distance,
                             double* share) = 0;

  protected:
    ~ExactMethods() = default;
};

/// Rays that are traced together, and what they brought. Level by level each wave holds what the
/// rays of the wave before it sent on.
struct Wave {
    static constexpr int most = 256;
    static constexpr int room = most + 8;  ///< full vectors may be stored at any place

    double origin[3][room], origin_lo[3][room], dir[3][room];
    double error[room], weight[room];
    double color[3][room];
    double mirror[3][room];  ///< the factor of `color` in the sender's light
    std::uint32_t sender[room];
    std::uint32_t item[room], face[room], left[room];
    bool entering[room];
    // In worlds with glassy items, in place of `mirror` and `sender`:
    double through[3][room];    ///< what the surfaces before let pass
    std::uint32_t chain[room];  ///< that the ray's light belongs to
    std::uint32_t bodies[most_bodies][room];
    int deepest;  ///< no ray is in more bodies
    int count;
};

/// A part of the light of a chain.
struct Term {
    double light[3];      ///< or the factor of what `child` brings
    std::uint32_t child;  ///< a chain; `nothing`: `light` is all
    std::uint32_t next;   ///< index into Ledger::terms
};

/// The light of a ray and of what it goes on as, bent or mirrored as a whole, as a sum of terms.
struct Chain {
    std::uint32_t first, last;  ///< terms
    double light[3];            ///< their sum, when all is traced
};

/// The light of a tile's rays as sums that are yet to be formed.
struct Ledger {
    Chain* chains;  ///< each after the one that it is a term of
    std::uint32_t chain_count, chain_room;
    Term* terms;
    std::uint32_t term_count, term_room;
    void (*grow)(Ledger& ledger);  ///< makes room for more terms
};

struct Counts {
    std::uint64_t primary, shadow, reflected, transmitted;
};

/// Everything that a tile of rays needs.
struct Job {
    const Scene* scene;
    ExactMethods* exact;
    Wave* (*wave)(void* waves, int index);  ///< the same at each call
    void* waves;
    Ledger* ledger;                  ///< of worlds with glassy items
    std::uint32_t* last_in_the_way;  ///< an item for each light, or `nothing`: ShadowQuery
    Counts counts;
};

/// Traces camera rays through `count` points of the picture, in pixels, at most Wave::most; their
/// light is then in the `color` of the first wave.
using TraceRays = void (*)(Job& job, const Camera& camera, const double* x, const double* y,
                           int count);

}  // namespace lancer::wide
