// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/MeshReaders.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace txn {
namespace {

using Path = std::filesystem::path;

enum class Encoding { Ascii, LittleEndian, BigEndian };
enum class NumberType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

std::optional<NumberType> numberType(std::string_view name) {
    using enum NumberType;
    static constexpr std::array<std::string_view, 16> kNames{"char",
                                                             "uchar",
                                                             "short",
                                                             "ushort",
                                                             "int",
                                                             "uint",
                                                             "float",
                                                             "double",
                                                             "int8",
                                                             "uint8",
                                                             "int16",
                                                             "uint16",
                                                             "int32",
                                                             "uint32",
                                                             "float32",
                                                             "float64"};
    static constexpr std::array kTypes{Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double};
    const auto at = static_cast<std::size_t>(std::ranges::find(kNames, name) - kNames.begin());
    return at < kNames.size() ? std::optional(kTypes[at % kTypes.size()]) : std::nullopt;
}

/// What is kept of a vertex: x, y, z, normal, uv.
constexpr std::size_t kSlots = 8;

std::optional<std::size_t> slotOf(std::string_view name) {
    static constexpr std::array<std::array<std::string_view, 4>, kSlots> kNames{
        {{"x"},
         {"y"},
         {"z"},
         {"nx"},
         {"ny"},
         {"nz"},
         {"s", "u", "texture_u", "tx"},
         {"t", "v", "texture_v", "ty"}}};
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
        if (std::ranges::find(kNames[slot], name) != kNames[slot].end())
            return slot;
    }
    return std::nullopt;
}

struct Property {
    std::string name;
    NumberType type = NumberType::Float;
    std::optional<NumberType> countType; ///< set for lists
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

/// The numbers after the header, one after the other.
class NumberReader {
  public:
    NumberReader(std::string_view bytes, Encoding encoding) : m_rest(bytes), m_encoding(encoding) {}

    /// Nothing at the end of the data and where ASCII has no number.
    std::optional<double> next(NumberType type) {
        if (m_encoding == Encoding::Ascii)
            return nextWord();
        switch (type) {
        case NumberType::Int8:
            return nextBinary<std::int8_t>();
        case NumberType::UInt8:
            return nextBinary<std::uint8_t>();
        case NumberType::Int16:
            return nextBinary<std::int16_t>();
        case NumberType::UInt16:
            return nextBinary<std::uint16_t>();
        case NumberType::Int32:
            return nextBinary<std::int32_t>();
        case NumberType::UInt32:
            return nextBinary<std::uint32_t>();
        case NumberType::Float:
            return nextBinary<float>();
        case NumberType::Double:
            return nextBinary<double>();
        }
        return std::nullopt;
    }

  private:
    std::optional<double> nextWord() {
        m_rest.remove_prefix(std::min(m_rest.find_first_not_of(" \t\r\n\v\f"), m_rest.size()));
        if (m_rest.starts_with('+'))
            m_rest.remove_prefix(1);
        double number = 0.0;
        const auto result = std::from_chars(m_rest.data(), m_rest.data() + m_rest.size(), number);
        if (result.ec == std::errc::invalid_argument)
            return std::nullopt;
        // What is too small or too large for double counts as infinite: nothing real is.
        if (result.ec != std::errc())
            number = HUGE_VAL;
        m_rest.remove_prefix(static_cast<std::size_t>(result.ptr - m_rest.data()));
        return number;
    }

    template <class Number>
    std::optional<double> nextBinary() {
        std::array<char, sizeof(Number)> raw{};
        if (m_rest.size() < raw.size())
            return std::nullopt;
        std::copy_n(m_rest.begin(), raw.size(), raw.begin());
        m_rest.remove_prefix(raw.size());
        if ((m_encoding == Encoding::LittleEndian) != (std::endian::native == std::endian::little))
            std::reverse(raw.begin(), raw.end());
        return static_cast<double>(std::bit_cast<Number>(raw));
    }

    std::string_view m_rest;
    Encoding m_encoding;
};

class PlyReader {
  public:
    PlyReader(std::string_view bytes, const Path& path) : m_rest(bytes), m_path(path) {}

    Result<RawMesh> read();

  private:
    Result<void> readHeader();
    bool takeHeaderLine(const std::string& line);
    Result<void> checkElements();
    Result<void> readElement(const Element& element, NumberReader& reader);

    Error unreadable(const std::string& reason) const { return unreadableMesh(m_path, reason); }

    std::string_view m_rest;
    const Path& m_path;
    std::optional<Encoding> m_encoding;
    std::vector<Element> m_elements;
    std::array<bool, kSlots> m_has{}; ///< whether vertices have that slot
    RawMesh m_mesh;
};

bool PlyReader::takeHeaderLine(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    if (words.empty() || words[0] == "ply" || words[0] == "comment" || words[0] == "obj_info")
        return true;
    if (words[0] == "format" && words.size() > 1 && !m_encoding) {
        if (words[1] == "ascii")
            m_encoding = Encoding::Ascii;
        if (words[1] == "binary_little_endian")
            m_encoding = Encoding::LittleEndian;
        if (words[1] == "binary_big_endian")
            m_encoding = Encoding::BigEndian;
        return m_encoding.has_value();
    }
    if (words[0] == "element" && words.size() == 3) {
        Element element{words[1], 0, {}};
        const char* end = words[2].data() + words[2].size();
        const auto parsed = std::from_chars(words[2].data(), end, element.count);
        m_elements.push_back(std::move(element));
        return parsed.ec == std::errc() && parsed.ptr == end;
    }
    const bool list = words.size() == 5 && words[1] == "list";
    if (words[0] != "property" || m_elements.empty() || (!list && words.size() != 3))
        return false;
    const auto type = numberType(words[words.size() - 2]);
    const auto countType = list ? numberType(words[2]) : std::nullopt;
    m_elements.back().properties.push_back(
        {words.back(), type.value_or(NumberType::Float), countType});
    return type && countType.has_value() == list;
}

Result<void> PlyReader::readHeader() {
    while (true) {
        const auto end = m_rest.find('\n');
        if (end == std::string_view::npos)
            return unreadable("its header has no end");
        std::string line(m_rest.substr(0, end));
        m_rest.remove_prefix(end + 1);
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line == "end_header")
            return checkElements();
        if (!takeHeaderLine(line))
            return unreadable("its header has a line that is wrong, or no part of PLY");
    }
}

Result<void> PlyReader::checkElements() {
    const auto countOf = [&](std::string_view name) {
        return std::count_if(m_elements.begin(), m_elements.end(), [&](const Element& element) {
            return element.name == name;
        });
    };
    if (!m_encoding)
        return unreadable("its header does not say in which format it is");
    if (countOf("tristrips") > 0 && countOf("face") == 0)
        return Error{ErrorCode::Unsupported,
                     unreadable("it has triangle strips; save it with faces instead").message};
    for (const Element& element : m_elements) {
        if (element.name == "vertex" && element.count > kMostVertices)
            return tooLargeMesh(m_path, "vertices");
        if (element.name == "face" && element.count > kMostTriangles)
            return tooLargeMesh(m_path, "triangles");
        for (const Property& property : element.properties) {
            if (const auto slot = slotOf(property.name);
                slot && element.name == "vertex" && !property.countType)
                m_has[*slot] = true;
        }
    }
    if (countOf("vertex") != 1 || !m_has[0] || !m_has[1] || !m_has[2])
        return unreadable("it needs one list of vertices with x, y and z");
    if (countOf("face") > 1)
        return unreadable("it has more than one list of faces");
    return {};
}

Result<void> PlyReader::readElement(const Element& element, NumberReader& reader) {
    const bool isVertex = element.name == "vertex";
    const bool isFace = element.name == "face";
    const bool normals = m_has[3] && m_has[4] && m_has[5];
    const bool uvs = m_has[6] && m_has[7];
    const auto wrong = [&](std::uint64_t i) {
        return unreadable(
            "its data end early or are wrong" +
            (isVertex || isFace ? " in " + element.name + " " + std::to_string(i) : std::string()));
    };
    if (element.properties.empty() && !isFace)
        return {};
    std::array<float, kSlots> values{};
    std::vector<std::optional<std::size_t>> slots;
    for (const Property& property : element.properties)
        slots.push_back(isVertex && !property.countType ? slotOf(property.name) : std::nullopt);
    for (std::uint64_t i = 0; i < element.count; ++i) {
        bool cornersFound = false;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const Property& property = element.properties[p];
            if (!property.countType) {
                const auto value = reader.next(property.type);
                if (!value)
                    return wrong(i);
                if (slots[p]) // far beyond what is accepted, and NaN stays
                    values[*slots[p]] = static_cast<float>(std::clamp(*value, -1e30, 1e30));
                continue;
            }
            const auto count = reader.next(*property.countType);
            if (!count || !(*count >= 0.0) || *count != std::floor(*count))
                return wrong(i);
            const bool isCorners =
                isFace && !cornersFound &&
                (property.name == "vertex_indices" || property.name == "vertex_index");
            cornersFound = cornersFound || isCorners;
            // More than any file has; the end of the data stops it.
            const auto items = static_cast<std::uint64_t>(std::min(*count, 0x1p40));
            if (isCorners) {
                if (auto begun = m_mesh.beginFace(items, m_path); !begun)
                    return begun.error();
            }
            for (std::uint64_t k = 0; k < items; ++k) {
                const auto value = reader.next(property.type);
                if (!value)
                    return wrong(i);
                if (!isCorners)
                    continue;
                if (!(*value >= 0.0 && *value < kMostVertices) || *value != std::floor(*value))
                    return unreadable("a face has an index out of range");
                const auto index = static_cast<std::uint32_t>(*value);
                m_mesh.corners.push_back(
                    {index, uvs ? index : kNoIndex, normals ? index : kNoIndex});
            }
        }
        if (isFace && !cornersFound)
            return unreadable("its faces have no vertex_indices");
        if (isVertex) {
            m_mesh.positions.emplace_back(values[0], values[1], values[2]);
            if (normals)
                m_mesh.normals.emplace_back(values[3], values[4], values[5]);
            if (uvs)
                m_mesh.uvs.emplace_back(values[6], values[7]);
        }
    }
    return {};
}

Result<RawMesh> PlyReader::read() {
    if (auto header = readHeader(); !header)
        return header.error();
    NumberReader reader(m_rest, *m_encoding);
    for (const Element& element : m_elements) {
        if (auto done = readElement(element, reader); !done)
            return done.error();
    }
    return std::move(m_mesh);
}

} // namespace

Result<RawMesh> readPly(std::string_view bytes, const Path& path) {
    return PlyReader(bytes, path).read();
}

} // namespace txn
