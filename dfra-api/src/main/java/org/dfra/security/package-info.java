/**
 * Who calls, and what a guard says to it.
 *
 * <p>Start at {@link org.dfra.security.Guard}: it decides about an {@link
 * org.dfra.security.AccessRequest} of a {@link org.dfra.security.Caller}, who is a {@link
 * org.dfra.security.Member} of the team if a certificate says so. This package is independent of
 * the network and of the form in which policies are written.
 */
@NullMarked
package org.dfra.security;

import org.jspecify.annotations.NullMarked;
