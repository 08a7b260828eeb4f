#include "app/low_paint.h"

#include "collision/triangle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>

namespace app {

namespace {

/// Faces are looked at every so many metres of their edges.
constexpr float SAMPLE_DISTANCE = 0.5f;
constexpr int MOST_SAMPLES_ALONG_AN_EDGE = 8;

/// Of a mesh of more faces, only so many are looked at, spread evenly.
constexpr std::size_t MOST_HIGH_FACES = 20'000;
constexpr std::size_t MOST_LOW_FACES = 1'000;

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

    void add(const Sample& sample, float weight = 1.0f)
    {
        sum += weight * sample.area * sample.colour;
        area += weight * sample.area;
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

/// Returns the nearest pixel; the image repeats.
glm::vec3 colour_at(const mesh::Image& image, const glm::vec2& place)
{
    const auto pixel = [](float coordinate, int size) {
        const float part = coordinate - std::floor(coordinate);
        return static_cast<std::size_t>(
            std::clamp(static_cast<int>(part * static_cast<float>(size)), 0, size - 1));
    };
    const std::size_t at =
        (pixel(place.y, image.height) * static_cast<std::size_t>(image.width) + pixel(place.x, image.width)) *
        static_cast<std::size_t>(image.channels);
    return glm::vec3(image.pixels[at], image.pixels[at + 1], image.pixels[at + 2]) / 255.0f;
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
void add_samples(const mesh::ObjMesh& obj, const mesh::Face& face, const mesh::Image& texture,
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
        std::clamp(longest / SAMPLE_DISTANCE, 1.0f, static_cast<float>(MOST_SAMPLES_ALONG_AN_EDGE)));
    const float part = 1.0f / static_cast<float>(cuts);
    const glm::vec2 at_a = texture_coordinate_of(obj, face.vertices[0]);
    const glm::vec2 at_b = texture_coordinate_of(obj, face.vertices[1]);
    const glm::vec2 at_c = texture_coordinate_of(obj, face.vertices[2]);
    const auto add = [&](float of_b, float of_c) {
        const float of_a = 1.0f - of_b - of_c;
        samples.push_back({.position = of_a * triangle.a + of_b * triangle.b + of_c * triangle.c,
                           .normal = normal / doubled,
                           .area = 0.5f * doubled * part * part,
                           .colour = colour_at(texture, of_a * at_a + of_b * at_b + of_c * at_c)});
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

std::vector<Sample> samples_of(const mesh::ObjMesh& obj, const mesh::Image& texture)
{
    std::vector<Sample> samples;
    const std::size_t step = 1 + obj.faces.size() / MOST_HIGH_FACES;
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
        const double at_least = std::max(std::abs(glm::dot(from_centre, target.normal)),
                                         glm::length(from_centre) - target.radius);
        if (at_least + turned >= best) {
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

/// Returns how much a place on a face counts for each of its corners: the fourth power of what it has of
/// them, so that the corners of a large face differ as the paint there does; and a little in any case.
std::array<float, 3> nearness_of(const Target& target, const glm::vec3& place)
{
    const collision::Triangle& triangle = target.triangle;
    const glm::vec3 whole = doubled_area(triangle);
    const float square = glm::dot(whole, whole);
    std::array<float, 3> nearness{1.0f, 1.0f, 1.0f};
    const std::array opposite = {collision::Triangle{place, triangle.b, triangle.c},
                                 collision::Triangle{triangle.a, place, triangle.c},
                                 collision::Triangle{triangle.a, triangle.b, place}};
    for (std::size_t corner = 0; square > 0.0f && corner < nearness.size(); ++corner) {
        const float part = std::clamp(glm::dot(doubled_area(opposite[corner]), whole) / square, 0.0f, 1.0f);
        nearness[corner] = 0.001f + part * part * part * part;
    }
    return nearness;
}

} // namespace

std::vector<FacePaint> paint_of(const mesh::ObjMesh& low, const mesh::ObjMesh& high,
                                const mesh::Image& texture)
{
    const std::vector<Sample> samples = samples_of(high, texture);
    const std::vector<Target> targets =
        low.faces.size() <= MOST_LOW_FACES ? targets_of(low) : std::vector<Target>{};
    Mean whole;
    std::vector<std::array<Mean, 3>> means(low.faces.size());
    for (const Sample& sample : samples) {
        whole.add(sample);
        if (const Nearest nearest = nearest_target(sample, targets); nearest.face < targets.size()) {
            const float weight = weight_of(sample, nearest.distance);
            const std::array<float, 3> nearness = nearness_of(targets[nearest.face], nearest.place);
            for (std::size_t corner = 0; corner < nearness.size(); ++corner) {
                means[nearest.face][corner].add(sample, weight * nearness[corner]);
            }
        }
    }
    const glm::vec3 usual = whole.area > 0.0f ? whole.sum / whole.area : glm::vec3(1.0f);
    std::vector<FacePaint> paint(means.size());
    for (std::size_t face = 0; face < means.size(); ++face) {
        std::transform(means[face].begin(), means[face].end(), paint[face].begin(),
                       [&](const Mean& mean) { return mean.area > 0.0f ? mean.sum / mean.area : usual; });
    }
    return paint;
}

} // namespace app
