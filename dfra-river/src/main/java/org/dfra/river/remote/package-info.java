/**
 * Remote interfaces: what clients may call over the network, a module's interface each with {@code
 * Remote} added. The second of the five classes.
 */
@NullMarked
package org.dfra.river.remote;

import org.jspecify.annotations.NullMarked;
