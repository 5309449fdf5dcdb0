/** The program {@code ./dfra}: one class per subcommand. Entry point: {@link org.dfra.cli.Main}. */
@NullMarked
package org.dfra.cli;

import org.jspecify.annotations.NullMarked;
