#include "dialect/heidenhain/functions.hpp"

#include <algorithm>
#include <array>

namespace obrys::dialect::heidenhain {

namespace {

using enum Use;

constexpr std::array functions{
    FnFunction{0, run, "", "assignment"},
    FnFunction{1, run, "", "addition"},
    FnFunction{2, run, "", "subtraction"},
    FnFunction{3, run, "", "multiplication"},
    FnFunction{4, run, "DIV", "division; by 0 is an error"},
    FnFunction{5, run, "SQRT", "square root; of a negative value is an error"},
    FnFunction{6, run, "SIN", "sine of an angle in degrees"},
    FnFunction{7, run, "COS", "cosine of an angle in degrees"},
    FnFunction{8, run, "LEN", "root of a sum of squares"},
    FnFunction{9, run, "IF EQU GOTO LBL", "jump if equal"},
    FnFunction{10, run, "IF NE GOTO LBL", "jump if not equal"},
    FnFunction{11, run, "IF GT GOTO LBL", "jump if greater"},
    FnFunction{12, run, "IF LT GOTO LBL", "jump if less"},
    FnFunction{13, run, "ANG", "angle from two sides, 0 to below 360 degrees"},
    FnFunction{14, run, "ERROR", "stops with a message"},
    FnFunction{15, run, "PRINT", "puts out values, to a folder that is named for it only"},
    FnFunction{16, run, "F-PRINT", "puts out texts and values in a form, to a folder that is named for it only"},
    FnFunction{17, run, "SYSWRITE",
               "changes data of the control; run for dimensions of tools (ID 50), refused for others"},
    FnFunction{18, run, "SYSREAD", "reads data of the control: see the list"},
    FnFunction{19, accepted, "PLC", "hands two values to the PLC"},
    FnFunction{20, accepted, "WAIT FOR", "waits for the PLC, or until the control has caught up (SYNC)"},
    FnFunction{23, refused, "CDATA", "circle through 3 points"},
    FnFunction{24, refused, "CDATA", "circle through 4 points"},
    FnFunction{25, run, "PRESET", "gives a coordinate of a linear axis another value: a new datum"},
    FnFunction{26, run, "TABOPEN", "opens a freely definable table"},
    FnFunction{27, run, "TABWRITE", "writes into the open table, for the run alone"},
    FnFunction{28, run, "TABREAD", "reads from the open table"},
    FnFunction{29, accepted, "PLC", "hands up to eight values to the PLC"},
    FnFunction{37, accepted, "EXPORT", "hands local parameters of a machine builder's cycle to its caller"},
    FnFunction{38, accepted, "SEND", "writes a text into the log"},
};

// Texts: the manual's table "FN 14: ERROR", numbers 1000 … 1099.
constexpr std::array errors{
    ErrorText{1000, "Spindle?"},
    ErrorText{1001, "Tool axis is missing"},
    ErrorText{1002, "Tool radius too small"},
    ErrorText{1003, "Tool radius too large"},
    ErrorText{1004, "Range exceeded"},
    ErrorText{1005, "Start position incorrect"},
    ErrorText{1006, "ROTATION not permitted"},
    ErrorText{1007, "SCALING FACTOR not permitted"},
    ErrorText{1008, "MIRROR IMAGE not permitted"},
    ErrorText{1009, "Datum shift not permitted"},
    ErrorText{1010, "Feed rate is missing"},
    ErrorText{1011, "Input value incorrect"},
    ErrorText{1012, "Incorrect sign"},
    ErrorText{1013, "Entered angle not permitted"},
    ErrorText{1014, "Touch point inaccessible"},
    ErrorText{1015, "Too many points"},
    ErrorText{1016, "Contradictory input"},
    ErrorText{1017, "CYCL incomplete"},
    ErrorText{1018, "Plane wrongly defined"},
    ErrorText{1019, "Wrong axis programmed"},
    ErrorText{1020, "Wrong rpm"},
    ErrorText{1021, "Radius comp. undefined"},
    ErrorText{1022, "Rounding-off undefined"},
    ErrorText{1023, "Rounding radius too large"},
    ErrorText{1024, "Program start undefined"},
    ErrorText{1025, "Excessive nesting"},
    ErrorText{1026, "Angle reference missing"},
    ErrorText{1027, "No fixed cycle defined"},
    ErrorText{1028, "Slot width too small"},
    ErrorText{1029, "Pocket too small"},
    ErrorText{1030, "Q202 not defined"},
    ErrorText{1031, "Q205 not defined"},
    ErrorText{1032, "Q218 must be greater than Q219"},
    ErrorText{1033, "CYCL 210 not permitted"},
    ErrorText{1034, "CYCL 211 not permitted"},
    ErrorText{1035, "Q220 too large"},
    ErrorText{1036, "Q222 must be greater than Q223"},
    ErrorText{1037, "Q244 must be greater than 0"},
    ErrorText{1038, "Q245 must not equal Q246"},
    ErrorText{1039, "Angle range must be under 360 degrees"},
    ErrorText{1040, "Q223 must be greater than Q222"},
    ErrorText{1041, "Q214: 0 not permitted"},
    ErrorText{1042, "Traverse direction not defined"},
    ErrorText{1043, "No datum table active"},
    ErrorText{1044, "Position error: center in axis 1"},
    ErrorText{1045, "Position error: center in axis 2"},
    ErrorText{1046, "Hole diameter too small"},
    ErrorText{1047, "Hole diameter too large"},
    ErrorText{1048, "Stud diameter too small"},
    ErrorText{1049, "Stud diameter too large"},
    ErrorText{1050, "Pocket too small: rework axis 1"},
    ErrorText{1051, "Pocket too small: rework axis 2"},
    ErrorText{1052, "Pocket too large: scrap axis 1"},
    ErrorText{1053, "Pocket too large: scrap axis 2"},
    ErrorText{1054, "Stud too small: scrap axis 1"},
    ErrorText{1055, "Stud too small: scrap axis 2"},
    ErrorText{1056, "Stud too large: rework axis 1"},
    ErrorText{1057, "Stud too large: rework axis 2"},
    ErrorText{1058, "TCHPROBE 425: length exceeds max"},
    ErrorText{1059, "TCHPROBE 425: length below min"},
    ErrorText{1060, "TCHPROBE 426: length exceeds max"},
    ErrorText{1061, "TCHPROBE 426: length below min"},
    ErrorText{1062, "TCHPROBE 430: diameter too large"},
    ErrorText{1063, "TCHPROBE 430: diameter too small"},
    ErrorText{1064, "No measuring axis defined"},
    ErrorText{1065, "Tool breakage tolerance exceeded"},
    ErrorText{1066, "Enter Q247 unequal 0"},
    ErrorText{1067, "Enter Q247 greater than 5"},
    ErrorText{1068, "Datum table?"},
    ErrorText{1069, "Enter direction Q351 unequal 0"},
    ErrorText{1070, "Thread depth too large"},
    ErrorText{1071, "Missing calibration data"},
    ErrorText{1072, "Tolerance exceeded"},
    ErrorText{1073, "Block scan active"},
    ErrorText{1074, "ORIENTATION not permitted"},
    ErrorText{1075, "3DROT not permitted"},
    ErrorText{1076, "Activate 3DROT"},
    ErrorText{1077, "Enter depth as negative"},
    ErrorText{1078, "Q303 in meas. cycle undefined!"},
    ErrorText{1079, "Tool axis not allowed"},
    ErrorText{1080, "Calculated values incorrect"},
    ErrorText{1081, "Contradictory measuring points"},
    ErrorText{1082, "Incorrect clearance height"},
    ErrorText{1083, "Contradictory plunge type"},
    ErrorText{1084, "Fixed cycle not permitted"},
    ErrorText{1085, "Line is write-protected"},
    ErrorText{1086, "Oversize greater than depth"},
    ErrorText{1087, "No point angle defined"},
    ErrorText{1088, "Contradictory data"},
    ErrorText{1089, "Slot position 0 not permitted"},
    ErrorText{1090, "Enter infeed not equal to 0"},
    ErrorText{1091, "Switchover of Q399 not allowed"},
    ErrorText{1092, "Tool not defined"},
    ErrorText{1093, "Tool number not permitted"},
    ErrorText{1094, "Tool name not permitted"},
    ErrorText{1095, "Software option not active"},
    ErrorText{1096, "Kinematics cannot be restored"},
    ErrorText{1097, "Function not permitted"},
    ErrorText{1098, "Contradictory workpc. blank dim."},
    ErrorText{1099, "Measuring position not allowed"},
};

template <typename Table>
const auto* find_number(const Table& table, int number) {
    const auto found =
        std::lower_bound(table.begin(), table.end(), number, [](const auto& e, int n) { return e.number < n; });
    return found != table.end() && found->number == number ? &*found : nullptr;
}

}  // namespace

std::span<const FnFunction> all_fn() { return functions; }
const FnFunction* find_fn(int number) { return find_number(functions, number); }

std::span<const ErrorText> all_errors() { return errors; }
std::string_view error_text(int number) {
    const ErrorText* found = find_number(errors, number);
    return found == nullptr ? std::string_view{} : found->text;
}

std::string error_message(int number) {
    const std::string shown = "ERROR " + std::to_string(number);
    if (const std::string_view text = error_text(number); !text.empty()) return shown + ": " + std::string(text);
    return number >= 300 && number < 1000 ? shown + " (a message of the machine builder)" : shown;
}

}  // namespace obrys::dialect::heidenhain
