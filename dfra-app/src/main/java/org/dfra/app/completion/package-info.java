/** Completion of {@code ./dfra} in shells. */
@NullMarked
package org.dfra.app.completion;

import org.jspecify.annotations.NullMarked;
