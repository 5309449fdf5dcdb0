/** Time for logic that waits; passed in, so that tests step it. */
@NullMarked
package org.dfra.time;

import org.jspecify.annotations.NullMarked;
