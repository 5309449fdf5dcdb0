/** Logging: configuration of the logging library and its levels, and {@code ./dfra log}. */
@NullMarked
package org.dfra.app.log;

import org.jspecify.annotations.NullMarked;
