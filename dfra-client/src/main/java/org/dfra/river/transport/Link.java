package org.dfra.river.transport;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SelectableChannel;
import java.util.Collection;
import org.dfra.river.identity.ChannelPeer;
import org.jspecify.annotations.Nullable;

/**
 * The bytes of one established connection, in both directions, and what is known of the peer. Plain
 * TCP and Unix-domain sockets are such links; an encrypting one would wrap another.
 *
 * <p>One thread reads and writes at a time; any thread may close it, which ends the other's wait
 * with an exception.
 */
interface Link extends Closeable {

  /**
   * Reads what there is, at least one byte if it is blocking.
   *
   * @return number of bytes; 0 if there is none now and it is not blocking; -1 at the end
   */
  int read(ByteBuffer into) throws IOException;

  /**
   * Writes all bytes if it is blocking, otherwise as many as are accepted now.
   *
   * @return number of bytes
   */
  int write(ByteBuffer from) throws IOException;

  /** Whether reading and writing wait. */
  void setBlocking(boolean blocking) throws IOException;

  /** Tells the peer that nothing more is sent. */
  void endOutput() throws IOException;

  /** Ends the wait of a thread that reads: it gets the end, and so does every later one. */
  void endInput() throws IOException;

  /** Whether bytes are here that reading returns at once, and the channel no longer announces. */
  boolean hasReceived();

  /** The memory that it occupies for what was received and not read, in bytes. */
  int held();

  /** The bytes sent and received so far. For the thread that reads and writes. */
  long bytes();

  /** Who the peer has proved to be; null on a link without encryption. */
  @Nullable ChannelPeer partner();

  /** The channel to select on. */
  SelectableChannel channel();

  /** The peer, for limits and messages. */
  Peer peer();

  /** Adds what a called object may ask of its client, such as its address. */
  void addClientTo(Collection<Object> context);
}
