/** Shell completion of {@code ./dfra}. */
@NullMarked
package org.dfra.cli.completion;

import org.jspecify.annotations.NullMarked;
