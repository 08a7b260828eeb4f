#include "assets/low_paint.h"

#include "assets/corner_fit.h"
#include "assets/mipmap.h"
#include "collision/triangle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

namespace assets {

namespace {

/// Faces are looked at every so many metres of their edges.
constexpr float SAMPLE_DISTANCE = 0.2f;
constexpr int MAX_SAMPLES_ALONG_AN_EDGE = 24;

/// How high the window is for which the low tank is painted. Pixels.
constexpr double WINDOW_HEIGHT = 800.0;

/// Of a mesh of more faces, only so many are looked at, spread evenly.
constexpr std::size_t MAX_HIGH_FACES = 20'000;
constexpr std::size_t MAX_LOW_FACES = 1'000;

/// As far away as a face that looks a right angle off counts one that looks the same way. Metres.
constexpr double FAR_AS_A_RIGHT_ANGLE = 0.3;

/// Spots this far from their face count a quarter. Metres.
constexpr double HIDDEN_AT = 0.08;

/// A spot of the high mesh.
struct Sample
{
    glm::vec3 position;
    glm::vec3 normal; ///< of unit length
    float area;
    glm::vec3 colour;
};

/// A face of the low mesh, and what bounds its distance to a point from below.
struct Target
{
    collision::Triangle triangle;
    glm::vec3 normal; ///< of unit length, or zero
    glm::vec3 centre;
    float radius; ///< from the centre to the furthest corner
};

/// Collects colours by area.
struct Mean
{
    glm::vec3 sum{0.0f};
    float area = 0.0f;

    void add(const Sample& sample)
    {
        sum += sample.area * sample.colour;
        area += sample.area;
    }
};

glm::vec3 position_of(const mesh::ObjMesh& obj, const mesh::Face& face, std::size_t corner)
{
    return obj.positions[static_cast<std::size_t>(face.vertices[corner].position)];
}

/// Returns the texture coordinate that draw_obj gives a corner.
glm::vec2 texture_coordinate_of(const mesh::ObjMesh& obj, const mesh::FaceVertex& corner)
{
    return corner.texture_coordinate < 0
               ? glm::vec2(0.0f)
               : obj.texture_coordinates[static_cast<std::size_t>(corner.texture_coordinate)];
}

/// Returns twice the face's area along its normal.
glm::vec3 doubled_area(const collision::Triangle& triangle)
{
    return glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
}

collision::Triangle triangle_of(const mesh::ObjMesh& obj, const mesh::Face& face)
{
    return {position_of(obj, face, 0), position_of(obj, face, 1), position_of(obj, face, 2)};
}

/// Cuts a face into as many like triangles as its size asks for, and takes the middle of each.
void add_samples(const mesh::ObjMesh& obj, const mesh::Face& face, const Mipmap& texture,
                 std::vector<Sample>& samples)
{
    const collision::Triangle triangle = triangle_of(obj, face);
    const glm::vec3 normal = doubled_area(triangle);
    const float doubled = glm::length(normal);
    if (!(doubled > 0.0f) || !std::isfinite(doubled)) {
        return;
    }
    const float longest =
        std::max({glm::distance(triangle.a, triangle.b), glm::distance(triangle.b, triangle.c),
                  glm::distance(triangle.c, triangle.a)});
    const int cuts = static_cast<int>(
        std::clamp(longest / SAMPLE_DISTANCE, 1.0f, static_cast<float>(MAX_SAMPLES_ALONG_AN_EDGE)));
    const float part = 1.0f / static_cast<float>(cuts);
    const glm::vec2 at_a = texture_coordinate_of(obj, face.vertices[0]);
    const glm::vec2 at_b = texture_coordinate_of(obj, face.vertices[1]);
    const glm::vec2 at_c = texture_coordinate_of(obj, face.vertices[2]);
    const auto add = [&](float of_b, float of_c) {
        const float of_a = 1.0f - of_b - of_c;
        samples.push_back({.position = of_a * triangle.a + of_b * triangle.b + of_c * triangle.c,
                           .normal = normal / doubled,
                           .area = 0.5f * doubled * part * part,
                           .colour = texture.colour_at(of_a * at_a + of_b * at_b + of_c * at_c)});
    };
    constexpr float THIRD = 1.0f / 3.0f;
    for (int i = 0; i < cuts; ++i) {
        for (int j = 0; i + j < cuts; ++j) {
            const auto b = static_cast<float>(i);
            const auto c = static_cast<float>(j);
            add((b + THIRD) * part, (c + THIRD) * part);
            if (i + j + 1 < cuts) { // the one that stands the other way round
                add((b + 2.0f * THIRD) * part, (c + 2.0f * THIRD) * part);
            }
        }
    }
}

/// Returns how much of the tank a pixel of a view shows. Metres.
double pixel_width(const PaintView& view)
{
    return view.distance * 2.0 * std::tan(view.field_of_view / 2.0) / WINDOW_HEIGHT;
}

/// Returns the image's mipmap that shows the mesh from there: neighbours in the image have become one.
Mipmap as_seen(const mesh::ObjMesh& obj, const image::Image& image, const PaintView& view)
{
    double area = 0.0; // both doubled
    double texels = 0.0;
    for (const mesh::Face& face : obj.faces) {
        const glm::dvec2 a(texture_coordinate_of(obj, face.vertices[0]));
        const glm::dvec2 b = glm::dvec2(texture_coordinate_of(obj, face.vertices[1])) - a;
        const glm::dvec2 c = glm::dvec2(texture_coordinate_of(obj, face.vertices[2])) - a;
        area += static_cast<double>(glm::length(doubled_area(triangle_of(obj, face))));
        texels += std::abs(b.x * c.y - b.y * c.x) * image.width * image.height;
    }
    const double across = pixel_width(view) * std::sqrt(area > 0.0 ? texels / area : 0.0);
    int side = 1;
    while (2 * side < std::min(image.width, image.height) && across > std::numbers::sqrt2 * side) {
        side *= 2; // nearest to it
    }
    return Mipmap(image, side);
}

std::vector<Sample> samples_of(const mesh::ObjMesh& obj, const image::Image& image, const PaintView& view)
{
    const Mipmap texture = as_seen(obj, image, view);
    std::vector<Sample> samples;
    const std::size_t step = 1 + obj.faces.size() / MAX_HIGH_FACES;
    for (std::size_t face = 0; face < obj.faces.size(); face += step) {
        add_samples(obj, obj.faces[face], texture, samples);
    }
    return samples;
}

std::vector<Target> targets_of(const mesh::ObjMesh& obj)
{
    std::vector<Target> targets;
    for (const mesh::Face& face : obj.faces) {
        const collision::Triangle triangle = triangle_of(obj, face);
        const glm::vec3 normal = doubled_area(triangle);
        const float length = glm::length(normal);
        const glm::vec3 centre = (triangle.a + triangle.b + triangle.c) / 3.0f;
        const float radius = std::max({glm::distance(centre, triangle.a), glm::distance(centre, triangle.b),
                                       glm::distance(centre, triangle.c)});
        targets.push_back({triangle, length > 0.0f ? normal / length : glm::vec3(0.0f), centre, radius});
    }
    return targets;
}

/// Says which face stands for a spot, and how far from it that is, metres.
struct Nearest
{
    std::size_t face; ///< the number of faces when none looks the spot's way
    double distance;
    glm::vec3 place; ///< on the face
};

Nearest nearest_target(const Sample& sample, const std::vector<Target>& targets)
{
    double best = std::numeric_limits<double>::max();
    Nearest found{targets.size(), 0.0, {}};
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const Target& target = targets[i];
        const double cosine = static_cast<double>(glm::dot(sample.normal, target.normal));
        if (cosine <= 0.0) {
            continue;
        }
        const double turned = FAR_AS_A_RIGHT_ANGLE * (1.0 - cosine);
        const glm::vec3 from_centre = sample.position - target.centre;
        const float at_least = std::max(std::abs(glm::dot(from_centre, target.normal)),
                                        glm::length(from_centre) - target.radius);
        if (static_cast<double>(at_least) + turned >= best) {
            continue;
        }
        const glm::dvec3 position(sample.position);
        const glm::dvec3 place = collision::closest_point_on_triangle(position, target.triangle);
        const double distance = glm::distance(position, place);
        if (turned + distance < best) {
            best = turned + distance;
            found = {i, distance, glm::vec3(place)};
        }
    }
    return found;
}

/// Returns how much a spot counts so far from its face. What is deep below that is hidden, as a low mesh
/// wraps the high one; and what is dark is more often hidden than what is light: a texture has its shades
/// baked in. The root of the lightness gives pictures of our tank the mean colour that they have to have.
float weight_of(const Sample& sample, double distance)
{
    const double far = distance / HIDDEN_AT;
    const double falls = 1.0 + far * far;
    const float lightness = std::sqrt(sample.colour.r + sample.colour.g + sample.colour.b);
    return lightness * static_cast<float>(1.0 / (falls * falls));
}

/// Returns what a place on a face has of its three corners: 0 to 1, together 1.
glm::dvec3 parts_at(const Target& target, const glm::vec3& place)
{
    const collision::Triangle& triangle = target.triangle;
    const glm::dvec3 whole(doubled_area(triangle));
    const double square = glm::dot(whole, whole);
    if (!(square > 0.0)) {
        return glm::dvec3(1.0 / 3.0);
    }
    const auto part = [&](const collision::Triangle& opposite) {
        return std::clamp(glm::dot(glm::dvec3(doubled_area(opposite)), whole) / square, 0.0, 1.0);
    };
    const glm::dvec3 parts(part({place, triangle.b, triangle.c}), part({triangle.a, place, triangle.c}),
                           part({triangle.a, triangle.b, place}));
    return parts / (parts.x + parts.y + parts.z);
}

} // namespace

std::vector<FacePaint> paint_of(const mesh::ObjMesh& low, const mesh::ObjMesh& high,
                                const image::Image& texture, const PaintView& view)
{
    const std::vector<Sample> samples = samples_of(high, texture, view);
    const std::vector<Target> targets =
        low.faces.size() <= MAX_LOW_FACES ? targets_of(low) : std::vector<Target>{};
    Mean whole;
    std::vector<CornerFit> fits(low.faces.size());
    for (const Sample& sample : samples) {
        whole.add(sample);
        if (const Nearest nearest = nearest_target(sample, targets); nearest.face < targets.size()) {
            const auto weight = static_cast<double>(sample.area * weight_of(sample, nearest.distance));
            fits[nearest.face].add(sample.colour, parts_at(targets[nearest.face], nearest.place), weight);
        }
    }
    const glm::vec3 usual = whole.area > 0.0f ? whole.sum / whole.area : glm::vec3(1.0f);
    std::vector<FacePaint> paint;
    for (const CornerFit& fit : fits) {
        paint.push_back(fit.corners().value_or(FacePaint{usual, usual, usual}));
    }
    return paint;
}

} // namespace assets
