/** The verbs of {@code ./dfra lease}: who holds which module. */
@NullMarked
package org.dfra.app.lease;

import org.jspecify.annotations.NullMarked;
