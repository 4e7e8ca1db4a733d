// SPDX-License-Identifier: BSD-3-Clause
// Words, names and checksum of saved states: see sections.hpp.
#include "sections.hpp"

#include <array>

namespace pw85::detail::simulation {

namespace {

constexpr std::uint64_t format = 1;

/// As that of PNG: the first byte is not ASCII, and a transfer that changes ends of lines shows.
constexpr char signature[] = "\x89PW85\r\n\x1a";

constexpr char const *names[num_sections] = {"SETTINGS", "CELL    ", "PARTICLE",
                                             "LAW     ", "MESH    ", "SPECIES ",
                                             "WALLS   ", "FIELDS  ", "POTENTIA"};

constexpr std::size_t bytes_of_head = 3 * bytes_of_word; ///< signature, format, number of bytes

/// Bytes whose remainders are added at once.
constexpr std::size_t bytes_of_block = 2 * bytes_of_word;

/// remainders[k][b] is the remainder of byte b that k zero bytes follow. The polynomial is
/// 0x04c11db7, with the order of bits reversed.
constexpr auto remainders = [] {
    std::array<std::array<std::uint32_t, 256>, bytes_of_block> made{};
    for (std::uint32_t b = 0; b < 256; ++b) {
        std::uint32_t x = b;
        for (int bit = 0; bit < 8; ++bit) x = x >> 1 ^ (x & 1 ? 0xedb88320u : 0u);
        made[0][b] = x;
    }
    for (std::size_t k = 1; k < bytes_of_block; ++k)
        for (std::size_t b = 0; b < 256; ++b)
            made[k][b] = made[k - 1][b] >> 8 ^ made[0][made[k - 1][b] & 255];
    return made;
}();

/// The remainder of a word that some bytes follow.
[[gnu::always_inline]] inline std::uint32_t remainder_of(std::uint64_t word,
                                                         std::size_t num_following) noexcept
{
    std::uint32_t sum = 0;
    for (std::size_t b = 0; b < bytes_of_word; ++b)
        sum ^= remainders[num_following + bytes_of_word - 1 - b][word >> 8 * b & 255];
    return sum;
}

/// The CRC-32 of whole words by "slicing" (M. E. Kounavis and F. L. Berry, IEEE Transactions on
/// Computers 57, 1550, 2008): the remainders of the bytes of a block do not depend on each other.
std::uint32_t checksum(unsigned char const *bytes, std::size_t size) noexcept
{
    std::uint32_t sum = 0xffffffffu;
    std::size_t k = 0;
    for (; size - k >= bytes_of_block; k += bytes_of_block)
        sum = remainder_of(load_word(bytes + k) ^ sum, bytes_of_word) ^
              remainder_of(load_word(bytes + k + bytes_of_word), 0);
    if (k < size) sum = remainder_of(load_word(bytes + k) ^ sum, 0);
    return ~sum;
}

/// Returns whether bytes begin like a state of a version before format 1, which copied its memory:
/// with 0x70773835'6d630001 and up to 15 more, in either order of bytes.
bool is_memory_image(unsigned char const *bytes) noexcept
{
    unsigned char const mark[] = {0x00, 0x63, 0x6d, 0x35, 0x38, 0x77, 0x70};
    unsigned char const reversed[] = {0x70, 0x77, 0x38, 0x35, 0x6d, 0x63, 0x00};
    return std::memcmp(bytes + 1, mark, sizeof mark) == 0 ||
           std::memcmp(bytes, reversed, sizeof reversed) == 0;
}

/// Returns the requirement on all but the sections that the bytes do not meet, or null.
char const *check_frame(std::size_t size, unsigned char const *bytes) noexcept
{
    if (size >= bytes_of_word && is_memory_image(bytes))
        return "must not be of a version that saved memory: continue the simulation with that "
               "version, or create it again from its particles";
    if (size < bytes_of_word || std::memcmp(bytes, signature, bytes_of_word) != 0)
        return not_a_state;
    if (size < bytes_of_head + bytes_of_word || load_word(bytes + 2 * bytes_of_word) != size)
        return "must be complete: num_bytes differs from the number in the state";
    std::size_t const end = size - bytes_of_word;
    if (size % bytes_of_word != 0 || checksum(bytes, end) != load_word(bytes + end))
        return "must be as they were saved: their checksum differs";
    if (load_word(bytes + bytes_of_word) != format)
        return "must have a format that this version knows: restore them with a later version";
    return nullptr;
}

/// Returns the number of the section with a name, or num_sections.
std::size_t number_of(unsigned char const *name) noexcept
{
    std::size_t k = 0;
    while (k < num_sections && std::memcmp(name, names[k], bytes_of_word) != 0) ++k;
    return k;
}

/// Returns whether readers refuse a section whose name they do not know.
bool is_required(unsigned char const *name) noexcept { return name[0] < 'a' || name[0] > 'z'; }

} // namespace

void Writer::begin(std::size_t size) noexcept
{
    add_word(load_word(reinterpret_cast<unsigned char const *>(signature)));
    add_word(format);
    add_word(size);
}

std::size_t Writer::begin_section(Section section) noexcept
{
    add_word(load_word(reinterpret_cast<unsigned char const *>(names[section])));
    add_word(0); // until the end of the section is known
    return size_;
}

void Writer::end_section(std::size_t start) noexcept
{
    if (bytes_ != nullptr) store_word(size_ - start, bytes_ + start - bytes_of_word);
}

void Writer::end() noexcept { add_word(bytes_ == nullptr ? 0 : checksum(bytes_, size_)); }

int Reader::finish() const noexcept
{
    return status_ == PW85_SUCCESS && num_words_ > 0 ? int{PW85_EINVAL} : status_;
}

char const *find_sections(std::size_t size, unsigned char const *bytes,
                          Reader (&sections)[num_sections]) noexcept
{
    if (char const *const requirement = check_frame(size, bytes)) return requirement;
    std::size_t const end = size - bytes_of_word;
    for (std::size_t next = bytes_of_head; next < end;) {
        unsigned char const *const name = bytes + next;
        next += 2 * bytes_of_word;
        if (next > end) return not_a_state;
        std::uint64_t const given = load_word(name + bytes_of_word);
        if (given > end - next || given % bytes_of_word != 0) return not_a_state;
        auto const length = static_cast<std::size_t>(given);
        std::size_t const section = number_of(name);
        if (section == num_sections && is_required(name))
            return "must have no section that this version does not know: restore them with a "
                   "later version";
        if (section < num_sections) {
            if (sections[section].exists()) return not_a_state;
            sections[section] = Reader(bytes + next, length);
        }
        next += length;
    }
    return nullptr;
}

} // namespace pw85::detail::simulation
