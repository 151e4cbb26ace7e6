// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ProjectThumbnail.h"

#include "core/image/ImageIo.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

namespace txn::cli {
namespace {

namespace fs = std::filesystem;

/// "This is CBOR": the tag 55799.
constexpr std::array<char, 3> kSignature{'\xd9', '\xd9', '\xf7'};

/// Takes the byte string "thumbnail" of the outermost map, and stops there.
class ThumbnailFinder final : public nlohmann::json_sax<nlohmann::json> {
  public:
    const std::vector<std::uint8_t>& found() const { return m_found; }

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t& bytes) override {
        if (m_depth == 1 && m_isNext) {
            m_found = std::move(bytes);
            return false;
        }
        return true;
    }
    bool key(string_t& name) override {
        m_isNext = m_depth == 1 && name == "thumbnail";
        return true;
    }
    bool start_object(std::size_t) override { return ++m_depth <= kDeepest; }
    bool start_array(std::size_t) override { return ++m_depth <= kDeepest; }
    bool end_object() override { return leave(); }
    bool end_array() override { return leave(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
        return false;
    }

  private:
    /// The parser calls itself for each level, and hostile files have many.
    static constexpr int kDeepest = 32;

    bool leave() {
        --m_depth;
        return true;
    }

    int m_depth = 0;
    bool m_isNext = false;
    std::vector<std::uint8_t> m_found;
};

bool skipSignature(std::istream& file) {
    std::array<char, kSignature.size()> start{};
    return file.read(start.data(), start.size()) && start == kSignature;
}

} // namespace

bool isProject(const fs::path& path) {
    std::error_code error;
    std::ifstream file(path, std::ios::binary);
    return fs::is_regular_file(path, error) && skipSignature(file);
}

Result<Image> projectThumbnail(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return Error{ErrorCode::NotFound, quoted(path) + " was not found"};
    if (!skipSignature(file))
        return Error{ErrorCode::Unreadable, quoted(path) + " is not a Texton Studio project"};
    ThumbnailFinder finder;
    nlohmann::json::sax_parse(file, &finder, nlohmann::json::input_format_t::cbor);
    if (finder.found().empty())
        return Error{ErrorCode::Unreadable,
                     quoted(path) + " holds no picture of itself; open it and save it again"};
    auto loaded = loadImage(finder.found(), path);
    if (!loaded)
        return loaded.error();
    return std::move(loaded->image);
}

} // namespace txn::cli
