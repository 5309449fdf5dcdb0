/** Discovery of robots for commands: the team's lookup services, and the phoenix of this host. */
@NullMarked
package org.dfra.app.team;

import org.jspecify.annotations.NullMarked;
