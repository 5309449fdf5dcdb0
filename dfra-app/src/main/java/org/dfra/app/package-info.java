/** The program {@code ./dfra}: one verb, one class. Enter at {@link org.dfra.app.Main}. */
@NullMarked
package org.dfra.app;

import org.jspecify.annotations.NullMarked;
