/** Discovery of robots for commands: the team's lookup services, and the phoenix of this host. */
@NullMarked
package org.dfra.cli.team;

import org.jspecify.annotations.NullMarked;
