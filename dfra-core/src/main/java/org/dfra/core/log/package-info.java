/** How much modules log, changed while they run. */
@NullMarked
package org.dfra.core.log;

import org.jspecify.annotations.NullMarked;
