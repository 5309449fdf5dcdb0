/** The subcommands of {@code ./dfra persona}: the attributes that the team's robots publish. */
@NullMarked
package org.dfra.app.persona;

import org.jspecify.annotations.NullMarked;
