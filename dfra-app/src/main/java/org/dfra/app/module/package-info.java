/** The verbs of {@code ./dfra module}: what can be asked of a module, and done to it. */
@NullMarked
package org.dfra.app.module;

import org.jspecify.annotations.NullMarked;
