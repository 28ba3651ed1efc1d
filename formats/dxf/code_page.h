#pragma once
// Letters beyond ASCII in a DXF: UTF-8 from R2007 on, before that in the code page that the header names.

#include <string>
#include <vector>

#include "formats/dxf/tags.h"
#include "garment/report.h"

namespace toile::dxf {

// Makes every value of `tags` UTF-8. A file whose values are all UTF-8 is taken as that; any other is in $DWGCODEPAGE
// (ANSI_1252, DOS850, ISO8859-1, ...), without one in Windows-1252. Note "dxf.code-page" says which; it is a warning where the
// code page is not known or has not all the letters, which then become U+FFFD.
void decode(std::vector<Tag>& tags, const std::string& name, Report& report);

}  // namespace toile::dxf
