#include "fixtures.h"

#include "app/fields.h"
#include "app/tasks.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace app {

namespace {

constexpr char TRIANGLE[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";

} // namespace

std::string tiny_tga()
{
    // Header: uncompressed true colour, 2 x 2, 24 bits, rows from the bottom.
    std::string bytes = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0};
    for (int i = 0; i < 12; ++i) {
        bytes.push_back(static_cast<char>(20 * i));
    }
    return bytes;
}

Files Files::complete()
{
    Files files;
    for (const MeshFile& file : mesh_files()) {
        files.add(std::string(file.name), TRIANGLE);
    }
    files.add("texture.tga", tiny_tga());
    return files;
}

void Files::add(const std::string& name, const std::string& text)
{
    files_[name] = text;
}

void Files::remove(const std::string& name)
{
    files_.erase(name);
}

std::vector<AssetFile> Files::views() const
{
    std::vector<AssetFile> views;
    for (const auto& [name, text] : files_) {
        views.push_back({name, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}});
    }
    return views;
}

const Assets& tiny_assets()
{
    static const Assets MADE = [] {
        const Files files = Files::complete();
        mesh::Result<Assets> assets = read_assets(files.views());
        if (!assets) {
            std::abort();
        }
        return assets.value();
    }();
    return MADE;
}

Files own_files()
{
    Files files;
    const std::filesystem::path folder = std::filesystem::path(REPOSITORY) / "assets";
    for (const std::filesystem::path& from : {folder, folder / "tankobjs"}) {
        for (const auto& entry : std::filesystem::directory_iterator(from)) {
            if (entry.is_regular_file()) {
                std::ifstream stream(entry.path(), std::ios::binary);
                files.add(entry.path().filename().string(),
                          std::string(std::istreambuf_iterator<char>(stream), {}));
            }
        }
    }
    return files;
}

const Assets& own_assets()
{
    static const Assets MADE = [] {
        const Files files = own_files();
        mesh::Result<Assets> assets = read_assets(files.views());
        if (!assets) {
            std::abort();
        }
        return assets.value();
    }();
    return MADE;
}

double next_unit(std::mt19937_64& random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

State random_state(std::mt19937_64& random)
{
    State state;
    for (const Field& field : fields()) {
        if (!field.choices.empty()) {
            set_grid_value(field, state, static_cast<std::int64_t>(random() % field.choices.size()));
            continue;
        }
        switch (random() % 4) {
        case 0: // the default
            break;
        case 1: // an end
            field.set(state, within_limits(field, random() % 2 ? field.minimum : field.maximum));
            break;
        default:
            const double part = next_unit(random);
            field.set(state, within_limits(field, field.minimum + (field.maximum - field.minimum) * part));
        }
    }
    if (random() % 2 == 0) {
        state.task = random() % tasks().size();
    }
    state.tick = random() % 1000;
    state.held[random() % 8] = true;
    state.revision.count = random() % 1000;
    return state;
}

} // namespace app
