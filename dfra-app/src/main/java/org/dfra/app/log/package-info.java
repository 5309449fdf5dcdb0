/**
 * The application's logging library as the architecture sets its levels, and {@code ./dfra log}.
 */
@NullMarked
package org.dfra.app.log;

import org.jspecify.annotations.NullMarked;
