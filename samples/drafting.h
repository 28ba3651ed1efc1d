#pragma once
// What the drafts of the samples share: lines as a pattern maker draws them, pieces made of them, and the program round a
// draft.

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "garment/mannequin.h"
#include "garment/pattern.h"

namespace toile::drafting {

using Line = std::vector<Eigen::Vector2d>;  // m

struct Measures {
  double height, bust, waist, hip, upper_arm, wrist, thigh;  // m
};

// Throws BadInput "draft.no-measure" when the row lacks upper arm, wrist or thigh.
Measures measures_of(const SizeChartRow& row);

// `steps` + 1 points of the cubic Bezier curve over these four.
Line curve(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d,
           int steps = 10);
// Through the points in turn, as a bent ruler lies: Catmull-Rom with chord-length knots (no loops).
Line through(const Line& points, int steps = 4);
Line reversed(Line line);
Line mirrored(Line line);  // about the y axis, points in the same order
Line shifted(Line line, const Eigen::Vector2d& by);
Line joined(Line first, const Line& second);  // second begins where first ends
double length(const Line& line);
// Share of the line's length at `distance` from its beginning.
double share_at(const Line& line, double distance);

// The value in [low, high] for which `f`, which only rises or only falls, is 0. Throws std::invalid_argument when it has one
// sign.
double solve(double low, double high, const std::function<double(double)>& f);

// An edge of a piece still being drafted.
struct Draft {
  std::string id;
  Line line;
  double allowance = 10e-3;  // m
  bool hem = false;
  std::vector<double> notches = {};  // shares of its length
};

// A piece from its edges counter-clockwise, notches on them.
Piece piece(const std::string& name, const std::vector<Draft>& outline);
// From the edges of the half at x >= 0, the first beginning and the last ending on the centre line: the whole piece. The first
// and the last edge are joined with their mirror images; of the others, those at x > 0 get the suffix `right`, the others
// `left`.
std::vector<Draft> whole(const std::vector<Draft>& half, const std::string& right, const std::string& left);

// The draft's program: `NAME FOLDER [SIZE]` writes FOLDER/NAME.dxf for a row (38) of templates/mannequins/women.csv.
int draft_program(int count, char** arguments, const std::string& name, const std::string& style,
                  const std::function<std::vector<Piece>(const Measures&)>& pieces);

}  // namespace toile::drafting
