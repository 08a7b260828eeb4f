#include "assets/corner_fit.h"

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace assets {
namespace {

constexpr glm::vec3 RED{0.8f, 0.2f, 0.2f};
constexpr glm::vec3 GREEN{0.2f, 0.8f, 0.2f};
constexpr glm::vec3 BLUE{0.2f, 0.2f, 0.8f};

/// Calls place(parts) at places spread evenly over a triangle.
template <class Place> void spread(const Place& place)
{
    constexpr int CUTS = 12;
    for (int i = 0; i < CUTS; ++i) {
        for (int j = 0; i + j < CUTS; ++j) {
            const glm::dvec2 part = (glm::dvec2(i, j) + 1.0 / 3.0) / static_cast<double>(CUTS);
            place(glm::dvec3(part, 1.0 - part.x - part.y));
        }
    }
}

TEST(CornerFit, OfOneColourIsThatColour)
{
    CornerFit fit;
    spread([&](const glm::dvec3& parts) { fit.add(RED, parts, 0.5); });
    const auto corners = fit.corners();
    ASSERT_TRUE(corners);
    for (const glm::vec3& corner : *corners) {
        EXPECT_LT(glm::distance(corner, RED), 1e-5f);
    }
}

TEST(CornerFit, OfWhatChangesEvenlyHasEachCornerAsItIsThere)
{
    CornerFit fit;
    spread([&](const glm::dvec3& parts) {
        fit.add(
            glm::vec3(parts.x * glm::dvec3(RED) + parts.y * glm::dvec3(GREEN) + parts.z * glm::dvec3(BLUE)),
            parts, 1.0);
    });
    const auto corners = fit.corners();
    ASSERT_TRUE(corners);
    const std::array expected{RED, GREEN, BLUE};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_LT(glm::distance((*corners)[i], expected[i]), 0.1f) << i;
    }
}

TEST(CornerFit, CountsWhatWeighsMore)
{
    CornerFit fit;
    fit.add(RED, glm::dvec3(1.0 / 3.0), 3.0);
    fit.add(BLUE, glm::dvec3(1.0 / 3.0), 1.0);
    const auto corners = fit.corners();
    ASSERT_TRUE(corners);
    for (const glm::vec3& corner : *corners) {
        EXPECT_LT(glm::distance(corner, 0.75f * RED + 0.25f * BLUE), 1e-5f);
    }
}

TEST(CornerFit, KeepsTheContrastThatSmallPatchesHave)
{
    // Stripes as narrow as cannot be fitted, a little lighter towards the first corner.
    CornerFit fit;
    bool light = false;
    spread([&](const glm::dvec3& parts) {
        light = !light;
        fit.add(glm::vec3(static_cast<float>((light ? 0.7 : 0.3) + 0.1 * parts.x)), parts, 1.0);
    });
    const auto corners = fit.corners();
    ASSERT_TRUE(corners);
    EXPECT_GT((*corners)[0].g - (*corners)[1].g, 0.2f); // the fit alone would have 0.1
}

TEST(CornerFit, HasNoColourBeyondWhatWasSeen)
{
    // All that is seen is near the second corner, and steep: the others would be far out.
    CornerFit fit;
    spread([&](const glm::dvec3& parts) {
        if (parts.y > 0.6) {
            fit.add(parts.y > 0.8 ? GREEN : RED, parts, 1.0);
        }
    });
    const auto corners = fit.corners();
    ASSERT_TRUE(corners);
    for (const glm::vec3& corner : *corners) {
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_GE(corner[channel], 0.2f - 1e-6f);
            EXPECT_LE(corner[channel], 0.8f + 1e-6f);
        }
    }
}

TEST(CornerFit, OfNothingIsNothing)
{
    EXPECT_FALSE(CornerFit().corners());
}

TEST(CornerFit, OfOnePlaceGivesNumbers)
{
    CornerFit fit;
    fit.add(GREEN, {1.0, 0.0, 0.0}, 1.0);
    const auto corners = fit.corners();
    ASSERT_TRUE(corners);
    for (const glm::vec3& corner : *corners) {
        EXPECT_LT(glm::distance(corner, GREEN), 1e-5f);
    }
}

} // namespace
} // namespace assets
