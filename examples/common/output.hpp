#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// A folder that receives all of its files or none: they are written under temporary names and renamed together.
class output_folder {
public:
    /// Makes the folder if need be and proves at once that the named files can be written into it.
    /// Throws std::runtime_error, "FOLDER: problem".
    output_folder(std::filesystem::path folder, const std::vector<std::string>& names);
    ~output_folder();
    output_folder(const output_folder&) = delete;
    output_folder& operator=(const output_folder&) = delete;

    std::filesystem::path temporary(const std::string& name) const { return folder / ("." + name + ".partial"); }
    void commit();

private:
    std::filesystem::path folder;
    std::vector<std::string> names;
    std::vector<std::filesystem::path> made;  // the folder and those above it that were not there
};
