#include "lod/threshold_search.h"

#include <algorithm>
#include <cmath>

namespace lod {

ThresholdSearch::ThresholdSearch(const SearchRange& range, const ShowingCriterion& criterion)
    : range_(range), criterion_(criterion), asked_(range.furthest)
{}

std::optional<double> ThresholdSearch::next_distance() const
{
    return result_.outcome == ThresholdOutcome::searching ? std::optional(asked_) : std::nullopt;
}

void ThresholdSearch::report(const PictureDifference& difference)
{
    if (result_.outcome != ThresholdOutcome::searching) {
        return;
    }
    if (shows(difference, criterion_)) {
        shows_at_ = asked_;
    } else {
        hides_at_ = asked_;
    }
    if (!hides_at_) {
        finish(ThresholdOutcome::shows_everywhere, 0.0);
    } else if (!shows_at_) {
        if (!(asked_ > range_.nearest)) {
            finish(ThresholdOutcome::shows_nowhere, *hides_at_);
        }
        const double nearer = asked_ / range_.ratio;
        asked_ = nearer > range_.nearest && nearer < asked_ ? nearer : range_.nearest;
    } else {
        asked_ = *shows_at_ + 0.5 * (*hides_at_ - *shows_at_);
        // The second condition is for a resolution finer than the doubles there.
        if (*hides_at_ - *shows_at_ <= range_.resolution || asked_ <= *shows_at_ || asked_ >= *hides_at_) {
            finish(ThresholdOutcome::found, *hides_at_);
        }
    }
}

ThresholdResult ThresholdSearch::result() const
{
    return result_;
}

} // namespace lod
