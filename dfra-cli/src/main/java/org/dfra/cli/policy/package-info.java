/** The subcommands of {@code ./dfra policy}: who may do what with the robots of a team. */
@NullMarked
package org.dfra.cli.policy;

import org.jspecify.annotations.NullMarked;
