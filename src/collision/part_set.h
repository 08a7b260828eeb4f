#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>

namespace collision {

/// At most this many parts are in one hierarchy.
constexpr std::size_t MAX_PARTS = 64;

/// A set of parts, by index: one machine word, so that a test allocates nothing.
class PartSet
{
public:
    constexpr PartSet() = default;
    constexpr explicit PartSet(std::uint64_t bits) : bits_(bits) {}

    /// Puts a part in. Precondition: part < MAX_PARTS.
    constexpr void insert(std::size_t part)
    {
        assert(part < MAX_PARTS);
        bits_ |= std::uint64_t{1} << part;
    }

    constexpr bool contains(std::size_t part) const { return part < MAX_PARTS && (bits_ >> part & 1u) != 0; }
    constexpr bool is_empty() const { return bits_ == 0; }
    constexpr int count() const { return std::popcount(bits_); }

    /// Returns part k as bit k.
    constexpr std::uint64_t bits() const { return bits_; }

    /// Calls visit(part) for each part, lowest index first.
    template <class Visit> constexpr void for_each(Visit&& visit) const
    {
        for (std::uint64_t rest = bits_; rest != 0; rest &= rest - 1) {
            visit(static_cast<std::size_t>(std::countr_zero(rest)));
        }
    }

    friend constexpr bool operator==(PartSet, PartSet) = default;

private:
    std::uint64_t bits_ = 0;
};

} // namespace collision
