/** Shell completion of {@code ./dfra}. */
@NullMarked
package org.dfra.app.completion;

import org.jspecify.annotations.NullMarked;
