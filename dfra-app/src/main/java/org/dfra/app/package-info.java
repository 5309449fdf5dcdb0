/** The program {@code ./dfra}: one class per subcommand. Entry point: {@link org.dfra.app.Main}. */
@NullMarked
package org.dfra.app;

import org.jspecify.annotations.NullMarked;
