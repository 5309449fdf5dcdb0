/** The verbs of {@code ./dfra persona}: what the team's robots show of themselves. */
@NullMarked
package org.dfra.app.persona;

import org.jspecify.annotations.NullMarked;
