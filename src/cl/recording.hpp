#pragma once
/// A stream kept to be gone through once more, in little room: most records are straight moves that differ from the one
/// before in where they lead (some ten bytes each, where coordinates are decimals; a whole Record has some hundreds).

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "cl/record.hpp"

namespace obrys::cl {

class Recording {
    /// What the next straight move is told from.
    struct Last {
        Record line{
            Linear{}, {}, 0};  ///< the last straight move that takes no axis along, at the place of the last record
        std::array<std::int64_t, 3> millionths{};  ///< of X, Y, Z: as last told so
    };

public:
    /// Appends one.
    void take(const Record& record);
    [[nodiscard]] std::size_t size() const { return size_; }

    /// Goes through the records of a recording, which must outlive it and take no more meanwhile.
    class Playback {
    public:
        explicit Playback(const Recording& recording) : of_(recording) {}
        /// Gives the next one to `sink`; false behind the last.
        bool step(Sink sink);

    private:
        const std::byte* get_line(const std::byte* at, std::uint8_t kind);

        const Recording& of_;
        std::size_t next_ = 0, block_ = 0, at_ = 0, whole_ = 0;
        Last last_;
    };

private:
    static constexpr std::size_t block_size = std::size_t{1} << 18;  // bytes; no record lies across two blocks
    /// Room for `bytes` more in one block.
    std::byte* room(std::size_t bytes);

    void take_line(const Record& record);
    void take_other(const Record& record);

    std::vector<std::unique_ptr<std::byte[]>> blocks_;
    std::vector<std::size_t> ends_;  ///< of each block
    std::vector<Record> whole_;      ///< those whose step is no plain memory
    Last last_;
    std::size_t size_ = 0;
};

}  // namespace obrys::cl
