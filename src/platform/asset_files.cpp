#include "platform/asset_files.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <vector>

namespace platform {
namespace {

namespace fs = std::filesystem;

/// No mesh or texture comes near this; what does is not one, and must not take all memory.
constexpr std::uintmax_t MOST_BYTES = std::uintmax_t{256} << 20;

struct FileContent
{
    std::string path;
    std::vector<std::uint8_t> bytes;
};

std::string lower_case(std::string text)
{
    for (char& letter : text) {
        if (letter >= 'A' && letter <= 'Z') {
            letter = static_cast<char>(letter - 'A' + 'a');
        }
    }
    return text;
}

/// Tells whether read_assets() has a use for a file of this name.
bool is_wanted(const std::string& name)
{
    const std::string lower = lower_case(name);
    const auto matches = [&lower](std::string_view wanted) {
        return lower_case(std::string(wanted)) == lower;
    };
    const auto meshes = app::mesh_files();
    const auto textures = app::texture_file_names();
    return std::any_of(meshes.begin(), meshes.end(),
                       [&](const app::MeshFile& file) { return matches(file.name); }) ||
           std::any_of(textures.begin(), textures.end(), matches);
}

/// Reads a whole file. Returns "" or why it cannot be read.
std::string read_file(const fs::path& path, std::vector<std::uint8_t>& bytes)
{
    std::error_code fault;
    if (!fs::is_regular_file(path, fault)) {
        return path.string() + ": is not a file";
    }
    if (fs::file_size(path, fault) > MOST_BYTES) {
        return path.string() + ": is too large to be read (more than 256 MB)";
    }
    errno = 0;
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
        return path.string() + ": cannot be read: " + std::strerror(errno);
    }
    std::uint8_t buffer[1 << 16];
    std::size_t count = 0;
    while ((count = std::fread(buffer, 1, sizeof buffer, file)) > 0) {
        bytes.insert(bytes.end(), buffer, buffer + count);
    }
    const bool failed = std::ferror(file) != 0;
    const std::string cause = std::strerror(errno);
    std::fclose(file);
    return failed ? path.string() + ": cannot be read: " + cause : "";
}

/// Appends the wanted files of one folder, in the order of their names.
std::string read_wanted_files(const fs::path& folder, std::vector<FileContent>& files)
{
    std::error_code fault;
    std::vector<fs::path> paths;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
        if (is_wanted(entry->path().filename().string())) {
            paths.push_back(entry->path());
        }
    }
    if (fault) {
        return folder.string() + ": the folder cannot be read: " + fault.message();
    }
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        files.push_back({path.string(), {}});
        if (std::string error = read_file(path, files.back().bytes); !error.empty()) {
            return error;
        }
    }
    return "";
}

/// Returns the folder `assets` that comes with the program, or "".
std::string find_own_folder()
{
    std::error_code fault;
    const fs::path executable = fs::read_symlink("/proc/self/exe", fault);
    if (fault) {
        return "";
    }
    for (fs::path folder = executable.parent_path();; folder = folder.parent_path()) {
        const fs::path candidate = folder / "assets";
        if (fs::is_directory(candidate / "tankobjs", fault)) {
            return candidate.string();
        }
        if (folder == folder.root_path() || folder.empty()) {
            return "";
        }
    }
}

} // namespace

std::string read_asset_folder(const std::string& folder, app::Assets& assets)
{
    std::vector<FileContent> contents;
    if (std::string error = read_wanted_files(folder, contents); !error.empty()) {
        return error;
    }
    const fs::path meshes = fs::path(folder) / "tankobjs";
    std::error_code ignored;
    if (fs::is_directory(meshes, ignored)) {
        if (std::string error = read_wanted_files(meshes, contents); !error.empty()) {
            return error;
        }
    }
    std::vector<app::AssetFile> files;
    files.reserve(contents.size());
    for (const FileContent& content : contents) {
        files.push_back({content.path, content.bytes});
    }
    mesh::Result<app::Assets> read = app::read_assets(files);
    if (!read) {
        return folder + ": " + read.error().message();
    }
    assets = std::move(read).value();
    return "";
}

std::string read_asset_folder_or_own(const std::string& folder, app::Assets& assets)
{
    const std::string used = folder.empty() ? find_own_folder() : folder;
    if (used.empty()) {
        return "There is no folder 'assets' with the tank's files near the program: name it with --assets.";
    }
    return read_asset_folder(used, assets);
}

} // namespace platform
