#include "app/state/state.h"

#include "app/state/fields.h"

namespace app {

namespace {

void append_bytes(std::string& bytes, std::uint64_t value)
{
    for (int shift = 0; shift < 64; shift += 8) {
        bytes.push_back(static_cast<char>((value >> shift) & 0xff));
    }
}

void append_bytes(std::string& bytes, double value)
{
    // -0 equals 0, so both are written as 0.
    append_bytes(bytes, __builtin_bit_cast(std::uint64_t, value == 0.0 ? 0.0 : value));
}

} // namespace

State::State()
{
    for (const Field& field : fields()) {
        set_grid_value(field, *this, field.initial);
    }
}

std::string serialised(const State& state)
{
    std::string bytes;
    for (const Field& field : fields()) {
        append_bytes(bytes, field.get(state));
    }
    append_bytes(bytes, state.task ? std::uint64_t{*state.task + 1} : std::uint64_t{0});
    for (std::size_t i = 0; i < state.held.size(); ++i) {
        bytes.push_back(state.held[i] ? '1' : '0');
    }
    append_bytes(bytes, state.tick);
    append_bytes(bytes, state.seed);
    append_bytes(bytes, std::uint64_t{state.shot.flies});
    for (const glm::dvec3& vector : {state.shot.origin, state.shot.velocity}) {
        append_bytes(bytes, vector.x);
        append_bytes(bytes, vector.y);
        append_bytes(bytes, vector.z);
    }
    append_bytes(bytes, std::uint64_t{state.shot.age});
    append_bytes(bytes, static_cast<std::uint64_t>(state.event.kind));
    append_bytes(bytes, std::uint64_t{state.event.age});
    return bytes;
}

std::uint64_t hash(const State& state)
{
    std::uint64_t hash = 0xcbf29ce484222325;
    for (char byte : serialised(state)) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    return hash;
}

} // namespace app
