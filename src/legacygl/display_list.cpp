#include "legacygl/display_list.h"

#include "legacygl/list_replay.h"

#include <cstring>

namespace legacygl {

void DisplayList::append(VertexBatch batch)
{
    geometry_.push_back(std::make_unique<ListGeometry>(std::move(batch)));
    append([geometry = geometry_.back().get()](Context& gl) { replay(gl, *geometry); });
}

Blob DisplayList::keep(const Blob& blob)
{
    if (blob.size == 0)
        return {nullptr, 0};
    blobs_.push_back(std::make_unique<std::uint8_t[]>(blob.size));
    std::memcpy(blobs_.back().get(), blob.data, blob.size);
    return {blobs_.back().get(), blob.size};
}

void DisplayList::run(Context& gl) const
{
    for (std::size_t at = 0; at < commands_.size();) {
        const auto* header = reinterpret_cast<const Header*>(&commands_[at]);
        header->run(gl, &commands_[at + HEADER_WORDS]);
        at += HEADER_WORDS + header->words;
    }
}

void ListStore::put(GLuint name, std::shared_ptr<const DisplayList> list)
{
    if (name >= LOW) {
        high_[name] = std::move(list);
        return;
    }
    if (name >= low_.size())
        low_.resize(std::size_t{name} + 1);
    low_[name] = std::move(list);
}

GLuint ListStore::generate(GLsizei range)
{
    const auto count = static_cast<std::uint64_t>(range);
    std::uint64_t first = 1;
    for (std::uint64_t name = 1; name < low_.size() && name < first + count; ++name)
        if (low_[name])
            first = name + 1;
    for (const auto& [name, list] : high_) {
        if (name >= first + count)
            break;
        if (name >= first)
            first = std::uint64_t{name} + 1;
    }
    if (count == 0 || first + count - 1 > 0xffffffffu)
        return 0;
    const auto empty = std::make_shared<const DisplayList>();
    for (std::uint64_t i = 0; i < count; ++i)
        put(static_cast<GLuint>(first + i), empty);
    return static_cast<GLuint>(first);
}

void ListStore::erase(GLuint first, GLsizei range)
{
    const std::uint64_t end = std::uint64_t{first} + static_cast<std::uint64_t>(range);
    for (std::uint64_t name = first; name < end && name < low_.size(); ++name)
        low_[name] = nullptr;
    for (auto it = high_.lower_bound(first); it != high_.end() && it->first < end;)
        it = high_.erase(it);
}

} // namespace legacygl
