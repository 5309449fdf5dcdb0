/** The histories of modules across restarts. Start at {@link org.dfra.core.history.IncidentLog}. */
@NullMarked
package org.dfra.core.history;

import org.jspecify.annotations.NullMarked;
