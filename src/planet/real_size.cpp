#include "planet/real_size.hpp"

namespace terrella {

#ifdef TERRELLA_REAL_SIZE
const bool has_real_size = true;
#else
const bool has_real_size = false;
#endif

}  // namespace terrella
