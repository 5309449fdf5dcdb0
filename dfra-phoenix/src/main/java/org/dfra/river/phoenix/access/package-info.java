/**
 * Who may change what phoenix has: only programs on phoenix's own computer register and monitor,
 * and nobody changes its RMI registry.
 *
 * <p>Enter at {@link org.dfra.river.phoenix.access.LocalCallerGuard}.
 */
@NullMarked
package org.dfra.river.phoenix.access;

import org.jspecify.annotations.NullMarked;
