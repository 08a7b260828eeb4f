#pragma once

#include "legacygl/list/blob.h"
#include "legacygl/list/list_geometry.h"
#include "legacygl/vertex/assembler.h"

#include <GL/gl.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace legacygl {

struct Context;

/// Draws a list's vertices where the list is called. The context's to do: a list knows only what to draw.
using Replay = void (*)(Context& gl, ListGeometry& geometry);

/// The commands of one list, in the order they were given (OpenGL 1.5, 5.4).
///
/// A command is a trivially copyable callable, stored by value one behind the other; vertices are packed
/// into geometry that one command draws. A list that does nothing else has that geometry within itself: a
/// program that calls a thousand small lists waits for memory most of all.
class DisplayList
{
public:
    template <class Command> void append(const Command& command)
    {
        static_assert(std::is_trivially_copyable_v<Command> && alignof(Command) <= alignof(Word));
        const std::size_t words = (sizeof(Command) + sizeof(Word) - 1) / sizeof(Word);
        const std::size_t at = commands_.size();
        commands_.resize(at + HEADER_WORDS + words);
        new (&commands_[at])
            Header{[](Context& gl, const void* payload) { (*static_cast<const Command*>(payload))(gl); },
                   static_cast<std::uint32_t>(words)};
        new (&commands_[at + HEADER_WORDS]) Command(command);
        ++command_count_;
    }
    /// Has the vertices drawn at this place of the list.
    void append(VertexBatch batch, Replay replay);
    /// Copies bytes into the list, where they stay as long as it.
    Blob keep(const Blob& blob);

    /// Ends the list: nothing is appended any more.
    void finish();

    /// Runs the commands, in order. replay: as given to append().
    void run(Context& gl, Replay replay);

private:
    using Word = std::uint64_t;
    struct Header
    {
        void (*run)(Context& gl, const void* payload);
        std::uint32_t words;
    };
    static constexpr std::size_t HEADER_WORDS = (sizeof(Header) + sizeof(Word) - 1) / sizeof(Word);

    std::optional<ListGeometry> only_; ///< What a finished list draws that has no commands.
    std::uint32_t command_count_ = 0;
    std::vector<Word> commands_;
    std::vector<std::unique_ptr<ListGeometry>> geometry_;
    std::vector<std::unique_ptr<std::uint8_t[]>> blobs_;
};

/// A list between glNewList and glEndList.
class ListCompiler
{
public:
    ListCompiler(GLuint name, bool executes, Replay replay)
        : name_(name), executes_(executes), replay_(replay)
    {}
    GLuint name() const { return name_; }
    bool executes() const { return executes_; }
    /// Where glBegin, glVertex … go.
    VertexAssembler& vertices() { return vertices_; }

    template <class Command> void append(const Command& command)
    {
        close_batch();
        list_.append(command);
    }
    Blob keep(const Blob& blob) { return list_.keep(blob); }
    DisplayList finish()
    {
        close_batch();
        list_.finish();
        return std::move(list_);
    }

private:
    void close_batch()
    {
        if (!vertices_.batch().empty() || vertices_.inside()) {
            list_.append(vertices_.take(), replay_);
        }
    }

    GLuint name_;
    bool executes_;
    Replay replay_;
    CurrentAttributes current_ = initial_attributes();
    VertexAssembler vertices_{current_, VertexAssembler::Use::list};
    DisplayList list_;
};

/// All lists by name; a name may stand for an empty list.
class ListStore
{
public:
    ListStore() { add_chunk(); }
    /// Returns the list, or null. It stays until its name is given another list or erased, which no list that
    /// runs can do: those commands are never compiled.
    DisplayList* find(GLuint name)
    {
        const Place place = place_of(name);
        return place == NONE ? nullptr : &at(place);
    }
    bool contains(GLuint name) const { return place_of(name) != NONE; }
    void put(GLuint name, DisplayList list);
    /// Makes range empty lists with names in a row and returns the first; 0 when no such row is free.
    GLuint generate(GLsizei range);
    void erase(GLuint first, GLsizei range);

private:
    /// Where a list lies; all empty ones share a place.
    using Place = std::uint32_t;
    static constexpr Place NONE = 0, EMPTY = 1;
    /// Lists lie side by side in chunks, in the order they were made, which they are mostly called in, too.
    static constexpr std::size_t CHUNK = 64;
    using Chunk = std::array<DisplayList, CHUNK>;
    /// Lists by names below LOW, which generated ones are, are found at once.
    static constexpr GLuint LOW = 1u << 16;

    DisplayList& at(Place place) { return (*chunks_[place / CHUNK])[place % CHUNK]; }
    Place place_of(GLuint name) const
    {
        if (name < low_.size()) {
            return low_[name];
        }
        const auto found = high_.find(name);
        return found == high_.end() ? NONE : found->second;
    }
    void add_chunk() { chunks_.push_back(std::make_unique<Chunk>()); }
    Place make_place();
    void set_place(GLuint name, Place place);
    void release(Place place);

    std::vector<std::unique_ptr<Chunk>> chunks_;
    Place made_ = EMPTY + 1; ///< How many places there are, free ones too.
    std::vector<Place> free_;
    std::vector<Place> low_;
    std::map<GLuint, Place> high_; ///< By any other name.
};

} // namespace legacygl
