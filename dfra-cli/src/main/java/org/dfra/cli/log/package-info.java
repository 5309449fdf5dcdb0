/** Logging: configuration of the logging library and its levels, and {@code ./dfra log}. */
@NullMarked
package org.dfra.cli.log;

import org.jspecify.annotations.NullMarked;
