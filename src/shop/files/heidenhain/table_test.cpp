#include "shop/files/heidenhain/table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

// Columns of the older control: 16 characters of name, deltas of 7.
const std::string old_tools =
    "BEGIN TOOL    .T       MM\r\n"
    "T    NAME             L          R          DL      TL RT  DOC\r\n"
    "0                     +0,000     +0,000     +0,000\r\n"
    "1    FR\xC4SER D8         +80,5      +4,000     +0,000         lang\r\n"
    "5.1  1234567890123456 +120       -4.25      +0      L  7   \r\n"
    "[END]\r\n";

const std::string cutting_data =
    "BEGIN FRAES_2.CDT \n#STRUCTBEGIN\n   NAME = WMAT\n     WIDTH = 16\n     DEC = 0\n* comment\n   NAME = Vc1\n     "
    "WIDTH = 7\n"
    "#STRUCTEND\nNR      WMAT             Vc1\n0       St 33-1          40\n; old\n\n1       Al 99,9          "
    "250\n[END]\n";

const std::string described =
    "BEGIN PALLETMAG.TAB INCH\nTableDescription (\n  columns:= [\n    CfgColumnDescription (\n      key:=\"KEY\",\n    "
    "  width:=3,\n"
    "      unique:=TRUE\n    ),\n    CfgColumnDescription (\n      key:=\"PALLET_NAME\",\n      width:=11\n    ),\n"
    "    CfgColumnDescription (\n      key:=\"N\",\n      width:=4\n    )\n  ]\n)\nKEYPALLET_NAMEN   \n0  "
    "ABCDEFGHIJK12  \n1  Z              \n[END]";

struct TableOf : Reading {
    HeidenhainTable table;
    explicit TableOf(const std::string& text, const std::string& name = "TOOL.T") {
        table = read_heidenhain_table(add(text, name), sources, diagnostics);
    }
};

std::string names(const HeidenhainTable& t) {
    std::string out;
    for (const TableColumn& c : t.columns)
        out += c.name + "@" + std::to_string(c.begin) + "/" +
               (c.width == TableColumn::no_limit ? "-" : std::to_string(c.width)) + " ";
    return out;
}

TEST(HeidenhainTable, ColumnsStandWhereTheirNamesBegin) {
    const TableOf t(old_tools);
    EXPECT_EQ(t.complaints(), "");
    EXPECT_EQ(t.table.name, "TOOL");
    EXPECT_EQ(t.table.extension, "T");
    EXPECT_EQ(t.table.unit, TableUnit::mm);
    EXPECT_EQ(names(t.table), "T@0/4 NAME@5/16 L@22/10 R@33/10 DL@44/7 TL@52/2 RT@55/3 DOC@59/- ");
    ASSERT_EQ(t.table.rows.size(), 3U);
    EXPECT_EQ(cell(t.table, 1, 1), "FR\xC4SER D8");
    EXPECT_EQ(cell_text(t.table, 1, 1), "FR\xC3\x84SER D8");
    EXPECT_EQ(cell(t.table, 0, 7), "");
    EXPECT_EQ(cell(t.table, 1, 7), "lang");
    EXPECT_EQ(cell(t.table, 2, 5), "L");
    EXPECT_EQ(find_column(t.table, "name"), 1U);
    EXPECT_FALSE(find_column(t.table, "R2"));
    EXPECT_EQ(find_row(t.table, "05.1"), 2U);
    EXPECT_FALSE(find_row(t.table, "5"));
    EXPECT_EQ(t.sources.position(cell_span(t.table, 2, 3)).line, 5U);
    EXPECT_EQ(t.sources.position(cell_span(t.table, 2, 3)).column, 34U);
}

TEST(HeidenhainTable, FirstLines) {
    const auto head = [](const std::string& line) {
        const TableOf t(line + "\nT  L\n[END]\n");
        return t.table.name + "|" + t.table.extension + "|" + std::to_string(static_cast<int>(t.table.unit)) +
               t.complaints();
    };
    EXPECT_EQ(head("BEGIN TOOL.T MM Version: 'Update:110.24'"), "TOOL|T|1");
    EXPECT_EQ(head("begin  null .d  INCH"), "NULL|D|2");
    EXPECT_EQ(head("BEGIN FRAES_GB.CDT "), "FRAES_GB|CDT|0");
    EXPECT_EQ(head("BEGIN TOOL MM"), "TOOL||1");
    EXPECT_EQ(head("BEGIN TOOL MM Version: 'Update:110.24'"), "TOOL||1");
}

TEST(HeidenhainTable, DescriptionsAreReadAndKept) {
    const TableOf c(cutting_data, "A.CDT");
    EXPECT_EQ(c.complaints(), "");
    EXPECT_EQ(names(c.table), "NR@0/7 WMAT@8/16 Vc1@25/7 ");
    ASSERT_EQ(c.table.rows.size(), 4U);
    EXPECT_FALSE(c.table.rows[1].data);
    EXPECT_EQ(cell(c.table, 3, 1), "Al 99,9");
    const TableOf d(described, "PALLETMAG.TAB");
    EXPECT_EQ(d.complaints(), "");
    EXPECT_EQ(names(d.table), "KEY@0/3 PALLET_NAME@3/11 N@14/4 ");
    EXPECT_EQ(cell(d.table, 0, 1), "ABCDEFGHIJK");
    EXPECT_EQ(cell(d.table, 0, 2), "12");
}

TEST(HeidenhainTable, WriteGivesBackWhatWasRead) {
    for (const std::string& text :
         {old_tools, cutting_data, described, std::string("BEGIN A .D MM\rD    X    \r0    +1\r"),
          std::string("\n\nBEGIN A .T MM\r\n"), std::string("rubbish"), std::string(" "),
          old_tools + "after [END]\r\nmore\x80", std::string("BEGIN A .T MM\nT  L\n\t1 2\n3")}) {
        const TableOf t(text);
        EXPECT_EQ(write_heidenhain_table(t.table), text);
    }
}

TEST(HeidenhainTable, MistakesArePlacedAndTheRestIsRead) {
    const TableOf t("BEGIN A .D MM\nD  X    X\n0  +1\nA  +2\n\t1 +3\n0  +4\n2  +5\n", "A.D");
    EXPECT_EQ(
        t.complaints(),
        "A.D:2:9: error: column X is already there [job-file]\n  D  X    X\n          ^\n  remedy: name each column "
        "once: the "
        "first one is taken\n"
        "A.D:4:1: error: this line has no row number in column D [job-file]\n  A  +2\n  ^~~~~\n"
        "  remedy: a row begins with its number; the values stand below the column names\n"
        "A.D:5:1: error: a tab in a row of a table with fixed columns [job-file]\n   1 +3\n  ^\n"
        "  remedy: replace it by as many blanks as the columns need\n"
        "A.D:6:1: error: row 0 is already there (column D) [job-file]\n  0  +4\n  ^\n  remedy: number each row once\n"
        "A.D:8:1: warning: the table ends without [END] [job-file]\n  \n  ^\n  remedy: see whether the file is "
        "complete\n");
    EXPECT_EQ(find_row(t.table, "2"), 4U);
    const TableOf none("T  L\n1  2\n[END]\n", "A.T");
    EXPECT_EQ(none.diagnostics.all().size(), 1U);
    EXPECT_EQ(cell(none.table, 0, 1), "2");
    EXPECT_EQ(TableOf("BEGIN A .T MM\n[END]\n").diagnostics.all().at(0).text, "the table has no line of column names");
    EXPECT_EQ(TableOf("BEGIN A .T MM\n#STRUCTBEGIN\n NAME = A\n").diagnostics.all().at(0).text,
              "the description of the columns has no end");
}

TEST(HeidenhainTable, ChangedCellsMoveNothing) {
    TableOf t(old_tools);
    EXPECT_EQ(set_cell(t.table, 2, 2, "+1"), std::nullopt);
    EXPECT_EQ(t.table.rows[2].text, "5.1  1234567890123456 +1         -4.25      +0      L  7   ");
    EXPECT_EQ(set_cell(t.table, 0, 6, "12"), std::nullopt);  // behind the end of the line
    EXPECT_EQ(t.table.rows[0].text, "0                     +0,000     +0,000     +0,000     12");
    EXPECT_EQ(set_cell(t.table, 1, 7, "kurz und \xC3\xBC\x62\x65r"), std::nullopt);
    EXPECT_EQ(cell(t.table, 1, 7), "kurz und \xFC\x62\x65r");
    const std::string before = write_heidenhain_table(t.table);
    EXPECT_EQ(set_cell(t.table, 2, 2, "+1"), std::nullopt);
    EXPECT_EQ(set_cell(t.table, 2, 1, "12345678901234567").value_or(""),
              "column NAME: \"12345678901234567\" has 17 characters, the column holds 16");
    EXPECT_TRUE(set_cell(t.table, 2, 1, "a\nb"));
    EXPECT_TRUE(set_cell(t.table, 2, 1, "\xE2\x88\x9E"));  // infinity is not in CP1252
    EXPECT_TRUE(set_cell(t.table, 2, 0, "9"));
    EXPECT_EQ(write_heidenhain_table(t.table), before);
    EXPECT_EQ(add_row(t.table, "7"), std::nullopt);
    EXPECT_TRUE(add_row(t.table, "5.1"));
    EXPECT_TRUE(add_row(t.table, "x"));
    EXPECT_TRUE(add_row(t.table, "12345"));
    EXPECT_EQ(set_cell(t.table, 3, 2, "+5"), std::nullopt);
    EXPECT_EQ(t.table.rows[3].text, "7" + std::string(21, ' ') + "+5" + std::string(35, ' '));
    EXPECT_TRUE(write_heidenhain_table(t.table).ends_with("+5" + std::string(35, ' ') + "\r\n[END]\r\n"));
}

TEST(HeidenhainTable, Utf8CountsCharacters) {
    TableOf t("BEGIN A .T MM\nT  NAME  L\n1  \xC3\x84\xC3\x84\xC3\x84   +1\n[END]\n");
    EXPECT_EQ(cell(t.table, 0, 2), "+1");
    EXPECT_EQ(set_cell(t.table, 0, 1, "\xC3\x96\x62"), std::nullopt);
    EXPECT_EQ(t.table.rows[0].text, "1  \xC3\x96\x62    +1");
}

/// Any bytes come back; and a cell that takes a value gives it back, with all other cells as they were.
RC_GTEST_PROP(HeidenhainTable, AnyTextComesBack, (const std::string& noise)) {
    RC_PRE(!noise.starts_with("\xEF\xBB\xBF"));  // the byte order mark is dropped by base::Sources
    const std::string alphabet[] = {"BEGIN A .T MM",
                                    "\r\n",
                                    "\n",
                                    "\r",
                                    "T  NAME L",
                                    "1  ",
                                    "[END]",
                                    "\t",
                                    "#STRUCTBEGIN",
                                    "NAME = T",
                                    "#STRUCTEND",
                                    "TableDescription (",
                                    ")",
                                    "\xC3\x84",
                                    "\xE4"};
    std::string text = noise;
    for (int i = *rc::gen::inRange(0, 20); i > 0; --i)
        text += alphabet[*rc::gen::inRange<std::size_t>(0, std::size(alphabet))];
    const TableOf t(text);
    RC_ASSERT(write_heidenhain_table(t.table) == text);
}

RC_GTEST_PROP(HeidenhainTable, OneCellChangesAlone, ()) {
    TableOf t(*rc::gen::element(old_tools, cutting_data, described));
    const auto row = *rc::gen::inRange<std::size_t>(0, t.table.rows.size());
    const auto column = *rc::gen::inRange<std::size_t>(1, t.table.columns.size());
    RC_PRE(t.table.rows[row].data);
    const auto value = *rc::gen::container<std::string>(rc::gen::inRange<char>('!', '~'));
    HeidenhainTable after = t.table;
    const auto problem = set_cell(after, row, column, value);
    RC_ASSERT(problem.has_value() == (value.size() > t.table.columns[column].width));
    for (std::size_t r = 0; r < t.table.rows.size(); ++r)
        for (std::size_t c = 0; c < t.table.columns.size(); ++c)
            RC_ASSERT(cell(after, r, c) ==
                      (!problem && r == row && c == column ? std::string_view(value) : cell(t.table, r, c)));
}

}  // namespace
}  // namespace obrys::shop
