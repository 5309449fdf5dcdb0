/**
 * Modules: the smallest parts of a robot that others can find, use and replace.
 *
 * <p>Start at {@link org.dfra.module.Module}. A module reports its identity ({@link
 * org.dfra.module.Identification}) and its lifecycle state ({@link org.dfra.lifecycle.Readiness}).
 * This package is independent of the network: a method that may cross it declares {@code
 * RemoteException}, so that local and remote callers write the same code.
 */
@NullMarked
package org.dfra.module;

import org.jspecify.annotations.NullMarked;
