#pragma once
/// What making a part costs in a shop. File format: docs/cost.md.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/source.hpp"

namespace obrys::shop {

/// A tool that wears, per piece.
struct CostTool {
    std::string name;
    std::optional<std::uint32_t> number;  ///< in a program that takes the time: how long it cuts there
    double price = 0;                     ///< of a new one, or of a set of inserts
    double lives = 1;                     ///< how often it is used up: edges of an insert, regrinds and the first life
    double regrind = 0;                   ///< price of one of them
    double life_min = 0;                  ///< minutes of cutting
    std::optional<double> cut_s;          ///< seconds that it cuts in a piece; not said: not known
    double change_min = 0;                ///< to change it when it is worn
};

/// Money in the table's own currency, hours of people and machines by the hour, percent.
struct CostTable {
    std::string currency;            ///< empty: not said
    double utilisation = 1;          ///< part of the paid machine time in which the cycle runs, above 0, at most 1
    double wage = 0;                 ///< an hour
    double overhead = 0;             ///< % on wages
    double machine = 0;              ///< an hour
    double material = 0;             ///< a piece
    std::optional<double> pieces;    ///< a year
    std::optional<double> rounding;  ///< the price of a piece is rounded to a multiple of this
    // What a price per piece from the cycle alone leaves out.
    std::optional<double> batch;  ///< pieces for which the machine is set up once
    double set_up_min = 0;        ///< of a batch
    double load_s = 0;            ///< to load and unload a piece
    double fixture = 0;           ///< a year
    double programming = 0;       ///< once, over all pieces of a year
    double scrap = 0;             ///< % of pieces that are thrown away
    std::vector<CostTool> tools;
};

/// A way of making the part: its time is given, or that of a program.
struct CostVariant {
    std::string name;
    std::optional<double> time_s;
    std::string program;  ///< path as written, relative to the table's; empty: none
    CostTable table;      ///< with what this variant says otherwise
    base::Span where{};
};

}  // namespace obrys::shop
