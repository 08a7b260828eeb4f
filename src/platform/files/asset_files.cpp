#include "platform/files/asset_files.h"

#include "app/view/camera_view.h"
#include "assets/asset_sources.h"

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
constexpr std::uintmax_t MAX_BYTES = std::uintmax_t{256} << 20;

/// How deep the files may lie, and among how many others.
constexpr int DEEPEST_FOLDER = 8;
constexpr int MAX_ENTRIES = 100'000;

/// Archives that a Mac has packed hold a copy of each name in here that is no copy of the file.
constexpr std::string_view MAC_FOLDER = "__MACOSX";

struct FileContent
{
    std::string path;
    std::vector<std::uint8_t> bytes;
};

/// Reads a whole file. Returns "" or why it cannot be read.
std::string read_file(const fs::path& path, std::vector<std::uint8_t>& bytes)
{
    std::error_code fault;
    if (!fs::is_regular_file(path, fault)) {
        return path.string() + ": is not a file";
    }
    if (fs::file_size(path, fault) > MAX_BYTES) {
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

/// Appends the paths of the wanted files in a folder and, `depth` levels down, in those in it, in the order
/// of their names. What may not be looked into is passed by.
std::string find_wanted_files(const fs::path& folder, int depth, std::vector<fs::path>& paths,
                              int& entries_left)
{
    std::error_code fault;
    std::vector<fs::path> found;
    std::vector<fs::path> folders;
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
        if (--entries_left < 0) {
            return folder.string() + ": there are too many files; name the folder of the tank's own files";
        }
        const std::string name = entry->path().filename().string();
        std::error_code ignored;
        if (assets::is_asset_name(name)) {
            found.push_back(entry->path());
        } else if (depth > 0 && name != MAC_FOLDER && entry->is_directory(ignored) &&
                   !entry->is_symlink(ignored)) {
            folders.push_back(entry->path());
        }
    }
    if (fault) {
        return folder.string() + ": the folder cannot be read: " + fault.message();
    }
    std::sort(found.begin(), found.end());
    std::sort(folders.begin(), folders.end());
    paths.insert(paths.end(), found.begin(), found.end());
    for (const fs::path& below : folders) {
        const std::string error = find_wanted_files(below, depth - 1, paths, entries_left);
        if (entries_left < 0) {
            return error;
        }
    }
    return "";
}

/// Reads the wanted files of a folder, `depth` levels down. Returns "" or what cannot be read.
std::string read_wanted_files(const fs::path& folder, int depth, std::vector<FileContent>& files)
{
    std::vector<fs::path> paths;
    int entries_left = MAX_ENTRIES;
    if (std::string error = find_wanted_files(folder, depth, paths, entries_left); !error.empty()) {
        return error;
    }
    for (const fs::path& path : paths) {
        files.push_back({path.string(), {}});
        if (std::string error = read_file(path, files.back().bytes); !error.empty()) {
            return error;
        }
    }
    return "";
}

std::vector<assets::AssetFile> views_of(const std::vector<FileContent>& contents)
{
    std::vector<assets::AssetFile> files;
    files.reserve(contents.size());
    for (const FileContent& content : contents) {
        files.push_back({content.path, content.bytes});
    }
    return files;
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

std::string read_asset_folder(const std::string& folder, assets::Assets& assets)
{
    std::vector<FileContent> contents;
    if (std::string error = read_wanted_files(folder, 1, contents); !error.empty()) {
        return error;
    }
    base::Result<assets::Assets> read = assets::read_assets(views_of(contents), app::paint_view());
    if (!read) {
        return folder + ": " + read.error().message();
    }
    assets = std::move(read).value();
    return "";
}

std::string read_tank(const std::string& folder, assets::UsersTank& tank)
{
    if (folder.empty()) {
        const std::string own = find_own_folder();
        if (own.empty()) {
            return "There is no folder 'assets' with the tank's files near the program: name it with "
                   "--assets.";
        }
        tank = {};
        return read_asset_folder(own, tank.assets);
    }
    std::vector<FileContent> contents;
    if (std::string error = read_wanted_files(folder, DEEPEST_FOLDER, contents); !error.empty()) {
        return error;
    }
    base::Result<assets::UsersTank> read = assets::read_users_tank(views_of(contents), app::paint_view());
    if (!read) {
        return folder + ": " + read.error().message();
    }
    tank = std::move(read).value();
    return "";
}

} // namespace platform
