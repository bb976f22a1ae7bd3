#include "output.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace fs = std::filesystem;

output_folder::output_folder(fs::path folder_, const std::vector<std::string>& names_)
    : folder(std::move(folder_)), names(names_) {
    std::error_code error;
    for (fs::path p = fs::absolute(folder); !fs::exists(p, error); p = p.parent_path()) made.push_back(p);
    fs::create_directories(folder, error);
    if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
    if (error) throw std::runtime_error(folder.string() + ": cannot be the output folder: " + error.message());

    for (const std::string& name : names) {
        if (fs::is_directory(folder / name))
            throw std::runtime_error((folder / name).string() + ": is a folder, and a picture is to be written there");
        if (!std::ofstream{temporary(name)})
            throw std::runtime_error(folder.string() + ": cannot be written to: " + std::strerror(errno));
        fs::remove(temporary(name));
    }
}

output_folder::~output_folder() {
    std::error_code ignored;
    for (const std::string& name : names) fs::remove(temporary(name), ignored);
    for (const fs::path& p : made) fs::remove(p, ignored);  // no effect once it holds a file
}

void output_folder::commit() {
    for (const std::string& name : names) fs::rename(temporary(name), folder / name);
}
