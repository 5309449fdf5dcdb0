/**
 * What a module is: the smallest part of a robot that others can find, use and replace.
 *
 * <p>Enter at {@link org.dfra.module.Module}. A module says who it is ({@link
 * org.dfra.module.Identification}) and how far it has come ({@link org.dfra.module.Readiness}).
 * Nothing in this package knows a network: a method that may cross one declares {@code
 * RemoteException}, so that local and remote callers write the same code.
 */
@NullMarked
package org.dfra.module;

import org.jspecify.annotations.NullMarked;
