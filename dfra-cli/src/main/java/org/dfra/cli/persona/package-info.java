/** The subcommands of {@code ./dfra persona}: the attributes that the team's robots publish. */
@NullMarked
package org.dfra.cli.persona;

import org.jspecify.annotations.NullMarked;
