#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <initializer_list>

namespace base {

/// Holds up to N values within itself, without a heap, in the order they were added. Unused places hold T{}.
template <class T, std::size_t N> class StaticVector
{
public:
    constexpr StaticVector() = default;

    /// Precondition: at most N values.
    constexpr StaticVector(std::initializer_list<T> values)
    {
        for (const T& value : values) {
            push_back(value);
        }
    }

    /// Adds a value and returns it. Precondition: size() < N.
    constexpr T& push_back(const T& value)
    {
        assert(size_ < N && "StaticVector: it is full");
        return values_[size_++] = value;
    }

    constexpr void clear() { size_ = 0; }

    /// Keeps the first values. Precondition: size <= size().
    constexpr void truncate(std::size_t size)
    {
        assert(size <= size_ && "StaticVector: it has fewer values");
        size_ = size;
    }

    constexpr std::size_t size() const { return size_; }
    constexpr bool empty() const { return size_ == 0; }

    /// Precondition: index < size().
    constexpr T& operator[](std::size_t index) { return values_[index]; }
    constexpr const T& operator[](std::size_t index) const { return values_[index]; }
    constexpr const T& back() const { return values_[size_ - 1]; }

    constexpr T* data() { return values_.data(); }
    constexpr const T* data() const { return values_.data(); }
    constexpr T* begin() { return values_.data(); }
    constexpr T* end() { return values_.data() + size_; }
    constexpr const T* begin() const { return values_.data(); }
    constexpr const T* end() const { return values_.data() + size_; }

private:
    std::array<T, N> values_{};
    std::size_t size_ = 0;
};

} // namespace base
