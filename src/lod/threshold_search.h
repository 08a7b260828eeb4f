#pragma once

#include "lod/picture_difference.h"

#include <cstdint>
#include <optional>
#include <span>

namespace lod {

/// Says how a search for the threshold ended.
enum class ThresholdOutcome : std::uint8_t
{
    searching,
    found,
    shows_everywhere, ///< even at the furthest distance: look further away
    shows_nowhere,    ///< not even at the nearest: that is the threshold
};

/// Holds a threshold distance d, in metres, where there is one.
struct ThresholdResult
{
    ThresholdOutcome outcome;
    double distance; ///< 0 unless found or shows_nowhere

    friend bool operator==(const ThresholdResult&, const ThresholdResult&) = default;
};

/// Says where to search, metres. Precondition: 0 < nearest <= furthest, ratio > 1, resolution > 0, all
/// finite.
struct SearchRange
{
    double nearest;
    double furthest;
    double ratio = 1.05;     ///< between one distance and the next
    double resolution = 0.1; ///< of the result
};

/// Searches the threshold distance by asking for pictures at one distance after the other, one or more
/// frames each: from the furthest inwards until a difference shows, so that the furthest decides here, too;
/// then halving what is left. What shows only between two of the steps is missed.
///
///     while (auto distance = search.next_distance()) search.report(measured at *distance);
class ThresholdSearch
{
public:
    explicit ThresholdSearch(const SearchRange& range, const ShowingCriterion& criterion = {});

    /// Returns the distance to measure at; nothing when the search is over.
    std::optional<double> next_distance() const;

    /// Takes in what was measured at next_distance(). Does nothing when the search is over.
    void report(const PictureDifference& difference);

    /// Returns what came out, or ThresholdOutcome::searching.
    ThresholdResult result() const;

private:
    void finish(ThresholdOutcome outcome, double distance) { result_ = {outcome, distance}; }

    SearchRange range_;
    ShowingCriterion criterion_;
    double asked_;
    std::optional<double> shows_at_; ///< the furthest distance found to show a difference
    std::optional<double> hides_at_; ///< the nearest from which on none does
    ThresholdResult result_{ThresholdOutcome::searching, 0.0};
};

/// Runs such a search over a function from a distance in metres to a PictureDifference.
template <class Measure>
ThresholdResult find_threshold(const SearchRange& range, const ShowingCriterion& criterion, Measure&& measure)
{
    ThresholdSearch search(range, criterion);
    while (const std::optional<double> distance = search.next_distance()) {
        search.report(measure(*distance));
    }
    return search.result();
}

} // namespace lod
