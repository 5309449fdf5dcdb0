/**
 * Remote interfaces: what clients may call over the network. Each is a module's interface with
 * {@code Remote} added. The second of the five classes.
 */
@NullMarked
package org.dfra.river.remote;

import org.jspecify.annotations.NullMarked;
