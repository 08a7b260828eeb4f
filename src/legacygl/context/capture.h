#pragma once

#include <legacygl/legacygl.h>

#include <array>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace legacygl {

/// Notes the calls made between capture_begin and capture_end.
class Capture
{
public:
    bool active() const { return active_; }
    void begin()
    {
        calls_.clear();
        active_ = true;
    }
    std::span<const LegacyGLCall> end()
    {
        active_ = false;
        return calls_;
    }
    template <class... Args>
    void note(const char* name, int list_depth, const float* modelview, const Args&... args)
    {
        LegacyGLCall call{};
        call.name = name;
        call.list_depth = list_depth;
        std::memcpy(call.modelview, modelview, sizeof call.modelview);
        (add(call, args), ...);
        calls_.push_back(call);
    }

private:
    template <class T>
        requires std::is_arithmetic_v<T>
    static void add(LegacyGLCall& call, T value)
    {
        if (call.argument_count < 16) {
            call.arguments[call.argument_count++] = static_cast<double>(value);
        }
    }
    template <class T, std::size_t N> static void add(LegacyGLCall& call, const std::array<T, N>& values)
    {
        for (const T& value : values) {
            add(call, value);
        }
    }
    /// Blobs and how they are laid out are not numbers.
    template <class T>
        requires(!std::is_arithmetic_v<T>)
    static void add(LegacyGLCall&, const T&)
    {}

    bool active_ = false;
    std::vector<LegacyGLCall> calls_;
};

} // namespace legacygl
