#include "mesh/ear_clipper.h"

#include <utility>

namespace mesh {

EarClipper::EarClipper(std::vector<glm::dvec2> points, long long& steps_left)
    : points_(std::move(points)), reflex_(points_), remaining_(static_cast<int>(points_.size())),
      steps_left_(steps_left)
{
    corners_.reserve(points_.size());
    for (int i = 0; i < remaining_; ++i) {
        corners_.push_back({(i + remaining_ - 1) % remaining_, (i + 1) % remaining_, true, false, false});
    }
    for (int i = 0; i < remaining_; ++i) {
        classify(i);
    }
    wait_all();
}

bool EarClipper::clip(std::vector<CornerTriangle>& triangles)
{
    bool clipped_since_wait_all = true;
    while (remaining_ > 3 && steps_left_ >= 0) {
        --steps_left_;
        if (queue_front_ < queue_.size()) {
            const int corner = queue_[queue_front_++];
            corners_[corner].waiting = false;
            if (!corners_[corner].clipped && is_ear(corner, Contact::none)) {
                clip_corner(corner, triangles);
                clipped_since_wait_all = true;
            }
        } else if (clipped_since_wait_all) {
            wait_all();
            clipped_since_wait_all = false;
        } else {
            clip_corner(corner_to_force(), triangles);
            clipped_since_wait_all = true;
        }
    }
    const Corner& last = corners_[some_corner_];
    triangles.push_back({last.previous, some_corner_, last.next});
    return steps_left_ >= 0;
}

void EarClipper::classify(int corner)
{
    Corner& c = corners_[corner];
    c.convex = turn(points_[c.previous], points_[corner], points_[c.next]) > 0;
    reflex_.mark(corner, !c.convex);
}

void EarClipper::wait(int corner)
{
    if (corners_[corner].waiting) {
        return;
    }
    corners_[corner].waiting = true;
    queue_.push_back(corner);
}

void EarClipper::wait_all()
{
    queue_.clear();
    queue_front_ = 0;
    int corner = some_corner_;
    for (int i = 0; i < remaining_; ++i, corner = corners_[corner].next) {
        wait(corner);
    }
    steps_left_ -= remaining_;
}

bool EarClipper::is_ear(int corner, Contact allowed)
{
    const Corner& ear = corners_[corner];
    if (!ear.convex) {
        return false;
    }
    const glm::dvec2 a = points_[ear.previous];
    const glm::dvec2 b = points_[corner];
    const glm::dvec2 c = points_[ear.next];
    const auto is_in_the_way = [&](int other) {
        const glm::dvec2 p = points_[other];
        if (p == a || p == b || p == c) { // also the twin of an own corner, where a bridge leads to a hole
            return false;
        }
        const double ab = turn(a, b, p);
        const double bc = turn(b, c, p);
        const double ca = turn(c, a, p);
        return allowed == Contact::none ? ab >= 0 && bc >= 0 && ca >= 0 : ab > 0 && bc > 0 && ca > 0;
    };
    return !reflex_.any_near_triangle({a, b, c}, is_in_the_way, steps_left_);
}

/// Chooses what to clip when there is no clean ear: a corner on the line of its neighbours, whose triangle
/// covers nothing; else an ear that touches others; else, since the polygon crosses itself, anything, convex
/// if possible.
int EarClipper::corner_to_force()
{
    int touching_ear = -1;
    int convex = -1;
    int corner = some_corner_;
    for (int i = 0; i < remaining_; ++i, corner = corners_[corner].next) {
        --steps_left_;
        const Corner& c = corners_[corner];
        if (turn(points_[c.previous], points_[corner], points_[c.next]) == 0) {
            return corner;
        }
        if (touching_ear < 0 && is_ear(corner, Contact::outline)) {
            touching_ear = corner;
        }
        if (convex < 0 && c.convex) {
            convex = corner;
        }
    }
    return touching_ear >= 0 ? touching_ear : convex >= 0 ? convex : some_corner_;
}

void EarClipper::clip_corner(int corner, std::vector<CornerTriangle>& triangles)
{
    Corner& c = corners_[corner];
    triangles.push_back({c.previous, corner, c.next});
    c.clipped = true;
    reflex_.mark(corner, false);
    corners_[c.previous].next = c.next;
    corners_[c.next].previous = c.previous;
    some_corner_ = c.next;
    --remaining_;
    for (const int neighbour : {c.previous, c.next}) {
        classify(neighbour);
        wait(neighbour);
    }
}

} // namespace mesh
