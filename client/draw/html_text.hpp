// The parts of the page of HTML that are the same for every model.
#pragma once

namespace spoctree {

extern const char* const kHtmlHead;      ///< in the head, before the title
extern const char* const kHtmlStyle;     ///< style sheet
extern const char* const kHtmlControls;  ///< slider and button, hidden where there are no scripts
extern const char* const kHtmlScript;

}  // namespace spoctree
