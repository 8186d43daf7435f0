// Whether this program draws planets of real size. It is told when programs are linked, which leaves out what only they
// need: the page has one program with it and one without, of the same objects.
#pragma once

namespace terrella {

extern const bool has_real_size;

}  // namespace terrella
