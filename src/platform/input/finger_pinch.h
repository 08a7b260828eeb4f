#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include <SDL.h>

namespace platform {

/// Follows two fingers on a touch screen and tells how they close and spread.
class FingerPinch
{
public:
    /// Takes an event of a finger. Returns by how much two fingers have moved apart (negative: together), as
    /// a share of the window's side; nothing unless exactly two are down.
    std::optional<double> handle(const SDL_TouchFingerEvent& event)
    {
        const std::size_t place = place_of(event.fingerId);
        if (event.type == SDL_FINGERDOWN) {
            ++down_;
            if (place == NONE && place_of_free() != NONE) {
                fingers_[place_of_free()] = {true, event.fingerId, event.x, event.y};
            }
            return std::nullopt;
        }
        if (event.type == SDL_FINGERUP) {
            down_ = down_ > 0 ? down_ - 1 : 0;
            if (place != NONE) {
                fingers_[place].down = false;
            }
            return std::nullopt;
        }
        if (place == NONE) {
            return std::nullopt;
        }
        const double before = distance();
        fingers_[place].x = event.x;
        fingers_[place].y = event.y;
        if (down_ != 2 || !fingers_[0].down || !fingers_[1].down) {
            return std::nullopt;
        }
        return distance() - before;
    }

    /// Returns how many fingers are down.
    int fingers_down() const { return down_; }

private:
    struct Finger
    {
        bool down = false;
        SDL_FingerID id = 0;
        float x = 0.0f;
        float y = 0.0f;
    };
    static constexpr std::size_t NONE = 2;

    std::size_t place_of(SDL_FingerID id) const
    {
        for (std::size_t i = 0; i < NONE; ++i) {
            if (fingers_[i].down && fingers_[i].id == id) {
                return i;
            }
        }
        return NONE;
    }
    std::size_t place_of_free() const { return !fingers_[0].down ? 0 : !fingers_[1].down ? 1 : NONE; }
    double distance() const
    {
        return std::hypot(static_cast<double>(fingers_[0].x - fingers_[1].x),
                          static_cast<double>(fingers_[0].y - fingers_[1].y));
    }

    Finger fingers_[NONE];
    int down_ = 0;
};

} // namespace platform
