/** The audit trail: its chain, its floods and its faults. */
@NullMarked
package org.dfra.core.audit;

import org.jspecify.annotations.NullMarked;
