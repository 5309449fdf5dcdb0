/**
 * The Unix-domain sockets by which processes of one user on one computer call each other. Start at
 * {@link org.dfra.river.transport.local.LocalSocket}, the address of one; {@link
 * org.dfra.river.transport.local.SocketFolder} opens them.
 */
@NullMarked
package org.dfra.river.transport.local;

import org.jspecify.annotations.NullMarked;
