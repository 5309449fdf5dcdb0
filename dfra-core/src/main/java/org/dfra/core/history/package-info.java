/** What modules remember of their lives. Enter at {@link org.dfra.core.history.IncidentLog}. */
@NullMarked
package org.dfra.core.history;

import org.jspecify.annotations.NullMarked;
