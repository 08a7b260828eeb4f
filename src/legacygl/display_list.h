#pragma once

#include "legacygl/capture.h"
#include "legacygl/list_geometry.h"
#include "legacygl/vertex_assembler.h"

#include <GL/gl.h>

#include <cstdint>
#include <map>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace legacygl {

struct Context;

/// The commands of one list, in the order they were given (OpenGL 1.5, 5.4).
///
/// A command is a trivially copyable callable, stored by value one behind the other; vertices are packed
/// into geometry that one command draws.
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
    }
    /// Draws the vertices at this place of the list.
    void append(VertexBatch batch);
    /// Copies bytes into the list, where they stay as long as it.
    Blob keep(const Blob& blob);

    void run(Context& gl) const;

private:
    using Word = std::uint64_t;
    struct Header
    {
        void (*run)(Context& gl, const void* payload);
        std::uint32_t words;
    };
    static constexpr std::size_t HEADER_WORDS = (sizeof(Header) + sizeof(Word) - 1) / sizeof(Word);

    std::vector<Word> commands_;
    std::vector<std::unique_ptr<ListGeometry>> geometry_;
    std::vector<std::unique_ptr<std::uint8_t[]>> blobs_;
};

/// A list between glNewList and glEndList.
class ListCompiler
{
public:
    ListCompiler(GLuint name, bool executes) : name_(name), executes_(executes) {}
    GLuint name() const { return name_; }
    bool executes() const { return executes_; }
    /// Where glBegin, glVertex … go.
    VertexAssembler& vertices() { return vertices_; }

    template <class Command> void append(const Command& command)
    {
        close_batch();
        list_->append(command);
    }
    Blob keep(const Blob& blob) { return list_->keep(blob); }
    std::shared_ptr<DisplayList> finish()
    {
        close_batch();
        return std::move(list_);
    }

private:
    void close_batch()
    {
        if (!vertices_.batch().empty() || vertices_.inside())
            list_->append(vertices_.take());
    }

    GLuint name_;
    bool executes_;
    CurrentAttributes current_ = initial_attributes();
    VertexAssembler vertices_{current_, VertexAssembler::Use::list};
    std::shared_ptr<DisplayList> list_ = std::make_shared<DisplayList>();
};

/// All lists by name; a name may stand for an empty list.
class ListStore
{
public:
    /// Returns the list, or null. The caller shares it, so that it survives its own deletion.
    std::shared_ptr<const DisplayList> find(GLuint name) const
    {
        if (name < low_.size())
            return low_[name];
        const auto found = high_.find(name);
        return found == high_.end() ? nullptr : found->second;
    }
    bool contains(GLuint name) const { return find(name) != nullptr; }
    void put(GLuint name, std::shared_ptr<const DisplayList> list);
    /// Makes range empty lists with names in a row and returns the first; 0 when no such row is free.
    GLuint generate(GLsizei range);
    void erase(GLuint first, GLsizei range);

private:
    /// Lists by names below LOW, which generated ones are: found at once. Null: there is none.
    static constexpr GLuint LOW = 1u << 16;
    std::vector<std::shared_ptr<const DisplayList>> low_;
    std::map<GLuint, std::shared_ptr<const DisplayList>> high_; ///< By any other name.
};

} // namespace legacygl
