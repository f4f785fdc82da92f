// No verdict rests on what one reader alone says of the sources.
#pragma once

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

/// Whether the netlists of both are what their sources say, as a simulator runs them: `gold_read`
/// and `gate_read` of the answer. A side that is misread is read again by slang, where it is
/// installed. Else `left` of the answer says why not. Sources of the same text are trusted as they
/// are. OutOfTime.
bool are_trusted(Question& q, Answer& answer);

}  // namespace cosim::equiv
