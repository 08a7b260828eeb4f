#include "assets/track_links.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

namespace assets {

namespace {

constexpr std::size_t MIN_LINKS = 3;

/// Links that face opposite ways have no normal between.
constexpr double MIN_NORMAL_LENGTH = 1e-6;

/// Says which link of which chain a group is.
struct LinkName
{
    std::string_view chain; ///< with its side; empty: the group is no link
    Side side;
    int number;
};

LinkName link_name(std::string_view group)
{
    const std::size_t last = group.find_last_of('_');
    const bool is_left = group.starts_with("left_");
    if (last == group.npos || (!is_left && !group.starts_with("right_"))) {
        return {};
    }
    int number = 0;
    const char* const end = group.data() + group.size();
    const auto [read, error] = std::from_chars(group.data() + last + 1, end, number);
    if (error != std::errc{} || read != end || number < 0) {
        return {};
    }
    return {group.substr(0, last), is_left ? Side::left : Side::right, number};
}

struct Chain
{
    Side side = Side::left;
    bool has_doubles = false;
    std::map<int, const mesh::FaceGroup*> links; ///< by their numbers
};

std::map<std::string_view, Chain> chains_of(const mesh::ObjMesh& body)
{
    std::map<std::string_view, Chain> chains;
    for (const mesh::FaceGroup& group : body.groups) {
        const LinkName name = link_name(group.name);
        if (!name.chain.empty()) {
            Chain& chain = chains[name.chain];
            chain.side = name.side;
            chain.has_doubles = !chain.links.try_emplace(name.number, &group).second || chain.has_doubles;
        }
    }
    return chains;
}

bool is_whole(const Chain& chain)
{
    const auto count = static_cast<int>(chain.links.size());
    return !chain.has_doubles && chain.links.size() >= MIN_LINKS &&
           chain.links.rbegin()->first == count - 1 &&
           std::all_of(chain.links.begin(), chain.links.end(), [&](const auto& link) {
               return link.second->face_count == chain.links.begin()->second->face_count;
           });
}

void add_faces(const Chain& chain, std::vector<LinkFace>& moving)
{
    std::vector<int> first;
    for (const auto& [number, group] : chain.links) {
        first.push_back(group->first_face);
    }
    const std::size_t count = first.size();
    for (std::size_t link = 0; link < count; ++link) {
        for (int i = 0; i < chain.links.begin()->second->face_count; ++i) {
            moving.push_back({.previous = first[(link + count - 1) % count] + i,
                              .here = first[link] + i,
                              .next = first[(link + 1) % count] + i,
                              .after_next = first[(link + 2) % count] + i});
        }
    }
}

std::vector<int> resting_faces(const mesh::ObjMesh& body, const TrackLinks& links)
{
    std::vector<bool> moves(body.faces.size(), false);
    for (const std::vector<LinkFace>& side : links.moving) {
        for (const LinkFace& face : side) {
            moves[static_cast<std::size_t>(face.here)] = true;
        }
    }
    std::vector<int> resting;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        if (!moves[i]) {
            resting.push_back(static_cast<int>(i));
        }
    }
    return resting;
}

const mesh::FaceVertex& corner_of(const mesh::ObjMesh& body, int face, std::size_t corner)
{
    return body.faces[static_cast<std::size_t>(face)].vertices[corner];
}

glm::dvec3 position_of(const mesh::ObjMesh& body, int face, std::size_t corner)
{
    return body.positions[static_cast<std::size_t>(corner_of(body, face, corner).position)];
}

glm::dvec3 normal_of(const mesh::ObjMesh& body, int face, std::size_t corner)
{
    return body.normals[static_cast<std::size_t>(corner_of(body, face, corner).normal)];
}

/// Returns the pitch: most links lie on straight runs, where every corner is one pitch from its next place.
/// On an end wheel it is further for what is outside and nearer for what is inside, which the median leaves
/// out. Metres.
double pitch_of(const mesh::ObjMesh& body, const TrackLinks& links)
{
    std::vector<double> ways;
    for (const std::vector<LinkFace>& side : links.moving) {
        for (const LinkFace& face : side) {
            ways.push_back(glm::length(position_of(body, face.next, 0) - position_of(body, face.here, 0)));
        }
    }
    const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
    std::nth_element(ways.begin(), middle, ways.end());
    return *middle;
}

/// The weights of four points in a row, for the spline from the second to the third.
std::array<double, 4> spline_weights(double t)
{
    const double t2 = t * t;
    const double t3 = t2 * t;
    return {0.5 * (2.0 * t2 - t - t3), 0.5 * (2.0 - 5.0 * t2 + 3.0 * t3), 0.5 * (t + 4.0 * t2 - 3.0 * t3),
            0.5 * (t3 - t2)};
}

template <class At>
glm::dvec3 on_spline(const LinkFace& face, const std::array<double, 4>& weights, const At& at)
{
    return weights[0] * at(face.previous) + weights[1] * at(face.here) + weights[2] * at(face.next) +
           weights[3] * at(face.after_next);
}

/// Adds a face to a mesh whose arrays it does not share with other faces but the texture coordinates.
class FaceWriter
{
public:
    FaceWriter(mesh::ObjMesh& to, const mesh::ObjMesh& body) : to_(to)
    {
        to_.texture_coordinates = body.texture_coordinates;
    }

    void add_corner(const glm::dvec3& position, const glm::dvec3& normal, int texture_coordinate)
    {
        const auto index = static_cast<int>(to_.positions.size());
        face_.vertices[corner_++] = {
            .position = index, .normal = index, .texture_coordinate = texture_coordinate};
        to_.positions.emplace_back(position);
        to_.normals.emplace_back(normal);
        if (corner_ == face_.vertices.size()) {
            to_.faces.push_back(face_);
            corner_ = 0;
        }
    }

private:
    mesh::ObjMesh& to_;
    mesh::Face face_{};
    std::size_t corner_ = 0;
};

} // namespace

TrackLinks find_track_links(const mesh::ObjMesh& body, double wheel_radius)
{
    TrackLinks links;
    for (const auto& [name, chain] : chains_of(body)) {
        if (is_whole(chain)) {
            add_faces(chain, links.moving[static_cast<std::size_t>(chain.side)]);
        }
    }
    const bool has_faces = !links.moving[0].empty() || !links.moving[1].empty();
    const double pitch = has_faces ? pitch_of(body, links) : 0.0;
    const double per_turn = pitch > 0.0 ? std::round(2.0 * std::numbers::pi * wheel_radius / pitch) : 0.0;
    if (!(per_turn >= 1.0 && per_turn <= 1e6)) {
        links = {};
    } else {
        links.per_turn = static_cast<int>(per_turn);
    }
    links.resting = resting_faces(body, links);
    return links;
}

std::size_t link_phase(const TrackLinks& links, double angle, std::size_t phases)
{
    const double passed = angle / (2.0 * std::numbers::pi) * links.per_turn;
    const double step = std::round((passed - std::floor(passed)) * static_cast<double>(phases));
    return static_cast<std::size_t>(step) % phases;
}

mesh::ObjMesh moved_links(const mesh::ObjMesh& body, const TrackLinks& links, Side side, double way)
{
    mesh::ObjMesh moved;
    FaceWriter writer(moved, body);
    const std::array<double, 4> weights = spline_weights(way);
    for (const LinkFace& face : links.moving[static_cast<std::size_t>(side)]) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::dvec3 normal =
                on_spline(face, weights, [&](int of) { return normal_of(body, of, corner); });
            const bool has_direction = glm::dot(normal, normal) > MIN_NORMAL_LENGTH * MIN_NORMAL_LENGTH;
            writer.add_corner(on_spline(face, weights, [&](int of) { return position_of(body, of, corner); }),
                              has_direction ? normal : normal_of(body, face.here, corner),
                              corner_of(body, face.here, corner).texture_coordinate);
        }
    }
    return moved;
}

mesh::ObjMesh without_links(const mesh::ObjMesh& body, const TrackLinks& links)
{
    mesh::ObjMesh rest = body;
    rest.groups.clear();
    rest.faces.clear();
    for (int face : links.resting) {
        rest.faces.push_back(body.faces[static_cast<std::size_t>(face)]);
    }
    return rest;
}

} // namespace assets
