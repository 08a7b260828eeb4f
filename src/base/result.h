#pragma once

#include "base/read_error.h"

#include <cassert>
#include <utility>
#include <variant>

namespace base {

/// Holds what a function returns or, when it failed, why. Stands in for exceptions, which the web build has
/// not.
template <class T> class [[nodiscard]] Result
{
public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(ReadError error) : content_(std::in_place_index<1>, std::move(error)) {}

    /// True when there is a value.
    explicit operator bool() const { return content_.index() == 0; }

    /// Returns the value. Precondition: there is one.
    T& value() & { return *checked(std::get_if<0>(&content_)); }
    const T& value() const& { return *checked(std::get_if<0>(&content_)); }
    T&& value() && { return std::move(*checked(std::get_if<0>(&content_))); }

    /// Returns why there is no value. Precondition: there is none.
    const ReadError& error() const { return *checked(std::get_if<1>(&content_)); }

private:
    template <class Pointer> static Pointer checked(Pointer pointer)
    {
        assert(pointer && "Result: value() of a failure, or error() of a success");
        return pointer;
    }

    std::variant<T, ReadError> content_;
};

} // namespace base
