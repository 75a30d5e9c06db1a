#include "app/export/parts/stroke_font.hpp"

#include <algorithm>
#include <array>

namespace cognate::app {
namespace {

/// Strokes with a space between them, each of two digits for a point: x from 0, and y with the line
/// at 2, small letters up to 6, capitals to 8.
constexpr std::array kGlyphs = {
    "",                                     // space
    "1814 1312",                            // !
    "0806 2826",                            // "
    "1713 3733 0646 0444",                  // #
    "473818070615354443321203 2822",        // $
    "0248 0708181707 3233434232",           // %
    "420607182837360403122244",             // &
    "0806",                                 // '
    "18060412",                             // (
    "08161402",                             // )
    "1713 0644 4604",                       // *
    "2723 0545",                            // +
    "121301",                               // ,
    "0545",                                 // -
    "0203",                                 // .
    "0248",                                 // /
    "120307183847433212 0347",              // 0
    "061812 0222",                          // 1
    "07183847450242",                       // 2
    "071838474635 1535 354443321203",       // 3
    "32380444",                             // 4
    "480805354443321203",                   // 5
    "383818070312324344351504",             // 6
    "084812",                               // 7
    "153546473818070615040312324344 3544",  // 8
    "12324347381807061545",                 // 9
    "0506 0203",                            // :
    "1516 121301",                          // ;
    "470543",                               // <
    "0646 0444",                            // =
    "074503",                               // >
    "0718384746252423 2221",                // ?
    "4212030718384744242646",               // @
    "02052845424404",                       // A
    "02083847463505 3544433202",            // B
    "4738180703123243",                     // C
    "02082846442202",                       // D
    "48080242 0535",                        // E
    "480802 0535",                          // F
    "473818070312324345 4525",              // G
    "0802 4842 0545",                       // H
    "0828 1812 0222",                       // I
    "3833221203",                           // J
    "0802 4804 1542",                       // K
    "080242",                               // L
    "0208254842",                           // M
    "02084248",                             // N
    "120307183847433212",                   // O
    "0208384746350505",                     // P
    "120307183847433212 2442",              // Q
    "02083847463505 2542",                  // R
    "473818070615354443321203",             // S
    "0848 2822",                            // T
    "08031232434848",                       // U
    "082248",                               // V
    "0812253248",                           // W
    "0248 0842",                            // X
    "082548 2522",                          // Y
    "08480242",                             // Z
    "28080222",                             // [
    "0842",                                 // backslash
    "08282202",                             // ]
    "061826",                               // ^
    "0141",                                 // _
    "0817",                                 // `
    "3632 3526160503122233",                // a
    "0802 0516263533221203",                // b
    "352616050312223322",                   // c
    "3832 3526160503122233",                // d
    "04343526160503122233",                 // e
    "281712 0626",                          // f
    "36312010 3526160503122233",            // g
    "0802 0516263532",                      // h
    "0206 0708",                            // i
    "161100 1718",                          // j
    "0802 360432",                          // k
    "08031222",                             // l
    "0206 05162522 25364542",               // m
    "0206 0516263532",                      // n
    "160503122233352616",                   // o
    "0600 0516263533221203",                // p
    "3630 3526160503122233",                // q
    "0206 05162635",                        // r
    "35261605142433221203",                 // s
    "18132233 0626",                        // t
    "0603122233 3632",                      // u
    "061236",                               // v
    "0612243246",                           // w
    "0236 0632",                            // x
    "0612 3600",                            // y
    "06360232",                             // z
    "28171605141322",                       // {
    "0800",                                 // |
    "08171625141302",                       // }
    "05162536",                             // ~
};

constexpr double kRows = 6;        // of a capital
constexpr double kAcross = 0.8;    // width of a column as a share of a row's height
constexpr int kFootLine = 2;       // y of the line
constexpr double kBetween = 1.5;   // columns from one letter to the next
constexpr double kSpaceWidth = 2;  // columns
constexpr std::string_view kBox = "0208484202";

/// The glyph of the character at the beginning of `text`, which loses it.
std::string_view next_glyph(std::string_view& text) {
  constexpr unsigned char kFirst = ' ';
  const auto lead = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (lead >= kFirst && lead < kFirst + kGlyphs.size()) return kGlyphs.at(lead - kFirst);
  while (!text.empty() && (static_cast<unsigned char>(text.front()) & 0xC0U) == 0x80U) {
    text.remove_prefix(1);
  }
  return kBox;
}

double columns_of(std::string_view glyph) {
  if (glyph.empty()) return kSpaceWidth;
  int most = 0;
  for (std::size_t i = 0; i < glyph.size(); ++i) {
    if (glyph[i] == ' ') continue;
    most = std::max(most, glyph[i] - '0');
    ++i;  // y
  }
  return most;
}

}  // namespace

std::vector<std::vector<Vec2d>> strokes_of(std::string_view text, double height) {
  std::vector<std::vector<Vec2d>> strokes;
  const double row = height / kRows, column = kAcross * row;
  double left = 0;
  while (!text.empty()) {
    const std::string_view glyph = next_glyph(text);
    std::vector<Vec2d> stroke;
    for (std::size_t i = 0; i < glyph.size(); i += 2) {
      if (glyph[i] == ' ') {
        strokes.push_back(std::move(stroke));
        stroke.clear();
        ++i;
      }
      stroke.push_back({column * (left + glyph[i] - '0'), row * (glyph[i + 1] - '0' - kFootLine)});
    }
    if (!stroke.empty()) strokes.push_back(std::move(stroke));
    left += columns_of(glyph) + kBetween;
  }
  return strokes;
}

double stroke_width(std::string_view text, double height) {
  double columns = 0;
  while (!text.empty()) columns += columns_of(next_glyph(text)) + kBetween;
  return std::max(0.0, columns - kBetween) * kAcross * height / kRows;
}

}  // namespace cognate::app
