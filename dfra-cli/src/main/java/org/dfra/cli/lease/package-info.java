/** The subcommands of {@code ./dfra lease}: leases on modules and their holders. */
@NullMarked
package org.dfra.cli.lease;

import org.jspecify.annotations.NullMarked;
