/** The application's logging library, as the architecture sets its levels. */
@NullMarked
package org.dfra.app.log;

import org.jspecify.annotations.NullMarked;
