/** The subcommands of {@code ./dfra lease}: leases on modules and their holders. */
@NullMarked
package org.dfra.app.lease;

import org.jspecify.annotations.NullMarked;
