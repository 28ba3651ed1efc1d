#pragma once
// Figures as a page shows them. All throw std::invalid_argument for what is not finite.

#include <string>

namespace toile::html {

std::string number(double value, int digits);
std::string mm(double metres, int digits = 2);
std::string change(double metres);  // mm with its sign; one that rounds to nothing has none
std::string percent(double share, int digits = 2);

}  // namespace toile::html
