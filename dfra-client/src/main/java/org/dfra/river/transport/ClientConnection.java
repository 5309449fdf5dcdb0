package org.dfra.river.transport;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.ByteBuffer;
import java.util.concurrent.TimeUnit;
import org.dfra.river.identity.ChannelPeer;
import org.jspecify.annotations.Nullable;

/**
 * One connection to a server. Owned by one call, or idle in {@link ClientConnections}, whose lock
 * then guards it; any thread may close it.
 */
final class ClientConnection {

  private static final System.Logger LOG = System.getLogger(ClientConnection.class.getName());

  /** A connection that was idle for less than this is used without a check. */
  private static final long CHECK_AFTER_NANOS = TimeUnit.MILLISECONDS.toNanos(5);

  private final Link link;
  private @Nullable ByteBuffer output;
  private @Nullable ByteBuffer input; // ready to be read from
  private long idleSince;
  private boolean paused;
  private boolean isNew = true;

  ClientConnection(Link link) {
    this.link = link;
  }

  Link link() {
    return link;
  }

  /** The buffer for a request. */
  ByteBuffer output() {
    ByteBuffer buffer = output;
    if (buffer == null) {
      buffer = BufferPool.BLOCKS.take();
      output = buffer;
    }
    return buffer;
  }

  /** The buffer for a response, ready to be read from. */
  ByteBuffer input() {
    ByteBuffer buffer = input;
    if (buffer == null) {
      buffer = BufferPool.BLOCKS.take().limit(0);
      input = buffer;
    }
    return buffer;
  }

  /** Begins an idle period. */
  void setIdle(long now) {
    idleSince = now;
    paused = false;
    isNew = false;
  }

  /** Whether no call on it has been answered. */
  boolean isNew() {
    return isNew;
  }

  /**
   * The next connection to the server makes a complete handshake. A server that resumes a session
   * can refuse it, but only a complete handshake says why.
   */
  void forgetSession() {
    if (link instanceof TlsLink encrypted) {
      encrypted.forgetSession();
    }
  }

  /** How long it has been idle, in nanoseconds. */
  long idleNanos(long now) {
    return now - idleSince;
  }

  /** Whether the server knows that no call follows soon. */
  boolean isPaused() {
    return paused;
  }

  /** Informs the server that no call follows soon, and frees the buffers. */
  void pause() throws IOException {
    ByteBuffer block = output();
    block.clear().putInt(Block.encode(Block.Kind.PAUSE, 0)).flip();
    link.setBlocking(false); // a peer may take no bytes, and the watchdog must not wait for it
    if (link.write(block) < Block.HEADER_BYTES) {
      throw new IOException("the peer takes no more bytes");
    }
    link.setBlocking(true);
    paused = true;
    freeBuffers();
  }

  /** Only for an idle connection: a call that was aborted may still write into its buffer. */
  private void freeBuffers() {
    if (output != null) {
      BufferPool.BLOCKS.giveBack(output);
      output = null;
    }
    if (input != null) {
      BufferPool.BLOCKS.giveBack(input);
      input = null;
    }
  }

  /**
   * Whether the server can still receive a request, as far as this computer knows. An idle
   * connection receives nothing: a byte says that the server closes it.
   */
  boolean isOpen(long now) {
    if (idleNanos(now) < CHECK_AFTER_NANOS) {
      return true;
    }
    ByteBuffer buffer = input();
    buffer.clear();
    try {
      link.setBlocking(false);
      boolean isSilent = link.read(buffer) == 0 && link.held() == 0;
      link.setBlocking(true);
      buffer.limit(0);
      return isSilent;
    } catch (IOException e) {
      buffer.limit(0);
      return false;
    }
  }

  /** Whether the server's certificate was revoked after the connection was made. */
  boolean isRevoked() {
    @Nullable ChannelPeer server = link.partner();
    return server != null && server.isRevoked();
  }

  /** Closes it and frees its buffers; only while it is idle. */
  void closeIdle() {
    freeBuffers();
    close();
  }

  void close() {
    try {
      link.close();
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "The connection to " + link.peer() + " was not closed in order.", e);
    }
  }
}
