#include "legacygl/list/display_list.h"

#include <cstring>
#include <utility>

namespace legacygl {

void DisplayList::append(VertexBatch batch, Replay replay)
{
    geometry_.push_back(std::make_unique<ListGeometry>(std::move(batch)));
    append([geometry = geometry_.back().get(), replay](Context& gl) { replay(gl, *geometry); });
}

Blob DisplayList::keep(const Blob& blob)
{
    if (blob.size == 0) {
        return {nullptr, 0};
    }
    blobs_.push_back(std::make_unique<std::uint8_t[]>(blob.size));
    std::memcpy(blobs_.back().get(), blob.data, blob.size);
    return {blobs_.back().get(), blob.size};
}

void DisplayList::finish()
{
    if (geometry_.size() == 1 && command_count_ == 1) {
        only_ = std::move(*geometry_.front());
        geometry_.clear();
        commands_.clear();
    }
    commands_.shrink_to_fit();
}

void DisplayList::run(Context& gl, Replay replay)
{
    if (only_) {
        return replay(gl, *only_);
    }
    for (std::size_t at = 0; at < commands_.size();) {
        const auto* header = reinterpret_cast<const Header*>(&commands_[at]);
        header->run(gl, &commands_[at + HEADER_WORDS]);
        at += HEADER_WORDS + header->words;
    }
}

ListStore::Place ListStore::make_place()
{
    if (!free_.empty()) {
        const Place place = free_.back();
        free_.pop_back();
        return place;
    }
    if (made_ / CHUNK >= chunks_.size()) {
        add_chunk();
    }
    return made_++;
}

void ListStore::release(Place place)
{
    if (place == NONE || place == EMPTY) {
        return;
    }
    at(place) = DisplayList{};
    free_.push_back(place);
}

void ListStore::set_place(GLuint name, Place place)
{
    if (name < LOW && name >= low_.size()) {
        low_.resize(std::size_t{name} + 1, NONE);
    }
    release(std::exchange(name < LOW ? low_[name] : high_[name], place));
}

void ListStore::put(GLuint name, DisplayList list)
{
    const Place place = make_place();
    at(place) = std::move(list);
    set_place(name, place);
}

GLuint ListStore::generate(GLsizei range)
{
    const auto count = static_cast<std::uint64_t>(range);
    std::uint64_t first = 1;
    for (std::uint64_t name = 1; name < low_.size() && name < first + count; ++name) {
        if (low_[name]) {
            first = name + 1;
        }
    }
    for (const auto& [name, list] : high_) {
        if (name >= first + count) {
            break;
        }
        if (name >= first) {
            first = std::uint64_t{name} + 1;
        }
    }
    if (count == 0 || first + count - 1 > 0xffffffffu) {
        return 0;
    }
    for (std::uint64_t i = 0; i < count; ++i) {
        set_place(static_cast<GLuint>(first + i), EMPTY);
    }
    return static_cast<GLuint>(first);
}

void ListStore::erase(GLuint first, GLsizei range)
{
    const std::uint64_t end = std::uint64_t{first} + static_cast<std::uint64_t>(range);
    for (std::uint64_t name = first; name < end && name < low_.size(); ++name) {
        release(std::exchange(low_[name], NONE));
    }
    for (auto it = high_.lower_bound(first); it != high_.end() && it->first < end;) {
        release(it->second);
        it = high_.erase(it);
    }
}

} // namespace legacygl
