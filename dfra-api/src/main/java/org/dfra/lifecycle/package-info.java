/**
 * The states of a module's life, and what disturbed it: for modules, which report them, and for
 * events, which announce them.
 *
 * <p>Start at {@link org.dfra.lifecycle.Readiness}.
 */
@NullMarked
package org.dfra.lifecycle;

import org.jspecify.annotations.NullMarked;
