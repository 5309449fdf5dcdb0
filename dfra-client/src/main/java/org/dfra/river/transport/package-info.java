/**
 * How the bytes of remote calls travel: a JERI transport in which one connection carries one call
 * at a time.
 *
 * <pre>
 *   caller's thread                                      worker's thread
 *   TransportEndpoint                                    TransportServerEndpoint
 *     takes a connection from ClientConnections            ConnectionSelector has the idle ones
 *     writes blocks (MessageOutput)   ---- Link ----&gt;      reads blocks (MessageInput), dispatches
 *     reads blocks (MessageInput)     &lt;--- Link -----      writes blocks (MessageOutput)
 *                         ^
 *          CallWatchdog closes the connection of a late call
 * </pre>
 *
 * <p>No thread passes a call on to another: the caller itself writes and reads, and the server's
 * worker reads, executes and answers. While calls follow each other on a connection, the worker
 * waits for the next one; a client that has no more tells it so ({@link
 * org.dfra.river.transport.Block.Kind#PAUSE}), and the connection goes to the one selector of the
 * virtual machine.
 *
 * <p>A connection begins with a greeting of the client and one of the server. Then both send {@link
 * org.dfra.river.transport.Block blocks}. Clients on the same computer and of the same user may
 * take a Unix-domain socket; {@link org.dfra.river.transport.Link} hides the difference.
 */
@NullMarked
package org.dfra.river.transport;

import org.jspecify.annotations.NullMarked;
