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

std::shared_ptr<const DisplayList> ListStore::find(GLuint name) const
{
    const auto found = lists_.find(name);
    return found == lists_.end() ? nullptr : found->second;
}

GLuint ListStore::generate(GLsizei range)
{
    const auto count = static_cast<std::uint64_t>(range);
    std::uint64_t first = 1;
    for (const auto& [name, list] : lists_) {
        if (name >= first + count)
            break;
        if (name >= first)
            first = static_cast<std::uint64_t>(name) + 1;
    }
    if (count == 0 || first + count - 1 > 0xffffffffu)
        return 0;
    const auto empty = std::make_shared<const DisplayList>();
    for (std::uint64_t i = 0; i < count; ++i)
        lists_[static_cast<GLuint>(first + i)] = empty;
    return static_cast<GLuint>(first);
}

void ListStore::erase(GLuint first, GLsizei range)
{
    const std::uint64_t end = static_cast<std::uint64_t>(first) + static_cast<std::uint64_t>(range);
    for (auto it = lists_.lower_bound(first); it != lists_.end() && it->first < end;)
        it = lists_.erase(it);
}

} // namespace legacygl
